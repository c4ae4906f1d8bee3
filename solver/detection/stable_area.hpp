// Limits the stiffness of node–edge contacts in a step with mass scaling (share/doc/laws.md).
//
// A contact with the stiffness kt A resists the motion Σ a_C v_C of the vertex clusters C of its three nodes, where a_C sums the
// fractions 1, −(1 − s) and −s of its nodes in C. By the Cauchy–Schwarz inequality, for all contacts i and any motion v of
// clusters
//
//   Σ_i kt_i A_i (Σ_C a_iC v_C)² ≤ Σ_C v_C² L_C,   L_C = Σ_i kt_i A_i |a_iC| Σ_D |a_iD|
//
// The load L_C is kept below η M_C/Δt², where M_C is the mass of the cluster, so that contacts add at most η to ω² Δt². Where it
// is larger, the next update of the pair list reduces areas to c A and increases overlap and elastic slip by 1/√c, which
// conserves the stored energy.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Finds the load of each cluster, and reduces the areas of contacts if it is too large. It is called at an update of the pair
/// list and does nothing without mass scaling.
void limit_contact_areas(const Assemblage& assemblage, const StepParameters& parameters, State& state);

/// A new node–edge contact without an area.
struct NewContact {
    std::int32_t pair;                     ///< index in the list
    std::array<std::int32_t, 2> occupied;  ///< the nodes whose area it occupies
    double area;                           ///< m²
};

/// Reduces the areas of new contacts, in equal fractions, to the load of each cluster that is left by the contacts of the last
/// update and those that began since, and adds their loads. Without mass scaling it does nothing.
void limit_new_areas(const Assemblage& assemblage, const StepParameters& parameters, std::vector<NewContact>& contacts,
                     State& state);

}  // namespace graincrack
