#include "post/report/trust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "post/report/html.hpp"
#include "post/test_words.hpp"
#include "solver/law/table.hpp"

namespace graincrack {

namespace {

using html::number;

std::string percent(double share) { return number(100 * share, 3) + " %"; }

/// Names of the tests for the heads of columns: files of a set differ in what matters.
std::string short_name(const TestReport& t) { return std::filesystem::path(t.data.name).stem().string(); }

std::string law_words(const RunHeader& header) {
    const auto& laws = all_contact_laws();
    const auto law =
        std::find_if(laws.begin(), laws.end(), [&](const LawDescription& d) { return d.name == header.contact_law; });
    const std::string potential = law == laws.end() ? "unknown to this build"
                                  : law->potential  ? "has a potential"
                                                    : "no potential";
    return header.contact_law + ", " + potential;
}

std::string mismatch_words(const TestReport& t) {
    const double lost = t.data.history[HistoryColumn::law_mismatch].back();
    return t.data.header.energy_scale > 0 ? percent(lost / t.data.header.energy_scale) : "";
}

std::string confinement_words(const TestReport& t) {
    const RunHeader& h = t.data.header;
    if (h.test != "triaxial") return "";
    return fmt::format("{} ± {} MPa of {}", number(h.confinement_mean * 1e-6), number(h.confinement_deviation * 1e-6, 2),
                       number(h.confining_pressure * 1e-6));
}

std::string ending_words(const TestReport& t) {
    return t.strength.peak_kind.empty() ? "stopped (" + t.data.header.stop_reason + ")" : t.strength.peak_kind;
}

std::string sliding_words(const CrackBalance& b) {
    const auto share = b.share_more_sliding();
    return share ? fmt::format("{} of {} ({})", b.tensile_more_sliding, b.tensile, percent(*share)) : "no tensile cracks";
}

std::string rate_words(const RunHeader& h) {
    const std::string speed = number(h.platen_speed * 1e3) + " mm/s";
    if (h.rate == "auto") return "automatic, tolerance " + number(h.rate_tolerance) + ", mean " + speed;
    return h.rate == "blocks" ? "blocks, " + speed + " within" : speed;
}

std::string scaling_words(const RunHeader& header) {
    if (header.mass_scaling == "none") return "none";
    return header.mass_scaling + ", " + number(header.mass_scaling_factor);
}

/// What moves the peak most, if the run was asked.
std::string sensitivity_words(const TestReport& t) {
    std::string words;
    for (std::size_t i = 1; i < t.sensitivity.size(); ++i) {
        const SensitivityRow& row = t.sensitivity[i];
        const double change = row.peak_axial_stress / t.sensitivity[0].peak_axial_stress - 1;
        words += (words.empty() ? "" : "; ") + row.changed + " " +
                 (std::isfinite(change) ? fmt::format("{:+.1f} %", 100 * change) : std::string("failed"));
    }
    return words.empty() ? "not asked for (--sensitivity)" : words;
}

struct Check {
    const char* words;
    std::function<std::string(const TestReport&)> value;
};

const std::vector<Check>& checks() {
    static const std::vector<Check> all{
        {"test", [](const TestReport& t) { return series_words(t.data.header.test, t.data.header.confining_pressure); }},
        {"the curve ended by", ending_words},
        {"contact law", [](const TestReport& t) { return law_words(t.data.header); }},
        {"plane", [](const TestReport& t) { return std::string(name_of(t.data.header.plane)); }},
        {"ledger residual, of peak stored energy", [](const TestReport& t) { return percent(t.data.header.ledger_residual); }},
        {"law mismatch, of peak stored energy", mismatch_words},
        {"share of the work that damping took", [](const TestReport& t) { return percent(t.data.header.damping_share); }},
        {"platen forces differ by, ½ peak to peak",
         [](const TestReport& t) { return percent(t.data.header.platen_force_difference); }},
        {"confinement achieved, mean ± s.d.", confinement_words},
        {"contact zone over mean edge",
         [](const TestReport& t) { return number(t.contact_zone_length / t.data.specimen.mean_edge, 3); }},
        {"tensile : shear cracks at the peak",
         [](const TestReport& t) { return fmt::format("{} : {}", t.at_peak.tensile, t.at_peak.shear); }},
        {"tensile cracks with more sliding than opening, at the peak",
         [](const TestReport& t) { return sliding_words(t.at_peak); }},
        {"failed open : closed, by the end",
         [](const TestReport& t) { return fmt::format("{} : {}", t.branches.open, t.branches.closed); }},
        {"by traction angle < 45° : 45–90° : compressed",
         [](const TestReport& t) {
             return fmt::format("{} : {} : {}", t.branches.by_tension, t.branches.by_shear, t.branches.compressed);
         }},
        {"separated by the end", [](const TestReport& t) { return fmt::format("{}", t.branches.separated); }},
        {"platen speed", [](const TestReport& t) { return rate_words(t.data.header); }},
        {"damping", [](const TestReport& t) { return number(t.data.header.damping); }},
        {"mass scaling", [](const TestReport& t) { return scaling_words(t.data.header); }},
        {"sensitivity of the peak", [](const TestReport& t) { return sensitivity_words(t); }},
        {"warning", [](const TestReport& t) { return t.split ? t.split->warning : std::string(); }}};
    return all;
}

std::string common_words(const std::vector<TestReport>& tests) {
    const Rock& rock = tests.front().data.header.rock;
    const auto without_peak =
        std::count_if(tests.begin(), tests.end(), [](const TestReport& t) { return t.strength.peak_kind != "drop"; });
    std::string words = html::paragraph(
        fmt::format("Density {} kg/m³ is an input of the material file; plane models 1 m thick; grains are elastic and do not "
                    "crush; platens are rigid.",
                    number(rock.density)));
    if (without_peak > 0) {
        words += html::paragraph(
            fmt::format("{} of {} runs reached no peak: their largest stress is no strength.", without_peak, tests.size()));
    }
    return words;
}

}  // namespace

std::string trust_block(const std::vector<TestReport>& tests) {
    std::vector<std::string> head{"check"};
    for (const TestReport& t : tests) head.push_back(short_name(t));
    html::Table table(head);
    for (const Check& check : checks()) {
        std::vector<std::string> row{check.words};
        for (const TestReport& t : tests) row.push_back(check.value(t));
        const bool any = std::any_of(row.begin() + 1, row.end(), [](const std::string& cell) { return !cell.empty(); });
        if (any) table.row(std::move(row));
    }
    return "<div class=\"trust\">\n" + common_words(tests) + table.str() + "</div>\n";
}

}  // namespace graincrack
