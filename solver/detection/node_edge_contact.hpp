// A node–edge contact (share/doc/laws.md) acts between a node of one grain and an edge of another without a bond. It has a
// penalty stiffness and Coulomb friction, and a stored energy.
//
// Let x be the node, x0 → x1 the edge (solid on its left), t its direction, n its outward normal, and s the place of the node
// along it, 0 to 1. The depth is d = −(x − x0)·n, the overlap is e = d − initial overlap, where the initial overlap is the depth
// at which the contact was found. With the tributary area A of the node:
//
//   normal    kt A e on the node along n; the spring stores ½ kt A e²
//   friction  τ = ks q within ±(c_r + kt e tan φ_r) while e > 0, with the elastic part q of the sliding; it stores ½ ks A q²
//
// The edge takes the opposite forces in the fractions 1 − s and s, and the couple d τ. A contact ends between two steps: when the
// node is found past the edge by o, the scheme has taken ½ kt A e o more energy from the spring than it stored. A tension of
// ½ kt A e o/(e + o) in the following step corrects this: its work over the distance 2 (e + o) of two steps is that energy.
#pragma once

#include <algorithm>

#include "solver/arithmetic/simd.hpp"
#include "solver/arithmetic/vector2.hpp"
#include "solver/law/contact_law.hpp"
#include "solver/model/contact_pairs.hpp"

namespace graincrack {

/// Position of a node relative to an edge.
struct PairGeometry {
    Vector2 tangent;
    Vector2 normal;         ///< outward normal, t turned by −90°
    double inv_length = 0;  ///< inverse length of the edge, 1/m
    double place = 0;       ///< s along the edge, 0 to 1 over it
    double depth = 0;       ///< d behind the edge, m
};
/// \param edge vector from its first node to its second, m \param from_first vector from the first node to the node, m
GRAINCRACK_INLINE PairGeometry pair_geometry(const Vector2& edge, const Vector2& from_first) {
    const double inv_length = 1 / length(edge);
    const Vector2 t = inv_length * edge;
    const Vector2 n{t.y, -t.x};
    return {t, n, inv_length, inv_length * dot(from_first, t), -dot(from_first, n)};
}
inline PairGeometry pair_geometry(const Vector2& node, const Vector2& first, const Vector2& second) {
    return pair_geometry(second - first, node - first);
}

/// Forces of a node–edge contact.
struct NodeEdgeForces {
    Vector2 on_node, on_first, on_second;  ///< N
};
struct NodeEdgeResponse {
    NodeEdgeContact contact;
    NodeEdgeForces forces;
    double friction = 0;  ///< energy dissipated in the update, J
    double slip = 0;      ///< slip in the update, m
};

/// The law of a node–edge contact: the residual law of the contact class of its two grains.
inline FrictionLaw friction_law(const ContactLaw& law) {
    const double per_slip = law.wear_slip > 0 ? 1 / law.wear_slip : 0;
    return {law.kt, law.ks, law.residual_cc, law.worn_tan_phi, per_slip > 0 ? law.tan_phi - law.worn_tan_phi : 0, per_slip};
}
inline FrictionLaw friction_law(const Assemblage& a, const ContactLaws& laws, const CandidatePair& pair) {
    return friction_law(laws[class_between(a, pair.node, pair.edge)]);
}
/// Largest frictional traction of worn faces under a pressure (Pa), Pa.
GRAINCRACK_INLINE double friction_limit(const FrictionLaw& law, double pressure) {
    return law.cohesion + pressure * law.tan_friction;
}
/// The same with tan φ_r + (tan φc − tan φ_r) (1 − worn/w) for faces that have slid by `worn` (m) since they lost their cohesion.
GRAINCRACK_INLINE double friction_limit(const FrictionLaw& law, double pressure, double worn) {
    return friction_limit(law, pressure) + pressure * law.tan_fresh * std::max(0.0, 1 - worn * law.inv_wear_slip);
}
/// The limit at the end of a step in which faces slide on from `worn` until the spring bears the limit there; both are linear in
/// the slip. \param trial magnitude of the traction without slip, Pa
GRAINCRACK_INLINE double worn_limit(const FrictionLaw& law, double pressure, double worn, double trial) {
    const double before = friction_limit(law, pressure, worn);
    const double fall = pressure * law.tan_fresh * law.inv_wear_slip / law.shear_stiffness;  // over that of the spring
    const double along = fall < 1 ? (before - fall * trial) / (1 - fall) : 0.0;
    return trial > before ? std::max(std::min(before, along), friction_limit(law, pressure)) : before;
}

/// Energy stored in the springs of a node–edge contact, J.
inline double node_edge_energy(const FrictionLaw& law, const NodeEdgeContact& contact) {
    return 0.5 * contact.area *
           (law.normal_stiffness * contact.overlap * contact.overlap +
            law.shear_stiffness * contact.elastic_slip * contact.elastic_slip);
}

GRAINCRACK_INLINE NodeEdgeForces node_edge_forces(const FrictionLaw& law, const NodeEdgeContact& contact, const PairGeometry& g) {
    const double pressure = contact.area * law.normal_stiffness * (contact.overlap - contact.release_correction);
    const double friction = contact.area * law.shear_stiffness * contact.elastic_slip;
    const Vector2 on_node = pressure * g.normal - friction * g.tangent;
    const Vector2 couple = (friction * g.depth * g.inv_length) * g.normal;
    return {on_node, -(1 - g.place) * on_node - couple, -g.place * on_node + couple};
}

/// Moves an active contact to a new position.
///
/// \param sliding of the node along the edge since the last update, in the edge's own frame, m
/// \tparam wears true if faces wear \param worn slip of the faces of the node so far, m
template <bool wears = false>
GRAINCRACK_INLINE NodeEdgeResponse move_node_edge_contact(const FrictionLaw& law, const NodeEdgeContact& old,
                                                          const PairGeometry& g, double sliding, double worn = 0) {
    NodeEdgeResponse r{old, {}, 0};
    NodeEdgeContact& contact = r.contact;
    contact.near_first = g.place < 0.5;
    contact.initial_overlap = std::min(old.initial_overlap, std::max(g.depth, 0.0));
    contact.overlap = std::max(g.depth - contact.initial_overlap, 0.0);
    const double past = old.initial_overlap - g.depth;
    const bool ends = (past > 0) & (old.overlap > 0);  // no branch: contacts are moved side by side
    contact.release_correction = ends ? 0.5 * old.overlap * past / (ends ? old.overlap + past : 1.0) : 0.0;
    const double pressure = law.normal_stiffness * contact.overlap;
    const double trial = old.elastic_slip + sliding;
    const double bears =
        wears ? worn_limit(law, pressure, worn, std::abs(trial) * law.shear_stiffness) : friction_limit(law, pressure);
    const double limit = (contact.overlap > 0 ? bears : 0.0) / law.shear_stiffness;
    contact.elastic_slip = std::clamp(trial, -limit, limit);
    r.slip = trial - contact.elastic_slip;
    r.friction = 0.5 * contact.area * law.shear_stiffness * (old.elastic_slip + contact.elastic_slip) * r.slip;
    r.forces = node_edge_forces(law, contact, g);
    return r;
}

/// Sliding of a node along an edge in a step, m, from the displacements of the step in the frame that turns with the edge.
GRAINCRACK_INLINE double sliding_along(const PairGeometry& g, const Vector2& node, const Vector2& first, const Vector2& second) {
    const Vector2 turn = second - first;
    const Vector2 relative = node - first - g.place * turn;
    return dot(relative, g.tangent) - g.depth * g.inv_length * dot(turn, g.normal);
}

}  // namespace graincrack
