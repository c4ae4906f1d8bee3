#include "mesher/mesh_options.hpp"

#include <limits>

#include "mesher/plane/triangulation.hpp"
#include "share/base/error.hpp"
#include "share/options/command_line.hpp"

namespace graincrack::mesher {

namespace {

constexpr const char* examples =
    "  graincrack-mesh rectangle --width 80mm --height 160mm --grains 1122 -o specimen.h5\n"
    "  graincrack-mesh disc --diameter 80mm --edge 5.13mm --seed 7 --material augig-granite -o disc.h5\n"
    "  graincrack-mesh rectangle --width 40mm --height 80mm --edge 3mm --phases quartz=0.3,feldspar=0.6,mica=0.1 "
    "--strength-modulus 5 -o minerals.h5";

/// Options of both shapes.
void add_mesh_options(CLI::App& shape, MeshOptions& options) {
    SpecimenRequest& request = options.request;
    CLI::Option* edge = add_quantity(shape, "--edge", request.edge, quantity::mean_edge,
                                     "requested mean edge over all grain edges, rim included");
    CLI::Option* grains =
        add_integer<std::int64_t>(shape, "--grains", request.grains, "exact number of grains, instead of --edge", 1);
    edge->excludes(grains);
    add_quantity(shape, "--spread", request.spread, quantity::edge_spread,
                 "coefficient of variation of the edges, at most 0.3; values below about 0.1 are reached only as far as a mesh "
                 "without a preferred direction allows",
                 "0.1");
    add_integer<std::uint64_t>(shape, "--seed", request.seed, "seed of the random numbers", 0);
    add_integer<int>(shape, "--elements-per-edge", request.elements_per_edge,
                     "each grain becomes N x N constant-strain triangles", 1, max_elements_per_edge);
    detail::add_value(
        shape, "--phases", [&request](const std::string& text) { request.phases.fractions = parse_phases(text); },
        "phases of the grains with their fractions of the area, whose sum is 1: quartz=0.32,feldspar=0.62,mica=0.06; reached to "
        "one grain",
        "NAME=FRACTION,...", "");
    add_integer<std::uint64_t>(shape, "--phase-seed", request.phases.seed, "seed of the phases; default: that of --seed", 0);
    add_quantity(shape, "--phase-cluster", request.phases.cluster, quantity::phase_cluster,
                 "mean number of neighbouring grains that are drawn together to be of one phase", "1");
    add_quantity(shape, "--strength-modulus", request.strength.modulus, quantity::strength_modulus,
                 "Weibull modulus of the strength of grain boundaries: each has a factor of mean 1; default: no scatter");
    add_quantity(shape, "--strength-correlation", request.strength.correlation, quantity::strength_correlation,
                 "distance at which the autocorrelation of the strength of grain boundaries is 1/e; default: uncorrelated");
    add_integer<std::uint64_t>(shape, "--strength-seed", request.strength.seed,
                               "seed of the strength of grain boundaries; default: that of --seed", 0);
    detail::add_value(
        shape, "--material", [&options](const std::string& text) { options.material = text; },
        "material (name or TOML file) whose phases and scatter of strengths are taken unless given, and whose bounds of the "
        "grain "
        "size are printed",
        "NAME|FILE", "");
    detail::add_value(
        shape, "-o,--output", [&options](const std::string& text) { options.output = text; },
        "specimen file to write; - for stdout", "FILE|-", "");
}

}  // namespace

std::optional<MeshOptions> read_options(int argc, const char* const* argv) {
    MeshOptions options;
    CommonOptions common;
    CLI::App app("Makes specimens: rectangles and discs of triangular grains of near-equal size without a preferred direction");
    add_common_options(app, "graincrack-mesh", common, examples, {triangulation_library()});
    add_dry_run(app, common, "print the expected counts and file size without making a specimen");
    app.require_subcommand(1);
    Shape rectangle{ShapeKind::rectangle, 0, 0, Pole::facet};
    CLI::App* rectangle_app = app.add_subcommand("rectangle", "a rectangle, loaded along its height");
    add_quantity(*rectangle_app, "--width", rectangle.width, quantity::width, "width, across the load")->required();
    add_quantity(*rectangle_app, "--height", rectangle.height, quantity::height, "height, along the load")->required();
    add_quantity(*rectangle_app, "--notch", options.request.notch, quantity::notch,
                 "length of a notch through the centre, across the load, whose grain boundaries are broken from the start; the "
                 "width of the specimen makes it a joint");
    add_mesh_options(*rectangle_app, options);

    Shape disc{ShapeKind::disc, 0, 0, Pole::facet};
    CLI::App* disc_app = app.add_subcommand("disc", "a disc, loaded along its vertical diameter");
    add_quantity(*disc_app, "--diameter", disc.width, quantity::diameter, "diameter")->required();
    add_choice<Pole>(*disc_app, "--pole", disc.pole, {{"facet", Pole::facet}, {"vertex", Pole::vertex}},
                     "part of the rim that meets the platens");
    add_integer<int>(*disc_app, "--diameters", disc.diameters,
                     "number of diameters that can be loaded, at equal angles: 6 for every 30 degrees", 1, max_diameters);
    add_integer<int>(*disc_app, "--loaded-diameter", disc.loaded_diameter,
                     "index of the diameter along the load, counter-clockwise from 0: the same grains, rotated", 0,
                     max_diameters - 1);
    add_mesh_options(*disc_app, options);

    if (!parse_command_line(app, argc, argv)) return std::nullopt;
    disc.height = disc.width;
    options.request.shape = disc_app->parsed() ? disc : rectangle;
    options.verbosity = common.verbosity;
    options.dry_run = common.dry_run;
    options.configuration = effective_configuration(app);
    if (options.output.empty() && !options.dry_run) {
        throw UsageError("-o: missing; give the specimen file to write, or - for stdout");
    }
    return options;
}

}  // namespace graincrack::mesher
