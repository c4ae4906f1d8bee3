#include "solver/run/measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/node_edge_contact.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "solver/step/prescribed.hpp"

namespace graincrack {
namespace {

/// Least-squares slope of one displacement component over the same coordinate.
Gauge slope_gauge(const Assemblage& a, bool along_y, const std::vector<std::int32_t>& nodes) {
    const auto coordinate = [&](std::int32_t i) { return along_y ? a.position[i].y : a.position[i].x; };
    double mean = 0;
    for (const std::int32_t i : nodes) mean += coordinate(i);
    mean /= static_cast<double>(std::max<std::size_t>(nodes.size(), 1));
    double square = 0;
    for (const std::int32_t i : nodes) square += (coordinate(i) - mean) * (coordinate(i) - mean);
    Gauge gauge{along_y, {}, {}};
    if (square > 0) {
        for (const std::int32_t i : nodes) gauge.terms.push_back({i, (coordinate(i) - mean) / square});
    }
    return gauge;
}

void cut_terms(const Assemblage& a, Gauge& gauge) {
    std::sort(gauge.terms.begin(), gauge.terms.end(), [](const Gauge::Term& l, const Gauge::Term& r) { return l.node < r.node; });
    gauge.of_chunk = ranges_by_chunk(a, gauge.terms, [](const Gauge::Term& term) { return term.node; });
}

/// Nodes of the lateral boundary: side −1 left, +1 right.
std::vector<std::int32_t> lateral_nodes(const Assemblage& a, const Specimen& s, double side) {
    constexpr double tan_15_degrees = 0.2679491924311227;
    const auto part = static_cast<std::uint8_t>(side < 0 ? BoundaryPart::left : BoundaryPart::right);
    std::vector<std::int32_t> nodes;
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        for (const std::int32_t specimen_node : s.boundary_edges[e]) {
            const std::int32_t i = a.node_of_specimen[specimen_node];
            const Vector2& p = a.position[i];
            const bool near_axis = s.boundary_part[e] == static_cast<std::uint8_t>(BoundaryPart::rim) && side * p.x > 0 &&
                                   std::abs(p.y) <= tan_15_degrees * std::abs(p.x);
            if (s.boundary_part[e] == part || near_axis) nodes.push_back(i);
        }
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

/// Damping at this instant, into `damping_force`.
void find_damping_forces(const Assemblage& a, const StepParameters& parameters, State& s) {
    const MassScaling& scaling = parameters.mass_scaling;
    for (std::int32_t block = 0; scaling.is_on() && block < static_cast<std::int32_t>(a.node_chunks.size()); ++block) {
        update_clusters(a, parameters, s.loading, block, s);
        damp_clusters(a, parameters, s.loading, block, s);
    }
    for (std::size_t i = 0; i < s.damping_force.size() && !scaling.is_on(); ++i) {
        s.damping_force[i] = damping_force(parameters.damps(), s.force[i], s.force[i] - s.last_force[i], s.velocity[i]);
    }
}

double kinetic_energy(const Assemblage& a, const StepParameters& parameters, const State& s) {
    return 0.5 * sum_over_nodes(a, [&](std::int32_t i) {
               const Vector2 force = s.force[i] + s.damping_force[i];
               return a.mass[i] * dot(s.velocity[i], s.velocity[i] + (parameters.time_step * a.inverse_mass[i]) * force);
           });
}

double damping_half_work(const Assemblage& a, const StepParameters& parameters, const State& s) {
    return -0.5 * parameters.time_step *
           sum_over_nodes(a, [&](std::int32_t i) { return dot(s.damping_force[i], s.velocity[i]); });
}

TriangleState element_state(const Assemblage& a, std::size_t e, const State& s) {
    const auto [n0, n1, n2] = a.element_nodes[e];
    return triangle_state(a.element_geometry[e], a.elasticity[e], s.displacement[n1] - s.displacement[n0],
                          s.displacement[n2] - s.displacement[n0]);
}

/// Strain energy (J) and Σ |force on a node| over the nodes (N) of elements.
struct ElementSums {
    double energy = 0, force = 0;
    ElementSums& operator+=(const ElementSums& other) {
        energy += other.energy;
        force += other.force;
        return *this;
    }
};
ElementSums sum_over_elements(const Assemblage& a, const State& s) {
    return sum_over(a.element_chunks, [&](std::int32_t e) {
        const TriangleGeometry g = a.element_geometry[e];
        const TriangleState t = element_state(a, e, s);
        const TriangleForces f = triangle_forces(g, t);
        return ElementSums{triangle_energy(g, t), length(f.on_node0()) + length(f.on_node1) + length(f.on_node2)};
    });
}

void add_contact_energies(const Assemblage& a, const ContactLaws& laws, const State& s, Energies& energies) {
    energies.contact += stored_in_contacts(a, laws, s);
    energies.friction +=
        std::accumulate(s.contact_pairs.friction.begin(), s.contact_pairs.friction.end(), s.contact_pairs.friction_before);
    for (const ContactSums& sums : s.contact_sums) {
        energies.fracture_tension += sums.fracture_tension;
        energies.fracture_shear += sums.fracture_shear;
        energies.friction += sums.friction;
        energies.non_conservative_work += sums.non_conservative_work;
    }
}

/// What the platens do: energy they keep (J), work of the last half step (J), power (W), forces along y (N).
struct PlatenSums {
    double energy = 0, half_work = 0, power = 0;
    std::array<double, 2> force{};
    PlatenSums& operator+=(const PlatenSums& other) {
        energy += other.energy;
        half_work += other.half_work;
        power += other.power;
        force[bottom_platen] += other.force[bottom_platen];
        force[top_platen] += other.force[top_platen];
        return *this;
    }
};
void add_platen_energies(const Boundary& boundary, double time_step, const State& s, Measurement& m) {
    const PlatenSums sums = sum_over(boundary.platen_points_of_chunk, [&](std::int32_t i) {
        const PlatenPoint& point = s.platen_points[i];
        const PlatenResponse r = platen_response(boundary.platens[point.platen], point, s.displacement[point.node],
                                                 s.loading.platen_displacement[point.platen]);
        const double increment = s.loading.increment_before[point.platen];
        PlatenSums of_point{r.stored + r.friction, 0.5 * r.force.y * increment, r.force.y * increment / time_step};
        of_point.force[point.platen] = r.force.y;
        return of_point;
    });
    m.energies.platen += sums.energy;
    m.energies.external += sums.half_work;
    m.platen_power += sums.power;
    m.force_bottom += sums.force[bottom_platen];
    m.force_top += sums.force[top_platen];
}

void add_prescribed_energies(const Assemblage& a, const PrescribedConditions& prescribed, double time_step, const State& s,
                             Measurement& m) {
    if (prescribed.empty()) return;
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(a.node_chunks.size()); ++block) {
        m.energies.external += load_half_work(a, prescribed, block, time_step, s);
    }
    m.energies.external += reaction_half_work(prescribed, time_step, s);
    // Two ends an edge, two sides: the mean of the sides.
    m.membrane_force += sum_over(prescribed.edges_of_chunk, [&](std::int32_t i) { return std::abs(s.prescribed.pressing[i]); });
}

/// Motions, tractions, damage and states of all contact points, into a frame.
template <class Law>
void add_contacts(const Assemblage& a, const ContactLaws& laws, const State& s, Frame& frame) {
    for (auto* pairs : {&frame.opening, &frame.sliding, &frame.damage}) pairs->resize(a.n_contacts());
    frame.traction.resize(a.n_contacts());
    frame.state.resize(a.n_contacts());
    for_each_contact(a, [&](std::int32_t place, std::int32_t contact_class) {
        const ContactLaw& law = laws[contact_class];
        const std::int32_t c = a.specimen_contact[place];
        const double strength = a.contacts[place].strength;
        const bool released = s.contact_pairs.released[place] != 0;  // node–edge contacts carry its load
        for (std::size_t end = 0; end < 2; ++end) {
            const ContactHistory h = point_history(s, points_of(place)[end]);
            const ContactTraction t = released ? ContactTraction{} : contact_law::update<Law>(law, h.motion, h).traction;
            frame.opening[c][end] = strength * h.motion.opening;
            frame.sliding[c][end] = strength * h.motion.sliding;
            frame.traction[c][2 * end] = strength * t.normal;
            frame.traction[c][2 * end + 1] = strength * t.shear;
            frame.damage[c][end] = contact_law::damage<Law>(law, h);
            frame.state[c][end] = static_cast<std::uint8_t>(point_state(h));
        }
    });
}

}  // namespace

double Gauge::strain(const std::vector<Vector2>& displacement) const {
    return sum_over(of_chunk, [&](std::int32_t i) {
        const Vector2& u = displacement[terms[i].node];
        return terms[i].weight * (along_y ? u.y : u.x);
    });
}

Gauges make_gauges(const Assemblage& a, const Specimen& s) {
    std::vector<std::int32_t> central;
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        const Vector2& p = a.position[i];
        if (std::abs(p.y) <= s.height / 4 && (s.shape != "disc" || std::abs(p.x) <= s.width / 4)) central.push_back(i);
    }
    Gauges gauges{slope_gauge(a, true, central), slope_gauge(a, false, central), {}};
    for (const double side : {-1.0, 1.0}) {
        const std::vector<std::int32_t> nodes = lateral_nodes(a, s, side);
        for (const std::int32_t i : nodes) {
            gauges.widening.terms.push_back({i, side / (static_cast<double>(nodes.size()) * s.width)});
        }
    }
    for (Gauge* gauge : {&gauges.axial, &gauges.lateral, &gauges.widening}) cut_terms(a, *gauge);
    return gauges;
}

Measurement measure(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, State& s) {
    Measurement m;
    sum_nodal_forces(a, boundary, s.loading, s);
    const ElementSums elements = sum_over_elements(a, s);
    m.energies.strain = elements.energy;
    find_damping_forces(a, parameters, s);
    m.own_kinetic = kinetic_energy(a, parameters, s);
    const double unbalanced = sum_over_nodes(a, [&](std::int32_t i) { return length(s.force[i]); });
    m.energies.kinetic = m.own_kinetic;
    m.energies.damping = damping_half_work(a, parameters, s);
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(s.clusters.sums.size()); ++block) {
        m.energies.kinetic += added_kinetic_energy(a, parameters, s.loading, block, s);
    }
    for (const ClusterSums& sums : s.clusters.sums) {
        m.energies.damping += sums.damping;
        m.energies.numerical += sums.platen_loss;
        m.energies.external += sums.platen_work;
    }
    m.unbalanced_ratio = elements.force > 0 ? unbalanced / elements.force : 0;
    add_contact_energies(a, parameters.laws, s, m.energies);
    add_platen_energies(boundary, parameters.time_step, s, m);
    add_prescribed_energies(a, boundary.prescribed, parameters.time_step, s, m);
    for (const NodeSums& sums : s.node_sums) {
        m.energies.damping += sums.damping;
        m.energies.external += sums.platen_work + sums.load_work + sums.reaction_work;
        m.energies.platen += sums.platen_friction;
    }
    return m;
}

double stored_in_contacts(const Assemblage& a, const ContactLaws& laws, const State& s) {
    double energy = stored_in_active_contacts(a, laws, s.contact_pairs);
    contact_law::with_law(laws.variant(), [&](auto kind) {
        for (const ContactChunk& chunk : a.contact_chunks) {
            const ContactLaw& law = laws[chunk.contact_class];
            energy += sum_over(chunk.contacts, [&](std::int32_t c) {
                const auto [first, second] = points_of(c);
                const double of_points = decltype(kind)::stored_energy(law, point_history(s, first)) +
                                         decltype(kind)::stored_energy(law, point_history(s, second));  // per area, over s²
                const double strength = a.contacts[c].strength;
                return s.contact_pairs.released[c] != 0 ? 0 : strength * strength * a.contacts[c].point_area * of_points;
            });
        }
    });
    return energy;
}

Frame make_frame(const Assemblage& a, const ContactLaws& laws, const State& s) {
    Frame frame;
    frame.time = s.time;
    frame.step = s.step;
    for (const std::int32_t i : a.node_of_specimen) {
        frame.displacement.push_back({s.displacement[i].x, s.displacement[i].y});
        frame.velocity.push_back({s.velocity[i].x, s.velocity[i].y});
    }
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        frame.element_stress.push_back(triangle_stress(a.elasticity[e], element_state(a, e, s)));
    }
    contact_law::with_law(laws.variant(), [&](auto kind) { add_contacts<decltype(kind)>(a, laws, s, frame); });
    return frame;
}

}  // namespace graincrack
