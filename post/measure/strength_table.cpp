#include "post/measure/strength_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "post/measure/brazilian.hpp"
#include "post/measure/caveats.hpp"
#include "post/run/comparability.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/text.hpp"

namespace graincrack {

namespace {

/// A row of the table.
struct StrengthRow {
    RunData run;
    Strength strength;
    StrengthKind kind{};                  ///< what the columns beside the strengths belong to
    std::optional<BrazilianSplit> split;  ///< of a Brazilian test
    double loading_arc = 0;               ///< of its disc, rad
    OtherCounts cracks;                   ///< at the strength
    [[nodiscard]] const RunHeader& header() const { return run.header; }
    [[nodiscard]] const ContactParameters& contact() const { return run.header.contact; }
    /// A value that a checkpoint does not have yet.
    [[nodiscard]] Cell at_end(double value) const { return header().stop_reason == "checkpoint" ? Cell() : Cell(value); }
    [[nodiscard]] const CurveRow& shown() const { return strength.at(kind); }
    [[nodiscard]] bool is_exceeded() const { return shown().row < strength.largest.row; }
    [[nodiscard]] Cell bending_load() const { return header().loading() == Loading::bending ? Cell(shown().load) : Cell(); }
    [[nodiscard]] bool is_pulled() const {
        return header().loading() == Loading::splitting || header().loading() == Loading::tension;
    }
    [[nodiscard]] Cell flexural_strength() const { return distinct_shape(run) == "beam" ? Cell(strength.strength) : Cell(); }
    [[nodiscard]] Cell largest_compression() const {
        const Loading loading = header().loading();
        return loading == Loading::compression || loading == Loading::program ? Cell(strength.largest.stress) : Cell();
    }
    [[nodiscard]] double grain_steps() const {
        return static_cast<double>(header().integrations) * static_cast<double>(run.specimen.grains);
    }
    [[nodiscard]] bool is_timed() const { return grain_steps() > 0 && run.wall_time > 0; }
    [[nodiscard]] Cell of_peak(std::optional<double> FirstPeak::*member) const {
        return strength.first_peak ? Cell((*strength.first_peak).*member) : Cell();
    }
    [[nodiscard]] Cell of_split(std::optional<double> BrazilianSplit::*member) const {
        return split ? Cell((*split).*member) : Cell();
    }
};

StrengthRow read_strength_row(const std::string& path, StrengthKind kind) {
    const RunReader reader(path);
    StrengthRow row{run_data(reader), {}, kind, std::nullopt, 0, {}};
    const LoadCurve curve = load_curve(row.run);
    row.strength = measure_strength(row.run, curve);
    if (splits(row.run)) {
        const Specimen specimen = reader.specimen();
        row.split = measure_split(row.run, curve, specimen, read_cracks(reader, specimen));
        row.loading_arc = specimen.loading_arc;
    }
    row.cracks =
        count_other_labels(reader.cracks(), row.header().crack_event, row.run.history[HistoryColumn::time][row.shown().row]);
    return row;
}

const Columns<StrengthRow>& strength_columns() {
    using R = StrengthRow;
    using namespace unit;
    static const Columns<R> all = [] {
        Columns<R> list{
            {"file", none, [](const R& r) { return r.run.name; }},
            {"test", none, [](const R& r) { return r.header().test; }},
            {"seed", none, [](const R& r) { return r.run.specimen.seed; }},
            {"grains", none, [](const R& r) { return r.run.specimen.grains; }},
            {"mean_edge", millimetre, [](const R& r) { return r.run.specimen.mean_edge; }},
            {"confining_pressure", megapascal, [](const R& r) { return r.header().confining_pressure; }},
            {"peak_compressive_stress", megapascal, &R::largest_compression},
            {"tensile_strength", megapascal, [](const R& r) { return r.is_pulled() ? Cell(r.strength.strength) : Cell(); }},
            {"strain_at_peak", none, [](const R& r) { return r.shown().strain; }},
            {"peak_kind", none, [](const R& r) { return peak_kind(r.header(), r.strength.has_peak(r.kind)); }},
            {"first_yield", megapascal, [](const R& r) { return r.strength.first_yield; }},
            {"tensile_cracks", none, [](const R& r) { return count_cell(r.shown().tensile_cracks); }},
            {"shear_cracks", none, [](const R& r) { return count_cell(r.shown().shear_cracks); }},
            {"energy_balance_error", none, [](const R& r) { return r.at_end(r.header().energy_balance_error); }},
            {"platen_force_difference", none, [](const R& r) { return r.at_end(r.header().platen_force_difference); }},
            {"steps", none, [](const R& r) { return r.header().steps; }},
            {"wall_time", second, [](const R& r) { return r.is_timed() ? Cell(r.run.wall_time) : Cell(); }},
            {"ns_per_grain_step", none,
             [](const R& r) { return r.is_timed() ? Cell(r.run.wall_time * 1e9 / r.grain_steps()) : Cell(); }},
            {"stress_at_1_percent", megapascal, [](const R& r) { return r.strength.stress_at_marks[0]; }, further},
            {"stress_at_2_percent", megapascal, [](const R& r) { return r.strength.stress_at_marks[1]; }, further},
            {"stress_at_3_percent", megapascal, [](const R& r) { return r.strength.stress_at_marks[2]; }, further},
            {"spanning_strength", megapascal, [](const R& r) { return r.of_split(&BrazilianSplit::spanning_stress); }, further},
            {"first_crack_radius_over_R", none, [](const R& r) { return r.of_split(&BrazilianSplit::first_crack_radius); },
             further},
            {"loading_arc", degree, [](const R& r) { return r.split ? Cell(r.loading_arc) : Cell(); }, further},
            {"warning", none, [](const R& r) { return r.split ? Cell(r.split->warning()) : Cell(); }, further},
            {"achieved_confining_pressure", megapascal,
             [](const R& r) { return r.header().confining_pressure > 0 ? Cell(r.header().confinement_mean) : Cell(); }, further},
            {"contact_law", none, [](const R& r) { return r.header().contact_law; }, further},
            {"contact_tensile_strength", megapascal, [](const R& r) { return r.contact().tensile_strength; }, further},
            {"contact_cohesion", megapascal, [](const R& r) { return r.contact().cohesion; }, further},
            {"contact_friction_angle", degree, [](const R& r) { return r.contact().friction_angle; }, further},
            {"damping_load", none, [](const R& r) { return r.at_end(r.header().damping_load); }, further},
            {"first_peak", megapascal, [](const R& r) { return r.strength.first_peak ? Cell(r.strength.strength) : Cell(); }},
            {"residual", megapascal, [](const R& r) { return r.of_peak(&FirstPeak::residual); }},
            {"drop", percent, [](const R& r) { return r.of_peak(&FirstPeak::drop); }},
            {"rehardening", gigapascal, [](const R& r) { return r.of_peak(&FirstPeak::rehardening); }, further},
            {"contact_fracture_energy", joule_per_area, [](const R& r) { return r.contact().fracture_energy; }, further},
            {"contact_open_shear_strength", megapascal, [](const R& r) { return r.contact().open_shear_strength; }, further},
            {"grain_young_modulus", gigapascal, [](const R& r) { return r.header().rock.young_modulus; }, further},
            {"grain_poisson_ratio", none, [](const R& r) { return r.header().rock.poisson_ratio; }, further},
            {"max_strain", none, [](const R& r) { return r.header().max_strain; }, further},
            {"rate_tolerance", none, [](const R& r) { return r.header().rate_tolerance; }, further}};
        append_other_counts<R>(list, [](const R& r) -> const OtherCounts& { return r.cracks; });
        list.push_back({"plane", none, [](const R& r) { return name_of(r.header().plane); }, further});
        list.push_back({"peak_load", kilonewton_per_metre, [](const R& r) { return r.shown().load; }});
        list.push_back({"flexural_strength", megapascal, &R::flexural_strength});
        list.push_back(
            {"span", millimetre, [](const R& r) { return r.header().span > 0 ? Cell(r.header().span) : Cell(); }, further});
        return list;
    }();
    return all;
}

/// What a run was asked for by an option: of its own, of its specimen, or as a value of its material.
std::optional<Setting> setting_of(const StrengthRow& row, const std::string& name) {
    for (const Settings& settings : {row.header().request, row.run.specimen.settings, material_values(row.header())}) {
        if (const Setting* const found = find_setting(settings, name)) return *found;
    }
    return std::nullopt;
}

/// A number, anything else as people read it.
Cell cell_of(const std::optional<Setting>& setting) {
    if (!setting || std::holds_alternative<std::monostate>(setting->value)) return {};
    const auto* const number = std::get_if<double>(&setting->value);
    return number != nullptr ? Cell(*number) : Cell(shown(*setting));
}

/// Adds the column of an option, or shows the one that is there.
void append_option(Columns<StrengthRow>& columns, std::string name, const std::vector<StrengthRow>& rows) {
    std::ranges::replace(name, '-', '_');
    const auto there = std::ranges::find(columns, name, &Column<StrengthRow>::name);
    if (there != columns.end()) {
        there->is_further = false;
        return;
    }
    const auto has_it = [&](const StrengthRow& row) { return setting_of(row, name).has_value(); };
    const auto row = std::ranges::find_if(rows, has_it);
    if (row == rows.end()) throw UsageError(fmt::format("--columns {}: none of the runs has such an option", name));
    columns.push_back({name, unit_in_tables(setting_of(*row, name)->dimension),
                       [name](const StrengthRow& each) { return cell_of(setting_of(each, name)); }});
}

std::string ending(const StrengthRow& r) {
    if (r.strength.has_peak(r.kind)) return "peak";
    return r.header().stop_reason == "strain limit" ? "strain limit" : "stopped";
}

Cell strength_cell(const StrengthRow& r) {
    const auto strength = r.strength.reported(r.kind);
    return strength ? Cell(*strength) : Cell(did_not_fail);
}

const Columns<StrengthRow>& strength_terminal_columns() {
    using R = StrengthRow;
    using namespace unit;
    static constexpr ColumnUnit cracks{"cracks"};
    static const Columns<R> all{
        {"run", none, [](const R& r) { return r.run.name; }},
        {"seed", none, [](const R& r) { return r.run.specimen.seed; }},
        {"crystals", none, [](const R& r) { return r.run.specimen.crystals; }},
        {"diameter", millimetre, [](const R& r) { return r.run.specimen.grain_diameter; }},
        {"strength", megapascal, strength_cell},
        {"at strain", percent, [](const R& r) { return r.shown().strain; }},
        {"ended by", none, ending},
        {"tensile", cracks, [](const R& r) { return whole_contacts(r.shown().tensile_cracks); }},
        {"shear", cracks, [](const R& r) { return whole_contacts(r.shown().shear_cracks); }},
        {"largest", megapascal, [](const R& r) { return r.is_exceeded() ? Cell(r.strength.largest.stress) : Cell(" "); }},
        {"load", kilonewton_per_metre, &R::bending_load},
        {"flexural strength", megapascal, &R::flexural_strength}};
    return all;
}

/// Comparable runs under a title that says in what they differ from others of their test, with their mean, in which each test of
/// a specimen counts once. \param diagnostics gets a line for what counts with another
void write_strengths_to_terminal(std::ostream& out, const Columns<StrengthRow>& columns, const std::vector<StrengthRow>& rows,
                                 std::ostream& diagnostics) {
    TerminalTable table(columns);
    RunList runs;
    for (const StrengthRow& row : rows) runs.push_back(&row.run);
    const std::vector<std::size_t> counted = once_each(runs, "strength", diagnostics);
    for (const ComparableGroup& group : comparable_groups(runs, {}, {SettingGroup::plane, SettingGroup::heat})) {
        const StrengthRow& first = rows[group.runs.front()];
        table.group(series_label(first.run) + ", plane " + std::string(name_of(first.header().plane)) +
                    (first.header().heat != 0 ? ", " : "") + first.header().heat_label() +
                    (group.distinction.empty() ? "" : ", ") + group.distinction +
                    (is_compression(first.header()) ? "; strength: " + label_of(first.kind) : ""));
        std::vector<double> strengths;
        for (const std::size_t i : group.runs) {
            table.row(cells_of(columns, rows[i]));
            const auto strength = rows[i].strength.reported(rows[i].kind);
            if (strength && std::ranges::find(counted, i) != counted.end()) strengths.push_back(*strength);
        }
        if (strengths.size() < 2) continue;
        const Sample all = sample(strengths);
        std::vector<Cell> mean(columns.size(), " ");
        mean[0] = fmt::format("mean of {}, s.d. {}", all.n, Cell(all.deviation).times(unit::megapascal.factor).text(2));
        mean[4] = all.mean.value * unit::megapascal.factor;
        table.row(mean);
    }
    table.write(out);
}

}  // namespace

void write_strength_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, std::ostream& diagnostics,
                          StrengthKind kind, ColumnChoice choice, const std::vector<std::string>& options) {
    std::vector<StrengthRow> rows;
    CaveatCount count;
    std::vector<std::vector<Caveat>> doubts;
    for (const std::string& run : runs) {
        const StrengthRow& row = rows.emplace_back(read_strength_row(run, kind));
        count.add(row.run, doubts.emplace_back(caveats_of(row.run, row.split)));
    }
    Columns<StrengthRow> columns = format == TableFormat::aligned ? strength_terminal_columns() : strength_columns();
    for (const std::string& list : options) {
        for (const std::string_view option : split(list, ',')) append_option(columns, std::string(option), rows);
    }
    if (format == TableFormat::aligned) {
        write_strengths_to_terminal(out, columns, rows, diagnostics);
    } else {
        write_table(out, columns, rows, format, choice);
    }
    out.flush();
    if (!out) return;  // the command says so
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string& file = rows[i].run.name;
        for (const Caveat& each : doubts[i]) warn(diagnostics, "strength: " + printable(file), {each.text, each.code}, file);
    }
    const std::string tension = count.tension_line();
    if (!tension.empty()) warn(diagnostics, "strength", {tension, "tension"});
}

}  // namespace graincrack
