// Contact detection: which node–edge contacts begin, are transferred to another edge, and end.
#pragma once

#include <cstdint>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// Where contacts begin and when they are transferred; see share/doc/node-edge-contacts.md.
namespace detection_rule {
inline constexpr double slack = 1e-3;        // of an edge: a contact stays on it up to so far beyond its ends
inline constexpr double corner_zone = 5e-3;  // of an edge, at its ends: no contact begins there, where the corners of several
                                             // grains meet and would lock
inline constexpr double deep = 6e-3;         // of the mean edge: a node so far inside a grain is kept out even there
}  // namespace detection_rule

/// Whether a node behind an edge came into the grain through the face on the other side of a convex corner: it is nearer to that
/// face, or in front of it, by more than `margin` (m). No node comes through an edge that is bonded to another grain.
bool came_through_neighbour(const Assemblage& assemblage, const State& state, const CandidatePair& pair,
                            const PairGeometry& geometry, double margin);

/// Moves the contacts of a chunk as `move_active_contacts` does; decides before which of them end or are transferred to another
/// edge, and afterwards which begin.
void detect_contacts(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t chunk, State& state);

}  // namespace graincrack
