#include "post/report/quality_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "post/measure/test_label.hpp"
#include "post/report/html.hpp"
#include "solver/law/table.hpp"

namespace graincrack {

namespace {

using html::number;

std::string percent(double share) { return number(100 * share, 3) + "\u00a0%"; }

/// Names of the tests for the heads of columns: the names of files of a set show in what they differ.
std::string short_name(const TestReport& t) { return std::filesystem::path(t.data.name).stem().string(); }

std::string law_label(const RunHeader& header) {
    const auto& laws = all_contact_laws();
    const auto law =
        std::find_if(laws.begin(), laws.end(), [&](const LawDescription& d) { return d.name == header.contact_law; });
    const std::string potential = law == laws.end() ? "unknown to this build"
                                  : law->potential  ? "has a potential"
                                                    : "no potential";
    return header.contact_law + ", " + potential;
}

double non_conservative_percent(const TestReport& t) {
    const double scale = t.data.header.energy_scale;
    return scale > 0 ? 100 * t.data.history[HistoryColumn::non_conservative_work].back() / scale : std::nan("");
}

std::string confinement_label(const TestReport& t) {
    const RunHeader& h = t.data.header;
    if (h.test != "triaxial") return "";
    return fmt::format("{} ± {} MPa of {}", number(h.confinement_mean * 1e-6), number(h.confinement_deviation * 1e-6, 2),
                       number(h.confining_pressure * 1e-6));
}

std::string ending_label(const TestReport& t) {
    return t.strength.peak_kind.empty() ? "stopped (" + t.data.header.stop_reason + ")" : t.strength.peak_kind;
}

std::string sliding_label(const CrackBalance& b) {
    const auto share = b.share_more_sliding();
    return share
               ? fmt::format("{} of {} ({})", whole_contacts(b.tensile_more_sliding), whole_contacts(b.tensile), percent(*share))
               : "no tensile cracks";
}

std::string pair_label(double one, double other) { return whole_contacts(one) + " : " + whole_contacts(other); }

std::string mode_label(const std::optional<ModeCounts>& counts) {
    return counts ? pair_label(counts->tensile, counts->shear) : "not recorded";
}

std::string rate_label(const RunHeader& h) {
    const std::string speed = number(h.platen_speed * 1e3) + " mm/s";
    if (h.rate == "auto") return "automatic, tolerance " + number(h.rate_tolerance) + ", mean " + speed;
    return h.rate == "blocks" ? "blocks, " + speed + " within" : speed;
}

std::string damping_label(const RunHeader& h) { return h.damping > 0 ? number(h.damping) + ", " + h.damping_form : "none"; }

std::string scaling_label(const RunHeader& header) {
    if (header.mass_scaling == "none") return "none";
    return header.mass_scaling + ", " + number(header.mass_scaling_factor) + "; mass added " + number(100 * header.added_mass) +
           " %";
}

/// The settings that change the peak most, if the run was made with --sensitivity.
std::string sensitivity_label(const TestReport& t) {
    std::string label;
    for (std::size_t i = 1; i < t.sensitivity.size(); ++i) {
        const SensitivityRow& row = t.sensitivity[i];
        const double change = row.peak_axial_stress / t.sensitivity[0].peak_axial_stress - 1;
        label += (label.empty() ? "" : "; ") + row.changed + " " +
                 (std::isfinite(change) ? fmt::format("{:+.1f} %", 100 * change) : std::string("failed"));
    }
    return label.empty() ? "not asked for (--sensitivity)" : label;
}

/// A row of the checks: a text, or a number with its unit, of each run. NaN: does not apply.
struct Check {
    const char* name;
    std::function<std::string(const TestReport&)> label;
    std::function<double(const TestReport&)> value = nullptr;
    const char* unit = "";
};

std::string range_label(double low, double high, const std::string& unit) {
    const std::string least = number(low, 3);
    const std::string most = number(high, 3);
    if (most.empty()) return "";
    return (least == most ? most : least + " to " + most) + unit;
}

/// The result of a check over some runs: the range of a number, or the different texts, a line each.
std::string cell_of(const Check& check, const std::vector<const TestReport*>& runs) {
    if (check.value) {
        double low = std::nan("");
        double high = std::nan("");
        for (const TestReport* run : runs) {  // fmin and fmax pass over NaN
            low = std::fmin(low, check.value(*run));
            high = std::fmax(high, check.value(*run));
        }
        return range_label(low, high, check.unit);
    }
    std::vector<std::string> lines;
    for (const TestReport* run : runs) {
        const std::string label = check.label(*run);
        if (!label.empty() && std::find(lines.begin(), lines.end(), label) == lines.end()) lines.push_back(label);
    }
    return fmt::format("{}", fmt::join(lines, "\n"));
}

const std::vector<Check>& checks() {
    const auto percent_of = [](double RunHeader::*share) {
        return [share](const TestReport& t) { return 100 * t.data.header.*share; };
    };
    static const std::vector<Check> all{
        {"test", [](const TestReport& t) { return series_label(t.data.header.test, t.data.header.confining_pressure); }},
        {"the curve ended by", ending_label},
        {"contact law", [](const TestReport& t) { return law_label(t.data.header); }},
        {"plane", [](const TestReport& t) { return std::string(name_of(t.data.header.plane)); }},
        {"energy balance residual, of peak stored energy", nullptr, percent_of(&RunHeader::energy_balance_error), "\u00a0%"},
        {"non-conservative work of the law, of peak stored energy", nullptr, non_conservative_percent, "\u00a0%"},
        {"share of the work that damping took", nullptr, percent_of(&RunHeader::damping_share), "\u00a0%"},
        {"load that damping carries before the peak", nullptr, percent_of(&RunHeader::damping_load), "\u00a0%"},
        {"platen forces differ by, ½ peak to peak", nullptr, percent_of(&RunHeader::platen_force_difference), "\u00a0%"},
        {"confinement achieved, mean ± s.d.", confinement_label},
        {"contact zone over mean edge", nullptr,
         [](const TestReport& t) { return t.contact_zone_length / t.data.specimen.mean_edge; }},
        {"tensile : shear cracks at the peak",
         [](const TestReport& t) { return pair_label(t.at_peak.tensile, t.at_peak.shear); }},
        {"tensile cracks with more sliding than opening, at the peak",
         [](const TestReport& t) { return sliding_label(t.at_peak); }},
        {"failed open : closed, by the end", [](const TestReport& t) { return pair_label(t.branches.open, t.branches.closed); }},
        {"opened more than slid : not, when they failed, by the end",
         [](const TestReport& t) { return mode_label(t.failed_by_displacement); }},
        {"broken open : closed, by the end", [](const TestReport& t) { return mode_label(t.broken); }},
        {"opened more than slid : not, when they broke, by the end",
         [](const TestReport& t) { return mode_label(t.broken_by_displacement); }},
        {"by traction angle < 45° : 45–90° : compressed",
         [](const TestReport& t) {
             return pair_label(t.branches.by_tension, t.branches.by_shear) + " : " + whole_contacts(t.branches.compressed);
         }},
        {"separated by the end", nullptr, [](const TestReport& t) { return std::ceil(t.branches.separated); }},
        {"platen speed", [](const TestReport& t) { return rate_label(t.data.header); }},
        {"damping", [](const TestReport& t) { return damping_label(t.data.header); }},
        {"mass scaling", [](const TestReport& t) { return scaling_label(t.data.header); }},
        {"sensitivity of the peak", [](const TestReport& t) { return sensitivity_label(t); }},
        {"speaks against the strength", [](const TestReport& t) {
             std::string lines;
             for (const Objection& objection : t.objections) {
                 lines += (lines.empty() ? "" : "\n") + short_name(t) + ": " + objection.text;
             }
             return lines;
         }}};
    return all;
}

/// Columns of the checks: runs, or, where these are many, runs of one test and confining pressure.
std::vector<std::pair<std::string, std::vector<const TestReport*>>> columns_of(const std::vector<TestReport>& tests) {
    constexpr std::size_t max_runs = 4;  // beside the names of the checks within the width of the page
    std::vector<std::pair<std::string, std::vector<const TestReport*>>> columns;
    for (const TestReport& t : tests) {
        const RunHeader& h = t.data.header;
        const std::string head = tests.size() <= max_runs ? short_name(t) : series_label(h.test, h.confining_pressure);
        auto column = columns.end();
        if (tests.size() > max_runs) {
            column = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.first == head; });
        }
        if (column == columns.end()) column = columns.insert(column, {head, {}});
        column->second.push_back(&t);
    }
    for (auto& [head, runs] : columns) {
        if (runs.size() > 1) head += fmt::format(" ({} runs)", runs.size());
    }
    return columns;
}

std::string common_paragraphs(const std::vector<TestReport>& tests) {
    const Rock& rock = tests.front().data.header.rock;
    const auto without_peak =
        std::count_if(tests.begin(), tests.end(), [](const TestReport& t) { return t.strength.peak_kind != "drop"; });
    std::string paragraphs = html::paragraph(
        fmt::format("Density {} kg/m³ is an input of the material file; plane models 1 m thick; grains are elastic and do not "
                    "crush; platens are rigid.",
                    number(rock.density)));
    if (without_peak > 0) {
        paragraphs += html::paragraph(fmt::format("{} of {} reached no peak: a largest stress without one is no strength.",
                                                  without_peak, counted(tests.size(), "run")));
    }
    return paragraphs;
}

}  // namespace

std::string quality_checks(const std::vector<TestReport>& tests) {
    const auto columns = columns_of(tests);
    std::vector<std::string> head{"check"};
    for (const auto& [name, runs] : columns) head.push_back(name);
    html::Table table(head);
    for (const Check& check : checks()) {
        std::vector<std::string> row{check.name};
        for (const auto& [name, runs] : columns) row.push_back(cell_of(check, runs));
        const bool any = std::any_of(row.begin() + 1, row.end(), [](const std::string& cell) { return !cell.empty(); });
        if (any) table.row(std::move(row));
    }
    return "<div class=\"checks\">\n" + common_paragraphs(tests) + table.str() + "</div>\n";
}

}  // namespace graincrack
