#include "post/report/quality_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "post/measure/strength_summary.hpp"
#include "post/report/html.hpp"
#include "post/run/test_label.hpp"
#include "solver/law/table.hpp"

namespace graincrack {

namespace {

using html::number;

std::string law_label(const RunSettings& header) {
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
    if (!h.description().is_confined) return "";
    return fmt::format("{} ± {} MPa of {}", number(h.confinement_mean * 1e-6), number(h.confinement_deviation * 1e-6, 2),
                       number(h.confining_pressure * 1e-6));
}

std::string ending_label(const TestReport& t) {
    return t.strength.peak_kind.empty() ? "stopped (" + t.data.header.stop_reason + ")" : t.strength.peak_kind;
}

std::string rate_label(const RunSettings& h) {
    if (h.rate == "auto") return "automatic, tolerance " + number(h.rate_tolerance);
    return h.rate == "blocks" ? "blocks" : "constant";
}

std::string damping_label(const RunSettings& h) { return h.damping > 0 ? number(h.damping) + ", " + h.damping_form : "none"; }

/// The settings that change the peak most, if the run was made with --sensitivity.
std::string sensitivity_label(const TestReport& t) {
    std::string label;
    for (std::size_t i = 1; i < t.sensitivity.size(); ++i) {
        const SensitivityRow& row = t.sensitivity[i];
        const double change = row.peak_axial_stress / t.sensitivity[0].peak_axial_stress - 1;
        label += (label.empty() ? "" : "; ") + row.changed + " " +
                 (std::isfinite(change) ? fmt::format("{:+.1f} %", 100 * change) : std::string("failed"));
    }
    return label.empty() ? "not tested (--sensitivity)" : label;
}

using Runs = std::vector<const TestReport*>;

/// A row of the checks: its cell for comparable runs; "" where it does not apply.
struct Check {
    const char* name;
    std::function<std::string(const Runs&)> cell;
};

std::string range_label(double low, double high, const std::string& unit) {
    const std::string least = number(low, 3);
    const std::string most = number(high, 3);
    if (most.empty()) return "";
    return (least == most ? most : least + " to " + most) + unit;
}

/// The different texts of runs, a line each.
std::function<std::string(const Runs&)> texts(std::string (*label)(const TestReport&)) {
    return [label](const Runs& runs) {
        std::vector<std::string> lines;
        for (const TestReport* run : runs) {
            const std::string own = label(*run);
            if (!own.empty() && std::find(lines.begin(), lines.end(), own) == lines.end()) lines.push_back(own);
        }
        return fmt::format("{}", fmt::join(lines, "\n"));
    };
}

/// The range of a number of runs with its unit; NaN: it does not apply.
std::function<std::string(const Runs&)> range(const std::function<double(const TestReport&)>& value, const char* unit = "") {
    return [value, unit](const Runs& runs) {
        double low = std::nan("");
        double high = std::nan("");
        for (const TestReport* run : runs) {  // fmin and fmax pass over NaN
            low = std::fmin(low, value(*run));
            high = std::fmax(high, value(*run));
        }
        return range_label(low, high, unit);
    };
}

/// "2 to 5 : 10 to 12": ranges of numbers of tensile and shear contacts over runs.
std::function<std::string(const Runs&)> contacts(CrackBalance TestReport::*balance) {
    return [balance](const Runs& runs) {
        std::string label;
        for (double ModeCounts::*mode : {&ModeCounts::tensile, &ModeCounts::shear}) {
            const auto of = [&](const TestReport* run) { return (run->*balance).*mode; };
            const auto [low, high] =
                std::minmax_element(runs.begin(), runs.end(), [&](const auto* a, const auto* b) { return of(a) < of(b); });
            const std::string least = whole_contacts(of(*low));
            const std::string most = whole_contacts(of(*high));
            label += (label.empty() ? "" : " : ") + (least == most ? most : least + " to " + most);
        }
        return label;
    };
}

/// Length of the zone in which a contact softens over the mean edge, and whether grains resolve it.
std::string contact_zone_label(const Runs& runs) {
    const auto of = [](const TestReport* run) { return run->contact_zone_length / run->data.specimen.mean_edge; };
    const auto [least, most] =
        std::minmax_element(runs.begin(), runs.end(), [&](const auto* a, const auto* b) { return of(a) < of(b); });
    return range_label(of(*least), of(*most), of(*least) < 1 ? " (not resolved: below one edge)" : "");
}

/// Caveats of the strengths of runs of one kind, and the number of runs that have each.
std::string caveats_label(const Runs& runs) {
    std::vector<std::pair<std::string, std::size_t>> kinds;
    for (const TestReport* run : runs) {
        for (const Caveat& caveat : run->caveats) {
            auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == caveat.kind; });
            if (kind == kinds.end()) kind = kinds.insert(kind, {caveat.kind, 0});
            ++kind->second;
        }
    }
    std::string label;
    for (const auto& [kind, n] : kinds) {
        label += (label.empty() ? "" : "\n") + fmt::format("{} ({} of {})", kind, n, counted(runs.size(), "run"));
    }
    return label;
}

const std::vector<Check>& checks() {
    const auto percent_of = [](auto share) {
        return range([share](const TestReport& t) { return 100 * t.data.header.*share; }, "\u00a0%");
    };
    using T = const TestReport&;
    using H = RunHeader;
    static const std::vector<Check> all{
        {"the curve ended by", texts(ending_label)},
        {"contact law", texts([](T t) { return law_label(t.data.header); })},
        {"plane", texts([](T t) { return std::string(name_of(t.data.header.plane)); })},
        {"error of the energy balance, of the largest stored energy", percent_of(&H::energy_balance_error)},
        {"non-conservative work of the law, of the largest stored energy", range(non_conservative_percent, "\u00a0%")},
        {"share of the work that damping absorbed", percent_of(&H::damping_share)},
        {"load that damping carries before the peak", percent_of(&H::damping_load)},
        {"platen forces differ by, ½ peak to peak", percent_of(&H::platen_force_difference)},
        {"confinement achieved, mean ± s.d.", texts(confinement_label)},
        {"contact zone over mean edge", contact_zone_label},
        {"tensile : shear cracks at the strength", contacts(&TestReport::at_peak)},
        {"tensile : shear cracks by the end", contacts(&TestReport::at_end)},
        {"what counts as a crack", texts([](T t) { return t.crack_definition; })},
        {"separated by the end", range([](T t) { return std::ceil(t.at_end.separated); })},
        {"rate of loading", texts([](T t) { return rate_label(t.data.header); })},
        {"platen speed, mean", range([](T t) { return 1e3 * t.data.header.platen_speed; }, "\u00a0mm/s")},
        {"damping", texts([](T t) { return damping_label(t.data.header); })},
        {"mass scaling", texts([](T t) { return t.data.header.mass_scaling; })},
        {"factor of mass scaling",
         range([](T t) { return t.data.header.mass_scaling == "none" ? std::nan("") : t.data.header.mass_scaling_factor; })},
        {"mass added", percent_of(&H::added_mass)},
        {"sensitivity of the peak", texts(sensitivity_label)},
        {"caveats of the strength", caveats_label}};
    return all;
}

/// Columns of the checks: comparable runs.
std::vector<std::pair<std::string, Runs>> columns_of(const std::vector<TestReport>& tests) {
    std::vector<std::pair<std::string, Runs>> columns;
    for (const SeedGroup& group : seed_groups(tests)) {
        auto& [name, runs] = columns.emplace_back(group.name(), Runs{});
        for (const std::size_t i : group.indices) runs.push_back(&tests[i]);
        if (runs.size() > 1) name += fmt::format(" ({} runs)", runs.size());
    }
    return columns;
}

std::string common_paragraphs(const std::vector<TestReport>& tests) {
    const Rock& rock = tests.front().data.header.rock;
    const auto without_peak =
        std::count_if(tests.begin(), tests.end(), [](const TestReport& t) { return !t.strength.has_peak(); });
    std::string paragraphs = html::paragraph(
        fmt::format("Density {} kg/m³ is an input of the material file; plane models 1 m thick; grains are elastic and do not "
                    "crush; platens are rigid.",
                    number(rock.density)));
    if (without_peak > 0) {
        paragraphs +=
            html::paragraph(fmt::format("{} of {} did not fail: their largest stress is no strength, and no mean has it.",
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
        std::vector<std::string> cells;
        for (const auto& [name, runs] : columns) cells.push_back(check.cell(runs));
        const bool same = std::all_of(cells.begin(), cells.end(), [&](const std::string& cell) { return cell == cells.front(); });
        if (same && cells.front().empty()) continue;
        if (same) {
            table.row({check.name, cells.front()});
        } else {
            cells.insert(cells.begin(), check.name);
            table.row(std::move(cells));
        }
    }
    return "<div class=\"checks\">\n" + common_paragraphs(tests) + table.str() + "</div>\n";
}

}  // namespace graincrack
