// The first and the last response of every contact law, without branches, so that vector units can work on many points at once:
// that of a point that has not failed, which each law gives, and that of a point on which nothing but friction is left, which is
// the same for all laws. In most steps nearly all points are of one of these two kinds.
#pragma once

#include <algorithm>

#include "solver/law/friction.hpp"

namespace graincrack {

/// A point before and after a motion, and what its response depends on of its history before.
struct MovedPoint {
    double old_opening, old_sliding;  ///< m
    double opening, sliding;          ///< m
    double integrity;                 ///< β; 1 if the law has no damage before the peak
    double slip = 0;                  ///< m
    double largest_open = 0;          ///< as in `ContactHistory`
    double largest_slid = 0;
    double bridge = 0;
};
/// The response of `update_contact` to an intact point, where `holds`.
struct IntactResponse {
    double normal, shear;  ///< Pa
    double holds;          ///< 1 if the point stays intact and this is all that happens to it; 0 if it needs `update_contact`
    double integrity = 1;
    double fracture = 0;  ///< dissipated by damage before the peak, J/m²
};

/// The same of a point past its peak with cohesion left.
struct SofteningResponse {
    double normal, shear;  ///< Pa
    double integrity;
    double slip;                ///< m
    double fracture;            ///< dissipated, J/m²
    double friction;            ///< dissipated, J/m²
    double holds;               ///< 1 if it stays open or stays closed, passes no further peak and cohesion is left, else 0
    double remaining_cohesion;  ///< fraction of the peak that its cohesion can bear, 0 to 1
    double largest_open = 0;
    double largest_slid = 0;
    double bridge = 0;
};

/// The same of a residual point, one of which `is_residual` of its law says that no cohesion is left.
struct ResidualResponse {
    double normal, shear;  ///< Pa
    double slip;           ///< m
    double friction;       ///< dissipated, J/m²
    double holds;          ///< 1 if the point stays open or stays closed, else 0
};
/// Compression and friction with the residual cohesion and friction angle while closed, nothing while open.
inline ResidualResponse residual_response(const ContactLaw& law, const MovedPoint& p) {
    const bool closed = p.opening < 0;
    const double compression = std::min(p.opening, 0.0);
    const contact_law::FrictionReturn friction = contact_law::friction_return(
        law.ks, p.old_sliding, p.sliding, p.slip, contact_law::residual_limit(law, -law.kt * compression));
    return {law.kt * compression, closed ? friction.shear : 0.0, closed ? friction.slip : p.slip,
            closed ? friction.dissipated : 0.0, (p.opening >= 0) == (p.old_opening >= 0) ? 1.0 : 0.0};
}

namespace contact_law {

/// 1 if the point stays open or stays closed, else 0.
inline double stays_on_its_side(const MovedPoint& p) { return (p.opening >= 0) == (p.old_opening >= 0) ? 1.0 : 0.0; }

inline MovedPoint moved_point(const ContactHistory& h, const ContactMotion& to) {
    return {h.motion.opening, h.motion.sliding, to.opening,     to.sliding, h.integrity,
            h.slip,           h.largest_open,   h.largest_slid, h.bridge};
}

/// Moves a point that is intact on the side it is on, if the intact response holds. \return whether it does
template <class Law>
bool advance_intact(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    const IntactResponse intact = Law::intact(law, moved_point(r.history, to));
    if (intact.holds == 0) return false;
    r.traction = {intact.normal, intact.shear};
    r.dissipation.fracture += intact.fracture;
    r.history.integrity = intact.integrity;
    r.history.motion = to;
    return true;
}

/// The softening response of a law that has one, with its bridge if there is one.
template <class Law>
SofteningResponse softening_response(const ContactLaw& law, const MovedPoint& p) {
    if constexpr (requires { Law::bridged_softening(law, p); }) {
        if (law.bridge > 0) return Law::bridged_softening(law, p);
    }
    return Law::softening(law, p);
}
/// Moves a point past its peak by the softening response, whether that holds or not. \return the cohesion that is left
template <class Law>
double advance_softening(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    const SofteningResponse now = softening_response<Law>(law, moved_point(r.history, to));
    r.traction = {now.normal, now.shear};
    r.dissipation.fracture += now.fracture;
    r.dissipation.friction += now.friction;
    r.history.integrity = now.integrity;
    r.history.slip = now.slip;
    r.history.largest_open = now.largest_open;
    r.history.largest_slid = now.largest_slid;
    r.history.bridge = now.bridge;
    r.history.motion = to;
    return now.remaining_cohesion;
}

/// Moves a point on which nothing but friction is left; one that is open has separated.
inline void advance_residual(const ContactLaw& law, const ContactMotion& to, ContactResponse& r) {
    const ResidualResponse residual = residual_response(law, moved_point(r.history, to));
    r.traction = {residual.normal, residual.shear};
    r.dissipation.friction += residual.friction;
    r.history.slip = residual.slip;
    r.history.separated = r.history.separated || to.opening >= 0;
    r.history.motion = to;
}

}  // namespace contact_law
}  // namespace graincrack
