#include "mesher/import/label_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>

#include "mesher/import/label_image.hpp"
#include "mesher/import/label_pieces.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t most_label_lines = 20;

/// The phase of a label, "" if the key has none.
std::string phase_of_label(const LabelRow& row, const PhaseKey::OfLabels& phases, const std::string& name) {
    const auto by_number = phases.by_number.find(row.label);
    const auto by_colour = row.colour ? phases.by_colour.find(*row.colour) : phases.by_colour.end();
    if (by_number == phases.by_number.end()) return by_colour == phases.by_colour.end() ? "" : by_colour->second;
    if (by_colour != phases.by_colour.end() && by_colour->second != by_number->second) {
        throw InputError(fmt::format("{}: the label {} has the phase {} by its number and {} by its colour {}; give one", name,
                                     row.label, by_number->second, by_colour->second, colour_text(*row.colour)));
    }
    return by_number->second;
}

std::string colour_cell(const LabelRow& row) { return row.colour ? colour_text(*row.colour) : "-"; }

bool is_shade_of_grey(int colour) { return colour % 0x010101 == 0; }

/// True if each label has its own colour and some are not greys.
bool are_told_by_colours(const std::vector<LabelRow>& rows) {
    std::set<int> colours;
    bool are_greys = true;
    for (const LabelRow& row : rows) {
        if (!row.colour || !colours.insert(*row.colour).second) return false;
        are_greys = are_greys && is_shade_of_grey(*row.colour);
    }
    return !are_greys;
}

}  // namespace

std::vector<LabelRow> label_rows(const LabelImage& image, const LabelPieces& pieces, const PhaseKey::OfLabels& phases,
                                 const std::string& name) {
    struct Sum {
        std::int64_t pixels = 0;
        int pieces = 0;
    };
    std::map<int, Sum> sums;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Sum& sum = sums[pieces.label_of_piece[i]];
        sum.pixels += pieces.pixels_of_piece[i];
        ++sum.pieces;
    }
    const double all = static_cast<double>(pieces.width) * pieces.height;
    std::vector<LabelRow> rows;
    for (const auto& [label, sum] : sums) {
        LabelRow& row = rows.emplace_back();
        row.label = label;
        row.colour = image.colour_of(label);
        row.phase = phase_of_label(row, phases, name);
        row.share_of_area = static_cast<double>(sum.pixels) / all;
        row.pieces = sum.pieces;
    }
    std::stable_sort(rows.begin(), rows.end(),
                     [](const LabelRow& l, const LabelRow& r) { return l.share_of_area > r.share_of_area; });
    return rows;
}

std::vector<std::string> describe_labels(const std::vector<LabelRow>& rows) {
    const auto has_phase = [](const LabelRow& row) { return !row.phase.empty(); };
    const bool have_phases = std::any_of(rows.begin(), rows.end(), has_phase);
    const auto line = [&](const std::string& label, const std::string& colour, const std::string& share,
                          const std::string& pieces, const std::string& phase) {
        return fmt::format("  {:>10}  {:<7}  {:>13}  {:>6}{}", label, colour, share, pieces, have_phases ? "  " + phase : "");
    };
    std::vector<std::string> lines{line("label", "colour", "share of area", "pieces", "phase")};
    double rest = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const LabelRow& row = rows[i];
        if (i >= most_label_lines) {
            rest += row.share_of_area;
            continue;
        }
        lines.push_back(line(std::to_string(row.label), colour_cell(row), fmt::format("{:.2f} %", 100 * row.share_of_area),
                             std::to_string(row.pieces), row.phase.empty() ? "-" : row.phase));
    }
    if (rows.size() > most_label_lines) {
        lines.push_back(fmt::format("  and {} smaller ones with {:.2f} % of the area (--write-key FILE has all)",
                                    rows.size() - most_label_lines, 100 * rest));
    }
    return lines;
}

std::string key_of_labels(const std::vector<LabelRow>& rows, const std::string& source) {
    std::string text = fmt::format(
        "# Phases of the labels of {}: replace each {} by the name of a phase (a-z, 0-9, _)\n"
        "key\tphase\tlabel\tcolour\tshare_of_area\tpieces\n",
        printable(source), phase_to_be_named);
    const bool by_colours = are_told_by_colours(rows);
    for (const LabelRow& row : rows) {
        text += fmt::format("{}\t{}\t{}\t{}\t{:.6f}\t{}\n", by_colours ? colour_cell(row) : std::to_string(row.label),
                            row.phase.empty() ? phase_to_be_named : row.phase.c_str(), row.label, colour_cell(row),
                            row.share_of_area, row.pieces);
    }
    return text;
}

}  // namespace graincrack::mesher
