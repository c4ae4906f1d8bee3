#include "post/options.hpp"

#include <limits>

#include "share/command_line.hpp"

namespace graincrack {

namespace {

constexpr Quantity frame_time{"time", Dimension::time, 0, std::numeric_limits<double>::infinity(), "simulated time"};
constexpr Quantity magnification{"magnify", Dimension::one, 0, 1e6, "factor on displacements"};

constexpr Quantity significance{"alpha", Dimension::one, 0, 1, "level of significance", true};

const char* const examples =
    "  graincrack-post strength uniaxial.h5 brazilian.h5\n"
    "  graincrack-post plot cracks uniaxial.h5 --frame peak -o cracks.png\n";

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& help) { return app.add_subcommand(name, help); }

void add_files(CLI::App* command, PostOptions& options, const std::string& name, const std::string& help) {
    command->add_option(name, options.files, help + " (- is stdin)")->required()->type_name("FILE")->configurable(false);
}

void add_format(CLI::App* command, PostOptions& options) {
    add_choice<TableFormat>(*command, "--format", options.format, {{"tsv", TableFormat::tsv}, {"jsonl", TableFormat::jsonl}},
                            "form of the table: tab-separated with one header line, or JSON lines");
}

void add_capped(CLI::App* command, PostOptions& options) {
    add_choice<CappedRuns>(*command, "--capped", options.capped_runs,
                           {{"refuse", CappedRuns::refuse}, {"accept", CappedRuns::accept}},
                           "runs that the strain cap ended: refuse them, or take their largest stress for a peak and say so");
}

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
    add_format(history, options);
    CLI::App* strength = table("strength", "strength, strain, cracks at the peak and checks of the run, a row a run");
    strength->add_flag("--summary", options.summary, "means over seeds by test and confining pressure, UCS/BTS, DTS/BTS");
    table("moduli",
          "E and nu: chord from the start to half the peak, gauges over the central half; raw, converted from plane strain "
          "and predicted from contact compliance");
    add_capped(table("envelope", "cohesion, friction angle and Hoek-Brown constants of a set of tests, 95 % intervals"), options);
    add_capped(table("size-effect", "power law of strength against mean edge, a fit for each test and confining pressure"),
               options);
    CLI::App* fpz = add_command(app, "fpz", "the fracture process zone of a rock, every number with its equation");
    fpz->add_option("--material", options.material, "material: a name of share/materials or a TOML file")->required();
    add_format(fpz, options);
}

void add_names(CLI::App* command, const std::string& option, std::vector<std::string>& target, const std::string& type,
               const std::string& help) {
    command->add_option(option, target, help)->type_name(type)->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

/// Options of everything that fits a model to the runs of a design.
void add_model(CLI::App* command, PostOptions& options) {
    add_files(command, options, "table", "table of the runs: x1, x2, … and the responses");
    add_names(command, "--factor", options.ccd.factors, "NAME=LOW:HIGH",
              "factor with its values at -1 and +1, if the table has no x1");
    add_choice<bool>(*command, "--model", options.ccd.model.reduce, {{"full", false}, {"backward", true}},
                     "full quadratic, or reduced by backward elimination that keeps the hierarchy");
    add_quantity(*command, "--alpha", options.ccd.model.alpha, significance, "p above which elimination leaves a term out",
                 "0.1");
}

void add_goals(CLI::App* command, PostOptions& options) {
    add_names(command, "--target", options.ccd.targets, "NAME=[LOW:]TARGET[:HIGH]",
              "wanted value of a response; limits are the measured extremes unless given");
    add_names(command, "--maximise", options.ccd.maxima, "NAME=LOW:GOOD", "response as large as can be, useless at LOW");
    add_names(command, "--minimise", options.ccd.minima, "NAME=GOOD:HIGH", "response as small as can be, useless at HIGH");
}

void add_ccd(CLI::App& app, PostOptions& options) {
    CLI::App* ccd = add_command(app, "ccd", "central composite designs: runs to make, response surfaces, the factors wanted");
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

void add_maps(CLI::App& app, PostOptions& options) {
    CLI::App* cracks = add_command(app, "cracks", "grains and cracks as VTK series, catalogue and rosette");
    add_files(cracks, options, "run", "run file");
    cracks->add_option("-o,--output", options.output, "folder for grains.pvd, cracks.pvd, cracks.tsv, rosette.tsv")->required();
}

void add_plots(CLI::App& app, PostOptions& options) {
    CLI::App* plot = add_command(app, "plot", "pictures, without a display");
    plot->require_subcommand(1);
    const auto picture = [&](const std::string& name, const std::string& help, const std::string& files) {
        CLI::App* command = add_command(*plot, name, help);
        add_files(command, options, files, files == "runs" ? "run files" : files == "run" ? "run file" : "specimen or run");
        command->add_option("-o,--output", options.output, "picture: .png or .svg")->required();
        return command;
    };
    picture("specimen", "the grains of a specimen", "file");
    CLI::App* curve = picture("curve", "stress against axial and lateral strain, several runs on one plot", "runs");
    curve
        ->add_option("--laboratory", options.laboratory,
                     "table of a measured curve: axial_strain (or axial_strain_percent), stress_MPa, perhaps lateral_strain")
        ->type_name("FILE");
    add_capped(picture("envelope", "Mohr circles of a set of tests, Mohr-Coulomb and Hoek-Brown envelopes", "runs"), options);
    add_capped(picture("size-effect", "strength against mean edge with the power law", "runs"), options);
    CLI::App* surface = add_command(*plot, "surface", "contours of response surfaces with the optimum and its joint region");
    add_model(surface, options);
    add_goals(surface, options);
    surface->add_option("-o,--output", options.output, "picture: .png or .svg")->required();
    CLI::App* cracks = picture("cracks", "crack map: tensile red, shear black", "run");
    cracks->add_option("--frame", options.crack_map.frame, "frame: first, peak, last or a number from 0")->capture_default_str();
    add_quantity(*cracks, "--time", options.crack_map.time, frame_time, "frame nearest to a simulated time");
    add_quantity(*cracks, "--magnify", options.crack_map.magnification, magnification,
                 "draw displacements so many times as large", "1");
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
    add_plots(app, options);
    if (!parse_command_line(app, argc, argv)) return std::nullopt;
    const CLI::App* command = app.get_subcommands().front();
    options.command = command->get_name();
    if (!command->get_subcommands().empty()) options.picture = command->get_subcommands().front()->get_name();
    options.verbosity = common.verbosity;
    return options;
}

}  // namespace graincrack
