#include "post/commands/plot_options.hpp"

#include <limits>

#include "post/commands/option_parts.hpp"

namespace graincrack {

namespace {

constexpr Quantity frame_time{"time", Dimension::time, 0, std::numeric_limits<double>::infinity(), "simulated time"};
constexpr Quantity magnification{"magnify", Dimension::one, 0, 1e6, "factor on displacements"};
constexpr Quantity normal_stress{"normal_stress", Dimension::stress, 0, 1e12, "compression across a contact"};

/// A picture from files.
CLI::App* add_picture(CLI::App& plot, PostOptions& options, const std::string& name, const std::string& help,
                      const std::string& files) {
    CLI::App* command = add_command(plot, name, help);
    add_files(command, options, files, files == "runs" ? "run files" : files == "run" ? "run file" : "specimen or run");
    add_output(command, options, "picture: .png or .svg");
    return command;
}

void add_maps(CLI::App& plot, PostOptions& options) {
    for (CLI::App* map : {add_picture(plot, options, "cracks", "crack map: tensile red, shear black", "run"),
                          add_picture(plot, options, "fragments", "what still hangs together", "run")}) {
        map->add_option("--frame", options.crack_map.frame,
                        "frame: first, before, peak, after (80 % of the peak on that side), last or a number from 0; for cracks "
                        "several with commas stand side by side, once where they mean the same")
            ->capture_default_str();
        add_quantity(*map, "--time", options.crack_map.time, frame_time, "frame nearest to a simulated time");
        add_quantity(*map, "--magnify", options.crack_map.magnification, magnification,
                     "draw displacements so many times as large", "1");
    }
    add_picture(plot, options, "rosette", "directions of the cracks by mode, over those of the facets", "run");
    add_picture(plot, options, "counts", "micro-cracks over the loading by mode and pair of minerals", "run");
    add_events(add_picture(plot, options, "emission", "acoustic emission: number of events by magnitude, b-value", "run"),
               options);
}

void add_law(CLI::App& plot, PostOptions& options) {
    CLI::App* law = add_command(plot, "law", "curves of the contact laws, by a material or as in a run");
    add_files(law, options, "run", "run file");
    law->add_option("--material", options.material, "material: a name of share/materials or a TOML file");
    add_names(law, "--contact-law", options.law.laws, "NAME", "law to draw; may be given again; all unless given");
    add_choice(*law, "--coupling", options.law.coupling, {"full", "none"}, "whether failure in one mode takes the other");
    add_choice<PlaneCondition>(*law, "--plane", options.plane,
                               {{"strain", PlaneCondition::strain}, {"stress", PlaneCondition::stress}}, "plane condition");
    add_fracture_energy(*law, options.fracture_energy, "fracture energy of the contacts: mixed (Eq 32), mode-i or a value");
    add_quantity(*law, "--normal-stress", options.law.normal_stress, normal_stress, "compression for the curve of shear",
                 "20MPa");
    add_output(law, options, "picture: .png or .svg");
    add_output(add_command(plot, "lennard-jones", "the potential of Eqs 20-22 (Fig 11)"), options, "picture: .png or .svg");
}

}  // namespace

void add_plots(CLI::App& app, PostOptions& options) {
    CLI::App* plot = app.add_subcommand("plot", "pictures, without a display");
    plot->require_subcommand(1);
    add_picture(*plot, options, "specimen", "the grains of a specimen", "file");
    CLI::App* curve =
        add_picture(*plot, options, "curve", "stress against axial and lateral strain, several runs on one plot", "runs");
    add_names(curve, "--laboratory", options.laboratory, "FILE",
              "table of a measured curve: axial_strain (or axial_strain_percent), stress_MPa, perhaps lateral_strain");
    add_picture(*plot, options, "strength", "strengths by test with means and intervals, beside the laboratory's", "runs")
        ->add_option("--material", options.material, "material whose laboratory values stand beside the results");
    add_maps(*plot, options);
    add_picture(*plot, options, "energy", "the energy ledger over the strain", "run");
    add_picture(*plot, options, "thresholds", "crack initiation and damage on stress and volumetric strain", "run");
    CLI::App* envelope = add_picture(*plot, options, "envelope", "Mohr circles, Mohr-Coulomb and Hoek-Brown envelopes", "runs");
    add_capped(envelope, options);
    add_names(envelope, "--laboratory", options.laboratory, "FILE",
              "table of measured strengths: confining_pressure_MPa, strength_MPa");
    add_capped(add_picture(*plot, options, "size-effect", "strength against mean edge with the power law", "runs"), options);
    CLI::App* surface = add_command(*plot, "surface", "contours of response surfaces with the optimum and its joint region");
    add_model(surface, options);
    add_goals(surface, options);
    add_output(surface, options, "picture: .png or .svg");
    add_law(*plot, options);
    CLI::App* trend = add_command(*plot, "trend", "columns of tables with the line or power law through them");
    add_trend(trend, options);
    add_output(trend, options, "picture: .png or .svg");
    CLI::App* table = add_command(*plot, "table", "columns of tables against each other");
    add_files(table, options, "tables", "tables");
    table->add_option("--x", options.table_plot.x, "column along x")->required();
    add_names(table, "--y", options.table_plot.y, "NAME", "column along y; may be given again");
    table->get_option("--y")->required();
    table->add_flag("--points", options.table_plot.points, "points instead of lines");
    add_output(table, options, "picture: .png or .svg");
}

}  // namespace graincrack
