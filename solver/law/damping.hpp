// Damping of a step (Cundall 1987; share/doc/loading.md): a fraction α of the unbalanced force, component by component.
//
//   local      Fd = −α |F| sign(v)                        against the motion
//   combined   Fd = ½ α |F| (sign(Ḟ) − sign(v))           half against the motion, half with the rate of the unbalanced force
//
// In an oscillation F falls while v > 0 and rises while v < 0: both forms take the same energy from it. In steady motion, sliding
// above all, v keeps its sign while F fluctuates: local damping holds load by α times the mean of |F|, and the halves of the
// combined form cancel in each half of a fluctuation where F rises against the motion's sign.
#pragma once

#include <cmath>
#include <cstdint>
#include <string_view>

#include "solver/arithmetic/vector2.hpp"

namespace graincrack {

/// --damping-form
enum class DampingForm : std::uint8_t { combined, local };
constexpr std::string_view name_of(DampingForm form) { return form == DampingForm::combined ? "combined" : "local"; }

/// Shares of the unbalanced force that are set against the motion and with the rate of the force.
struct Damping {
    double against_motion = 0;
    double with_rate = 0;
};
constexpr Damping make_damping(double alpha, DampingForm form) {
    return form == DampingForm::combined ? Damping{alpha / 2, alpha / 2} : Damping{alpha, 0};
}

/// One component of the damping force, N.
/// \param force unbalanced, N \param change of the force since the step before, N \param velocity m/s
inline double damping_force(const Damping& damping, double force, double change, double velocity) {
    const double against = velocity == 0 ? 0.0 : std::copysign(damping.against_motion, velocity);
    const double with = change == 0 ? 0.0 : std::copysign(damping.with_rate, change);
    return std::abs(force) * (with - against);
}
inline Vector2 damping_force(const Damping& damping, const Vector2& force, const Vector2& change, const Vector2& velocity) {
    return {damping_force(damping, force.x, change.x, velocity.x), damping_force(damping, force.y, change.y, velocity.y)};
}

}  // namespace graincrack
