// A touch: a node of one grain against an edge of another, where no bond is left. Penalty and Coulomb friction, with an energy.
//
// With x the node, x0 → x1 the edge (solid on its left), t its direction, n its outward normal and s the place of the node along
// it, 0 to 1, the depth of the node behind the edge is d = −(x − x0)·n. The part of it that presses is e = d − allowance; the
// allowance is what the node was behind the edge when the touch began, so that a touch begins without a force however late it is
// found, and hands on to another edge without a jump. Per tributary area A of the node:
//
//   normal    kt A e on the node along n, stored ½ kt A e²
//   friction  τ = ks q within ±kt e tan φc, q the elastic part of the sliding of the node along the edge; stored ½ ks A q²
//
// A touch ends between two steps: the node is past the edge by o when it is found to be out, and the scheme has taken more from
// the spring than it held, ½ kt A e o; a grain that rattles would gain from every knock. So the step after the last one gives it
// back by a pull of ½ kt A e o/(e + o), whose work over the way of two steps, 2 (e + o), in the mean of the scheme is that.
//
// kt, ks, φc are those of a contact that failed (Kazerani & Zhao 2014, Eqs 10, 12), so a bonded contact that has lost its
// cohesion turns into touches of the same force and energy. The edge takes the opposite forces at its nodes in the shares 1 − s
// and s, and the couple d τ that the distance of node and edge makes: linear and angular momentum are exact.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/law/contact_law.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/simd.hpp"
#include "solver/vector2.hpp"

namespace graincrack {

/// Where a node stands to an edge.
struct TouchGeometry {
    Vector2 tangent;
    Vector2 normal;         ///< outward, t turned by −90°
    double inv_length = 0;  ///< of the edge, 1/m
    double place = 0;       ///< s along the edge, 0 to 1 over it
    double depth = 0;       ///< d behind the edge, m
};
/// \param edge from its first node to its second, m \param from_first to the node, m
GRAINCRACK_INLINE TouchGeometry touch_geometry(const Vector2& edge, const Vector2& from_first) {
    const double inv_length = 1 / length(edge);
    const Vector2 t = inv_length * edge;
    const Vector2 n{t.y, -t.x};
    return {t, n, inv_length, inv_length * dot(from_first, t), -dot(from_first, n)};
}
inline TouchGeometry touch_geometry(const Vector2& node, const Vector2& first, const Vector2& second) {
    return touch_geometry(second - first, node - first);
}

/// Forces of a touch.
struct TouchForces {
    Vector2 on_node, on_first, on_second;  ///< N
};
struct TouchResponse {
    Touch touch;
    TouchForces forces;
    double friction = 0;  ///< dissipated on the way here, J
};

/// Stored in the springs of a touch, J.
inline double touch_energy(const ContactLaw& law, const Touch& touch) {
    return 0.5 * touch.area * (law.kt * touch.pressing * touch.pressing + law.ks * touch.stretch * touch.stretch);
}

GRAINCRACK_INLINE TouchForces touch_forces(const ContactLaw& law, const Touch& touch, const TouchGeometry& g) {
    const double pressure = touch.area * law.kt * (touch.pressing - touch.pull);
    const double drag = touch.area * law.ks * touch.stretch;
    const Vector2 on_node = pressure * g.normal - drag * g.tangent;
    const Vector2 couple = (drag * g.depth * g.inv_length) * g.normal;
    return {on_node, -(1 - g.place) * on_node - couple, -g.place * on_node + couple};
}

/// Moves an active touch to a new place.
///
/// \param sliding of the node along the edge since the last update, in the edge's own frame, m
GRAINCRACK_INLINE TouchResponse move_touch(const ContactLaw& law, const Touch& old, const TouchGeometry& g, double sliding) {
    TouchResponse r{old, {}, 0};
    Touch& touch = r.touch;
    touch.near_first = g.place < 0.5;
    touch.allowance = std::min(old.allowance, std::max(g.depth, 0.0));
    touch.pressing = std::max(g.depth - touch.allowance, 0.0);
    const double past = old.allowance - g.depth;
    const bool ends = (past > 0) & (old.pressing > 0);  // no branch: touches are moved side by side
    touch.pull = ends ? 0.5 * old.pressing * past / (ends ? old.pressing + past : 1.0) : 0.0;
    const double limit = law.kt * touch.pressing * law.tan_phi / law.ks;
    const double trial = old.stretch + sliding;
    touch.stretch = std::clamp(trial, -limit, limit);
    r.friction = 0.5 * touch.area * law.ks * (old.stretch + touch.stretch) * (trial - touch.stretch);
    r.forces = touch_forces(law, touch, g);
    return r;
}

/// Sliding of a node along an edge over a step, from the displacements of the step; in the frame that turns with the edge.
GRAINCRACK_INLINE double sliding_along(const TouchGeometry& g, const Vector2& node, const Vector2& first, const Vector2& second) {
    const Vector2 turn = second - first;
    const Vector2 relative = node - first - g.place * turn;
    return dot(relative, g.tangent) - g.depth * g.inv_length * dot(turn, g.normal);
}

}  // namespace graincrack
