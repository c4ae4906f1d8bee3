// The fraction of the load that damping carries: damping forces that oppose the mean motion of the specimen, as in sliding, take
// a part of the load of the platens, and a strength is too high by it.
//
//   fraction = ⟨−Σ Fd·v̄⟩ / ⟨Σ P·w⟩
//
// v̄ is the mean velocity of each node over some wave transits, P and w are forces and velocities of the platens, and ⟨⟩ is the
// mean over the same time. It is the power of damping on the mean motion over that of the platens, and by virtual work along this
// motion the fraction of the load that damping carries. Damping of waves, which are no part of the mean motion, does not count: a
// brittle specimen emits them at any rate.
//
// All means are exponential, with the time constant `mean_transits`: (u − ū)/τ is that of v if ū is that of u.
#pragma once

#include <vector>

#include "solver/arithmetic/vector2.hpp"

namespace graincrack {

struct DampingLoad {
    std::vector<Vector2> mean_displacement;  ///< [n] ū, m
    double damping_power = 0;                ///< ⟨−Σ Fd·v̄⟩, W
    double platen_power = 0;                 ///< ⟨Σ P·w⟩, W
    double time = 0;                         ///< of the last update, s
    /// The fraction of the load of the platens; 0 while they do no work: the mean of what they did dies out.
    [[nodiscard]] double fraction() const {
        constexpr double least = 1e-30;  // W
        return platen_power > least ? damping_power / platen_power : 0;
    }
};

struct Assemblage;
struct State;

/// Wave transits over which motion and power are averaged.
inline constexpr double mean_transits = 4;

/// Takes the means on to the time of the state, after `measure`, by `state.damping_force` and the present displacements.
/// \param platen_power of both platens now, W \param time_constant of the means, s
void follow_damping_load(const Assemblage& assemblage, const State& state, double platen_power, double time_constant,
                         DampingLoad& load);

}  // namespace graincrack
