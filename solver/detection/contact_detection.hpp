// Contact detection: which node–edge contacts begin, are transferred to another edge, and end.
#pragma once

#include <cstdint>

#include "solver/detection/node_edge_contact.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/contact_pairs.hpp"
#include "solver/model/state.hpp"
#include "solver/model/step_parameters.hpp"

namespace graincrack {

/// The places at which contacts begin and are transferred, as far as the choice of watched pairs has to know it; see
/// share/doc/laws.md.
namespace detection_rule {
/// How far beyond the ends of its edge a contact stays on it, in lengths of the edge, so that a node at a joint does not go to
/// and fro between two edges. Longer, and the forces act farther beside the edge.
inline constexpr double end_tolerance = 1e-3;
/// Zone at either end of an edge in which no contact begins, in lengths of the edge: there the corners of several grains meet and
/// would lock. With half of it, grains lock and a uniaxial specimen hardens; wider, and corners come deeper into grains.
inline constexpr double corner_zone = 5e-3;
/// Depth in a grain, in mean edge lengths, beyond which a node is kept out wherever it is, so that corners do not overlap without
/// limit. More than the corner zone: with less, corners would lock in that zone after all.
inline constexpr double deep_node_depth = 6e-3;
}  // namespace detection_rule

/// True if the contact of a node belongs to a neighbouring face and not to the edge of the pair: around a convex corner, the node
/// is nearer to that face or in front of it, by more than `margin` (m). A face bonded to a third grain counts only while the node
/// is in front of it or less than the width of a bond (0.3 % of a mean edge) behind it.
bool belongs_to_neighbour(const Assemblage& assemblage, const State& state, const CandidatePair& pair,
                          const PairGeometry& geometry, double margin);

/// Moves the contacts of a chunk as `move_active_contacts` does; decides before which of them end or are transferred to another
/// edge, and afterwards which begin. They have no area, and so no stiffness, until `find_areas_of_new_contacts`.
void detect_contacts(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t chunk, State& state);

/// Once all chunks are done, on all ranks if pairs are watched anywhere: gives each contact that has just begun its area, in the
/// order of the pairs, whatever the number of threads and ranks. This is the tributary area of its node, or less where that would
/// exceed what is available at the node or at the nearer end of the edge: half of the two outline edges there, less what bonds
/// and other node–edge contacts occupy, so that no corners are stiffer together than bonds were. A contact that is transferred
/// keeps its area.
void find_areas_of_new_contacts(const Assemblage& assemblage, const StepParameters& parameters, State& state);

}  // namespace graincrack
