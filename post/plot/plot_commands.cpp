#include "post/plot/plot_commands.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "post/chart/picture.hpp"
#include "post/cracks/export.hpp"
#include "post/measure/caveats.hpp"
#include "post/plot/plots.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/file/h5_file.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

/// The options of all pictures; each picture declares its own.
struct PlotOptions {
    std::string picture;  ///< .png, .svg or .pdf, or the folder of all frames
    PictureSize size;
    PictureStyle style;
    std::vector<std::string> labels;  ///< "RUN=TEXT"
    std::string material;
    CrackMapOptions map;  ///< its label also serves pictures that are not maps
    EnvelopeOptions envelope;
    ccd::SolveOptions problem;
    LawPlotOptions law;
    PlaneCondition plane = PlaneCondition::strain;
    std::optional<FractureEnergyChoice> fracture_energy;
    TablePlotOptions columns;
};

/// A picture: the arguments of `plot NAME`, and its drawing function.
struct Plot {
    const char* name;
    const char* help;
    std::vector<std::string> examples;
    std::optional<FileArguments> files;
    std::vector<void (*)(OptionSet, PlotOptions&)> options;  ///< in the order of --help
    Drawing (*draw)(const PlotOptions&, const Call&);
};

void picture(OptionSet set, PlotOptions& options) {
    static constexpr Quantity width{"width", Dimension::length, 0.04, 2, "width of a picture on paper"};
    static constexpr Quantity resolution{"dpi", Dimension::one, 10, 2400, "pixels of a PNG to an inch"};
    add_output(set, options.picture, "picture: .png, .svg or .pdf", {".png", ".svg", ".pdf"});
    add_quantity(set, "--width", options.size.width, width,
                 "width on paper; letters of 6 to 7 pt in a column of 84 mm, of 8 to 10 pt over two of 174 mm");
    add_quantity(set.seldom(), "--dpi", options.size.resolution, resolution,
                 "pixels of a PNG to an inch of --width (default: 300)");
    add_text(set, "--title", options.style.title, "title in place of the picture's own").type_name("TEXT");
}

void add_limits(OptionSet set, const std::string& option, std::optional<AxisLimits>& limits, const std::string& what) {
    add_value(
        set.seldom(), option, [&limits, option](const std::string& text) { limits = parse_limits(text, option); },
        what + " in its unit, such as 0,0.4; what lies outside is cut off", "LOW,HIGH", "");
}

void chart(OptionSet set, PlotOptions& options) {
    picture(set, options);
    add_limits(set, "--x-limits", options.style.x_limits, "level axis");
    add_limits(set, "--y-limits", options.style.y_limits, "upright axis");
}

void run_labels(OptionSet set, PlotOptions& options) {
    add_texts(set, "--label", options.labels, "RUN=TEXT", "text in the legend for a file; may be given again");
}

void frame(OptionSet set, PlotOptions& options) {
    constexpr Quantity frame_time{"time", Dimension::time, 0, std::numeric_limits<double>::infinity(), "simulated time"};
    constexpr Quantity magnification{"magnify", Dimension::one, 0, 1e6, "factor on displacements"};
    add_text(set, "--frame", options.map.frame,
             "frame: first, before, peak, after (80 % of the peak on that side), last or a number from 0; for cracks "
             "several with commas stand side by side, once where they mean the same, and all are numbered PNG of one scale in "
             "the folder of --output");
    add_quantity(set, "--time", options.map.time, frame_time, "frame nearest to a simulated time");
    add_choice<MapFill>(
        set, "--fill", options.map.fill,
        {{"mineral", MapFill::mineral},
         {"sigma1", MapFill::sigma1},
         {"sigma3", MapFill::sigma3},
         {"displacement", MapFill::displacement}},
        "what colours the grains: their minerals, the greatest (sigma1) or least (sigma3) compression in the plane, "
        "displacements");
    add_quantity(set, "--magnify", options.map.magnification, magnification, "draw displacements so many times as large", "1");
}

void crack_label(OptionSet set, PlotOptions& options) { add_crack_label(set, options.map.label); }
void envelope(OptionSet set, PlotOptions& options) { add_envelope_options(set, options.envelope); }

void problem(OptionSet set, PlotOptions& options) {
    ccd::add_model(set, options.problem.model);
    ccd::add_goals(set, options.problem.goals);
}

void law(OptionSet set, PlotOptions& options) {
    constexpr Quantity normal_stress{"normal_stress", Dimension::stress, 0, 1e12, "compression across a contact"};
    add_text(set, "--material", options.material, "material: a name of share/materials or a TOML file");
    add_texts(set, "--contact-law", options.law.laws, "NAME", "law to draw; may be given again; default: that of the material")
        .excludes(add_flag(set, "--all-laws", options.law.all, "all laws with the values of the material"));
    add_choice<PlaneCondition>(set, "--plane", options.plane,
                               {{"strain", PlaneCondition::strain}, {"stress", PlaneCondition::stress}}, "plane condition");
    add_fracture_energy(set, options.fracture_energy, "fracture energy of the contacts: mixed (Eq 32), mode-i or a value");
    add_quantity(set, "--normal-stress", options.law.normal_stress, normal_stress, "compression for the curve of shear", "20MPa");
}

void columns(OptionSet set, PlotOptions& options) {
    add_text(set, "--x", options.columns.x, "column along x").required();
    add_texts(set, "--y", options.columns.y, "NAME", "column along y; may be given again").required();
    add_flag(set, "--points", options.columns.points, "points instead of lines");
}

Drawing curve_picture(const PlotOptions& options, const Call& call) {
    std::vector<RunData> runs;
    CaveatCount doubts;
    std::vector<std::string> lines;  // lines of a single run
    for (const std::string& file : call.files) {
        const RunReader reader(file);
        runs.push_back(run_data(reader, options.map.label));
        const std::vector<Caveat> caveats = caveats_of(reader, runs.back());
        doubts.add(runs.back(), caveats);
        for (const Caveat& caveat : caveats) lines.push_back(note_line(caveat));
    }
    return draw_curves(runs, definition_of(options.map.label.of(runs.front().header)), runs.size() == 1 ? lines : doubts.lines(),
                       options.style);
}

Drawing rosette_picture(const PlotOptions& options, const Call& call) {
    const RunReader run(call.file());
    const Specimen specimen = run.specimen();
    const CrackLabelChoice& label = options.map.label;
    return draw_rosette(crack_rosette(read_labelled_cracks(run, specimen, label), specimen), test_title(run.header()), run.name(),
                        definition_of(label.of(run.header())), options.style);
}

Drawing envelope_picture(const PlotOptions& options, const Call& call) {
    const std::vector<RunData> runs = read_once_each(call.files, call.command, call.diagnostics());
    const EnvelopeTests tests = collect_envelope_tests(runs, options.envelope);
    print_left_out(call.diagnostics(), "envelope", tests.left_out);
    return draw_envelope(tests, runs.front().header.material, options.style);
}

Drawing size_effect_picture(const PlotOptions& options, const Call& call) {
    const std::vector<RunData> runs = read_once_each(call.files, call.command, call.diagnostics());
    const std::vector<SizeSeries> series = collect_sizes(runs, options.envelope);
    for (const SizeSeries& s : series) print_left_out(call.diagnostics(), "size-effect", s.left_out);
    return draw_size_effect(series, options.style);
}

Drawing law_picture(const PlotOptions& options, const Call& call) {
    LawPlotOptions own = options.law;
    if (!call.files.empty()) {
        const RunHeader header = RunReader(call.file()).header();
        own.own = header.contact_law;
        return draw_laws(header.contact, fmt::format("{}, {}", header.material, header.contact_law), own, options.style);
    }
    if (options.material.empty()) throw UsageError("plot law: neither a run nor a material; give a run file or --material NAME");
    const Material material = read_material_of(call, options.material);
    own.own = material.law.empty() ? name_of(default_law) : material.law;
    return draw_laws(contact_parameters(material, options.plane, options.fracture_energy),
                     fmt::format("{}, plane {}", material.name, name_of(options.plane)), own, options.style);
}

std::vector<Plot> plots_of_runs() {
    return {
        {"specimen",
         "the grains of a specimen",
         {"disc.h5 -o disc.png", "uniaxial.h5 -o specimen.svg"},
         FileArguments{"file", "specimen or run"},
         {picture},
         [](const PlotOptions& options, const Call& call) {
             return draw_specimen(read_specimen(H5Input(call.file())), options.style);
         }},
        {"curve",
         "stress against axial and lateral strain, several runs on one plot",
         {"uniaxial.h5 triaxial.h5 -o curves.png", "uniaxial.h5 --label uniaxial=dry --width 84mm -o curve.pdf"},
         several_runs,
         {chart, run_labels, crack_label},
         curve_picture},
        {"cracks",
         "crack map: tensile red, shear black",
         {"brazilian.h5 --frame before,peak,after -o cracks.png", "uniaxial.h5 --frame all --magnify 10 -o frames"},
         one_run,
         {picture, frame, crack_label},
         [](const PlotOptions& options, const Call& call) {
             return draw_cracks(RunReader(call.file()), options.map, options.style);
         }},
        {"rosette",
         "directions of the cracks by mode, over those of the facets",
         {"uniaxial.h5 -o rosette.png", "brazilian.h5 --crack-event broken -o rosette.svg"},
         one_run,
         {picture, crack_label},
         rosette_picture},
        {"energy",
         "the energy balance over a test",
         {"uniaxial.h5 -o energy.png", "brazilian.h5 --width 84mm -o energy.svg"},
         one_run,
         {chart},
         [](const PlotOptions& options, const Call& call) { return draw_energy(read_run_data(call.file()), options.style); }},
        {"thresholds",
         "crack initiation and damage on axial, lateral and volumetric strain",
         {"uniaxial.h5 -o thresholds.png", "triaxial.h5 --width 84mm -o thresholds.svg"},
         one_run,
         {chart},
         [](const PlotOptions& options, const Call& call) { return draw_thresholds(read_run_data(call.file()), options.style); }},
    };
}

std::vector<Plot> plots_of_sets() {
    return {
        {"envelope",
         "Mohr circles, Mohr-Coulomb and Hoek-Brown envelopes",
         {"uniaxial.h5 triaxial.h5 -o envelope.png",
          "uniaxial.h5 triaxial.h5 brazilian.h5 --strength largest --capped accept -o envelope.svg"},
         several_runs,
         {chart, envelope},
         envelope_picture},
        {"size-effect",
         "strength against mean edge with the power law",
         {"brazilian-coarse.h5 brazilian.h5 -o size.png", "brazilian-coarse.h5 brazilian.h5 --strength largest -o size.svg"},
         several_runs,
         {chart, envelope},
         size_effect_picture},
        {"surface",
         "contours of response surfaces with the optimum and its joint region",
         {"table7.csv --target C_MPa=21 --target phi_deg=53 -o surface.png",
          "table7.csv --target C_MPa=21 --target phi_deg=53 --model backward -o surface.svg"},
         ccd::design_table,
         {problem, chart},
         [](const PlotOptions& options, const Call& call) {
             return draw_surface(ccd::solve_problem(call.file(), options.problem), options.style);
         }},
        {"law",
         "curves of the contact laws, by a material or as in a run",
         {"--material augig-granite -o law.png", "uniaxial.h5 --normal-stress 50MPa -o law.svg"},
         FileArguments{"run", "run file", false},
         {law, picture},
         law_picture},
        {"lennard-jones",
         "the potential of Eqs 20-22 (Fig 11)",
         {"-o potential.png", "-o potential.svg"},
         std::nullopt,
         {chart},
         [](const PlotOptions& options, const Call&) { return draw_lennard_jones(options.style); }},
        {"table",
         "columns of tables against each other",
         {"strength.tsv --x mean_edge_mm --y tensile_strength_MPa --points -o table.png",
          "strength.tsv --x strain_at_peak --y tensile_cracks --y shear_cracks --points -o table.svg"},
         FileArguments{"tables", "tables", true, true},
         {columns, chart, run_labels},
         [](const PlotOptions& options, const Call& call) { return draw_tables(call.files, options.columns, options.style); }},
    };
}

/// The style for the size of the picture, with the labels of its files. \throws UsageError for a label of another file
PictureStyle style_of(const PlotOptions& options, const std::vector<std::string>& files) {
    PictureStyle style = options.style;
    const bool is_pdf = options.picture.ends_with(".pdf");
    if (options.size.width || is_pdf) style.page_width = page_width_on_paper(options.size.width.value_or(pdf_width));
    for (const std::string& label : options.labels) style.labels.push_back(parse_run_label(label));
    style.require_labels_of(files);
    return style;
}

Command command_of(const Plot& plot) {
    return make_command<PlotOptions>(
        plot.name, plot.help, plot.examples, plot.files,
        [plot](OptionSet set, PlotOptions& options) {
            for (const auto& add : plot.options) add(set, options);
        },
        [plot](const PlotOptions& options, const Call& call) {
            PlotOptions sized = options;
            const bool all_frames = options.map.frame == "all" && plot.name == std::string_view("cracks");
            if (!all_frames) require_picture(options.picture, options.size);
            sized.style = style_of(options, call.files);
            if (!all_frames) return write_picture(plot.draw(sized, call), options.picture, options.size);
            write_frames(RunReader(call.file()), sized.map, sized.style, options.picture, options.size, call.verbosity);
        });
}

}  // namespace

std::vector<Command> plot_commands() {
    std::vector<Command> commands;
    for (const auto& plots : {plots_of_runs(), plots_of_sets()}) {
        for (const Plot& plot : plots) commands.push_back(command_of(plot));
    }
    return commands;
}

}  // namespace graincrack
