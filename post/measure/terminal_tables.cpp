#include "post/measure/terminal_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "post/run/test_label.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/terminal_table.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

/// Rows of equal title, in the order in which the titles first come.
using Groups = std::vector<std::pair<std::string, std::vector<NamedRow>>>;

Groups grouped(const ScriptTable& table, const std::function<std::string(const NamedRow&)>& title_of) {
    Groups groups;
    for (const std::vector<Cell>& cells : table.rows) {
        const NamedRow row(table.columns, cells);
        const std::string title = title_of(row);
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == title; });
        if (group == groups.end()) group = groups.insert(group, {title, {}});
        group->second.push_back(row);
    }
    return groups;
}

std::string test_of(const NamedRow& row) {
    return series_label(row.text("test"), 1e6 * row.number("confining_pressure_MPa").value_or(0));
}

std::string strength_column(const NamedRow& row) {
    return row.text("tensile_strength_MPa").empty() ? "peak_compressive_stress_MPa" : "tensile_strength_MPa";
}

std::string ending(const NamedRow& row) {
    const std::string& kind = row.text("peak_kind");
    return kind == "drop" ? "peak" : kind == "cap" ? "strain limit" : "stopped";
}

std::string contacts(const NamedRow& row, const std::string& column) {
    const auto count = row.number(column);
    return count ? whole_contacts(*count) : "";
}

std::string mean_label(const Sample& strengths) {
    return fmt::format("mean of {}, s.d. {}", strengths.n, format_number(strengths.deviation.value_or(0), 2));
}

}  // namespace

void write_strengths_to_terminal(std::ostream& out, const ScriptTable& table) {
    TerminalTable people({{"run", ""},
                          {"seed", ""},
                          {"grains", ""},
                          {"mean edge", "mm"},
                          {"strength", "MPa"},
                          {"at strain", "%"},
                          {"ended by", ""},
                          {"tensile", "cracks"},
                          {"shear", "cracks"}});
    const auto title = [](const NamedRow& row) { return test_of(row) + ", plane " + row.text("plane"); };
    for (const auto& [name, rows] : grouped(table, title)) {
        people.group(name);
        std::vector<double> strengths;
        for (const NamedRow& row : rows) {
            const std::string strength = strength_column(row);
            strengths.push_back(row.number(strength).value_or(0));
            people.row({row.text("file"), row.text("seed"), row.text("grains"), row.shown("mean_edge_mm"), row.shown(strength),
                        row.shown("strain_at_peak", 100), ending(row), contacts(row, "tensile_cracks"),
                        contacts(row, "shear_cracks")});
        }
        if (strengths.size() < 2) continue;
        const Sample all = sample(strengths);
        people.row({mean_label(all), " ", " ", " ", format_number(all.mean.value, 4), " ", " ", " ", " "});
    }
    people.write(out);
}

void write_summary_to_terminal(std::ostream& out, const ScriptTable& table) {
    TerminalTable people({{"test", ""},
                          {"plane", ""},
                          {"edge", "mm"},
                          {"runs", ""},
                          {"without peak", ""},
                          {"strength", "MPa"},
                          {"s.d.", "MPa"},
                          {"95 % interval of the mean", "MPa"},
                          {"over Brazilian", ""}});
    for (const std::vector<Cell>& cells : table.rows) {
        const NamedRow row(table.columns, cells);
        const std::string low = row.shown("strength_low_MPa");
        people.row({test_of(row), row.text("plane"), row.shown("mean_edge_mm"), row.text("runs"), row.text("runs_without_peak"),
                    row.shown("strength_MPa"), row.shown("strength_deviation_MPa"),
                    low.empty() ? "" : low + " to " + row.shown("strength_high_MPa"), row.shown("ratio_to_brazilian")});
    }
    people.write(out);
}

void write_moduli_to_terminal(std::ostream& out, const ScriptTable& table) {
    TerminalTable people({{"run", ""},
                          {"E", "GPa"},
                          {"ν", ""},
                          {"E in the plane", "GPa"},
                          {"ν in the plane", ""},
                          {"E by platens", "GPa"},
                          {"E predicted", "GPa"},
                          {"ν predicted", ""},
                          {"E Voigt", "GPa"},
                          {"E Reuss", "GPa"},
                          {"crack initiation", "MPa"},
                          {"crack damage", "MPa"}});
    const auto title = [](const NamedRow& row) {
        return "plane " + row.text("plane") +
               (row.text("plane") == "strain" ? ": E and ν are material values, converted from those in the plane" : "");
    };
    for (const auto& [name, rows] : grouped(table, title)) {
        people.group(name);
        for (const NamedRow& row : rows) {
            people.row({row.text("file"), row.shown("young_modulus_GPa"), row.shown("poisson_ratio"),
                        row.shown("plane_young_modulus_GPa"), row.shown("plane_poisson_ratio"),
                        row.shown("platen_young_modulus_GPa"), row.shown("predicted_young_modulus_GPa"),
                        row.shown("predicted_poisson_ratio"), row.shown("voigt_young_modulus_GPa"),
                        row.shown("reuss_young_modulus_GPa"), row.shown("crack_initiation_count_MPa"),
                        row.shown("crack_damage_2d_MPa")});
        }
    }
    people.write(out);
    for (const std::vector<Cell>& cells : table.rows) {
        const NamedRow row(table.columns, cells);
        if (!row.text("warning").empty()) out << row.text("file") << ": warning: " << row.text("warning") << '\n';
    }
}

}  // namespace graincrack
