// How stiff node–edge contacts may be in a step with mass scaling.
//
// A node–edge contact with the stiffness kt A resists the motion Σ a_C v_C of the vertex clusters C of its three nodes, where a_C
// sums the shares 1, −(1 − s) and −s of the node and the ends of the edge that are in C. (Its resistance to motions within a
// cluster is that of the bonds it replaces: contact_detection.cpp limits the areas of a node to those of its bonds.) For all
// contacts i together and any motion v of clusters
//
//   Σ_i kt_i A_i (Σ_C a_iC v_C)² ≤ Σ_C v_C² L_C,   L_C = Σ_i kt_i A_i |a_iC| Σ_D |a_iD|
//
// by the Cauchy–Schwarz inequality. The load L_C of each cluster is kept below η M_C/Δt², M_C its mass, so that node–edge
// contacts add at most η to ω² Δt², which the fraction of the stable step keeps below 2 (4 is the limit without damping). A
// contact beside the vertex it came from has small a_C and keeps all of its area; one that has slid to another vertex becomes
// softer.
//
// If the load is too large, areas are reduced at the next update of the pair list, to c A. Overlap and elastic slip grow by
// 1/√c, so that the stored energy ½ A (kt e² + ks q²) stays as it is; forces fall by √c, and the limit of friction with them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Finds the load of each cluster and reduces the areas of contacts where it is too large. At an update of the pair list. Without
/// mass scaling it does nothing.
void limit_contact_areas(const Assemblage& assemblage, const StepParameters& parameters, State& state);

/// A node–edge contact that has begun and has no area yet.
struct NewContact {
    std::int32_t active;  ///< its place among the active contacts
    CandidatePair pair;
    std::array<std::int32_t, 2> occupied;  ///< the nodes whose area it occupies
    double area;                           ///< m²
};

/// Reduces the areas of new contacts to what those that were there at the last update, or began since, leave of the load of each
/// cluster, in equal shares; adds their loads. Without mass scaling it does nothing.
void limit_new_areas(const Assemblage& assemblage, const StepParameters& parameters, std::vector<NewContact>& contacts,
                     State& state);

}  // namespace graincrack
