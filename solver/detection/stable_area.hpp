// How stiff node–edge contacts may be in a step with mass scaling.
//
// A node–edge contact with the stiffness kt A resists the motion Σ a_C v_C of the vertex clusters C of its three nodes, where a_C
// sums the shares 1, −(1 − s) and −s of the node and the ends of the edge that are in C. (Its resistance to motions within a
// cluster is that of the bonds it replaces: contact_detection.cpp limits the areas of a node to those of its bonds.) For all
// contacts i together and any motion v of clusters
//
//   Σ_i kt A_i (Σ_C a_iC v_C)² ≤ Σ_C v_C² kt L_C,   L_C = Σ_i A_i |a_iC| Σ_D |a_iD|
//
// by the Cauchy–Schwarz inequality. The load L_C of each cluster is kept below η M_C/(kt Δt²), M_C its mass, so that node–edge
// contacts add at most η to ω² Δt², which the fraction of the stable step keeps below 2 (4 is the limit without damping). A
// contact beside the vertex it came from has small a_C and keeps all of its area; one that has slid to another vertex becomes
// softer.
//
// Where the load is too large, areas are reduced at the next update of the pair list, to c A. Overlap and elastic slip grow by
// 1/√c, so that the stored energy ½ A (kt e² + ks q²) stays as it is; forces fall by √c, and the limit of friction with them.
#pragma once

#include <cstdint>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Finds the load of each cluster and reduces the areas of contacts where it is too large. At an update of the pair list. Without
/// mass scaling it does nothing.
void limit_contact_areas(const Assemblage& assemblage, const StepParameters& parameters, State& state);

/// Area of a new contact, at most `wanted` (m²), beside those that were there at the last update or began since; its load is
/// added to those of its clusters. Without mass scaling it is `wanted`.
double take_stable_area(const Assemblage& assemblage, const StepParameters& parameters, const CandidatePair& pair, double wanted,
                        State& state);

}  // namespace graincrack
