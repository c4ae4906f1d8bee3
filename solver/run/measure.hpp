// Measures a run at one time: energies, forces of the platens and strains. Sums are formed by chunk and added in the order of
// chunks.
#pragma once

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// All terms of the energy balance, each from its own definition, J per metre of thickness.
struct Energies {
    double external = 0, kinetic = 0, strain = 0, contact = 0, fracture_tension = 0, fracture_shear = 0, friction = 0,
           damping = 0, platen = 0, non_conservative_work = 0;
    double numerical = 0;  ///< loss by mass scaling where vertex clusters meet or leave platens
    /// The external work less all other terms.
    [[nodiscard]] double balance_error() const {
        return external - (kinetic + strain + contact + fracture_tension + fracture_shear + friction + damping + platen +
                           non_conservative_work + numerical);
    }
    [[nodiscard]] double stored() const { return strain + contact; }
    using IsSum = void;
};

struct Measurement {
    Energies energies;
    double force_bottom = 0;  ///< axial force on the specimen, tension positive, N
    double force_top = 0;
    double platen_power = 0;      ///< power of both platens on the specimen, W
    double confining_force = 0;   ///< force of pressures along x, mean of the left and right boundary parts, N
    double own_kinetic = 0;       ///< kinetic energy of the unscaled masses, J
    double element_force = 0;     ///< Σ|element force| over nodes, N
    double unbalanced_ratio = 0;  ///< Σ|unbalanced force| / Σ|element force| over nodes
    using IsSum = void;
};

/// Measures a state: potential energies of its displacements, the kinetic energy ½ m v(n−½)·v(n+½), which the scheme conserves
/// together with a quadratic potential, and the work of dampers, platens and loads since the start. Uses `state.force` as
/// scratch.
Measurement measure(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, ThreadTeam& team,
                    State& state);

}  // namespace graincrack
