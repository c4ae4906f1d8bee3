#include "post/measure/strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "post/measure/caveats.hpp"
#include "post/measure/terminal_tables.hpp"
#include "post/run/mode_counts.hpp"
#include "post/run/run_state.hpp"
#include "share/base/error.hpp"
#include "share/base/printable.hpp"

namespace graincrack {

namespace {

const std::vector<std::string> first_columns{"file",
                                             "test",
                                             "seed",
                                             "grains",
                                             "mean_edge_mm",
                                             "confining_pressure_MPa",
                                             "peak_compressive_stress_MPa",
                                             "tensile_strength_MPa",
                                             "strain_at_peak",
                                             "peak_kind",
                                             "first_yield_MPa",
                                             "tensile_cracks",
                                             "shear_cracks",
                                             "energy_balance_error",
                                             "platen_force_difference",
                                             "steps",
                                             "wall_time_s",
                                             "ns_per_grain_step",
                                             "stress_at_1_percent_MPa",
                                             "stress_at_2_percent_MPa",
                                             "stress_at_3_percent_MPa",
                                             "spanning_strength_MPa",
                                             "first_crack_radius_over_R",
                                             "loading_arc_deg",
                                             "warning",
                                             "achieved_confining_pressure_MPa",
                                             "contact_law",
                                             "contact_tensile_strength_MPa",
                                             "contact_cohesion_MPa",
                                             "contact_friction_angle_deg",
                                             "damping_load",
                                             "first_peak_MPa",
                                             "residual_MPa",
                                             "drop_percent",
                                             "rehardening_GPa",
                                             "contact_fracture_energy_J/m2",
                                             "contact_open_shear_strength_MPa",
                                             "grain_young_modulus_GPa",
                                             "grain_poisson_ratio",
                                             "max_strain",
                                             "rate_tolerance"};
std::vector<std::string> all_columns() {
    std::vector<std::string> columns = first_columns;
    columns.insert(columns.end(), label_columns().begin(), label_columns().end());
    columns.emplace_back("plane");
    return columns;
}

constexpr double degree = std::numbers::pi / 180;

Cell megapascal(const std::optional<double>& pascal) { return pascal ? Cell(*pascal * 1e-6) : Cell(); }

/// The columns of a Brazilian test, empty for others. \return the split, empty for others
std::optional<BrazilianSplit> append_split(std::vector<Cell>& row, const RunReader& reader, const RunData& run) {
    if (run.header.test != "brazilian") {
        row.insert(row.end(), 4, Cell());
        return std::nullopt;
    }
    const Specimen specimen = reader.specimen();
    BrazilianSplit split = measure_split(run, load_curve(run), specimen, read_cracks(reader, specimen));
    row.push_back(megapascal(split.spanning_stress));
    row.push_back(cell(split.first_crack_radius));
    row.emplace_back(specimen.loading_arc / degree);
    row.emplace_back(split.warning());
    return split;
}

void append_first_peak(std::vector<Cell>& row, const std::optional<FirstPeak>& peak) {
    row.push_back(peak ? Cell(peak->stress * 1e-6) : Cell());
    row.push_back(peak ? megapascal(peak->residual) : Cell());
    row.push_back(peak && peak->drop ? Cell(100 * *peak->drop) : Cell());
    row.push_back(peak && peak->rehardening ? Cell(*peak->rehardening * 1e-9) : Cell());
}

/// Caveats of the strengths of some runs: a line for each run and reason, and the runs counted.
struct Doubts {
    std::vector<std::string> lines;
    CaveatCount count;
    void add(const RunData& run, const std::vector<Caveat>& caveats) {
        for (const Caveat& caveat : caveats) lines.push_back(printable(run.name) + ": warning: " + caveat.text);
        count.add(run, caveats);
    }
};

std::vector<Cell> strength_row(const std::string& path, Doubts& doubts) {
    const RunReader reader(path);
    const RunData run = run_data(reader);
    const Strength strength = measure_strength(run);
    const double grain_steps = static_cast<double>(run.header.integrations) * static_cast<double>(run.specimen.grains);
    // A checkpoint does not have yet what is found at the end of a run.
    const auto at_end = [&](double value) { return run.header.stop_reason == "checkpoint" ? Cell() : Cell(value); };
    const bool timed = grain_steps > 0 && run.wall_time > 0;
    std::vector<Cell> row{run.name,
                          run.header.test,
                          run.specimen.seed,
                          run.specimen.grains,
                          run.specimen.mean_edge * 1e3,
                          run.header.confining_pressure * 1e-6,
                          megapascal(strength.peak_compressive_stress),
                          megapascal(strength.tensile_strength),
                          strength.strain_at_peak,
                          strength.peak_kind,
                          megapascal(strength.first_yield),
                          count_cell(strength.tensile_cracks),
                          count_cell(strength.shear_cracks),
                          at_end(run.header.energy_balance_error),
                          at_end(run.header.platen_force_difference),
                          run.header.steps,
                          timed ? Cell(run.wall_time) : Cell(),
                          timed ? Cell(run.wall_time * 1e9 / grain_steps) : Cell(),
                          megapascal(strength.stress_at_marks[0]),
                          megapascal(strength.stress_at_marks[1]),
                          megapascal(strength.stress_at_marks[2])};
    doubts.add(run, caveats_of(run, append_split(row, reader, run)));
    row.push_back(run.header.confining_pressure > 0 ? Cell(run.header.confinement_mean * 1e-6) : Cell());
    const ContactParameters& contact = run.header.contact;
    row.emplace_back(run.header.contact_law);
    for (const double value : {contact.tensile_strength * 1e-6, contact.cohesion * 1e-6, contact.friction_angle / degree}) {
        row.emplace_back(value);
    }
    row.push_back(at_end(run.header.damping_load));
    append_first_peak(row, strength.first_peak);
    for (const double value : {contact.fracture_energy, contact.open_shear_strength * 1e-6, run.header.rock.young_modulus * 1e-9,
                               run.header.rock.poisson_ratio, run.header.max_strain, run.header.rate_tolerance}) {
        row.emplace_back(value);
    }
    const double time_of_peak = run.history[HistoryColumn::time][load_curve(run).peak];
    for (Cell& each : label_cells(reader.cracks(), run.header.crack_event, time_of_peak)) row.push_back(std::move(each));
    row.emplace_back(std::string(name_of(run.header.plane)));
    return row;
}

}  // namespace

std::string name_of(StrengthKind kind) {
    switch (kind) {
        case StrengthKind::first_peak: return "first-peak";
        case StrengthKind::residual: return "residual";
        default: return "largest";
    }
}

std::optional<double> Strength::value(StrengthKind kind) const {
    if (kind == StrengthKind::largest) return value();
    if (!first_peak) return std::nullopt;
    return kind == StrengthKind::first_peak ? std::optional(first_peak->stress) : first_peak->residual_strength();
}

Strength measure_strength(const RunData& run) {
    const LoadCurve curve = load_curve(run);
    Strength strength;
    (is_compression(run.header) || run.header.test == "program" ? strength.peak_compressive_stress : strength.tensile_strength) =
        curve.peak_stress();
    strength.strain_at_peak = curve.axial_strain[curve.peak];
    strength.peak_kind = peak_kind(run, curve);
    strength.first_yield = first_yield(curve);
    strength.first_peak = measure_first_peak(run, curve);
    std::transform(strain_marks.begin(), strain_marks.end(), strength.stress_at_marks.begin(),
                   [&](double strain) { return stress_at_strain(curve, strain); });
    strength.tensile_cracks = run.history[HistoryColumn::tensile_cracks][curve.peak];
    strength.shear_cracks = run.history[HistoryColumn::shear_cracks][curve.peak];
    return strength;
}

bool stopped_at_strain_limit(const RunData& run, const Strength& strength, StrainLimitRuns strain_limit_runs,
                             const std::string& what) {
    if (strength.peak_kind == "drop") return false;
    if (strength.peak_kind != "cap") {
        throw InputError(run.name + ": was stopped (" + run.header.stop_reason + ") before a peak; " + what +
                         " needs runs that fell behind their peak");
    }
    if (strain_limit_runs == StrainLimitRuns::refuse) {
        throw InputError(
            fmt::format("{}: stopped at the strain limit ({:.3g} %) without a peak, so that its largest stress is not a "
                        "strength; run it further (--max-strain), or accept the largest stress with --capped accept",
                        run.name, 100 * run.header.max_strain));
    }
    return true;
}

void write_strength_table(std::ostream& out, const std::vector<std::string>& runs, std::optional<TableFormat> format,
                          std::ostream& diagnostics) {
    Doubts doubts;
    const std::vector<std::string> columns = all_columns();
    std::vector<std::vector<Cell>> rows;
    for (const std::string& run : runs) rows.push_back(strength_row(run, doubts));
    if (format) {
        TableWriter table(out, columns, *format);
        for (const auto& row : rows) table.row(row);
    } else {
        write_strengths_to_terminal(out, {columns, rows});
    }
    out.flush();
    if (!out) return;  // the command says so
    for (const std::string& line : doubts.lines) diagnostics << "strength: " << line << '\n';
    const std::string tension = doubts.count.tension_line();
    if (!tension.empty()) diagnostics << "strength: warning: " << tension << '\n';
}

}  // namespace graincrack
