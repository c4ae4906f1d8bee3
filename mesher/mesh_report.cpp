#include "mesher/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "mesher/cells/triangles.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "share/base/units.hpp"
#include "share/file/fabric.hpp"
#include "share/file/specimen_measures.hpp"
#include "share/rock/fracture_process_zone.hpp"

namespace graincrack::mesher {

namespace {

constexpr double fewest_of_zone = 1;  ///< elements

/// The contacts between or within crystals, and their softening zones.
struct Zones {
    double shortest = std::numeric_limits<double>::infinity();  ///< m
    double longest = 0;
    std::string of;  ///< class with the shortest zone
    double length = 0, number = 0;
    [[nodiscard]] double elements() const { return shortest * number / length; }
};

/// True if the material has parameters for the contacts between phases of a specimen.
bool has_phases_of(const Material& material, const Specimen& specimen) {
    const auto& phases = material.fabric.phases;
    const auto is_known = [&](const std::string& name) { return phases.contains(name); };
    return phases.empty() || (phases.size() == specimen.phase_names.size() &&
                              std::all_of(specimen.phase_names.begin(), specimen.phase_names.end(), is_known));
}

}  // namespace

std::vector<Remark> describe_zones(const Material& material, const Specimen& specimen) {
    if (!has_phases_of(material, specimen)) return {};
    constexpr PlaneCondition plane = PlaneCondition::stress;  // in plane strain zones are the same, as Ẽ Gf = K²
    const auto between = fabric_of(material, plane, std::nullopt, specimen.phase_names).contacts;
    const std::vector<std::string> names = contact_class_names(specimen);
    const std::vector<std::uint8_t> classes = contact_classes(specimen);
    const auto is_within = [&](std::size_t i) { return !phase_of_within_class(names[i]).empty(); };
    std::vector<bool> is_present(names.size(), false);
    std::array<Zones, 2> kinds;  // between and within crystals; other flaws are left out
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        is_present[classes[c]] = true;
        if (classes[c] >= between.size() && !is_within(classes[c])) continue;
        Zones& zones = kinds[is_within(classes[c]) ? 1 : 0];
        zones.length += contact_length(specimen, c);
        ++zones.number;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!is_present[i] || (i >= between.size() && !is_within(i))) continue;
        const ContactParameters contact =
            is_within(i) ? contact_within_crystals(material, plane, std::nullopt, names[i], 0) : between[i];
        if (!(contact.tensile_strength > 0)) continue;
        const double zone = fpz::contact_zone_length(material.rock, plane, contact.fracture_energy, contact.tensile_strength);
        Zones& zones = kinds[is_within(i) ? 1 : 0];
        if (zone < zones.shortest) zones.of = "of " + names[i];
        zones.shortest = std::min(zones.shortest, zone);
        zones.longest = std::max(zones.longest, zone);
    }
    std::vector<Remark> lines;
    for (const Zones& zones : kinds) {
        if (!(zones.longest > 0)) continue;
        const bool are_equal = zones.longest < (1 + 1e-9) * zones.shortest;
        const std::string of = !are_equal ? zones.of : &zones == kinds.data() ? "between crystals" : "within crystals";
        const Zones& other = kinds[&zones == kinds.data() ? 1 : 0];
        const bool is_short = zones.elements() < fewest_of_zone && !(other.elements() < zones.elements());
        lines.emplace_back(
            fmt::format("{:.2g} elements a contact zone {}, {} long{}", zones.elements(), of,
                        format_quantity(zones.shortest, Dimension::length, 3),
                        is_short ? ": with fewer than one strengths depend on the size of elements; make them smaller" : ""),
            is_short ? "short_zone" : "");
    }
    return lines;
}

namespace {

// Measured on specimens of 2,000 to 100,000 grains:
constexpr double bytes_of_element = 28;  ///< size in a file
constexpr double bytes_of_contact = 30;
constexpr double time_of_triangle = 1e-5;  ///< s
constexpr double time_of_crystal = 3e-4;
constexpr double fewest_elements = 5;  ///< elements of a crystal
constexpr double contacts_of_element = 1.5;
constexpr double contacts_of_crystal = 3;  ///< of crystals that do not break

constexpr double largest_area_error = 0.05;  ///< area error of a crystal up to which there is no note
constexpr std::size_t fewest_on_hole = 16;   ///< sides, whose rise is below 2 % of the radius

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

std::string size_line(const char* what, double mean, double variation, double min, double max) {
    const auto mm = [](double value) { return in_unit(value, Dimension::length, "mm"); };
    return fmt::format("{:<26} mean {:.4g} mm, CV {:.4f}, min {:.4g} mm, max {:.4g} mm", what, mm(mean), variation, mm(min),
                       mm(max));
}

/// A number with commas between thousands.
std::string with_commas(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
    return digits;
}

/// Describes sizes and angles of crystals, which are made once and have no notable preferred direction.
void describe_crystals(const Specimen& specimen, const Fabric& fabric, const MeshReport& r, std::vector<Remark>& lines) {
    const MeshStatistics& s = specimen.statistics;
    lines.push_back(fmt::format(
        "crystals: equal-area diameter mean {}, CV {:.4f}{} ({} requested); areas met to {:.0e}; {} short edges were removed{}",
        format_quantity(r.mean_diameter, Dimension::length, 4), r.spread, fabric.grading ? " over the graded size" : "",
        format_number(fabric.spread), r.largest_area_error, r.n_short_edges,
        r.n_edges_left > 0 ? fmt::format(" ({} could not be)", r.n_edges_left) : ""));
    const bool can_break = fabric.tessellation == Tessellation::trigon;
    lines.push_back(
        size_line(can_break ? "edge" : "edge of equal-area triangle", s.mean_edge, s.edge_variation, s.min_edge, s.max_edge));
    lines.push_back(fmt::format("smallest angle of elements {:.1f} deg, psi6 {:.3f}, area error {:.1e}", degrees(s.min_angle),
                                s.psi6, s.area_error));
    if (r.largest_area_error > largest_area_error) {
        lines.emplace_back(
            fmt::format("a crystal misses its area by {:.0f} %, since holes or flaws leave little room; give smaller "
                        "crystals",
                        100 * r.largest_area_error),
            "missed_areas");
    }
}

void describe_triangles(const MeshStatistics& s, const MeshReport& report, std::vector<Remark>& lines) {
    lines.push_back(size_line("edge", s.mean_edge, s.edge_variation, s.min_edge, s.max_edge));
    lines.push_back(size_line("equal-area diameter", s.mean_diameter, s.diameter_variation, s.min_diameter, s.max_diameter));
    lines.push_back(fmt::format("smallest angle {:.1f} deg, psi6 {:.3f} (at most {:.3f} in eight equal parts), area error {:.1e}",
                                degrees(s.min_angle), s.psi6, report.psi6_of_parts, s.area_error));
}

/// A note on the round hole with the fewest sides if it is rather a polygon; "" otherwise.
std::string note_on_holes(const Specimen& specimen, const Request& request) {
    std::string note;
    std::size_t fewest = fewest_on_hole;
    for (const Loop& loop : request.region.loops) {
        if (!loop.circle || &loop == &request.region.loops.front()) continue;
        std::set<long> directions;
        for (std::size_t b = 0; b < specimen.n_boundary_edges(); ++b) {
            if (specimen.boundary_part[b] != loop.parts.front()) continue;
            const auto& p = specimen.node_position[index(specimen.boundary_edges[b][0])];
            const auto& q = specimen.node_position[index(specimen.boundary_edges[b][1])];
            directions.insert(std::lround(1e6 * std::atan2(q[1] - p[1], q[0] - p[0])));
        }
        if (directions.size() >= fewest) continue;
        fewest = directions.size();
        note = fmt::format(
            "{} is a polygon of {} sides, of its area; {} are round: smaller grains, or --grade "
            "towards=holes,from=0.4,distance={}",
            specimen.part_names[loop.parts.front()], fewest, fewest_on_hole,
            format_quantity(2 * loop.circle->radius, Dimension::length, 2));
    }
    return note;
}

/// Notes on triangles that miss their bounds.
void add_notes_on_triangles(const Specimen& specimen, const Request& request, const MeshReport& report,
                            std::vector<Remark>& lines) {
    const MeshStatistics& s = specimen.statistics;
    const double spread = request.fabric.spread;
    if (request.fabric.grading || s.elongation > 0) {
        lines.push_back(fmt::format("spread {:.3f} over the graded size, before elongation", report.spread));
    }
    if (std::abs(report.spread - spread) > 0.1 * spread) {
        lines.push_back(fmt::format("spread {:.3f} was requested, {:.3f} was reached", spread, report.spread));
    }
    if (const auto ends = notch_ends(specimen); ends && request.notch) {
        lines.push_back(fmt::format("slit of {} requested, {} between the ends of its grain boundaries",
                                    format_length(*request.notch), format_quantity((*ends)[1] - (*ends)[0], Dimension::length)));
    }
    if (s.psi6 > max_psi6 || report.psi6_of_parts > max_psi6_of_parts) {
        lines.emplace_back(fmt::format("after {} attempts parts of the mesh still have a preferred direction, which is hardly "
                                       "avoidable with so few grains",
                                       report.attempts),
                           "preferred_directions");
    }
}

}  // namespace

std::vector<std::string> summary_of(const Specimen& specimen, const std::string& output) {
    const auto mm = [](double value) { return format_number(in_unit(value, Dimension::length, "mm"), 4); };
    const bool is_elastic = specimen.n_elements() != specimen.n_grains() && specimen.grain_crystal.empty();
    const bool are_triangles = specimen.tessellation == "delaunay";
    const char* kind = are_triangles ? "grains" : is_elastic ? "elastic crystals" : "crystals";
    std::vector<std::string> lines{fmt::format(
        "{}{}{} of {} mm, {} {}, mean {}; {} triangles, {} contacts", output == "-" ? "stdout" : output,
        output.empty() ? "" : ": ", specimen.shape,
        specimen.width == specimen.height ? mm(specimen.width) : mm(specimen.width) + " × " + mm(specimen.height),
        with_commas(number_of_crystals(specimen)), kind, format_quantity(mean_crystal_diameter(specimen), Dimension::length, 3),
        with_commas(specimen.n_elements()), with_commas(specimen.n_contacts()))};
    if (const std::string flaws = flaws_text(specimen); !flaws.empty()) lines.push_back("  flaws: " + flaws);
    if (specimen.phase_names == Specimen{}.phase_names) return lines;
    const std::vector<double> fractions = phase_fractions(specimen);
    std::string phases;
    for (std::size_t p = 0; p < fractions.size(); ++p) {
        phases += fmt::format("{} {} {:.1f} %", p == 0 ? "" : ",", specimen.phase_names[p], 100 * fractions[p]);
    }
    lines.push_back("  phases:" + phases);
    return lines;
}

std::vector<Remark> describe_mesh(const Specimen& specimen, const Request& request, const MeshReport& report) {
    const Fabric& fabric = request.fabric;
    const MeshStatistics& s = specimen.statistics;
    std::vector<Remark> lines{
        fmt::format("{}: {} nodes, {} boundary edges", specimen.tessellation, specimen.n_nodes(), specimen.n_boundary_edges())};
    if (fabric.has_crystals()) {
        describe_crystals(specimen, fabric, report, lines);
    } else {
        describe_triangles(s, report, lines);
    }
    if (specimen.loading_arc > 0) lines.push_back(fmt::format("loading arc {:.2f} deg", degrees(specimen.loading_arc)));
    if (const std::string sides = note_on_holes(specimen, request); !sides.empty()) lines.emplace_back(sides, "coarse_hole");
    if (const std::string open = open_boundaries_text(specimen); !open.empty()) lines.push_back("open boundaries: " + open);
    if (s.elongation > 0) {
        lines.push_back(fmt::format("elongation {:.3f} along {:.1f} deg", s.elongation, degrees(s.elongation_angle)));
    }
    if (report.n_flaws > 0 || !request.joint_sets.empty()) {
        lines.push_back(fmt::format("{} of flaws and joints, {} long in all",
                                    report.n_flaws == 1 ? "1 piece" : fmt::format("{} pieces", report.n_flaws),
                                    format_length(report.flaw_length)));
    }
    lines.insert(lines.end(), report.warnings.begin(), report.warnings.end());
    if (!fabric.has_crystals()) add_notes_on_triangles(specimen, request, report, lines);
    const double min_angle = fabric.has_crystals() ? s.min_angle : report.min_angle;
    if (report.n_flaws + request.region.loops.size() > 1 && min_angle < smallest_angle) {
        lines.emplace_back(
            "holes or flaws lie so near to each other that a grain has a small angle, which makes time steps short",
            "small_angle");
    }
    if (const std::string note = note_on_few_crystals(specimen); !note.empty()) lines.emplace_back(note, "few_crystals");
    return lines;
}

std::vector<std::string> describe_plan(const Request& request) {
    const MeshPlan plan = plan_mesh(request);
    const Fabric& fabric = request.fabric;
    const auto n = static_cast<double>(plan.n_grains);
    const double whole = area(request.region);
    const double per_edge = fabric.elements_per_edge;
    double elements = n * per_edge * per_edge;
    double contacts = contacts_of_element * n * per_edge;
    if (fabric.has_crystals()) {
        elements = std::max(fewest_elements * n, triangles_of_square * whole / (plan.element_size * plan.element_size));
        contacts = fabric.tessellation == Tessellation::trigon ? contacts_of_element * elements : contacts_of_crystal * n;
    }
    const double spread = fabric.has_crystals() ? fabric.spread : 0;
    const double diameter = std::sqrt(4 / std::numbers::pi * whole / (n * (1 + spread * spread)));
    return {
        fmt::format("{} of {} {}, mean about {}", request.region.name, plan.n_grains,
                    fabric.has_crystals() ? "crystals" : "grains", format_quantity(diameter, Dimension::length, 3)),
        fmt::format("  about {} elements and {} contacts, a file of {:.2g} MB, {:.2g} s",
                    with_commas(static_cast<std::size_t>(elements)), with_commas(static_cast<std::size_t>(contacts)),
                    1e-6 * (bytes_of_element * elements + bytes_of_contact * contacts),
                    n * (fabric.has_crystals() ? time_of_crystal : time_of_triangle)),
    };
}

}  // namespace graincrack::mesher
