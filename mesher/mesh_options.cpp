#include "mesher/mesh_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "mesher/plane/triangulation.hpp"
#include "mesher/region/region_files.hpp"
#include "share/base/error.hpp"
#include "share/base/printable.hpp"
#include "share/base/quantities.hpp"
#include "share/base/units.hpp"
#include "share/options/command_line.hpp"

namespace graincrack::mesher {

namespace {

constexpr const char* examples =
    "  graincrack-mesh rectangle --width 80mm --height 160mm --grains 1122 -o specimen.h5\n"
    "  graincrack-mesh disc --diameter 80mm --edge 5.13mm --seed 7 --material augig-granite -o disc.h5\n"
    "  graincrack-mesh rectangle --width 40mm --height 80mm --edge 3mm --phases quartz=0.3,feldspar=0.6,mica=0.1 "
    "--strength-modulus 5 -o minerals.h5\n"
    "  graincrack-mesh import section.msh --scale 1mm -o section.h5\n"
    "  graincrack-mesh import thin-section.png --write-key labels.tsv\n"
    "  graincrack-mesh import thin-section.png --pixel-size 0.1mm --phase-key minerals.tsv --crystals break -o section.h5";

/// What the options of a kind of specimens set; kinds share them.
struct KindOptions {
    double width = 0;
    double height = 0;
    double diameter = 0;
    double inner_diameter = 0;
    Pole pole = Pole::facet;
    int diameters = 1;
    int loaded_diameter = 0;
    std::optional<double> flats;
    std::optional<double> notch;
    std::optional<double> angle;  ///< of a notch or slit
    std::string file;
    std::optional<double> grain_size;  ///< equal-area diameter
};

/// A kind of specimens: a subcommand with its options, and how they make the region of a request.
struct Kind {
    const char* name;
    const char* help;
    void (*add_options)(OptionSet, KindOptions&);
    void (*make)(const KindOptions&, SpecimenRequest&);
};

void add_width(OptionSet set, KindOptions& options, const char* name) {
    add_quantity(set, name, options.width, quantity::width, "width, along x").required();
}
void add_height(OptionSet set, KindOptions& options) {
    add_quantity(set, "--height", options.height, quantity::height, "height, along the load").required();
}
void add_diameter(OptionSet set, KindOptions& options) {
    add_quantity(set, "--diameter", options.diameter, quantity::diameter, "diameter").required();
}

const Kind kinds[] = {
    {"rectangle", "a rectangle, loaded along its height",
     [](OptionSet set, KindOptions& options) {
         add_width(set, options, "--width");
         add_height(set, options);
         add_quantity(
             set, "--notch", options.notch, quantity::notch,
             "length of a notch through the centre, across the load, whose grain boundaries are broken from the start; the "
             "width of the specimen makes it a joint");
         add_quantity(
             set, "--notch-angle", options.angle, quantity::direction,
             "direction of the notch from x: a straight notch, which grain boundaries follow; default: across the load, of "
             "triangles along whole grain boundaries as they lie, of polygons straight");
     },
     [](const KindOptions& options, SpecimenRequest& request) {
         request.region = rectangle(options.width, options.height);
         if (options.angle && !options.notch) throw UsageError("--notch-angle: there is no notch; add --notch 20mm");
         if (options.angle) {
             request.region.edges = {central_slit(request.region, *options.notch, *options.angle, "--notch")};
         } else {
             request.notch = options.notch;
         }
     }},
    {"disc", "a disc, loaded along its vertical diameter",
     [](OptionSet set, KindOptions& options) {
         add_diameter(set, options);
         Option pole = add_choice<Pole>(set, "--pole", options.pole, {{"facet", Pole::facet}, {"vertex", Pole::vertex}},
                                        "part of the rim that meets the platens");
         Option diameters = add_integer<int>(set, "--diameters", options.diameters,
                                             "number of diameters that can be loaded, at equal angles: 6 for every 30 degrees", 1,
                                             max_diameters);
         Option loaded = add_integer<int>(
             set, "--loaded-diameter", options.loaded_diameter,
             "index of the diameter along the load, counter-clockwise from 0: the same grains, rotated, with holes and flaws", 0,
             max_diameters - 1);
         Option flats = add_quantity(set, "--flats", options.flats, quantity::flats,
                                     "angle under which flat poles, the parts top and bottom, are seen from the centre");
         for (Option other : {pole, diameters, loaded}) flats.excludes(other);
         add_quantity(set, "--slit", options.notch, quantity::slit, "length of a straight crack through the centre");
         add_quantity(set, "--slit-angle", options.angle, quantity::direction,
                      "direction of the crack from x; 90deg along the load; default: 90deg");
     },
     [](const KindOptions& options, SpecimenRequest& request) {
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
         add_quantity(set, "--inner-diameter", options.inner_diameter, quantity::diameter, "diameter of the hole").required();
     },
     [](const KindOptions& options, SpecimenRequest& request) {
         if (!(options.inner_diameter < options.diameter)) throw UsageError("--inner-diameter: must be less than --diameter");
         request.region = ring(options.diameter, options.inner_diameter);
     }},
    {"beam", "a beam along x, to be bent",
     [](OptionSet set, KindOptions& options) {
         add_width(set, options, "--length");
         add_height(set, options);
         add_quantity(set, "--notch", options.notch, quantity::slit, "length of a straight crack from below at mid-length");
     },
     [](const KindOptions& options, SpecimenRequest& request) {
         request.region = rectangle(options.width, options.height);
         request.region.name = "beam";
         if (options.notch) request.region.edges = {slit_from_below(request.region, *options.notch, "--notch")};
     }},
    {"half-disc", "half a disc on its flat side, to be bent",
     [](OptionSet set, KindOptions& options) {
         add_diameter(set, options);
         add_quantity(set, "--slit", options.notch, quantity::slit,
                      "length of a straight crack from the middle of the flat side");
     },
     [](const KindOptions& options, SpecimenRequest& request) {
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
     [](const KindOptions& options, SpecimenRequest& request) { request.region = read_polygon(options.file); }},
};

/// What is cut into a specimen of any kind.
struct CutOptions {
    std::vector<std::string> holes;
    std::vector<std::string> joint_sets;
    std::string flaws;
    std::string hole_file;
};

void add_cuts(OptionSet set, CutOptions& options) {
    add_texts(set, "--hole", options.holes, "X,Y,RADIUS",
              "round hole, as 10mm,-5mm,4mm; may be given again; its part is hole_1, hole_2 …");
    add_value(
        set, "--flaws", [&options](const std::string& text) { options.flaws = text; },
        "straight flaws that grain boundaries follow: TSV with columns x1_mm, y1_mm, x2_mm, y2_mm and, if wanted, class: broken "
        "(from the start; the default), intact or a NAME, whose contacts have the parameters [flaws.NAME] of the material, and "
        "state: broken or intact",
        "FILE", "");
    add_value(
        set, "--holes", [&options](const std::string& text) { options.hole_file = text; },
        "round holes: TSV with columns x_mm, y_mm, radius_mm", "FILE", "");
    add_texts(
        set, "--joint-set", options.joint_sets, "KEY=VALUE,...",
        "parallel joints at random: spacing=20mm,dip=45deg and, if wanted, persistence=0.7 (share of a line that is jointed), "
        "length=30mm (mean; default: the spacing), class=broken|intact|NAME, state=broken|intact; may be given again");
}

/// Texts between commas. \throws UsageError naming `where` unless there are as many as wanted
std::vector<std::string_view> parts_of(std::string_view text, std::size_t n, const std::string& where, const char* wanted) {
    std::vector<std::string_view> parts;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        parts.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    if (parts.size() != n) {
        throw UsageError(where + ": \"" + std::string(text.substr(0, 60)) + "\" is not understood; give " + wanted);
    }
    return parts;
}

Point parse_point(const std::string& text, const std::string& where) {
    const auto parts = parts_of(text, 2, where, "X,Y as 40mm,80mm");
    return {parse_quantity(parts[0], quantity::coordinate, where), parse_quantity(parts[1], quantity::coordinate, where)};
}

/// The text of a hole: its centre and radius. \throws UsageError naming `where`
void cut_hole(const std::string& text, const std::string& where, Region& region) {
    const auto parts = parts_of(text, 3, where, "X,Y,RADIUS as 10mm,-5mm,4mm");
    add_hole(region,
             {parse_quantity(parts[0], quantity::coordinate, where), parse_quantity(parts[1], quantity::coordinate, where)},
             parse_quantity(parts[2], quantity::hole_radius, where), where);
}

/// Cuts holes and flaws; their coordinates are those of the kind, before the region is centred.
/// \return the translation
Point make_cuts(const CutOptions& options, SpecimenRequest& request) {
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

/// The choice that a word names. \throws UsageError naming the option
template <class T>
T chosen(const std::vector<std::pair<std::string, T>>& choices, const std::string& word, const char* option, const char* words) {
    for (const auto& [name, choice] : choices) {
        if (name == word) return choice;
    }
    throw UsageError(fmt::format("{}: \"{}\" is not known; {} fits", option, printable(word.substr(0, 40)), words));
}

/// Of edges of triangles at most 0.35, of diameters of polygons more.
constexpr Quantity spread_of_grains = [] {
    Quantity spread = quantity::edge_spread;
    spread.upper = max_spread_of_polygons;
    return spread;
}();

/// How grains are made.
void add_tessellation(OptionSet shape, SpecimenRequest& request) {
    add_choice<Tessellation>(
        shape, "--tessellation", request.tessellation,
        {{"delaunay", Tessellation::delaunay}, {"voronoi", Tessellation::voronoi}, {"trigon", Tessellation::trigon}},
        "grains: triangles (delaunay), polygons of elements that do not break (voronoi), or polygons whose triangles are grains, "
        "so that they break (trigon)");
    add_quantity(
        shape, "--element-size", request.element_size, quantity::element_size,
        "side of the triangles of polygons, the same everywhere; default: 0.36 of --edge, which makes seven to eight of them a "
        "polygon, and graded as polygons are with --grade")
        .excludes(add_quantity(shape, "--elements-per-crystal", request.elements_per_crystal, quantity::elements_per_crystal,
                               "mean number of elements of a polygon instead of --element-size; the corners of polygons ask for "
                               "three to four at least"));
    add_value(
        shape, "--size-distribution",
        [&request](const std::string& text) {
            static const std::vector<std::pair<std::string, SizeDistribution>> distributions{
                {"normal", SizeDistribution::normal}, {"lognormal", SizeDistribution::lognormal}};
            request.size_distribution = chosen(distributions, text, "--size-distribution", "normal or lognormal");
        },
        "distribution of the equal-area diameters of polygons; default: normal", "normal|lognormal", "");
}

/// The grains that are made.
void add_grain_options(OptionSet shape, KindOptions& kind, SpecimenRequest& request) {
    Option edge = add_quantity(
        shape, "--edge", request.edge, quantity::mean_edge,
        "requested mean edge over all grain edges, rim included; of polygons the edge of the equilateral triangle of their "
        "mean area");
    Option grains = add_integer<std::int64_t>(shape, "--grains", request.grains,
                                              "exact number of grains, or of polygons, instead of --edge", 1);
    Option grain_size = add_quantity(shape, "--grain-size", kind.grain_size, quantity::grain_size,
                                     "mean equal-area diameter of grains or polygons, instead of --edge; with --grade as many as "
                                     "without it");
    edge.excludes(grains).excludes(grain_size);
    grains.excludes(grain_size);
    add_quantity(shape, "--spread", request.spread, spread_of_grains,
                 "coefficient of variation of the edges over their graded size, before elongation, at most 0.35; values below "
                 "about 0.1 are reached only as far as a mesh without a preferred direction allows; of polygons that of their "
                 "equal-area diameters over their graded size, at most 0.6",
                 "0.1");
    add_value(
        shape, "--grade", [&request](const std::string& text) { request.grading = parse_grading(text, "--grade"); },
        "sizes that are graded, around the same mean edge (of polygons mean area) or number of grains: along=y,from=0.5,to=2 "
        "(relative edges at the lower and the upper end; along=x too) or towards=flaws,from=0.4,distance=10mm (relative edge at "
        "slits, straight notches, "
        "flaws "
        "and joints, growing to 1 at the distance; towards=boundary and towards=holes too)",
        "KEY=VALUE,...", "");
    add_quantity(shape, "--elongation", request.elongation.ratio, quantity::elongation,
                 "ratio of the long to the short axis of grains, 1 to 4: foliated rock", "1");
    add_quantity(
        shape, "--elongation-angle", request.elongation.angle, quantity::direction,
        "direction of the long axis of elongated grains from x; on a disc turned to another of its diameters it turns too",
        "0deg");
    add_integer<int>(shape, "--elements-per-edge", request.elements_per_edge,
                     "each grain becomes N x N constant-strain triangles", 1, max_elements_per_edge);
}

/// What the grains are, and where the specimen goes: options of all kinds.
void add_fabric_options(OptionSet shape, MeshOptions& options) {
    SpecimenRequest& request = options.request;
    add_integer<std::uint64_t>(shape, "--seed", request.seed, "seed of the random numbers", 0);
    add_value(
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
    add_quantity(
        shape, "--open-boundaries", request.open.share, quantity::open_boundaries,
        "share of the length of grain boundaries, 0 to below 1, that is open from the start: whole boundaries at random, "
        "without tension or cohesion, with friction; default: none");
    add_integer<std::uint64_t>(shape, "--open-seed", request.open.seed, "seed of the open boundaries; default: that of --seed",
                               0);
    add_value(
        shape, "--material", [&options](const std::string& text) { options.material = read_material(text); },
        "material (name or TOML file) whose [fabric], phases and scatter of strengths are taken unless given, and whose bounds "
        "of the "
        "grain "
        "size are printed",
        "NAME|FILE", "");
    add_value(
        shape, "-o,--output", [&options](const std::string& text) { options.output = text; },
        "specimen file to write; - for stdout", "FILE|-", "");
}

/// A mesh or a picture from elsewhere.
void add_import(OptionSet set, ImportRequest& request) {
    add_text(set, "file", request.file,
             "mesh of Gmsh (MSH 2.2, 4.1), Neper (.msh, .tess) or Abaqus (.inp), or picture of labels (PNG, or integers as "
             "text); - for stdin")
        .type_name("FILE|-")
        .required();
    add_value(
        set, "--format",
        [&request](const std::string& text) {
            static const std::vector<std::pair<std::string, MeshFormat>> formats{{"gmsh", MeshFormat::gmsh},
                                                                                 {"neper", MeshFormat::neper},
                                                                                 {"abaqus", MeshFormat::abaqus},
                                                                                 {"labels", MeshFormat::labels}};
            request.format = chosen(formats, text, "--format", "gmsh, neper, abaqus or labels");
        },
        "format of the file; default: told by its content", "gmsh|neper|abaqus|labels", "");
    add_value(
        set, "--grain",
        [&request](const std::string& text) {
            static const std::vector<std::pair<std::string, GrainChoice>> choices{
                {"element", GrainChoice::element}, {"entity", GrainChoice::entity}, {"physical", GrainChoice::physical}};
            request.grains = chosen(choices, text, "--grain", "element, entity or physical");
        },
        "what is a grain: an element, a geometrical entity (elset of Neper and Abaqus, cell of a tessellation, piece of a "
        "picture), or what is connected of a physical group; "
        "default: entity, or element where there is one entity only",
        "element|entity|physical", "");
    add_value(
        set, "--crystals",
        [&request](const std::string& text) {
            static const std::vector<std::pair<std::string, CrystalChoice>> choices{{"elastic", CrystalChoice::elastic},
                                                                                    {"break", CrystalChoice::breaking}};
            request.crystals = chosen(choices, text, "--crystals", "elastic or break");
        },
        "crystals of several elements: elastic (the elements deform together, as those of voronoi polygons), or break (the "
        "elements are grains within their crystal, as those of trigon polygons); default: elastic",
        "elastic|break", "");
    add_value(
        set, "--phase-key", [&request](const std::string& text) { request.phase_key = text; },
        "phases of grains: TSV with columns key (name or number of a physical group, a group or an elset; number or colour as "
        "#c03020 of a label) and phase; default: names of physical groups and elsets",
        "FILE", "");
    add_value(
        set, "--write-key", [&request](const std::string& text) { request.new_key = text; },
        "write a key with all labels of a picture, their colours, areas and pieces, whose phases are to be named, and make no "
        "specimen; - for stdout",
        "FILE|-", "");
    add_value(
        set, "--pixel-size",
        [&request](const std::string& text) {
            request.labels.pixel_size = parse_quantity(text, quantity::pixel_size, "--pixel-size");
        },
        "side of a pixel of a picture, as 0.1mm", "LENGTH", "");
    add_quantity(set, "--element-size", request.labels.element_size, quantity::element_size,
                 "side of the triangles into which grains of a picture or of a tessellation are divided; default: a third of the "
                 "mean diameter of "
                 "grains, at least 2 pixels");
    add_integer<int>(set, "--smallest-piece", request.labels.smallest_piece,
                     "pieces of fewer pixels of a picture join the neighbour with the longest common border", 1);
    add_flag(set, "--jagged", request.labels.jagged, "grain boundaries along the sides of pixels instead of smooth ones");
    add_quantity(set, "--scale", request.placement.scale, quantity::mesh_scale, "length of one unit of the file", "1m");
    add_value(
        set, "--origin", [&request](const std::string& text) { request.placement.origin = parse_point(text, "--origin"); },
        "point of the file that becomes the origin, as 40mm,80mm; default: the middle of the extent", "X,Y", "");
    add_value(
        set, "--shape",
        [&request](const std::string& text) {
            static const std::vector<std::pair<std::string, std::string>> shapes{
                {"rectangle", "rectangle"}, {"disc", "disc"},           {"ring", "ring"},
                {"beam", "beam"},           {"half-disc", "half-disc"}, {"polygon", "polygon"}};
            request.placement.shape = chosen(shapes, text, "--shape", "rectangle, disc, ring, beam, half-disc or polygon");
        },
        "shape of the specimen, which says how it can be tested; default: told by its outline, which takes a beam for a "
        "rectangle",
        "NAME", "");
}

/// What a material says of its grains becomes the default of options. The variation of sizes is that of edges of triangles or
/// of diameters of polygons, and so holds only where the kind of grains is the material's.
void take_grains(CommandLine& line, const GrainFabric& grains, const SpecimenRequest& request) {
    const auto set = [&line](const char* option, const std::optional<double>& value, Dimension dimension) {
        constexpr int digits = 15;  // that every number of a file keeps
        if (value) line.set_default(option, format_quantity(*value, dimension, digits));
    };
    const bool is_chosen = line.is_given("--tessellation");
    const bool are_triangles = grains.tessellation.empty() || grains.tessellation == "delaunay";
    if (!grains.tessellation.empty()) line.set_default("--tessellation", grains.tessellation);
    set("--grain-size", grains.grain_size, Dimension::length);
    set("--elongation", grains.elongation, Dimension::one);
    set("--elongation-angle", grains.elongation_angle, Dimension::angle);
    if (is_chosen && are_triangles != (request.tessellation == Tessellation::delaunay)) return;
    set("--spread", grains.size_variation, Dimension::one);
    set("--elements-per-crystal", grains.elements_per_crystal, Dimension::one);
}

/// As many grains as have this mean diameter. The mean area of polygons whose diameters vary by s is that of the mean diameter
/// times 1 + s²; diameters of triangles hardly vary. \throws UsageError if no specimen has so few or so many
std::int64_t grains_of_size(const SpecimenRequest& request, double diameter) {
    const double spread = request.tessellation == Tessellation::delaunay ? 0 : request.spread;
    const double n = std::round(area(request.region) / (std::numbers::pi / 4 * diameter * diameter * (1 + spread * spread)));
    if (n >= 2 && n <= 7e8) return static_cast<std::int64_t>(n);
    throw UsageError(fmt::format("--grain-size: {} would make {} grains; give a size of which the specimen has 2 to 7e8",
                                 format_length(diameter), format_number(n, 3)));
}

}  // namespace

std::optional<MeshOptions> read_options(int argc, const char* const* argv) {
    MeshOptions options;
    CommonOptions common;
    CommandLine line("graincrack-mesh",
                     "Makes specimens of triangular grains of near-equal size without a preferred direction, or of polygons",
                     common, examples, {triangulation_library()});
    add_dry_run(line.options(), common, "print the expected counts and file size without making a specimen");
    KindOptions kind_options;
    CutOptions cuts;
    std::vector<OptionSet> sets;
    for (const Kind& kind : kinds) {
        OptionSet set = sets.emplace_back(line.options().add_subcommand(kind.name, kind.help));
        kind.add_options(set, kind_options);
        add_cuts(set, cuts);
        add_tessellation(set, options.request);
        add_grain_options(set, kind_options, options.request);
        add_fabric_options(set, options);
    }
    ImportRequest imported;
    OptionSet import_set = line.options().add_subcommand("import", "a mesh of Gmsh, Neper or Abaqus, or a picture of labels");
    add_import(import_set, imported);
    add_fabric_options(import_set, options);
    const auto complete = [&] {
        if (options.material) take_grains(line, options.material->grains, options.request);
    };
    if (!line.parse(argc, argv, complete)) return std::nullopt;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (sets[i].is_called()) kinds[i].make(kind_options, options.request);
    }
    if (import_set.is_called()) {
        check(options.request.phases);
        check(options.request.strength);
        check(options.request.open);
        if (!imported.new_key.empty() && !options.output.empty()) {
            throw UsageError("--write-key: makes no specimen; leave -o out, and name the phases in the key first");
        }
        options.imported = imported;
    } else {
        options.moved = make_cuts(cuts, options.request);
        if (kind_options.grain_size) options.request.grains = grains_of_size(options.request, *kind_options.grain_size);
    }
    options.verbosity = common.verbosity;
    options.dry_run = common.dry_run;
    options.configuration = line.effective_configuration();
    const bool writes_key = options.imported && !options.imported->new_key.empty();
    if (options.output.empty() && !options.dry_run && !writes_key) {
        throw UsageError("-o: missing; give the specimen file to write, or - for stdout");
    }
    return options;
}

}  // namespace graincrack::mesher
