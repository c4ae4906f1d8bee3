#include "post/commands/commands.hpp"

#include <fmt/ostream.h>

#include <algorithm>

#include "post/fit/envelope.hpp"
#include "post/options/command.hpp"
#include "post/run/comparability.hpp"
#include "post/table/column.hpp"
#include "share/base/events.hpp"

namespace graincrack {

namespace {

/// The one row of the table: its columns with their values.
class RowBuilder {
public:
    void add(const std::string& column, const Cell& value) { add(column, unit::none, value); }
    void add(const std::string& column, const ColumnUnit& unit, const Cell& value) {
        columns_.push_back(script_name(column, unit));
        cells_.push_back(value.times(unit.factor));
    }
    /// NAME_UNIT, NAME_low_UNIT, NAME_high_UNIT; empty without an interval
    void add_interval(const std::string& name, const ColumnUnit& unit, const std::optional<Estimate>& any) {
        const std::optional<Estimate> e = determined(any);
        add(name, unit, e ? Cell(e->value) : Cell());
        add(name + "_low", unit, e ? Cell(e->low) : Cell());
        add(name + "_high", unit, e ? Cell(e->high) : Cell());
    }
    void add_sample(const std::string& name, const ColumnUnit& unit, const std::optional<Sample>& s) {
        add_interval(name, unit, s ? std::optional(s->mean) : std::nullopt);
        add(name + "_deviation", unit, s ? Cell(s->deviation) : Cell());
    }
    void write(std::ostream& out, TableFormat format) const { TableWriter(out, columns_, format).row(cells_); }

private:
    std::vector<std::string> columns_;
    std::vector<Cell> cells_;
};

std::optional<double> mean(const std::vector<double>& values) {
    return values.empty() ? std::nullopt : std::optional(sample(values).mean.value);
}

void add_tension(RowBuilder& row, const Envelope& envelope, const EnvelopeTests& tests) {
    row.add("mohr_coulomb_tensile_strength", unit::megapascal,
            envelope.is_determined() ? Cell(envelope.tensile_strength()) : Cell());
    const auto& curve = envelope.hoek_brown;
    row.add("hoek_brown_tensile_strength", unit::megapascal,
            curve && determined(curve->mi) ? Cell(curve->tensile_strength()) : Cell());
    row.add("brazilian_tensile_strength", unit::megapascal, mean(tests.brazilian));
    row.add("direct_tensile_strength", unit::megapascal, mean(tests.direct_tension));
}

void add_seeds(RowBuilder& row, const std::optional<SeedEnvelopes>& seeds) {
    row.add("whole_seeds", static_cast<std::int64_t>(seeds ? seeds->seeds : 0));
    row.add_sample("seed_cohesion", unit::megapascal, seeds ? std::optional(seeds->cohesion) : std::nullopt);
    row.add_sample("seed_friction_angle", unit::degree, seeds ? std::optional(seeds->friction_angle) : std::nullopt);
}

/// The plane condition of the compression tests, which is one for all.
Cell plane_of_compression(const std::vector<RunData>& runs) {
    const auto test = std::find_if(runs.begin(), runs.end(), [](const RunData& run) { return is_compression(run.header); });
    return test == runs.end() ? Cell() : Cell(std::string(name_of(test->header.plane)));
}

/// The few quantities that people look for, a line each, with their intervals.
void write_to_terminal(std::ostream& out, const Envelope& envelope, const EnvelopeTests& tests, const Cell& plane) {
    TerminalTable table({"quantity", "value", "95 % interval", "unit"});
    const std::size_t runs = tests.compression.size();
    const auto add = [&](const std::string& label, const ColumnUnit& unit, const std::string& symbol,
                         const std::optional<Estimate>& e) {
        const bool is_known = determined(e).has_value();
        table.row({label, is_known ? Cell(e->value).times(unit.factor) : Cell(" "),
                   is_known ? interval_cell(e->low, e->high, unit) : Cell(not_determined(runs)), is_known ? symbol : " "});
    };
    const auto add_value = [&](const std::string& label, const std::optional<double>& stress) {
        const Cell value = Cell(stress).times(unit::megapascal.factor);
        if (!value.empty()) table.row({label, value, " ", "MPa"});
    };
    const auto& hoek_brown = envelope.hoek_brown;
    table.group(fmt::format("{} of {} compression runs, plane {}; strength: {}", runs, tests.compression_runs, plane.text(),
                            label_of(tests.kind)));
    add("cohesion C", unit::megapascal, "MPa", envelope.cohesion);
    add("friction angle φ", unit::degree, "°", envelope.friction_angle);
    add("Hoek–Brown σci", unit::megapascal, "MPa", hoek_brown ? std::optional(hoek_brown->sigma_ci) : std::nullopt);
    add("Hoek–Brown mi", unit::none, " ", hoek_brown ? std::optional(hoek_brown->mi) : std::nullopt);
    const bool has_curve = hoek_brown && determined(hoek_brown->mi);
    const bool is_pulled = !tests.brazilian.empty() || !tests.direct_tension.empty();
    if (envelope.is_determined() || has_curve || is_pulled) table.group("tensile strength");
    if (envelope.is_determined()) add_value("where the line has σ1 = 0", envelope.tensile_strength());
    if (has_curve) add_value("where the Hoek–Brown curve has σ1 = 0", hoek_brown->tensile_strength());
    add_value("Brazilian tests", mean(tests.brazilian));
    add_value("direct tension", mean(tests.direct_tension));
    table.write(out);
}

}  // namespace

void write_envelope_table(std::ostream& out, const std::vector<std::string>& paths, TableFormat format,
                          const EnvelopeOptions& options, std::ostream& diagnostics) {
    const std::vector<RunData> runs = read_once_each(paths, "envelope", diagnostics);
    const EnvelopeTests tests = collect_envelope_tests(runs, options);
    const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
    RowBuilder row;
    row.add("runs", static_cast<std::int64_t>(tests.compression.size()));
    row.add("runs_at_strain_limit", static_cast<std::int64_t>(tests.at_strain_limit));
    row.add_interval("cohesion", unit::megapascal, envelope.cohesion);
    row.add_interval("friction_angle", unit::degree, envelope.friction_angle);
    row.add("r_squared", envelope.line.r_squared);
    const auto& curve = envelope.hoek_brown;
    row.add_interval("hoek_brown_sigma_ci", unit::megapascal, curve ? std::optional(curve->sigma_ci) : std::nullopt);
    row.add_interval("hoek_brown_mi", unit::none, curve ? std::optional(curve->mi) : std::nullopt);
    add_tension(row, envelope, tests);
    add_seeds(row, fit_seed_envelopes(tests));
    row.add("strength", name_of(tests.kind));
    row.add("compression_runs", static_cast<std::int64_t>(tests.compression_runs));
    row.add("plane", plane_of_compression(runs));
    print_left_out(diagnostics, "envelope", tests.left_out);
    if (tests.at_strain_limit > 0) {
        say(diagnostics,
            fmt::format(
                "graincrack-post: envelope: {} of {} runs were stopped at the strain limit; their largest stress is taken as "
                "a strength, so that C and phi depend on that limit",
                tests.at_strain_limit, runs.size()));
    }
    if (format == TableFormat::aligned) {
        write_to_terminal(out, envelope, tests, plane_of_compression(runs));
    } else {
        row.write(out, format);
    }
}

Command envelope_command() {
    return make_command<EnvelopeOptions>(
        "envelope", "cohesion, friction angle and Hoek-Brown constants of a set of tests, with 95 % intervals",
        {"uniaxial.h5 triaxial.h5", "uniaxial.h5 triaxial.h5 brazilian.h5 --strength largest --capped accept"}, several_runs,
        add_envelope_options,
        [](const EnvelopeOptions& options, const Call& call) {
            write_envelope_table(call.out, call.files, call.format, options, call.diagnostics());
        },
        Prints::terminal_table);
}

}  // namespace graincrack
