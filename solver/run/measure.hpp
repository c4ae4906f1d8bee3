// The measures of a run at an instant: energies, forces of the platens, strains. Sums are made by chunk and totalled in the order
// of chunks.
#pragma once

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// All terms of the energy balance, J per metre of thickness; each from its own definition.
struct Energies {
    double external = 0, kinetic = 0, strain = 0, contact = 0, fracture_tension = 0, fracture_shear = 0, friction = 0,
           damping = 0, platen = 0, non_conservative_work = 0;
    double numerical = 0;  ///< lost by mass scaling where vertex clusters meet or leave platens
    /// external − all the others
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
    double platen_power = 0;      ///< of both platens on the specimen, W
    double confining_force = 0;   ///< along x of pressures on the boundary parts left and right, mean of the two, N
    double own_kinetic = 0;       ///< kinetic energy of the masses as they are, J
    double element_force = 0;     ///< Σ|element force| over nodes, N
    double unbalanced_ratio = 0;  ///< Σ|unbalanced force| / Σ|element force| over nodes
    using IsSum = void;
};

/// Measures the state at its time: potential energies of the present displacements, kinetic energy ½ m v(n−½)·v(n+½)
/// (conserved by the scheme together with a quadratic potential), and the work of dampers, platens and loads up to now.
/// `state.force` is used as scratch.
Measurement measure(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, ThreadTeam& team,
                    State& state);

}  // namespace graincrack
