#include "post/commands/commands.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "post/calibrate/folder.hpp"
#include "post/chart/drawing.hpp"
#include "post/chart/font.hpp"
#include "post/chart/page.hpp"
#include "post/chart/picture.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

/// A cell: positive values are red, negative blue, the stronger the larger; faint ones have no colour.
struct HeatCell {
    double value = 0;
    std::string text;
    bool faint = false;
};

constexpr double row_height = 44;
constexpr double letter_size = 22;
constexpr double gap = 14;

Colour blended(Colour strongest, double share) {
    const auto part = [&](std::uint8_t c) { return static_cast<std::uint8_t>(std::lround(255 + share * (c - 255))); };
    return {part(strongest.red), part(strongest.green), part(strongest.blue)};
}

/// \param cells a row for each name of `rows`, as long as `columns`; the strongest colour is that of 1
Drawing draw_heat_map(const std::string& title, const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                      const std::vector<std::vector<HeatCell>>& cells) {
    const double page_width = PictureStyle().page_width;
    double names = 0;
    for (const std::string& row : rows) names = std::max(names, text_width(row, letter_size));
    const double left = names + 2 * gap;
    const double width = (page_width - left - gap) / static_cast<double>(std::max<std::size_t>(columns.size(), 1));
    const double top = 3 * row_height;
    Drawing drawing(static_cast<int>(page_width), static_cast<int>(top + row_height * static_cast<double>(rows.size()) + gap));
    drawing.text({{gap, row_height}, title, letter_size, palette::ink, Anchor::start, true});
    for (std::size_t k = 0; k < columns.size(); ++k) {
        // Names that are wider than their columns stand on two lines by turns, and stay on the page.
        const double y = top - gap - (k % 2 == 0 ? 0 : 0.7 * row_height);
        const double half = 0.5 * text_width(columns[k], letter_size);
        const double x = std::min(left + (static_cast<double>(k) + 0.5) * width, page_width - gap - half);
        drawing.text({{x, y}, columns[k], letter_size, palette::ink, Anchor::middle});
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = top + row_height * static_cast<double>(i);
        drawing.text({{left - gap, y + 0.7 * row_height}, rows[i], letter_size, palette::ink, Anchor::end});
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const HeatCell& cell = cells[i][k];
            const double share = cell.faint ? 0 : std::min(1.0, std::abs(cell.value));
            const double x = left + width * static_cast<double>(k);
            drawing.rectangle({x + 1, y + 1}, {x + width - 1, y + row_height - 1},
                              blended(cell.value > 0 ? palette::tensile : palette::pre_existing, 0.75 * share));
            drawing.text({{x + 0.5 * width, y + 0.7 * row_height},
                          with_minus(cell.text),
                          letter_size,
                          cell.faint ? palette::rim : palette::ink,
                          Anchor::middle});
        }
    }
    return drawing;
}

struct CalibrateOptions {
    std::string material;
    std::vector<std::string> settings;
    std::size_t jobs = 1;
};

/// "50 s", "24 min", "1.9 h".
std::string duration_text(double seconds) {
    if (seconds < 99.5) return fmt::format("{:.0f} s", seconds);
    return seconds < 5970 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

/// Response by response, a row each. \pre each response has all parameters
void write_heat_map(const std::string& file, const std::vector<calibrate::Sensitivity>& all) {
    std::vector<std::string> rows;
    std::vector<std::string> columns;
    std::vector<std::vector<HeatCell>> cells;
    for (const calibrate::Sensitivity& s : all) {
        if (rows.empty() || rows.back() != s.response) {
            rows.push_back(s.response);
            cells.emplace_back();
        }
        if (rows.size() == 1) {
            const std::size_t table = s.parameter.find("contact.") == 0 ? 8 : 0;
            columns.push_back(s.parameter.substr(table));
            std::replace(columns.back().begin(), columns.back().end(), '_', ' ');
        }
        cells.back().push_back({s.exponent.value, fmt::format("{:.2f}", s.exponent.value), !s.is_significant()});
    }
    write_picture(draw_heat_map("d ln response / d ln parameter; white: the 95 % interval contains 0", rows, columns, cells),
                  file);
}

void write_decision(const CalibrateOptions& options, const Call& call) {
    using calibrate::Ending;
    const std::string& folder = call.file();
    const auto [decision, requested_time, sensitivities] =
        calibrate::calibrate_folder(folder, options.material, options.settings, call.diagnostics());
    if (!sensitivities.empty()) write_heat_map(folder + "/identify.png", sensitivities);
    if (decision.ending == Ending::requested) {
        fmt::print(call.out, "{}/wanted.tsv\n", folder);
        const std::size_t n = decision.requested.size();
        const double by_the_clock = requested_time / static_cast<double>(std::min<std::size_t>(options.jobs, n));
        const std::string time = requested_time > 0 ? fmt::format(" (about {} of processor time, {} by the clock)",
                                                                  duration_text(requested_time), duration_text(by_the_clock))
                                                    : "";
        say(call.diagnostics(), fmt::format("graincrack-post: calibrate: {} {} wanted{}: {}", n, n == 1 ? "run is" : "runs are",
                                            time, decision.reason));
        return;
    }
    if (decision.ending == Ending::calibrated) {
        fmt::print(call.out, "{}/calibrated.toml\n", folder);
        return;
    }
    throw NumericalError(fmt::format("calibrate: {}: {}: {}; next: {}; {}/report.md has every step{}", folder,
                                     calibrate::label_of(decision.ending), decision.reason, decision.next, folder,
                                     decision.point.empty() ? "" : ", nearest.toml has the nearest point"));
}

}  // namespace

Command calibrate_command() {
    return make_command<CalibrateOptions>(
        "calibrate", "the next runs of a calibration, or the calibrated material; starts no runs itself",
        {"results/my-rock", "results/my-rock --material augig-granite --set zooms=2"},
        FileArguments{"folder", "folder with strength.tsv, moduli.tsv and toughness.tsv of the finished runs"},
        [](OptionSet set, CalibrateOptions& options) {
            add_text(set, "--material", options.material,
                     "material with [targets], [parameters] and [study], or with [laboratory] alone: a name of "
                     "share/materials or a TOML file; default: FOLDER/material.toml")
                .type_name("FILE");
            add_texts(set, "--set", options.settings, "KEY=VALUE", "new value of a key of [study]; may be given again");
            add_integer<std::size_t>(set, "--jobs", options.jobs, "runs side by side, by which the time is estimated", 1, 10000);
        },
        &write_decision);
}

}  // namespace graincrack
