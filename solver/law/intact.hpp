// The law for intact points that stay on their branch, without a jump in the code, for vector units: one formula for all laws.
#pragma once

#include <cmath>

#include "solver/exponential.hpp"

namespace graincrack {

/// Constants of the intact law. \see make_intact_law
struct IntactLaw {
    double kt, ks, open_ks;          ///< normal stiffness; shear stiffness closed and open
    double open_normal, open_shear;  ///< weights of δn², δs² in the squared load of the open branch
    double closed_shear;             ///< weight of δs² in that of the closed branch
    double follows_open;             ///< 0 if open points need `update_contact` (they book mismatch or damage), else 1
    double follows_closed;           ///< likewise
};
struct IntactTraction {
    double normal, shear;  ///< Pa
    double load;           ///< δeff/δct, λ or |δs|/δcs: 1 at the peak
};
/// What `update_contact` gives while the point stays on its branch and `load` ≤ 1.
inline IntactTraction intact_traction(const IntactLaw& law, double opening, double sliding) {
    const bool open = opening >= 0;
    const double squared =
        (open ? law.open_normal : 0.0) * opening * opening + (open ? law.open_shear : law.closed_shear) * sliding * sliding;
    const double load = std::sqrt(squared);
    const double decay = exp_of_minus(load);
    return {law.kt * (open ? decay : 1.0) * opening, (open ? law.open_ks : law.ks) * decay * sliding, load};
}

}  // namespace graincrack
