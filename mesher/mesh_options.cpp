#include "mesher/mesh_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "mesher/mesh_settings.hpp"
#include "mesher/plane/triangulation.hpp"
#include "mesher/region/region_files.hpp"
#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"
#include "share/options/command_line.hpp"

namespace graincrack::mesher {

namespace {

constexpr int max_diameters = 36;  ///< loaded diameters of a disc

constexpr const char* examples =
    "  graincrack-mesh rectangle --width 80mm --height 160mm --grains 1122 -o specimen.h5\n"
    "  graincrack-mesh disc --diameter 80mm --edge 5.13mm --seed 7 --material augig-granite -o disc.h5\n"
    "  graincrack-mesh rectangle --width 40mm --height 80mm --edge 3mm --phases quartz=0.3,feldspar=0.6,mica=0.1 "
    "--strength-modulus 5 -o minerals.h5\n"
    "  graincrack-mesh import section.msh --scale 1mm -o section.h5\n"
    "  graincrack-mesh import thin-section.png --write-key labels.tsv\n"
    "  graincrack-mesh import thin-section.png --pixel-size 0.1mm --phase-key minerals.tsv --crystals break -o section.h5";

/// Values of the options of a kind of specimens, which kinds share.
struct KindOptions {
    double width = 0, height = 0, diameter = 0, inner_diameter = 0;
    Pole pole = Pole::facet;
    int diameters = 1, loaded_diameter = 0;
    std::optional<double> flats;
    std::optional<double> notch;
    std::optional<double> angle;  ///< angle of a slit
    std::optional<double> place;  ///< place of a slit from below, along x
    std::string file;
    std::optional<double> grain_size;  ///< equal-area diameter
};

/// A kind of specimens: a subcommand with its options, which make the region of a request.
struct Kind {
    const char* name;
    const char* help;
    void (*add_options)(OptionSet, KindOptions&);
    void (*make)(const KindOptions&, Request&);
};

void add_width(OptionSet set, KindOptions& options, const char* name) {
    add_quantity(set, name, options.width, quantity::width, "width, along x").of(SettingGroup::size).required();
}
void add_height(OptionSet set, KindOptions& options) {
    add_quantity(set, "--height", options.height, quantity::height, "height, along the load").of(SettingGroup::size).required();
}
void add_diameter(OptionSet set, KindOptions& options) {
    add_quantity(set, "--diameter", options.diameter, quantity::diameter, "diameter").of(SettingGroup::size).required();
}

const Kind kinds[] = {
    {"rectangle", "a rectangle, loaded along its height",
     [](OptionSet set, KindOptions& options) {
         add_width(set, options, "--width");
         add_height(set, options);
         add_quantity(
             set.usual(), "--slit", options.notch, quantity::notch,
             "length of a slit through the centre, across the load, whose grain boundaries are broken from the start; the "
             "width of the specimen makes it a joint")
             .of(SettingGroup::cuts);
         add_quantity(
             set, "--slit-angle", options.angle, quantity::direction,
             "direction of the slit from x: a straight slit, which grain boundaries follow; default: across the load, of "
             "triangles along whole grain boundaries as they lie, of crystals straight")
             .of(SettingGroup::cuts);
     },
     [](const KindOptions& options, Request& request) {
         request.region = rectangle(options.width, options.height);
         if (options.angle && !options.notch) throw UsageError("--slit-angle: there is no slit; add --slit 20mm");
         if (options.angle) {
             request.region.edges = {central_slit(request.region, *options.notch, *options.angle, "--slit")};
         } else {
             request.notch = options.notch;
         }
     }},
    {"disc", "a disc, loaded along its vertical diameter",
     [](OptionSet set, KindOptions& options) {
         add_diameter(set, options);
         Option pole = add_choice<Pole>(set, "--pole", options.pole, {{"facet", Pole::facet}, {"vertex", Pole::vertex}},
                                        "part of the rim that meets the platens")
                           .of(SettingGroup::shape);
         Option diameters =
             add_integer<int>(set, "--diameters", options.diameters,
                              "number of diameters that can be loaded, at equal angles: 6 for every 30 degrees", 1, max_diameters)
                 .of(SettingGroup::none);
         Option loaded =
             add_integer<int>(
                 set, "--loaded-diameter", options.loaded_diameter,
                 "index of the diameter along the load, counter-clockwise from 0: the same grains, rotated, with holes and flaws",
                 0, max_diameters - 1)
                 .of(SettingGroup::seed);
         Option flats = add_quantity(set, "--flats", options.flats, quantity::flats,
                                     "angle under which flat poles, the parts top and bottom, are seen from the centre")
                            .of(SettingGroup::shape);
         for (Option other : {pole, diameters, loaded}) flats.excludes(other);
         add_quantity(set.usual(), "--slit", options.notch, quantity::slit, "length of a straight crack through the centre")
             .of(SettingGroup::cuts);
         add_quantity(set, "--slit-angle", options.angle, quantity::direction,
                      "direction of the crack from x; 90deg along the load; default: 90deg")
             .of(SettingGroup::cuts, [&options] {
                 return options.notch ? SettingValue(options.angle.value_or(quantity::right_angle)) : SettingValue();
             });
     },
     [](const KindOptions& options, Request& request) {
         request.region = options.flats ? disc_with_flats(options.diameter, *options.flats)
                                        : disc(options.diameter, options.pole, options.diameters, options.loaded_diameter);
         if (options.angle && !options.notch) throw UsageError("--slit-angle: there is no slit; add --slit 20mm");
         if (options.notch) {
             request.region.edges = {
                 central_slit(request.region, *options.notch, options.angle.value_or(quantity::right_angle), "--slit")};
         }
     }},
    {"ring", "a ring, loaded along its vertical diameter",
     [](OptionSet set, KindOptions& options) {
         add_diameter(set, options);
         add_quantity(set, "--inner-diameter", options.inner_diameter, quantity::diameter, "diameter of the hole")
             .of(SettingGroup::shape)
             .required();
     },
     [](const KindOptions& options, Request& request) {
         if (!(options.inner_diameter < options.diameter)) throw UsageError("--inner-diameter: must be less than --diameter");
         request.region = ring(options.diameter, options.inner_diameter);
     }},
    {"beam", "a beam along x, to be bent",
     [](OptionSet set, KindOptions& options) {
         add_width(set, options, "--length");
         add_height(set, options);
         add_quantity(set.usual(), "--slit", options.notch, quantity::slit,
                      "length of a straight crack from below, at mid-length or --slit-at")
             .of(SettingGroup::cuts);
         add_quantity(set, "--slit-at", options.place, quantity::coordinate, "place of the crack from mid-length along x")
             .of(SettingGroup::cuts);
     },
     [](const KindOptions& options, Request& request) {
         request.region = rectangle(options.width, options.height);
         request.region.name = "beam";
         if (options.place && !options.notch) throw UsageError("--slit-at: there is no slit; add --slit 20mm");
         if (options.notch) {
             request.region.edges = {slit_from_below(request.region, *options.notch, "--slit", options.place.value_or(0))};
         }
     }},
    {"half-disc", "half a disc on its flat side, to be bent",
     [](OptionSet set, KindOptions& options) {
         add_diameter(set, options);
         add_quantity(set.usual(), "--slit", options.notch, quantity::slit,
                      "length of a straight crack from the middle of the flat side")
             .of(SettingGroup::cuts);
     },
     [](const KindOptions& options, Request& request) {
         request.region = half_disc(options.diameter);
         if (options.notch) request.region.edges = {slit_from_below(request.region, *options.notch, "--slit")};
     }},
    {"polygon", "a polygon from a file, moved so that the middle of its extent is the origin",
     [](OptionSet set, KindOptions& options) {
         add_text(set, "file", options.file,
                  "TSV with columns x_mm and y_mm of the corners and, if there is one, part: the name of the side from a corner "
                  "to the next (side unless given; top, bottom, left and right are those of a rectangle)")
             .type_name("FILE")
             .required();
     },
     [](const KindOptions& options, Request& request) { request.region = read_polygon(options.file); }},
};

/// Cuts in a specimen of any kind.
struct CutOptions {
    std::vector<std::string> holes;
    std::vector<std::string> joint_sets;
    std::string flaws, hole_file;
};

void add_cuts(OptionSet set, CutOptions& options) {
    add_texts(set, "--hole", options.holes, "X,Y,RADIUS",
              "round hole, as 10mm,-5mm,4mm; may be given again; its part is hole_1, hole_2 …");
    add_text(
        set, "--flaws", options.flaws,
        "straight flaws that grain boundaries follow: TSV with columns x1_mm, y1_mm, x2_mm, y2_mm and, if needed, class: broken "
        "(from the start; the default), intact or a NAME, whose contacts have the parameters [flaws.NAME] of the material, and "
        "state: broken or intact")
        .type_name("FILE");
    add_text(set, "--holes", options.hole_file, "round holes: TSV with columns x_mm, y_mm, radius_mm").type_name("FILE");
    add_texts(
        set, "--joint-set", options.joint_sets, "KEY=VALUE,...",
        "parallel joints at random: spacing=20mm,dip=45deg and, if needed, persistence=0.7 (fraction of a line that is jointed), "
        "length=30mm (mean; default: the spacing), class=broken|intact|NAME, state=broken|intact; may be given again");
}

/// Notes the units assumed for bare lengths in a list: for all in "X,Y,RADIUS", for these keys in "KEY=VALUE,...".
void note_lengths(std::string_view text, const std::string& option) {
    constexpr std::array<std::string_view, 4> keys{"", "spacing", "length", "distance"};
    for (const std::string_view item : split(text, ',')) {
        const std::size_t equals = item.find('=');
        const std::string_view key = equals == std::string_view::npos ? "" : item.substr(0, equals);
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) continue;
        const std::string_view value = equals == std::string_view::npos ? item : item.substr(equals + 1);
        note_bare_number(value, quantity::coordinate, key.empty() ? option : fmt::format("{}: {}", option, key));
    }
}

/// The fields of a text. \throws UsageError naming `where` unless their number is the requested one
std::vector<std::string_view> parts_of(std::string_view text, std::size_t n, const std::string& where, const char* requested) {
    std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() == n) return parts;
    throw UsageError(where + ": \"" + std::string(text.substr(0, 60)) + "\" is not understood; give " + requested);
}

Point parse_point(const std::string& text, const std::string& where) {
    const auto parts = parts_of(text, 2, where, "X,Y as 40mm,80mm");
    return {parse_quantity(parts[0], quantity::coordinate, where), parse_quantity(parts[1], quantity::coordinate, where)};
}

/// Cuts a hole from the text of its centre and radius. \throws UsageError naming `where`
void cut_hole(const std::string& text, const std::string& where, Region& region) {
    const auto parts = parts_of(text, 3, where, "X,Y,RADIUS as 10mm,-5mm,4mm");
    add_hole(region,
             {parse_quantity(parts[0], quantity::coordinate, where), parse_quantity(parts[1], quantity::coordinate, where)},
             parse_quantity(parts[2], quantity::hole_radius, where), where);
}

/// Cuts holes and flaws, whose coordinates are those of the kind before the region is centred.
/// \return the translation, m
Point make_cuts(const CutOptions& options, Request& request) {
    const auto numbered = [](const char* option, std::size_t i, std::size_t n) {
        return std::string(option) + (n > 1 ? " " + std::to_string(i + 1) : "");
    };
    for (std::size_t i = 0; i < options.holes.size(); ++i) {
        cut_hole(options.holes[i], numbered("--hole", i, options.holes.size()), request.region);
    }
    if (!options.hole_file.empty()) {
        for (const Hole& hole : read_holes(options.hole_file)) add_hole(request.region, hole.centre, hole.radius, hole.name);
    }
    if (!options.flaws.empty()) {
        const auto flaws = read_flaws(options.flaws);
        request.region.edges.insert(request.region.edges.end(), flaws.begin(), flaws.end());
    }
    for (std::size_t i = 0; i < options.joint_sets.size(); ++i) {
        request.joint_sets.push_back(
            parse_joint_set(options.joint_sets[i], numbered("--joint-set", i, options.joint_sets.size())));
    }
    return centre_region(request.region);
}

/// Spread: of edges of triangles at most 0.35, of diameters of crystals more.
constexpr Quantity spread_of_grains = [] {
    Quantity spread = quantity::edge_spread;
    spread.upper = quantity::size_variation.upper;
    return spread;
}();

/// Adds the options of the size of grains, of which one applies.
void add_sizes(OptionSet set, KindOptions& kind, Fabric& fabric) {
    Option edge =
        add_quantity(
            set.usual(), "--edge", fabric.edge, quantity::mean_edge,
            "requested mean edge over all grain edges, rim included; of crystals the edge of the equilateral triangle of their "
            "mean area")
            .of(SettingGroup::none);
    Option grains = add_integer<std::int64_t>(set.usual(), "--grains", fabric.grains,
                                              "exact number of triangles, or of crystals, instead of --edge", 1)
                        .of(SettingGroup::none);
    Option grain_size = add_quantity(set.usual(), "--grain-size", kind.grain_size, quantity::grain_size,
                                     "mean equal-area diameter of triangles or crystals, instead of --edge; with --grade as many "
                                     "as without it");
    edge.excludes(grains).excludes(grain_size);
    grains.excludes(grain_size);
}

/// Adds the options of the grains.
void add_grains(OptionSet set, KindOptions& kind, Fabric& fabric) {
    add_choice<Tessellation>(
        set.usual(), "--tessellation", fabric.tessellation,
        {{"delaunay", Tessellation::delaunay}, {"voronoi", Tessellation::voronoi}, {"trigon", Tessellation::trigon}},
        "grains: triangles (delaunay), crystals of elements that do not break (voronoi), or crystals whose triangles are grains, "
        "so that they break (trigon)")
        .of(SettingGroup::fabric);
    add_quantity(
        set, "--element-size", fabric.element_size, quantity::element_size,
        "side of the triangles of crystals, the same everywhere; default: 0.36 of --edge, which makes seven to eight of them a "
        "crystal, and graded as crystals are with --grade")
        .of(SettingGroup::none)
        .excludes(add_quantity(set, "--elements-per-crystal", fabric.elements_per_crystal, quantity::elements_per_crystal,
                               "mean number of elements of a crystal instead of --element-size; the corners of crystals ask for "
                               "three to four at least")
                      .of(SettingGroup::none));
    add_choice<std::optional<SizeDistribution>>(
        set, "--size-distribution", fabric.size_distribution,
        {{"normal", SizeDistribution::normal}, {"lognormal", SizeDistribution::lognormal}},
        "distribution of the equal-area diameters of crystals; default: normal")
        .of(SettingGroup::fabric, [&fabric] {
            const bool is_normal = fabric.size_distribution.value_or(SizeDistribution::normal) == SizeDistribution::normal;
            return fabric.has_crystals() ? SettingValue(std::string(is_normal ? "normal" : "lognormal")) : SettingValue();
        });
    add_sizes(set, kind, fabric);
    add_quantity(set, "--spread", fabric.spread, spread_of_grains,
                 "coefficient of variation of the edges over their graded size, before elongation, at most 0.35; values below "
                 "about 0.1 are reached only as far as a mesh without a preferred direction allows; of crystals that of their "
                 "equal-area diameters over their graded size, at most 0.6",
                 "0.1")
        .of(SettingGroup::fabric);
    add_value(
        set, "--grade",
        [&fabric](const std::string& text) {
            fabric.grading = parse_grading(text, "--grade");
            note_lengths(text, "--grade");
        },
        "sizes that are graded, around the same mean edge (of crystals mean area) or number of grains: along=y,from=0.5,to=2 "
        "(relative edges at the lower and the upper end; along=x too) or towards=flaws,from=0.4,distance=10mm (relative edge at "
        "slits, straight notches, flaws and joints, growing to 1 at the distance; towards=boundary and towards=holes too)",
        "KEY=VALUE,...", "");
    add_quantity(set, "--elongation", fabric.elongation.ratio, quantity::elongation,
                 "ratio of the long to the short axis of grains, 1 to 4: foliated rock", "1")
        .of(SettingGroup::fabric);
    add_quantity(
        set, "--elongation-angle", fabric.elongation.angle, quantity::direction,
        "direction of the long axis of elongated grains from x; on a disc turned to another of its diameters it turns too",
        "0deg")
        .of(SettingGroup::fabric,
            [&fabric] { return fabric.elongation.ratio != 1 ? SettingValue(fabric.elongation.angle) : SettingValue(); });
    add_integer<int>(set, "--elements-per-edge", fabric.elements_per_edge,
                     "each triangle becomes N x N constant-strain triangles", 1, max_elements_per_edge)
        .of(SettingGroup::fabric);
}

/// Adds the options of all kinds: phases, strengths and output.
void add_fabric_options(OptionSet set, MeshOptions& options) {
    Fabric& fabric = options.request.fabric;
    add_integer<std::uint64_t>(set.usual(), "--seed", options.request.seed, "seed of the random numbers", 0)
        .of(SettingGroup::seed);
    add_value(
        set, "--phases", [&fabric](const std::string& text) { fabric.phases.fractions = parse_phases(text); },
        "phases of the grains with their fractions of the area, whose sum is 1: quartz=0.32,feldspar=0.62,mica=0.06; reached to "
        "one grain",
        "NAME=FRACTION,...", "");
    add_integer<std::uint64_t>(set, "--phase-seed", fabric.phases.seed, "seed of the phases; default: that of --seed", 0)
        .of(SettingGroup::seed);
    add_quantity(set, "--phase-cluster", fabric.phases.cluster, quantity::phase_cluster,
                 "mean number of neighbouring grains that are drawn together to be of one phase", "1")
        .of(SettingGroup::fabric);
    add_quantity(set, "--strength-modulus", fabric.strength.modulus, quantity::strength_modulus,
                 "Weibull modulus of the strength of grain boundaries: each has a factor of mean 1; default: no scatter")
        .of(SettingGroup::fabric);
    add_quantity(set, "--strength-correlation", fabric.strength.correlation, quantity::strength_correlation,
                 "distance at which the autocorrelation of the strength of grain boundaries is 1/e; default: uncorrelated")
        .of(SettingGroup::fabric);
    add_integer<std::uint64_t>(set, "--strength-seed", fabric.strength.seed,
                               "seed of the strength of grain boundaries; default: that of --seed", 0)
        .of(SettingGroup::seed);
    add_quantity(set, "--open-boundaries", fabric.open.fraction, quantity::open_boundaries,
                 "fraction of the length of grain boundaries, 0 to below 1, that is open from the start: whole boundaries at "
                 "random, without tension or cohesion, with friction; default: none")
        .of(SettingGroup::fabric);
    add_quantity(set, "--open-length", fabric.open.row, quantity::open_length,
                 "mean number of open boundaries in a row; rows lie apart, as straight as grains allow", "1")
        .of(SettingGroup::fabric, [&fabric] { return fabric.open.row != 1 ? SettingValue(fabric.open.row) : SettingValue(); });
    add_integer<std::uint64_t>(set, "--open-seed", fabric.open.seed, "seed of the open boundaries; default: that of --seed", 0)
        .of(SettingGroup::seed);
    add_value(
        set.usual(), "--material",
        [&options](const std::string& text) { options.material = read_material(options.material_name = text); },
        "material (name or TOML file) whose [fabric], phases and scatter of strengths are taken unless given, and whose "
        "contact zones elements must resolve",
        "NAME|FILE", "")
        .of(SettingGroup::none, [&options] { return options.material ? SettingValue(options.material->name) : SettingValue(); });
    add_output_file(set.usual(), options.output, "specimen file to write; - for stdout", {".h5"}).type_name("FILE|-");
}

/// Adds the options of imported meshes and pictures.
void add_import(OptionSet set, ImportRequest& request) {
    add_text(set, "file", request.file,
             "mesh of Gmsh (MSH 2.2, 4.1) or Neper (.msh), or picture of labels (PNG, or integers as text); - for stdin")
        .type_name("FILE|-")
        .required();
    add_choice<std::optional<MeshFormat>>(
        set.usual(), "--format", request.format,
        {{"gmsh", MeshFormat::gmsh}, {"neper", MeshFormat::neper}, {"labels", MeshFormat::labels}},
        "format of the file; default: told by its content");
    add_choice<std::optional<GrainChoice>>(
        set.usual(), "--grain", request.grains,
        {{"element", GrainChoice::element}, {"entity", GrainChoice::entity}, {"physical", GrainChoice::physical}},
        "what is a grain: an element, a geometrical entity (elset of Neper, piece of a picture), or what is connected "
        "of a physical group; default: entity, or element where there is one entity only")
        .of(SettingGroup::fabric);
    add_choice<CrystalChoice>(
        set.usual(), "--crystals", request.crystals, {{"elastic", CrystalChoice::elastic}, {"break", CrystalChoice::breaking}},
        "crystals of several elements: elastic (the elements deform together, as those of voronoi crystals), or break (the "
        "elements are grains within their crystal, as those of trigon crystals)")
        .of(SettingGroup::fabric);
    add_text(set.usual(), "--phase-key", request.phase_key,
             "phases of grains: TSV with columns key (name or number of a physical group, a group or an elset; number or "
             "colour as #c03020 of a label) and phase; default: names of physical groups and elsets")
        .type_name("FILE");
    add_text(set.usual(), "--write-key", request.new_key,
             "write a key with all labels of a picture, their colours, areas and pieces, whose phases are to be named, and make "
             "no specimen; - for stdout")
        .type_name("FILE|-");
    add_quantity(set.usual(), "--pixel-size", request.labels.pixel_size, quantity::pixel_size,
                 "side of a pixel of a picture, as 0.1mm")
        .of(SettingGroup::none);
    add_quantity(set, "--element-size", request.labels.element_size, quantity::element_size,
                 "side of the triangles into which grains of a picture are divided; default: a third of the mean diameter of "
                 "grains, at least 2 pixels")
        .of(SettingGroup::fabric);
    add_integer<int>(set, "--smallest-piece", request.labels.smallest_piece,
                     "pieces of fewer pixels of a picture join the neighbour with the longest common border", 1)
        .of(SettingGroup::fabric);
    add_quantity(set.usual(), "--scale", request.placement.scale, quantity::mesh_scale, "length of one unit of the file", "1m")
        .of(SettingGroup::none);
    add_value(
        set, "--origin",
        [&request](const std::string& text) {
            request.placement.origin = parse_point(text, "--origin");
            note_lengths(text, "--origin");
        },
        "point of the file that becomes the origin, as 40mm,80mm; default: the middle of the extent", "X,Y", "");
    add_choice(set, "--shape", request.placement.shape, {"rectangle", "disc", "ring", "beam", "half-disc", "polygon"},
               "shape of the specimen, which says how it can be tested; default: told by its outline, which "
               "takes a beam for a rectangle");
}

/// A value of [fabric] and its option.
struct FabricRow {
    const char* option;
    std::optional<double> GrainFabric::*value;
    Dimension dimension;
    void (*take)(MeshOptions&, KindOptions&, double);
    bool of_kind = false;  ///< true if it applies to triangles only, or to crystals only, like the material's
};
constexpr FabricRow fabric_rows[] = {
    {"--grain-size", &GrainFabric::grain_size, Dimension::length,
     [](MeshOptions&, KindOptions& kind, double value) { kind.grain_size = value; }},
    {"--elongation", &GrainFabric::elongation, Dimension::one,
     [](MeshOptions& options, KindOptions&, double value) { options.request.fabric.elongation.ratio = value; }},
    {"--elongation-angle", &GrainFabric::elongation_angle, Dimension::angle,
     [](MeshOptions& options, KindOptions&, double value) { options.request.fabric.elongation.angle = value; }},
    {"--spread", &GrainFabric::size_variation, Dimension::one,
     [](MeshOptions& options, KindOptions&, double value) { options.request.fabric.spread = value; }, true},
    {"--elements-per-crystal", &GrainFabric::elements_per_crystal, Dimension::one,
     [](MeshOptions& options, KindOptions&, double value) { options.request.fabric.elements_per_crystal = value; }, true},
};

/// Takes values of grains from a material unless options give them.
void take_grains(CommandLine& line, const GrainFabric& grains, MeshOptions& options, KindOptions& kind) {
    constexpr int digits = 15;  // every number of a file keeps these digits
    Fabric& fabric = options.request.fabric;
    const bool are_triangles = grains.tessellation.empty() || grains.tessellation == "delaunay";
    if (!grains.tessellation.empty() && line.replace_default("--tessellation", grains.tessellation)) {
        fabric.tessellation = are_triangles                      ? Tessellation::delaunay
                              : grains.tessellation == "voronoi" ? Tessellation::voronoi
                                                                 : Tessellation::trigon;
    }
    for (const FabricRow& row : fabric_rows) {
        const std::optional<double>& value = grains.*row.value;
        if (!value || (row.of_kind && are_triangles == fabric.has_crystals())) continue;
        if (line.replace_default(row.option, format_quantity(*value, row.dimension, digits))) row.take(options, kind, *value);
    }
}

/// Takes phases and scatter of strengths from a material unless options give them.
void take_fabric(const MaterialFabric& material, Fabric& fabric) {
    if (fabric.phases.fractions.empty()) {
        fabric.phases.yield = true;
        for (const auto& [name, phase] : material.phases) fabric.phases.fractions.push_back({name, phase.fraction});
    }
    if (fabric.strength.modulus || !material.strength_modulus) return;
    fabric.strength.modulus = material.strength_modulus;
    if (!fabric.strength.correlation && material.strength_correlation > 0) {
        fabric.strength.correlation = material.strength_correlation;
    }
}

/// Number of grains with this mean diameter (m). The mean area of crystals whose diameters vary by s is that of the mean diameter
/// times 1 + s²; diameters of triangles hardly vary. \throws UsageError if no specimen has this number
std::int64_t grains_of_size(const Request& request, double diameter) {
    const double spread = request.fabric.has_crystals() ? request.fabric.spread : 0;
    const double n = std::round(area(request.region) / (std::numbers::pi / 4 * diameter * diameter * (1 + spread * spread)));
    if (n >= 2 && n <= 7e8) return static_cast<std::int64_t>(n);
    throw UsageError(fmt::format("--grain-size: {} would make {} grains; give a size of which the specimen has 2 to 7e8",
                                 format_length(diameter), format_number(n, 3)));
}

}  // namespace

std::optional<MeshOptions> read_options(int argc, const char* const* argv) {
    MeshOptions options;
    CommonOptions common;
    CommandLine line(
        "graincrack-mesh",
        "Makes specimens of triangular grains of near-equal size without a preferred direction, or of polygonal crystals", common,
        examples, {triangulation_library()}, [] {
            return WrittenRows{{}, datasets_of("specimen")};
        });
    add_dry_run(line.options(), common, "print the expected counts and file size without making a specimen");
    KindOptions kind_options;
    CutOptions cuts;
    std::vector<OptionSet> sets;
    for (const Kind& kind : kinds) {
        OptionSet set = sets.emplace_back(line.options().add_subcommand(kind.name, kind.help));
        kind.add_options(set, kind_options);
        add_cuts(set, cuts);
        add_grains(set, kind_options, options.request.fabric);
        add_fabric_options(set, options);
    }
    ImportRequest imported;
    OptionSet import_set = line.options().add_subcommand("import", "a mesh of Gmsh or Neper, or a picture of labels");
    add_import(import_set, imported);
    add_fabric_options(import_set, options);
    const auto complete = [&] {
        for (const std::string& hole : cuts.holes) note_lengths(hole, "--hole");
        for (const std::string& joints : cuts.joint_sets) note_lengths(joints, "--joint-set");
        if (options.material) take_grains(line, options.material->grains, options, kind_options);
    };
    if (!line.parse(argc, argv, complete)) return std::nullopt;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (sets[i].is_called()) kinds[i].make(kind_options, options.request);
    }
    Fabric& fabric = options.request.fabric;
    if (options.material) take_fabric(options.material->fabric, fabric);
    if (import_set.is_called()) {
        check(fabric.phases);
        check(fabric.strength);
        check(fabric.open);
        if (!imported.new_key.empty() && !options.output.empty()) {
            throw UsageError("--write-key: makes no specimen; leave -o out, and name the phases in the key first");
        }
        options.imported = imported;
    } else {
        options.moved = make_cuts(cuts, options.request);
        if (kind_options.grain_size) fabric.grains = grains_of_size(options.request, *kind_options.grain_size);
    }
    options.verbosity = common.verbosity;
    options.dry_run = common.dry_run;
    options.configuration = line.effective_configuration();
    options.settings = line.settings();
    add_settings(options.request, options.settings);
    const bool writes_key = options.imported && !options.imported->new_key.empty();
    if (options.output.empty() && !options.dry_run && !writes_key) {
        throw UsageError("-o: missing; give the specimen file to write, or - for stdout");
    }
    return options;
}

}  // namespace graincrack::mesher
