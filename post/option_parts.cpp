#include "post/option_parts.hpp"

#include <optional>
#include <utility>

#include "share/options/command_line.hpp"

namespace graincrack {

namespace {

constexpr Quantity event_distance{"event_distance", Dimension::length, 0, 1e3, "distance within an acoustic event"};
constexpr Quantity event_time{"event_time", Dimension::time, 0, 1e6, "time within an acoustic event"};
constexpr Quantity significance{"alpha", Dimension::one, 0, 1, "level of significance", true};

}  // namespace

void add_format(CLI::App& app, TableFormat& format) {
    add_choice<TableFormat>(app, "--format", format,
                            {{"table", TableFormat::aligned}, {"tsv", TableFormat::tsv}, {"jsonl", TableFormat::jsonl}},
                            "form of the table: aligned columns, tab-separated values with one header line, or JSON lines");
}

void add_output(CLI::App& app, std::string& output, const std::string& help) {
    app.add_option("-o,--output", output, help)->required();
}

void add_strain_limit_runs(CLI::App& app, StrainLimitRuns& strain_limit_runs) {
    add_choice<StrainLimitRuns>(
        app, "--capped", strain_limit_runs, {{"refuse", StrainLimitRuns::refuse}, {"accept", StrainLimitRuns::accept}},
        "runs stopped at the strain limit: refuse them, or accept their largest stress as a strength and say so");
}

void add_envelope_options(CLI::App& app, EnvelopeOptions& options) {
    add_strain_limit_runs(app, options.strain_limit_runs);
    add_choice<StrengthKind>(app, "--strength", options.strength,
                             {{name_of(StrengthKind::first_peak), StrengthKind::first_peak},
                              {name_of(StrengthKind::largest), StrengthKind::largest},
                              {name_of(StrengthKind::residual), StrengthKind::residual}},
                             "which stress of a compression test is taken as its strength; runs without a first peak or residual "
                             "strength are left out");
}

void add_names(CLI::App& app, const std::string& option, std::vector<std::string>& target, const std::string& type,
               const std::string& help) {
    app.add_option(option, target, help)
        ->type_name(type)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->default_str("");  // no "[]", which --config would read as a value
}

void add_laboratory_material(CLI::App& app, std::string& material) {
    app.add_option("--material", material, "material with the laboratory values to compare with");
}

Material read_material_of(const Call& call, const std::string& name_or_file) {
    Material material = read_material(name_or_file);
    write_notes(call.diagnostics(), call.command, material);
    return material;
}

IncompleteMaterial read_incomplete_material_of(const Call& call, const std::string& name_or_file) {
    IncompleteMaterial read = read_incomplete_material(name_or_file);
    write_notes(call.diagnostics(), call.command, read.material);
    return read;
}

void add_model(CLI::App& app, ccd::ModelOptions& options) {
    add_names(app, "--factor", options.factors, "NAME=LOW:HIGH", "factor with its values at -1 and +1, if the table has no x1");
    add_choice<bool>(app, "--model", options.choice.reduce, {{"full", false}, {"backward", true}},
                     "full: all quadratic terms; backward: reduced by backward elimination that keeps the hierarchy");
    add_quantity(app, "--alpha", options.choice.alpha, significance, "p value above which elimination removes a term", "0.1");
}

void add_goals(CLI::App& app, ccd::GoalOptions& options) {
    add_names(app, "--target", options.targets, "NAME=[LOW:]TARGET[:HIGH]",
              "wanted value of a response; limits default to the measured extremes");
    add_names(app, "--maximise", options.maxima, "NAME=LOW:GOOD",
              "response to be as large as possible: desirability 0 at LOW, 1 at GOOD");
    add_names(app, "--minimise", options.minima, "NAME=GOOD:HIGH",
              "response to be as small as possible: desirability 1 at GOOD, 0 at HIGH");
}

void add_trend(CLI::App& app, TrendOptions& options) {
    app.add_option("--x", options.x, "column of the abscissa, one number per row")->required();
    app.add_option("--y", options.y, "column of the ordinate, one number per row")->required();
    app.add_flag("--power", options.power, "fit y = a x^b in logarithms instead of y = a + b x");
    add_names(app, "--group", options.groups, "COLUMN", "one fit for each value of this column; may be given again");
}

void add_crack_label(CLI::App& app, CrackLabelChoice& label) {
    std::vector<std::pair<std::string, std::optional<CrackEvent>>> events;
    for (const CrackEvent event : all_crack_events) events.emplace_back(name_of(event), event);
    add_choice<std::optional<CrackEvent>>(app, "--crack-event", label.event, events,
                                          "when a contact point counts as a micro-crack: it passed its peak (failed), less than "
                                          "50 % (half-damaged) or less than 10 % (broken) of its cohesion is left; default: "
                                          "half-damaged for laws with friction in addition to cohesion, failed for others");
    add_choice<CrackModeRule>(app, "--crack-mode", label.mode,
                              {{"traction", CrackModeRule::traction}, {"sign", CrackModeRule::sign}},
                              "when a micro-crack is tensile: it passed its peak open and with more tensile than shear traction "
                              "(traction), or it was open at the event (sign)");
}

void add_classes(CLI::App& app, std::vector<std::string>& classes) {
    add_names(
        app, "--class", classes, "PAIR",
        "only contacts between two phases, such as quartz-mica, in either order; may be given again; default: all contacts");
}

void add_events(CLI::App& app, EventOptions& options) {
    add_quantity(app, "--event-distance", options.distance, event_distance,
                 "crack points within this distance belong to one acoustic event; default: two mean edges");
    add_quantity(
        app, "--event-time", options.time, event_time,
        "crack points within this time belong to one acoustic event; default: that distance at half the speed of shear waves");
}

}  // namespace graincrack
