#include "solver/setup/regions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

constexpr double relative_slack = 1e-9;  // over the specimen's size, as in the schema

std::vector<std::uint8_t> numbers_of(const std::vector<std::string>& parts, const Specimen& s, const std::string& where) {
    std::vector<std::uint8_t> numbers;
    for (const std::string& part : parts) {
        const auto found = std::find(s.part_names.begin(), s.part_names.end(), part);
        if (found == s.part_names.end()) {
            throw InputError(fmt::format("{}: on: the specimen has no boundary part {}; it has {}", where, part,
                                         fmt::join(s.part_names, ", ")));
        }
        numbers.push_back(static_cast<std::uint8_t>(found - s.part_names.begin()));
    }
    return numbers;
}

/// Rotation of the specimen as a whole, rad: a least-squares fit weighted by the nodal masses.
double mean_rotation(const Assemblage& a, const State& state) {
    const auto mean = [&](const std::vector<Vector2>& value) {
        return (1 / sum_over_nodes(a, [&](std::int32_t i) { return a.rock_mass[i]; })) *
               Vector2{sum_over_nodes(a, [&](std::int32_t i) { return a.rock_mass[i] * value[i].x; }),
                       sum_over_nodes(a, [&](std::int32_t i) { return a.rock_mass[i] * value[i].y; })};
    };
    const Vector2 centre = mean(a.position);
    const Vector2 moved = mean(state.displacement);
    const auto sum = [&](auto&& of_node) {
        return sum_over_nodes(
            a, [&](std::int32_t i) { return a.rock_mass[i] * of_node(a.position[i] - centre, state.displacement[i] - moved); });
    };
    return sum([](const Vector2& r, const Vector2& u) { return r.x * u.y - r.y * u.x; }) /
           sum([](const Vector2& r, const Vector2&) { return dot(r, r); });
}

/// The node nearest to a point, the first of several; none for a point far outside.
RegionContent content_of_point(const Vector2& point, double slack, const Assemblage& a, const Specimen& s) {
    constexpr double near = 0.55;  // largest distance from the middle, over the extents
    RegionContent content;
    double least = std::numeric_limits<double>::infinity();
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        const double distance = length(a.position[i] - point);
        if (a.mass[i] == 0 || distance >= least - slack) continue;
        content.nodes = {i};
        least = distance;
    }
    if (std::abs(point.x) > near * s.width || std::abs(point.y) > near * s.height) content.nodes.clear();
    return content;
}

RegionContent content_within(const Region& region, const Assemblage& a, const Specimen& s, const std::string& where) {
    const std::vector<std::uint8_t> parts = numbers_of(region.parts, s, where);
    const bool is_outline = !parts.empty() || region.angles;
    RegionContent content;
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        if (!parts.empty() && std::find(parts.begin(), parts.end(), s.boundary_part[e]) == parts.end()) continue;
        const std::int32_t first = a.node_of_specimen[s.boundary_edges[e][0]];
        const std::int32_t second = a.node_of_specimen[s.boundary_edges[e][1]];
        if (!region.has_angle_of(0.5 * (a.position[first] + a.position[second]))) continue;
        if (region.has(a.position[first]) && region.has(a.position[second])) content.edges.push_back(e);
        for (const std::int32_t i : {first, second}) {
            if (is_outline && region.has(a.position[i])) content.nodes.push_back(i);
        }
    }
    for (std::int32_t i = 0; i < a.n_nodes() && !is_outline; ++i) {
        if (region.has(a.position[i]) && a.mass[i] > 0) content.nodes.push_back(i);
    }
    std::sort(content.nodes.begin(), content.nodes.end());
    content.nodes.erase(std::unique(content.nodes.begin(), content.nodes.end()), content.nodes.end());
    return content;
}

/// Prescribes velocities to nodes. Later conditions override earlier ones component by component.
void prescribe_velocities(const RegionContent& content, const std::array<std::int32_t, n_actions>& amplitudes,
                          std::int32_t condition, std::vector<PrescribedNode>& by_node) {
    for (const std::int32_t i : content.nodes) {
        by_node[i].node = i;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (amplitudes[axis] != no_amplitude) {
                by_node[i].amplitude[axis] = amplitudes[axis];
                by_node[i].condition[axis] = condition;
            }
        }
    }
}

void load_edges(const RegionContent& content, const std::array<std::int32_t, n_actions>& amplitudes, std::int32_t condition,
                const Assemblage& a, const Specimen& s, PrescribedConditions& prescribed) {
    for (const std::size_t e : content.edges) {
        LoadedEdge edge;
        edge.nodes = {a.node_of_specimen[s.boundary_edges[e][0]], a.node_of_specimen[s.boundary_edges[e][1]]};
        edge.traction = {amplitudes[static_cast<std::size_t>(Action::traction_x)],
                         amplitudes[static_cast<std::size_t>(Action::traction_y)]};
        edge.pressure = amplitudes[static_cast<std::size_t>(Action::pressure)];
        edge.shear = amplitudes[static_cast<std::size_t>(Action::shear)];
        edge.condition = condition;
        edge.length = length(a.position[edge.nodes[1]] - a.position[edge.nodes[0]]);
        const auto part = static_cast<BoundaryPart>(s.boundary_part[e]);
        edge.is_lateral = part == BoundaryPart::left || part == BoundaryPart::right;
        prescribed.edges.push_back(edge);
    }
}

/// The conditions that load an edge, by action; null for none.
using LoadingConditions = std::array<const BoundaryCondition*, n_actions>;
/// Records the loads of a condition. \throws InputError if another condition prescribes the same load on an edge
void note_loads(const RegionContent& content, const Program& program, std::size_t condition, const Assemblage& a,
                const Specimen& s, std::vector<LoadingConditions>& loaded_by) {
    const BoundaryCondition& own = program.boundary_conditions[condition];
    for (const std::size_t e : content.edges) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            if (!own.is_set[i] || is_velocity(static_cast<Action>(i))) continue;
            if (const BoundaryCondition* const other = std::exchange(loaded_by[e][i], &own)) {
                const Vector2 middle = 0.5 * (a.position[a.node_of_specimen[s.boundary_edges[e][0]]] +
                                              a.position[a.node_of_specimen[s.boundary_edges[e][1]]]);
                throw InputError(fmt::format(
                    "{}: boundary.{}: {}: boundary.{} has one on the same edge, at {:.4g} mm, {:.4g} mm; "
                    "parts that do not overlap fit",
                    program.file, own.name, name_of(static_cast<Action>(i)), other->name, 1e3 * middle.x, 1e3 * middle.y));
            }
        }
    }
}

PrescribedConditions make_prescribed_conditions(const Assemblage& a, const Specimen& s, const Program& program) {
    const AmplitudeNumbers amplitudes = number_amplitudes(program);
    PrescribedConditions prescribed;
    prescribed.gravity = program.gravity;
    std::vector<PrescribedNode> by_node(a.position.size());
    std::vector<LoadingConditions> loaded_by(s.n_boundary_edges());
    for (std::size_t c = 0; c < program.boundary_conditions.size(); ++c) {
        const BoundaryCondition& condition = program.boundary_conditions[c];
        const std::string where = fmt::format("{}: boundary.{}", program.file, condition.name);
        const RegionContent content = content_of_region(condition.region, a, s, where);
        const auto is_set = [&](Action action) { return condition.is_set[static_cast<std::size_t>(action)]; };
        if (is_set(Action::velocity_x) || is_set(Action::velocity_y)) {
            prescribe_velocities(content, amplitudes[c], static_cast<std::int32_t>(c), by_node);
        }
        if (is_set(Action::traction_x) || is_set(Action::traction_y) || is_set(Action::pressure) || is_set(Action::shear)) {
            if (content.edges.empty()) {
                throw InputError(where +
                                 ": there is no boundary edge to load; a part of the boundary, or a box that holds some, fits");
            }
            note_loads(content, program, c, a, s, loaded_by);
            load_edges(content, amplitudes[c], static_cast<std::int32_t>(c), a, s, prescribed);
        }
    }
    std::copy_if(by_node.begin(), by_node.end(), std::back_inserter(prescribed.nodes),
                 [](const PrescribedNode& n) { return n.amplitude[0] != no_amplitude || n.amplitude[1] != no_amplitude; });
    arrange_prescribed(a, prescribed);
    return prescribed;
}

}  // namespace

AmplitudeNumbers number_amplitudes(const Program& program) {
    AmplitudeNumbers numbers;
    std::int32_t next = 0;
    for (const BoundaryCondition& condition : program.boundary_conditions) {
        numbers.emplace_back();
        for (std::size_t i = 0; i < n_actions; ++i) numbers.back()[i] = condition.is_set[i] ? next++ : no_amplitude;
    }
    return numbers;
}

RegionContent content_of_region(const Region& region, const Assemblage& a, const Specimen& s, const std::string& where) {
    const double slack = relative_slack * (s.width + s.height);
    RegionContent content;
    if (region.at) {
        content = content_of_point({region.at->front(), region.at->back()}, slack, a, s);
    } else {
        Region wide = region;
        wide.left -= slack;
        wide.right += slack;
        wide.bottom -= slack;
        wide.top += slack;
        content = content_within(wide, a, s, where);
    }
    if (content.nodes.empty() && region.angles) {
        throw InputError(where + ": no edge of the boundary there has its middle between these angles; a wider range fits");
    }
    if (content.nodes.empty()) {
        throw InputError(
            fmt::format("{}: nothing of the specimen is there; it reaches from {} mm to {} mm along x and from {} mm to "
                        "{} mm along y",
                        where, -500 * s.width, 500 * s.width, -500 * s.height, 500 * s.height));
    }
    return content;
}

namespace {

/// Position of the face of a platen along its axis at which it first meets the boundary, m.
double position_of(const Platen& platen, const Assemblage& a, const Specimen& s, const std::string& where) {
    double outermost = -std::numeric_limits<double>::infinity();
    const double slack = 1e-9 * s.height;
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        const bool is_part =
            platen.parts.empty() || std::find(platen.parts.begin(), platen.parts.end(), s.boundary_part[e]) != platen.parts.end();
        for (const std::int32_t node : s.boundary_edges[e]) {
            const Vector2& position = a.position[a.node_of_specimen[node]];
            const double along = dot(across(platen.axis), position);
            if (!is_part || along < platen.left - slack || along > platen.right + slack) continue;
            outermost = std::max(outermost, platen.side * dot(platen.axis, position));
        }
    }
    if (std::isinf(outermost)) {
        throw InputError(fmt::format(
            "{}: meets no node of the boundary from {} mm to {} mm across its direction; another place, or a width of more than "
            "a grain edge ({:.3g} mm) does",
            where, 1e3 * platen.left, 1e3 * platen.right, 1e3 * s.statistics.mean_edge));
    }
    return platen.side * outermost;
}

/// Appends the faces of the bottom or the top platen of a program.
void append_faces(std::vector<Platen>& platens, Platen platen, const PlatenFaces& faces, const Assemblage& a, const Specimen& s,
                  const std::string& where) {
    if (faces.empty() && platen.axis.x == 0) {
        platen.position = platen.side * s.height / 2;
        platens.push_back(platen);
        return;
    }
    platen.parts = numbers_of(faces.parts, s, where);
    const std::size_t n_faces = std::max<std::size_t>(faces.at.size(), 1);
    for (std::size_t i = 0; i < n_faces; ++i) {
        if (!faces.at.empty()) {
            platen.left = faces.at[i] - faces.width / 2;
            platen.right = faces.at[i] + faces.width / 2;
        }
        platen.position = position_of(platen, a, s, where);
        platens.push_back(platen);
    }
}

}  // namespace

Boundary make_program_boundary(const Assemblage& a, const Specimen& s, const Program& program, const ContactParameters& contact,
                               double platen_friction) {
    Platen bottom;
    bottom.motion = bottom_platen;
    bottom.side = -1;
    Platen top;
    std::vector<Platen> platens;
    double reach = 0;
    if (program.platens) {
        // Nodes reach a platen through its own approach or the rotation of a separated grain.
        reach = 2 * s.statistics.mean_edge + program.platens->max_strain * s.height;
        for (Platen* const platen : {&bottom, &top}) {
            platen->axis = program.platens->axis();
            platen->normal_stiffness = contact.normal_stiffness;
            platen->shear_stiffness = program.platens->bonded ? 0 : contact.shear_stiffness;
            platen->tan_friction = std::tan(platen_friction);
            platen->bonded = program.platens->bonded;
        }
        append_faces(platens, bottom, program.platens->bottom, a, s, program.file + ": platens.bottom");
        append_faces(platens, top, program.platens->top, a, s, program.file + ": platens.top");
    } else {
        bottom.position = -std::numeric_limits<double>::infinity();
        top.position = std::numeric_limits<double>::infinity();
        platens = {bottom, top};
    }
    Boundary boundary = make_boundary(a, s, platens, reach);
    boundary.prescribed = make_prescribed_conditions(a, s, program);
    return boundary;
}

void remove_platens(State& state) {
    for (PlatenPoint& point : state.platen_points) point.gap = -std::numeric_limits<double>::infinity();
}

void place_platens(const Assemblage& a, const Boundary& boundary, State& state) {
    const double rotation = mean_rotation(a, state);
    const auto along = [&](const PlatenPoint& point) {
        const Platen& platen = boundary.platens[point.platen];
        const Vector2 axis = platen.bonded ? platen.axis : platen.axis + rotation * Vector2{-platen.axis.y, platen.axis.x};
        return platen.side * dot(axis, a.position[point.node] + state.displacement[point.node]);
    };
    std::vector<double> outermost(boundary.platens.size(), -std::numeric_limits<double>::infinity());
    for (const PlatenPoint& point : state.platen_points) {
        if (!point.on_boundary || !a.part.owns(point.node)) continue;
        outermost[point.platen] = std::max(outermost[point.platen], along(point));
    }
    a.part.ranks->take_largest(outermost);
    for (PlatenPoint& point : state.platen_points) {
        const Platen& platen = boundary.platens[point.platen];
        const double apart = platen.bonded ? 0 : along(point) - outermost[point.platen];
        const Vector2 moved = state.displacement[point.node];
        point.gap = apart - platen.side * (dot(platen.axis, moved) - state.loading.platen_displacement[platen.motion]);
    }
}

void set_initial_velocities(const Program& program, const Assemblage& a, const Specimen& s, State& state) {
    for (const InitialVelocity& initial : program.initial_velocities) {
        for (const std::int32_t i : content_of_region(initial.region, a, s, program.file + ": initial").nodes) {
            state.velocity[i] = initial.velocity;
        }
    }
    for (std::size_t chunk = 0; chunk < a.node_chunks.size(); ++chunk) {
        const Range nodes = a.node_chunks[chunk].nodes;
        double energy = 0;
        for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
            energy += 0.5 * a.mass[i] * dot(state.velocity[i], state.velocity[i]);
        }
        state.node_sums[chunk].load_work += energy;
    }
}

}  // namespace graincrack
