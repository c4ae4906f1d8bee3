// Which node–edge contacts begin, pass on to another edge, and end.
#pragma once

#include <cstdint>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Where contacts begin and how they pass on to other edges; see contact_detection.cpp and share/doc/touches.md.
namespace detection_rule {
inline constexpr double slack = 1e-3;  // of an edge, beyond its ends: a contact stays on it so far, or is transferred to the next
inline constexpr double corner_zone = 5e-3;  // of an edge, at its ends: no contact begins there, where the corners of several
                                             // grains meet and would lock
inline constexpr double deep = 6e-3;         // of the mean edge: a node as far in a grain as that is kept out even so
}  // namespace detection_rule

/// Whether a node behind an edge is by more than `margin` (m) in front of the face on the other side of a convex corner of the
/// edge, or nearer to that face: it has come through that one, or is held there by a contact. Nothing comes through an edge that
/// is bonded to another grain.
bool came_through_neighbour(const Assemblage& assemblage, const State& state, const CandidatePair& pair,
                            const PairGeometry& geometry, double margin);

/// Moves the contacts of a chunk as `move_active_contacts` does; decides before it which of them end or are transferred to
/// another edge, and after it which begin.
void detect_contacts(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t chunk, State& state);

}  // namespace graincrack
