#include "post/command_line.hpp"

#include "post/commands/option_parts.hpp"
#include "post/commands/plot_options.hpp"

namespace graincrack {

namespace {

const char* const examples =
    "  graincrack-post strength uniaxial.h5 brazilian.h5\n"
    "  graincrack-post plot cracks uniaxial.h5 --frame peak -o cracks.png\n";

void add_info(CLI::App& app, PostOptions& options) {
    CLI::App* info = add_command(app, "info", "what is in a specimen or run");
    add_files(info, options, "files", "specimens or runs");
    info->add_flag("--check", options.check, "read every dataset and validate the specimen");
    info->add_flag("--digest", options.digest, "print `digest  file` only: SHA-256 over the content except /provenance");
}

void add_tables(CLI::App& app, PostOptions& options) {
    const auto table = [&](const std::string& name, const std::string& help) {
        CLI::App* command = add_command(app, name, help);
        add_files(command, options, "runs", "run files");
        add_format(command, options);
        return command;
    };
    CLI::App* history = add_command(app, "history", "the history of a run as a table, tension positive");
    add_files(history, options, "run", "run file");
    history->add_flag("--follow", options.follow, "write the rows of a run in work as they appear, until it ends");
    auto* probe = history->add_option("--probe", options.probe, "of a program: this probe instead, or what this boundary did")
                      ->type_name("NAME");
    auto* stages = history->add_flag("--stages", options.stages, "of a program: its stages instead, and what ended them");
    stages->excludes(probe);
    add_format(history, options);
    CLI::App* strength = table("strength", "strength, strain, cracks at the peak and checks of the run, a row a run");
    strength->add_flag("--summary", options.summary, "means over seeds by test and confining pressure, UCS/BTS, DTS/BTS");
    table("moduli",
          "E and nu: chord from the start to half the peak, gauges over the central half; raw, converted from plane strain "
          "and predicted from contact compliance");
    table("toughness", "fracture toughness K_IC from tension of rectangles with a notch through the middle, a row a run");
    add_capped(table("envelope", "cohesion, friction angle and Hoek-Brown constants of a set of tests, 95 % intervals"), options);
    add_capped(table("size-effect", "power law of strength against mean edge, a fit for each test and confining pressure"),
               options);
    CLI::App* trend = add_command(app, "trend", "line or power law of a column against another, intervals, elasticity");
    add_trend(trend, options);
    add_format(trend, options);
    CLI::App* fpz = add_command(app, "fpz", "the fracture process zone of a rock, every number with its equation");
    fpz->add_option("--material", options.material, "material: a name of share/materials or a TOML file")->required();
    add_format(fpz, options);
}

void add_ccd(CLI::App& app, PostOptions& options) {
    CLI::App* ccd = app.add_subcommand("ccd", "central composite designs: runs to make, response surfaces, the factors wanted");
    ccd->require_subcommand(1);
    CLI::App* design = add_command(*ccd, "design", "the runs of a central composite design");
    add_names(design, "--factor", options.ccd.factors, "NAME=LOW:HIGH", "factor with its values at -1 and +1, unit in its name");
    add_choice<ccd::Star>(*design, "--star", options.ccd.star,
                          {{"rotatable", ccd::Star::rotatable}, {"face-centred", ccd::Star::face_centred}},
                          "star points at (2^k)^(1/4), or on the faces");
    add_integer<std::size_t>(*design, "--centre-runs", options.ccd.centre_runs, "runs at the centre", 0, 1000);
    add_format(design, options);
    CLI::App* fit = add_command(*ccd, "fit", "quadratic response surfaces: coefficients, analysis of variance, lack of fit");
    add_model(fit, options);
    add_names(fit, "--response", options.ccd.responses, "NAME", "column to fit; may be given again");
    using FitTable = ccd::Options::FitTable;
    add_choice<FitTable>(*fit, "--table", options.ccd.fit_table,
                         {{"terms", FitTable::terms}, {"anova", FitTable::anova}, {"summary", FitTable::summary}},
                         "what to print");
    add_format(fit, options);
    CLI::App* solve =
        add_command(*ccd, "solve", "factors at which the responses are as wanted (desirability), within the design");
    add_model(solve, options);
    add_goals(solve, options);
    add_format(solve, options);
}

void add_report(CLI::App& app, PostOptions& options) {
    CLI::App* report = add_command(app, "report", "a test or a set as one HTML page that needs nothing else");
    add_files(report, options, "runs", "run files");
    report->add_option("--material", options.material, "material whose laboratory values stand beside the results");
    add_capped(report, options);
    add_output(report, options, "page: .html");
}

void add_maps(CLI::App& app, PostOptions& options) {
    CLI::App* cracks = add_command(app, "cracks", "grains and cracks as VTK series, catalogue and rosette");
    add_files(cracks, options, "run", "run file");
    add_output(cracks, options, "folder for grains.pvd, cracks.pvd and the tables");
    add_events(cracks, options);
    add_format(cracks, options);
}

}  // namespace

std::optional<PostOptions> read_options(int argc, const char* const* argv) {
    PostOptions options;
    CommonOptions common;
    CLI::App app("Turns runs into tables, VTK files and pictures");
    add_common_options(app, "graincrack-post", common, examples, post_libraries());
    app.require_subcommand(1);
    add_info(app, options);
    add_tables(app, options);
    add_ccd(app, options);
    add_maps(app, options);
    add_report(app, options);
    add_plots(app, options);
    if (!parse_command_line(app, argc, argv)) return std::nullopt;
    const CLI::App* command = app.get_subcommands().front();
    options.command = command->get_name();
    if (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        options.picture = command->get_name();
    }
    complete_files(*command, options);
    options.verbosity = common.verbosity;
    return options;
}

}  // namespace graincrack
