// Contact detection decides which node–edge contacts begin, are transferred to another edge, and end.
//
// Invariant: each overlap is carried by exactly one contact. A bonded contact carries the overlap of its own nodes and edges
// until it is released, and `find_pairs` lists no pair of them before. At the release each closed point goes to exactly one pair
// (`update_pair_list`). A node begins a contact with a grain only if it has no other contact with this grain and, unless it lies
// deeper than `deep_node_depth`, none with the same surface of another grain; a transfer ends the contact on the edge that it
// leaves. Two exceptions: overlaps within the corner zones up to that depth are carried by none, and a transfer does not test
// whether the node has another contact with the grain that it goes to.
#pragma once

#include <cstdint>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// The places at which contacts begin and are transferred, as far as the choice of watched pairs depends on them; see
/// share/doc/laws.md. The three numbers were chosen by trial and not varied since.
namespace detection_rule {
/// Distance beyond the ends of its edge up to which a contact stays on it, in lengths of the edge, so that a node at a joint does
/// not alternate between two edges. With a larger one the forces act farther beside the edge.
inline constexpr double end_tolerance = 1e-3;
/// Zone at either end of an edge in which no contact begins, in lengths of the edge: the corners of several grains meet there and
/// would lock. With half of it grains lock and a uniaxial specimen hardens; with a wider zone corners move deeper into grains.
inline constexpr double corner_zone = 5e-3;
/// Depth in a grain, in mean edge lengths, beyond which a node begins a contact even in a corner zone, so that corners do not
/// overlap without limit. It exceeds the corner zone, as corners would lock in that zone otherwise.
inline constexpr double deep_node_depth = 6e-3;
}  // namespace detection_rule

/// True if the contact of a node belongs to a neighbouring face and not to the edge of the pair. This is so if, around a convex
/// corner, the node is nearer to that face or in front of it, by more than `margin` (m). A face bonded to a third grain counts
/// only while the node is in front of it or less than the width of a bond (0.3 % of a mean edge) behind it.
bool belongs_to_neighbour(const Assemblage& assemblage, const State& state, const CandidatePair& pair,
                          const PairGeometry& geometry, double margin);

/// Moves the contacts of a chunk of watched pairs as `move_active_contacts` does. Before the move it ends contacts and transfers
/// them to other edges; after it, contacts begin. New contacts have no area, and so no stiffness, until
/// `find_areas_of_new_contacts`. The cost of a node grows with the square of the number of its watched pairs.
void detect_contacts(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t chunk, State& state);

/// Gives each contact that has just begun its area (m², 1 m thick). All ranks call it once all chunks are done if pairs are
/// watched on any rank; the order of the pairs determines the result, not the number of threads or ranks. The area is the
/// tributary area of the node, or less if that exceeds the area available at the node or at the nearer end of the edge: half of
/// the two outline edges there, less what bonds and other node–edge contacts occupy. Corners are then no stiffer together than
/// bonds were. A transferred contact keeps its area.
void find_areas_of_new_contacts(const Assemblage& assemblage, const StepParameters& parameters, State& state);

}  // namespace graincrack
