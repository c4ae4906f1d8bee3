#include "post/option_parts.hpp"

#include <optional>
#include <utility>

#include "share/command_line.hpp"

namespace graincrack {

namespace {

constexpr Quantity event_distance{"event_distance", Dimension::length, 0, 1e3, "distance within an acoustic event"};
constexpr Quantity event_time{"event_time", Dimension::time, 0, 1e6, "time within an acoustic event"};
constexpr Quantity significance{"alpha", Dimension::one, 0, 1, "level of significance", true};

}  // namespace

void add_format(CLI::App& app, TableFormat& format) {
    add_choice<TableFormat>(app, "--format", format,
                            {{"table", TableFormat::aligned}, {"tsv", TableFormat::tsv}, {"jsonl", TableFormat::jsonl}},
                            "form of the table: aligned columns, tab-separated with one header line, or JSON lines");
}

void add_output(CLI::App& app, std::string& output, const std::string& help) {
    app.add_option("-o,--output", output, help)->required();
}

void add_strain_limit_runs(CLI::App& app, StrainLimitRuns& strain_limit_runs) {
    add_choice<StrainLimitRuns>(
        app, "--capped", strain_limit_runs, {{"refuse", StrainLimitRuns::refuse}, {"accept", StrainLimitRuns::accept}},
        "runs stopped at the strain limit: refuse them, or take their largest stress for a peak and report it");
}

void add_envelope_options(CLI::App& app, EnvelopeOptions& options) {
    add_strain_limit_runs(app, options.strain_limit_runs);
    add_choice<StrengthKind>(app, "--strength", options.strength,
                             {{name_of(StrengthKind::first_peak), StrengthKind::first_peak},
                              {name_of(StrengthKind::largest), StrengthKind::largest},
                              {name_of(StrengthKind::residual), StrengthKind::residual}},
                             "stress of a compression test that is its strength; runs without a first peak or residual strength "
                             "are left out");
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
    app.add_option("--material", material, "material whose laboratory values stand beside the results");
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
                     "full quadratic, or reduced by backward elimination that keeps the hierarchy");
    add_quantity(app, "--alpha", options.choice.alpha, significance, "p above which elimination leaves a term out", "0.1");
}

void add_goals(CLI::App& app, ccd::GoalOptions& options) {
    add_names(app, "--target", options.targets, "NAME=[LOW:]TARGET[:HIGH]",
              "wanted value of a response; limits are the measured extremes unless given");
    add_names(app, "--maximise", options.maxima, "NAME=LOW:GOOD",
              "response to be as large as possible: desirability 0 at LOW, 1 at GOOD");
    add_names(app, "--minimise", options.minima, "NAME=GOOD:HIGH",
              "response to be as small as possible: desirability 1 at GOOD, 0 at HIGH");
}

void add_trend(CLI::App& app, TrendOptions& options) {
    app.add_option("--x", options.x, "column along x: a number a row")->required();
    app.add_option("--y", options.y, "column along y: a number a row")->required();
    app.add_flag("--power", options.power, "y = a x^b through logarithms in place of y = a + b x");
    add_names(app, "--group", options.groups, "COLUMN", "a fit for each different entry of this column; may be given again");
}

void add_crack_label(CLI::App& app, CrackLabelChoice& label) {
    std::vector<std::pair<std::string, std::optional<CrackEvent>>> events;
    for (const CrackEvent event : all_crack_events) events.emplace_back(name_of(event), event);
    add_choice<std::optional<CrackEvent>>(app, "--crack-event", label.event, events,
                                          "a contact point is a micro-crack once it failed (passed its peak), or once less than "
                                          "50 or 10 % of its cohesion was left; "
                                          "unless given half-damaged for laws with friction beside cohesion, failed for others");
    add_choice<CrackModeRule>(app, "--crack-mode", label.mode,
                              {{"traction", CrackModeRule::traction}, {"sign", CrackModeRule::sign}},
                              "it is tensile if it passed its peak open and under more tension than shear traction, or if it was "
                              "open at the event");
}

void add_classes(CLI::App& app, std::vector<std::string>& classes) {
    add_names(app, "--class", classes, "PAIR",
              "contacts of two phases alone, as quartz-mica, in either order; may be given again; all contacts unless given");
}

void add_events(CLI::App& app, EventOptions& options) {
    add_quantity(app, "--event-distance", options.distance, event_distance,
                 "crack points within this distance are one acoustic event; two mean edges unless given");
    add_quantity(app, "--event-time", options.time, event_time,
                 "and within this time; that distance at half the speed of shear waves unless given");
}

}  // namespace graincrack
