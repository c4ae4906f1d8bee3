#include "mesher/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesher/cells/triangles.hpp"
#include "mesher/fabric/crystals.hpp"
#include "share/base/units.hpp"
#include "share/file/specimen_measures.hpp"
#include "share/rock/fracture_process_zone.hpp"

namespace graincrack::mesher {

namespace {

std::string millimetres(double value) { return format_number(in_unit(value, Dimension::length, "mm"), 3) + " mm"; }

}  // namespace

SizeBounds size_bounds(const Material& material) {
    const Rock& rock = material.rock;
    constexpr PlaneCondition plane = PlaneCondition::stress;
    const double tc = contact_parameters(material, plane, std::nullopt).tensile_strength;
    SizeBounds bounds;
    bounds.lower = fpz::min_grain_size(rock);
    bounds.lower_shear = fpz::min_grain_size_shear(rock);
    bounds.upper = fpz::max_grain_size(rock);
    bounds.contact_zone_mixed = fpz::contact_zone_length(rock, plane, fpz::mixed_mode_fracture_energy(rock, plane), tc);
    bounds.contact_zone_mode_i = fpz::contact_zone_length(rock, plane, fpz::mode_i_fracture_energy(rock, plane), tc);
    return bounds;
}

std::vector<std::string> describe_size_check(const Material& material, double mean_edge) {
    const SizeBounds bounds = size_bounds(material);
    const auto above = [&](double bound) { return mean_edge > bound ? "kept" : "not kept: grains are too small"; };
    const auto below = [&](double bound) { return mean_edge < bound ? "kept" : "not kept: grains are too large"; };
    const auto zone = [&](const char* kind, double length) {
        return fmt::format("  contact zone (9 pi/32) E' Gf/tc^2, Gf {:<16} {:>9}   {:.2g} mean edges", kind, millimetres(length),
                           length / mean_edge);
    };
    return {
        fmt::format("grain size for {}: mean edge {}", material.name, millimetres(mean_edge)),
        fmt::format("  lower bound 10 w_I = 40 K_IC^2/(E sigma_t), Eqs 15, 17    {:>9}   {}", millimetres(bounds.lower),
                    above(bounds.lower)),
        fmt::format("  lower bound 10 w_II (the same with K_IIC)                 {:>9}   {}", millimetres(bounds.lower_shear),
                    above(bounds.lower_shear)),
        fmt::format("  upper bound l/3, l = (9 pi/32) (K_IC/sigma_t)^2, Eqs 15-17 {:>8}   {}", millimetres(bounds.upper),
                    below(bounds.upper)),
        zone("mixed", bounds.contact_zone_mixed),
        zone("mode-i", bounds.contact_zone_mode_i),
    };
}

namespace {

// Bytes of a specimen file, measured:
constexpr std::int64_t bytes_of_node = 17;
constexpr std::int64_t bytes_of_element = 24;
constexpr std::int64_t bytes_of_contact = 9;

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

std::string size_line(const char* what, double mean, double variation, double min, double max) {
    const auto mm = [](double value) { return in_unit(value, Dimension::length, "mm"); };
    return fmt::format("  {:<26} mean {:.4g} mm, CV {:.4f}, min {:.4g} mm, max {:.4g} mm", what, mm(mean), variation, mm(min),
                       mm(max));
}

std::string phase_line(const Specimen& specimen, const PhaseRequest& request) {
    const std::vector<double> reached = phase_fractions(specimen);
    std::string line = "  phases by area:";
    for (std::size_t p = 0; p < reached.size(); ++p) {
        const auto n_grains = std::count(specimen.grain_phase.begin(), specimen.grain_phase.end(), p);
        line += fmt::format("{} {} {:.4f} ({} requested) in {} grains", p == 0 ? "" : ",", specimen.phase_names[p], reached[p],
                            format_number(request.fractions[p].fraction), n_grains);
    }
    return line;
}

std::string strength_line(const Specimen& specimen, const StrengthRequest& request) {
    double sum = 0;
    double squares = 0;
    for (const double factor : specimen.contact_strength_factor) {
        sum += factor;
        squares += factor * factor;
    }
    const double mean = sum / static_cast<double>(specimen.n_contacts());
    const double variance = squares / static_cast<double>(specimen.n_contacts()) - mean * mean;
    return fmt::format("  strength factor: mean {:.4f}, CV {:.4f}; modulus {}, {}", mean,
                       std::sqrt(std::max(0.0, variance)) / mean, format_number(*request.modulus),
                       request.correlation ? "correlated over " + format_length(*request.correlation) : "uncorrelated");
}

std::string open_line(const Specimen& specimen) {
    const std::string open = open_boundaries_text(specimen);
    return "  open boundaries: " + (open.empty() ? "none" : open);
}

/// Mean edges or diameters at both ends of a grading; of elongated grains before they are elongated.
std::string grading_line(const Fabric& fabric, const MeshReport& report) {
    const auto mean = [&](std::size_t end) {
        if (report.graded_size[end] == 0) return std::string("none");
        return fmt::format("{} ({} requested)", format_quantity(report.graded_size[end], Dimension::length, 3),
                           format_quantity(report.requested_size[end], Dimension::length, 3));
    };
    const bool is_along = fabric.grading->is_along();
    return fmt::format("  graded {}: mean {} in the {} eighth, {} {}", fabric.has_crystals() ? "diameters" : "edges", mean(0),
                       is_along ? "lowest" : "nearest", mean(1), is_along ? "in the uppermost" : "beyond 7/8 of the distance");
}

/// Flaws as they came out, and the length of all contacts that are broken from the start.
std::string flaw_line(const Specimen& specimen, const MeshReport& report) {
    double broken = 0;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (!starts_broken(specimen.contact_kind[c])) continue;
        const auto& p = specimen.node_position[static_cast<std::size_t>(specimen.contact_nodes[c][0])];
        const auto& q = specimen.node_position[static_cast<std::size_t>(specimen.contact_nodes[c][1])];
        broken += std::hypot(q[0] - p[0], q[1] - p[1]);
    }
    return fmt::format("  {} of flaws and joints, {} long in all; contacts broken from the start: {}",
                       report.n_flaws == 1 ? "1 piece" : fmt::format("{} pieces", report.n_flaws),
                       format_length(report.flaw_length), format_length(broken));
}

/// Sizes and angles of crystals, which are made once and have no preferred direction to speak of.
void describe_crystals(const Specimen& specimen, const Fabric& fabric, const MeshReport& r, std::vector<std::string>& lines) {
    const MeshStatistics& s = specimen.statistics;
    lines.push_back(fmt::format(
        "  crystals: equal-area diameter mean {}, CV {:.4f}{} ({} requested); areas met to {:.0e}; {} short edges were removed{}",
        format_quantity(r.mean_diameter, Dimension::length, 4), r.spread, fabric.grading ? " over the graded size" : "",
        format_number(fabric.spread), r.largest_area_error, r.n_short_edges,
        r.n_edges_left > 0 ? fmt::format(" ({} could not be)", r.n_edges_left) : ""));
    const bool can_break = fabric.tessellation == Tessellation::trigon;
    lines.push_back(
        size_line(can_break ? "edge" : "edge of equal-area triangle", s.mean_edge, s.edge_variation, s.min_edge, s.max_edge));
    lines.push_back(fmt::format("  smallest angle of elements {:.1f} deg, psi6 {:.3f}, area error {:.1e}", degrees(s.min_angle),
                                s.psi6, s.area_error));
}

void describe_triangles(const MeshStatistics& s, const MeshReport& report, std::vector<std::string>& lines) {
    lines.push_back(size_line("edge", s.mean_edge, s.edge_variation, s.min_edge, s.max_edge));
    lines.push_back(size_line("equal-area diameter", s.mean_diameter, s.diameter_variation, s.min_diameter, s.max_diameter));
    lines.push_back(
        fmt::format("  smallest angle {:.1f} deg, psi6 {:.3f} (at most {:.3f} in eight equal parts), area error {:.1e}",
                    degrees(s.min_angle), s.psi6, report.psi6_of_parts, s.area_error));
}

/// Triangles that are not as they should be.
void add_notes_on_triangles(const Specimen& specimen, const Request& request, const MeshReport& report,
                            std::vector<std::string>& lines) {
    const MeshStatistics& s = specimen.statistics;
    const double spread = request.fabric.spread;
    if (request.fabric.grading || s.elongation > 0) {
        lines.push_back(fmt::format("  spread {:.3f} over the graded size, before elongation", report.spread));
    }
    if (std::abs(report.spread - spread) > 0.1 * spread) {
        lines.push_back(fmt::format("  note: spread {:.3f} was requested, {:.3f} was reached", spread, report.spread));
    }
    if (const auto ends = notch_ends(specimen); ends && request.notch) {
        lines.push_back(fmt::format("  notch of {} requested, {} between the ends of its grain boundaries",
                                    format_length(*request.notch), format_quantity((*ends)[1] - (*ends)[0], Dimension::length)));
    }
    if (report.n_flaws + request.region.loops.size() > 1 && report.min_angle < smallest_angle) {
        lines.push_back(
            "  note: holes or flaws lie so near to each other that a grain has a small angle, which makes time steps short");
    }
    if (s.psi6 > max_psi6 || report.psi6_of_parts > max_psi6_of_parts) {
        lines.push_back(
            fmt::format("  note: after {} attempts parts of the mesh still have a preferred direction, which is hardly "
                        "avoidable with so few grains",
                        report.attempts));
    }
}

}  // namespace

std::vector<std::string> describe_mesh(const Specimen& specimen, const Request& request, const MeshReport& report) {
    const Fabric& fabric = request.fabric;
    const MeshStatistics& s = specimen.statistics;
    std::vector<std::string> lines{fmt::format("{} of {}{}: {} nodes, {} contacts, {} boundary edges", specimen.shape,
                                               grains_text(specimen),
                                               fabric.has_crystals() ? " (" + specimen.tessellation + ")" : "",
                                               specimen.n_nodes(), specimen.n_contacts(), specimen.n_boundary_edges())};
    if (fabric.has_crystals()) {
        describe_crystals(specimen, fabric, report, lines);
    } else {
        describe_triangles(s, report, lines);
    }
    if (specimen.loading_arc > 0) lines.push_back(fmt::format("  loading arc {:.2f} deg", degrees(specimen.loading_arc)));
    if (!fabric.phases.fractions.empty()) lines.push_back(phase_line(specimen, fabric.phases));
    if (fabric.strength.modulus) lines.push_back(strength_line(specimen, fabric.strength));
    if (fabric.open.fraction) lines.push_back(open_line(specimen));
    if (s.elongation > 0) {
        lines.push_back(fmt::format("  elongation {:.3f} along {:.1f} deg", s.elongation, degrees(s.elongation_angle)));
    }
    if (fabric.grading) lines.push_back(grading_line(fabric, report));
    if (report.n_flaws > 0 || !request.joint_sets.empty()) lines.push_back(flaw_line(specimen, report));
    if (!fabric.has_crystals()) add_notes_on_triangles(specimen, request, report, lines);
    if (const std::string note = note_on_few_crystals(specimen); !note.empty()) lines.push_back("  note: " + note);
    return lines;
}

std::vector<std::string> describe_plan(const Request& request) {
    const MeshPlan plan = plan_mesh(request);
    if (request.fabric.has_crystals()) {
        const auto n = static_cast<double>(plan.n_grains);
        // Crystals have five or so elements at least.
        const double elements = n * std::max(5.0, 1.8 * plan.edge * plan.edge / (plan.element_size * plan.element_size));
        return {fmt::format("{} of {} crystals, edge of the equilateral triangle of their mean area {}", request.region.name,
                            plan.n_grains, format_quantity(plan.edge, Dimension::length, 3)),
                fmt::format("  elements of {}, about {:.2g} in all; time about {:.2g} s",
                            format_quantity(plan.element_size, Dimension::length, 3), elements, 1e-4 * n + 1e-5 * elements)};
    }
    const std::int64_t n = request.fabric.elements_per_edge;  // along an edge
    const std::int64_t nodes = plan.n_grains * (n + 1) * (n + 2) / 2;
    const std::int64_t elements = plan.n_grains * n * n;
    const std::int64_t contacts = (3 * plan.n_grains - plan.n_boundary) / 2 * n;
    const double megabytes =
        1e-6 * static_cast<double>(bytes_of_node * nodes + bytes_of_element * elements + bytes_of_contact * contacts);
    return {
        fmt::format("{} of {}{} grains, mean edge about {}", request.region.name, request.fabric.grains ? "" : "about ",
                    plan.n_grains, format_quantity(plan.edge, Dimension::length, 3)),
        fmt::format("  {} nodes, {} elements, {} contacts, {} boundary edges", nodes, elements, contacts, plan.n_boundary * n),
        fmt::format("  file about {:.2g} MB, time about {:.2g} s", megabytes, 1.2e-5 * static_cast<double>(plan.n_grains)),
    };
}

}  // namespace graincrack::mesher
