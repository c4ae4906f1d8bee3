// What a run measures at an instant: energies, forces of the platens, strains. Sums are made by chunk and totalled in the order
// of chunks.
#pragma once

#include <vector>

#include "share/file/run_file.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// A strain as a linear function of displacements: Σ weight · component, by least squares over the nodes of a region.
struct Gauge {
    struct Term {
        std::int32_t node;
        double weight;  ///< 1/m
    };
    bool along_y = false;
    std::vector<Term> terms;      ///< ascending by node
    std::vector<Range> of_chunk;  ///< by chunk of nodes: its terms
    [[nodiscard]] double strain(const std::vector<Vector2>& displacement) const;
};

/// The four strain measures of the history.
struct Gauges {
    Gauge axial;     ///< slope of u_y over y in the central half
    Gauge lateral;   ///< slope of u_x over x in the central half
    Gauge widening;  ///< mean u_x of the right boundary less that of the left, over the width
};
/// The central half: |y| ≤ height/4, and |x| ≤ width/4 where the specimen is a disc. The boundary gauge takes parts left
/// and right, of a disc the rim within 15° of the x axis.
Gauges make_gauges(const Assemblage& assemblage, const Specimen& specimen);

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
};

struct Measurement {
    Energies energies;
    double force_bottom = 0;  ///< axial force on the specimen, tension positive, N
    double force_top = 0;
    double platen_power = 0;      ///< of both platens on the specimen, W
    double membrane_force = 0;    ///< lateral force of pressures on edges, mean of both sides, N
    double own_kinetic = 0;       ///< kinetic energy of the masses as they are, J
    double unbalanced_ratio = 0;  ///< Σ|unbalanced force| / Σ|element force| over nodes
};

/// Measures the state at its time: potential energies of the present displacements, kinetic energy ½ m v(n−½)·v(n+½)
/// (conserved by the scheme together with a quadratic potential), and the work of dampers, platens and loads up to now.
/// `state.force` is used as scratch.
Measurement measure(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, State& state);

/// Stored in contacts and in node–edge contacts, J.
double stored_in_contacts(const Assemblage& assemblage, const ContactLaws& laws, const State& state);

/// The state as a frame of the run file, in the specimen's own order.
Frame make_frame(const Assemblage& assemblage, const ContactLaws& laws, const State& state);

}  // namespace graincrack
