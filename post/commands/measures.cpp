// Commands that print tables of runs.
#include "post/commands/commands.hpp"

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/export.hpp"
#include "post/fit/envelope.hpp"
#include "post/fit/size_effect.hpp"
#include "post/laboratory/comparison.hpp"
#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/measure/strength_table.hpp"
#include "post/measure/toughness.hpp"
#include "post/options/command.hpp"
#include "post/run/comparability.hpp"
#include "post/summary/summarize.hpp"
#include "share/base/error.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

struct StrengthOptions {
    ColumnChoice columns = ColumnChoice::usual;
    std::vector<std::string> options;
    StrengthKind kind = StrengthKind::first_peak;
    bool summary = false;
};

void add_strength_options(OptionSet set, StrengthOptions& options) {
    add_columns(set, options.columns);
    add_texts(
        set, "--columns", options.options, "OPTION,...",
        "options of graincrack-mesh and graincrack-solve, such as edge, whose values in the runs are further columns; may be "
        "given again");
    add_choice<StrengthKind>(
        set, "--strength", options.kind,
        {{name_of(StrengthKind::first_peak), StrengthKind::first_peak}, {name_of(StrengthKind::largest), StrengthKind::largest}},
        "strength of a compression test, to which strains, cracks and means belong: the first peak, as laboratories report it, "
        "or "
        "the largest stress");
    add_flag(set, "--summary", options.summary, "means over seeds for each test and confining pressure, UCS/BTS and DTS/BTS");
}

}  // namespace

Command strength_command() {
    return make_command<StrengthOptions>(
        "strength", "strength, strain and cracks at the peak and quality checks, one row per run",
        {"uniaxial.h5 brazilian.h5", "uniaxial.h5 triaxial.h5 brazilian.h5 --summary"}, several_runs, add_strength_options,
        [](const StrengthOptions& options, const Call& call) {
            if (options.summary) {
                write_strength_summary(call.out, call.files, call.format, call.diagnostics(), options.kind);
            } else {
                write_strength_table(call.out, call.files, call.format, call.diagnostics(), options.kind, options.columns,
                                     options.options);
            }
        },
        Prints::terminal_table);
}

Command moduli_command() {
    return make_command<ColumnChoice>(
        "moduli",
        "Young's modulus and Poisson's ratio (chord up to half the peak), predicted values, Voigt and Reuss bounds, crack "
        "thresholds; one row per run",
        {"uniaxial.h5", "uniaxial.h5 triaxial.h5 --format jsonl"}, several_runs, add_columns,
        [](const ColumnChoice& columns, const Call& call) {
            write_moduli_table(call.out, call.files, call.format, call.diagnostics(), columns);
        },
        Prints::terminal_table);
}

Command toughness_command() {
    struct NoOptions {};
    return make_command<NoOptions>(
        "toughness",
        "fracture toughness K_IC from direct tension of rectangles with a central notch, and from bending of notched beams and "
        "half-discs, with its size and K_IC at infinite size by the strip-yield law, whose zone bears the tensile strength of "
        "contacts; one row per run",
        {"notched-tension.h5", "notched-tension.h5 --format jsonl"}, several_runs,
        [](OptionSet /*set*/, NoOptions& /*options*/) {},
        [](const NoOptions& /*options*/, const Call& call) {
            write_toughness_table(call.out, call.files, call.format, call.diagnostics());
        },
        Prints::terminal_table);
}

Command classes_command() {
    return make_command<CrackLabelChoice>(
        "classes", "contacts and micro-cracks for each class (pair of minerals), one row per class",
        {"uniaxial.h5", "uniaxial.h5 brazilian.h5 --crack-event broken --format jsonl"}, several_runs, add_crack_label,
        [](const CrackLabelChoice& label, const Call& call) {
            std::vector<RunClasses> runs;
            for (const std::string& file : call.files) runs.push_back(read_classes(RunReader(file), label));
            write_class_counts(call.out, runs, call.format);
        },
        Prints::terminal_table);
}

Command properties_command() {
    struct Options {
        std::string material;
        EnvelopeOptions envelope;
    };
    return make_command<Options>(
        "properties",
        "elastic constants, strengths, cohesion and friction angle of a set of tests, compared with the laboratory, and what new "
        "specimens have by the kind of rock, also without tests",
        {"uniaxial.h5 triaxial.h5 brazilian.h5 --material augig-granite", "brazilian.h5 --material augig-granite --format jsonl"},
        FileArguments{several_runs.name, several_runs.help, false, true},
        [](OptionSet set, Options& options) {
            add_text(set, "--material", options.material, "material with the laboratory values to compare with").required();
            add_envelope_options(set, options.envelope);
        },
        [](const Options& options, const Call& call) {
            const IncompleteMaterial material = read_incomplete_material_of(call, options.material);
            const std::vector<RunData> runs = read_once_each(call.files, call.command, call.diagnostics());
            require_material(runs, material);
            std::vector<std::string> left_out;
            for (const RunData& run : runs) {
                if (options.envelope.strength == StrengthKind::largest || measure_strength(run).strength) continue;
                left_out.push_back(run.name + ": " + did_not_fail);
            }
            std::string why;
            const std::vector<ComparisonRow> properties = property_rows(runs, material, options.envelope, why);
            if (runs.empty() && properties.empty()) {
                throw UsageError("runs: missing, and the kind of rock predicts nothing of " + material.material.file.string() +
                                 ": " + why);
            }
            write_properties(call.out, properties, call.format);
            print_left_out(call.diagnostics(), "properties", left_out);
        },
        Prints::terminal_table);
}

Command size_effect_command() {
    return make_command<EnvelopeOptions>(
        "size-effect", "power law of strength against mean edge, one fit for each test and confining pressure",
        {"brazilian-coarse.h5 brazilian.h5", "brazilian-coarse.h5 brazilian.h5 --strength largest --format jsonl"}, several_runs,
        add_envelope_options,
        [](const EnvelopeOptions& strength, const Call& call) {
            write_size_effect_table(call.out, read_once_each(call.files, call.command, call.diagnostics()), call.format, strength,
                                    call.diagnostics());
        },
        Prints::table);
}

Command summarize_command() {
    using summary::SummaryOptions;
    return make_command<SummaryOptions>(
        "summarize", "tables queried by SQL, with means, deviations, intervals and fits",
        {"strength.tsv --sql 'SELECT test, count(*) AS runs, mean(tensile_strength_MPa) AS mean_MPa FROM strength GROUP BY test'",
         "strength.tsv --sql \"SELECT test, mean_and_half(energy_balance_error, '.1e') FROM strength GROUP BY test\" --pivot "
         "--format markdown"},
        FileArguments{"tables", "tables as FILE, named by its stem, or NAME=FILE; those of one name are combined", true, true},
        [](OptionSet set, SummaryOptions& options) {
            add_text(
                set, "--sql", options.sql,
                "a SELECT as SQLite has it, or a file *.sql with one. Further aggregates: mean, median, deviation (n-1), low, "
                "high, half_interval (95 %, Student's t), slope(x, y), intercept, exponent, each with _low and _high, "
                "lack_of_fit, rank_correlation, cohesion(s3, s1), friction_angle, mean_and_half(x, '.1f'), entries; "
                "text('{:.1f} of {}', x, y) formats numbers. "
                "Default: all of the first table")
                .type_name("QUERY|FILE.sql");
            add_texts(set, "--set", options.settings, "NAME=VALUE", "value of :NAME in the query; may be given again");
            add_flag(set, "--pivot", options.pivot,
                     "the last two columns of the query are a name and a value: make a column for each name");
            add_text(set, "--label", options.label, "add this column to each table: the name of the row's file without its end")
                .type_name("COLUMN");
        },
        [](const SummaryOptions& options, const Call& call) {
            summary::write_summary(call.out, call.files, options, call.format);
        },
        Prints::table);
}

}  // namespace graincrack
