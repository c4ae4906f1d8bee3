#include "post/commands/envelope.hpp"

#include <fmt/ostream.h>

#include <algorithm>
#include <numbers>

#include "post/option_parts.hpp"
#include "post/table/table_form.hpp"
#include "post/table/terminal_table.hpp"

namespace graincrack {

namespace {

constexpr double mega = 1e-6;
constexpr double degrees = 180 / std::numbers::pi;

/// A row that grows with the names of its columns.
class RowBuilder {
public:
    void add(const std::string& column, Cell value) {
        columns_.push_back(column);
        cells_.push_back(std::move(value));
    }
    void add(const std::string& column, const std::optional<double>& value, double factor) {
        add(column, value ? Cell(*value * factor) : Cell());
    }
    /// NAME_UNIT, NAME_low_UNIT, NAME_high_UNIT
    void add_interval(const std::string& name, const std::string& unit, const std::optional<Estimate>& e, double factor) {
        const std::string suffix = unit.empty() ? "" : "_" + unit;
        add(name + suffix, e ? std::optional(e->value) : std::nullopt, factor);
        add(name + "_low" + suffix, e ? e->low : std::nullopt, factor);
        add(name + "_high" + suffix, e ? e->high : std::nullopt, factor);
    }
    void add_sample(const std::string& name, const std::string& unit, const std::optional<Sample>& s, double factor) {
        add_interval(name, unit, s ? std::optional(s->mean) : std::nullopt, factor);
        add(name + "_deviation" + (unit.empty() ? "" : "_" + unit), s ? s->deviation : std::nullopt, factor);
    }
    void write(std::ostream& out, TableFormat format) const { TableWriter(out, columns_, format).row(cells_); }
    [[nodiscard]] NamedRow named() const { return {columns_, cells_}; }

private:
    std::vector<std::string> columns_;
    std::vector<Cell> cells_;
};

std::optional<double> mean(const std::vector<double>& values) {
    return values.empty() ? std::nullopt : std::optional(sample(values).mean.value);
}

void add_hoek_brown(RowBuilder& row, const std::string& name, const std::optional<HoekBrown>& fit) {
    row.add_interval(name + "_sigma_ci", "MPa", fit ? std::optional(fit->sigma_ci) : std::nullopt, mega);
    row.add_interval(name + "_mi", "", fit ? std::optional(fit->mi) : std::nullopt, 1);
}

void add_tension(RowBuilder& row, const Envelope& envelope, const EnvelopeTests& tests) {
    row.add("mohr_coulomb_tensile_strength_MPa", envelope.tensile_strength(), mega);
    row.add("hoek_brown_tensile_strength_MPa",
            envelope.hoek_brown ? std::optional(envelope.hoek_brown->tensile_strength()) : std::nullopt, mega);
    row.add("brazilian_tensile_strength_MPa", mean(tests.brazilian), mega);
    row.add("direct_tensile_strength_MPa", mean(tests.direct_tension), mega);
    const bool any = !tests.tensile().empty();
    add_hoek_brown(row, "hoek_brown_with_tension",
                   any ? fit_hoek_brown(tests.confining(), tests.strength(), tests.tensile()) : std::nullopt);
    row.add("tension_from", any ? Cell(std::string(tests.direct_tension.empty() ? "brazilian" : "tension")) : Cell());
}

void add_seeds(RowBuilder& row, const std::optional<SeedEnvelopes>& seeds) {
    row.add("whole_seeds", static_cast<std::int64_t>(seeds ? seeds->seeds : 0));
    row.add_sample("seed_cohesion", "MPa", seeds ? std::optional(seeds->cohesion) : std::nullopt, mega);
    row.add_sample("seed_friction_angle", "deg", seeds ? std::optional(seeds->friction_angle) : std::nullopt, degrees);
    row.add_sample("seed_hoek_brown_sigma_ci", "MPa", seeds ? seeds->sigma_ci : std::nullopt, mega);
    row.add_sample("seed_hoek_brown_mi", "", seeds ? seeds->mi : std::nullopt, 1);
}

void add_at(RowBuilder& row, const std::string& place, const EnvelopeAt& at) {
    row.add("runs_at_" + place, static_cast<std::int64_t>(at.runs));
    const auto& envelope = at.envelope;
    row.add_interval("cohesion_at_" + place, "MPa", envelope ? std::optional(envelope->cohesion) : std::nullopt, mega);
    row.add_interval("friction_angle_at_" + place, "deg", envelope ? std::optional(envelope->friction_angle) : std::nullopt,
                     degrees);
}

/// Envelopes of the other stresses of the table `strength`: at first yield and at given strains.
void add_other_stresses(RowBuilder& row, const EnvelopeTests& tests) {
    add_at(row, "first_yield", fit_envelope_at_first_yield(tests));
    for (std::size_t mark = 0; mark < strain_marks.size(); ++mark) {
        add_at(row, fmt::format("{:.0f}_percent", 100 * strain_marks[mark]), fit_envelope_at_strain(tests, mark));
    }
}

/// The plane condition of the compression tests, which is one for all.
Cell plane_of_compression(const std::vector<RunData>& runs) {
    const auto test = std::find_if(runs.begin(), runs.end(), [](const RunData& run) { return is_compression(run.header); });
    return test == runs.end() ? Cell() : Cell(std::string(name_of(test->header.plane)));
}

/// The few quantities that people look for, a line each, with their intervals.
void write_to_terminal(std::ostream& out, const NamedRow& row) {
    TerminalTable table({{"quantity", ""}, {"value", ""}, {"95 % interval", ""}, {"unit", ""}});
    const auto add = [&](const std::string& label, const std::string& name, const std::string& unit) {
        const std::string suffix = unit.empty() ? "" : "_" + unit;
        const std::string low = row.shown(name + "_low" + suffix);
        const std::string value = row.shown(name + suffix);
        const std::string none = value.empty() ? "" : "not determined by " + row.text("runs") + " tests";
        table.row({label, value, low.empty() ? none : low + " to " + row.shown(name + "_high" + suffix),
                   unit == "deg"  ? "°"
                   : unit.empty() ? " "
                                  : unit});
    };
    const auto add_value = [&](const std::string& label, const std::string& column) {
        if (!row.text(column).empty()) table.row({label, row.shown(column), " ", "MPa"});
    };
    table.group(fmt::format("{} of {} compression runs, plane {}; strength: {}", row.text("runs"), row.text("compression_runs"),
                            row.text("plane"), row.text("strength")));
    add("cohesion C", "cohesion", "MPa");
    add("friction angle φ", "friction_angle", "deg");
    add("Hoek–Brown σci", "hoek_brown_sigma_ci", "MPa");
    add("Hoek–Brown mi", "hoek_brown_mi", "");
    table.group("tensile strength");
    add_value("where the line has σ1 = 0", "mohr_coulomb_tensile_strength_MPa");
    add_value("where the Hoek–Brown curve has σ1 = 0", "hoek_brown_tensile_strength_MPa");
    add_value("Brazilian tests", "brazilian_tensile_strength_MPa");
    add_value("direct tension", "direct_tensile_strength_MPa");
    table.write(out);
}

}  // namespace

void write_envelope_table(std::ostream& out, const std::vector<std::string>& paths, std::optional<TableFormat> format,
                          const EnvelopeOptions& options, std::ostream& diagnostics) {
    const std::vector<RunData> runs = read_runs(paths);
    const EnvelopeTests tests = collect_envelope_tests(runs, options);
    const Envelope envelope = fit_envelope(tests.confining(), tests.strength());
    RowBuilder row;
    row.add("runs", static_cast<std::int64_t>(tests.compression.size()));
    row.add("runs_at_strain_limit", static_cast<std::int64_t>(tests.at_strain_limit));
    row.add_interval("cohesion", "MPa", envelope.cohesion, mega);
    row.add_interval("friction_angle", "deg", envelope.friction_angle, degrees);
    row.add("r_squared", envelope.line.r_squared);
    add_hoek_brown(row, "hoek_brown", envelope.hoek_brown);
    row.add_interval("curvature", "per_MPa", envelope.curvature, 1e6);
    row.add("curvature_sign",
            envelope.curvature ? Cell(std::string(envelope.curvature->value < 0 ? "concave" : "convex")) : Cell());
    add_tension(row, envelope, tests);
    add_seeds(row, fit_seed_envelopes(tests));
    add_other_stresses(row, tests);
    row.add("strength", name_of(tests.kind));
    row.add("compression_runs", static_cast<std::int64_t>(tests.compression_runs()));
    row.add("plane", plane_of_compression(runs));
    print_left_out(diagnostics, tests);
    if (tests.at_strain_limit > 0) {
        fmt::print(diagnostics,
                   "graincrack-post: envelope: {} of {} runs were stopped at the strain limit; their largest stress is taken as "
                   "a strength, so that C and phi depend on that limit\n",
                   tests.at_strain_limit, runs.size());
    }
    if (format) {
        row.write(out, *format);
    } else {
        write_to_terminal(out, row.named());
    }
}

Command envelope_command() {
    struct Options {
        TableForm form = TableForm::automatic;
        EnvelopeOptions envelope;
    };
    return make_command<Options>(
        "envelope", "cohesion, friction angle and Hoek-Brown constants of a set of tests, with 95 % intervals",
        {"uniaxial.h5 triaxial.h5", "uniaxial.h5 triaxial.h5 brazilian.h5 --capped accept"}, several_runs,
        [](CLI::App& app, Options& options) {
            add_form(app, options.form);
            add_envelope_options(app, options.envelope);
        },
        [](const Options& options, const Call& call) {
            write_envelope_table(call.out, call.files, format_of(options.form, call.out), options.envelope, call.diagnostics());
        });
}

}  // namespace graincrack
