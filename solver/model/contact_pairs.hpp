// Which nodes may touch which edges: a list kept between searches, and what each pair of it remembers.
//
// Where grains are still bonded nothing is searched. A contact point is loose when it has lost its cohesion, or failed and moved;
// an edge is exposed when it is a free face, or a point of its contact or of the one before or after it on the grain is loose:
// another grain may have come in at the corner. A node is exposed when an edge of it is. A contact without cohesion goes on as a
// contact with its original partner (compression and friction) until it has moved by `hand_over` of its length; then it is
// released: its tractions pass to touches, and from there on its nodes and edges are met like all others.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "solver/model/assemblage.hpp"
#include "solver/law/contact_law.hpp"
#include "solver/detection/node_edge_contact.hpp"

namespace graincrack {

/// Where touches begin and how they pass on; see touch_review.cpp and share/doc/touches.md.
namespace touch_rule {
inline constexpr double slack = 1e-3;        // of an edge, beyond its ends: a touch stays on it so far, or passes on to the next
inline constexpr double corner_zone = 5e-3;  // of an edge, at its ends: no touch begins there, where the corners of several
                                             // grains meet and would hold each other
inline constexpr double deep = 6e-3;         // of the mean edge: a node as far in a grain as that is kept out even so
}  // namespace touch_rule

struct State;
struct StepParameters;

/// A node and an edge of another grain that are near each other.
struct TouchPair {
    std::int32_t node;
    std::int32_t edge;  ///< of the outline
    // NOLINTNEXTLINE(modernize-use-nullptr): it is none
    friend auto operator<=>(const TouchPair&, const TouchPair&) = default;
};

/// Forces on a node that come from moving touches, found by node.
struct TouchGather {
    std::int32_t node;
    Range slots;  ///< into `TouchList::gathered_slots`
};

/// Touches side by side: all that most steps work on. What becomes of them is decided at reviews only.
struct MovingTouches {
    std::vector<std::int32_t> pair;                                       ///< in the list
    std::vector<std::array<std::int32_t, 3>> nodes;                       ///< the node, first and second of the edge
    std::vector<double> live;                                             ///< 1; 0 from the step in which it ended
    std::vector<double> area, allowance, pressing, stretch, pull, place;  ///< of `Touch`, `TouchGeometry`
    std::vector<Vector2> forces;                                          ///< [3] on the nodes, N
    std::vector<std::int32_t> count;    ///< by block; those of a block lie from its first awake pair on
    std::vector<std::uint8_t> changed;  ///< by block: the last review found others than were there before
};

struct TouchList {
    std::vector<std::uint8_t> loose;     ///< [2 c] 1 once the point does not hold its nodes side by side any more
    std::vector<std::uint8_t> released;  ///< [c] 1 once it is no contact any more
    std::vector<TouchPair> pairs;        ///< ascending
    std::vector<Touch> touches;       ///< [pairs] with their forces as of the last review or batch: `moving` is what steps change
    std::vector<Vector2> forces;      ///< [3 pairs] on node, first and second node of the edge, N
    std::vector<Range> groups;        ///< pairs of one node
    std::vector<std::int32_t> awake;  ///< pairs that matter before the next look, ascending; the others have no forces
    std::vector<Range> awake_groups;  ///< of them, of one node each
    std::vector<Range> blocks;        ///< of `awake_groups`, that one thread works on at a time
    std::int64_t review_interval = 1;  ///< steps, or parts of them, from one review to the next
    MovingTouches moving;
    std::vector<double> friction;                 ///< [blocks] dissipated since the last look, J
    double friction_before = 0;                   ///< and before it, J
    std::vector<TouchGather> gathers;             ///< ascending by node
    std::vector<std::int32_t> gathered_slots;     ///< into `MovingTouches::forces`
    std::vector<Range> gathers_of_block;          ///< by block of grains
    std::vector<std::int32_t> gather_scratch;     ///< [n]
    std::vector<Vector2> displacement_at_search;  ///< [n] m
    bool wants_search = false;                    ///< something came loose or moved far since the last search
    double way_unsearched = 0;                    ///< that the fastest node has gone since then at most, m
    std::vector<double> taken;                    ///< [n] area of a node that touches take, at the last look, m²
    std::int64_t next_check = 0;                  ///< step

    [[nodiscard]] std::int32_t first_awake(std::int32_t block) const { return awake_groups[blocks[block].begin].begin; }
    /// Calls `visit` with the place of each moving touch.
    template <class Visit>
    void for_moving(Visit&& visit) const {
        for (std::int32_t block = 0; block < static_cast<std::int32_t>(blocks.size()); ++block) {
            const std::int32_t begin = first_awake(block);
            for (std::int32_t i = begin; i < begin + moving.count[block]; ++i) {
                visit(i);
            }
        }
    }
    /// Adds a pair of the list to the moving ones of its block.
    void append_moving(const Outline& outline, std::int32_t block, std::int32_t index);
};

/// Whether a node behind an edge is by more than `margin` (m) in front of the face on the other side of a convex corner of the
/// edge, or nearer to that face: it has come through that one, or is held there by a contact. Nothing comes through an edge that
/// is bonded to another grain.
bool came_through_neighbour(const Assemblage& assemblage, const State& state, const TouchPair& pair,
                            const TouchGeometry& geometry, double margin);

/// All pairs of an exposed node and an exposed edge of another grain it is not tied to, nearer than `margin` (m); ascending.
std::vector<TouchPair> find_pairs(const Assemblage& assemblage, double margin, const State& state);

/// An empty list; pre-existing cracks are found by the first search.
TouchList make_touch_list(const Assemblage& assemblage);

/// Looks after the list between two steps: finds contacts that lost their cohesion, releases those that moved far, searches
/// anew where that or the way the nodes have gone since the last search asks for it, and says when to look again
/// (`next_check`). With mass scaling there are no touches: it changes nothing but the list and returns true when one begins, or a
/// contact is to be released, and is to be called again with masses as they are. Serial; what it does depends on the state only.
/// \param shortest steps there are to the next look at least
bool look_after_touches(const Assemblage& assemblage, const StepParameters& parameters, std::int64_t shortest, State& state);

/// Moves the touches of a block to the present displacements: their forces, friction into the sums.
void move_touches(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t block, State& state);

/// Does so too, and decides before it which touches end or pass on to another edge, and after it which begin.
void review_touches(const Assemblage& assemblage, const StepParameters& parameters, std::int32_t block, State& state);

/// Writes what the moving touches of a block have become into the list.
void settle_touches(std::int32_t block, TouchList& list);

/// Makes the touches of the list that go on into moving ones, after a look or where a run goes on from a saved state.
void take_up_touches(const Assemblage& assemblage, TouchList& list);

/// Finds by node where the forces of the moving touches are; to be called where a review has changed them.
void arrange_gathers(const Assemblage& assemblage, TouchList& list);

/// Stored in all touches, J.
double stored_in_touches(const ContactLaw& law, const TouchList& list);

}  // namespace graincrack
