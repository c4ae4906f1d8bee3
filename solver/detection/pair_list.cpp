#include "solver/detection/pair_list.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/detection/pair_exchange.hpp"
#include "solver/detection/pair_geometry.hpp"
#include "solver/detection/pair_search.hpp"
#include "solver/detection/stable_area.hpp"

namespace graincrack {
namespace {

// Travels of contacts are over the contact's length, all other lengths over the mean edge of the grains. All numbers of this list
// were chosen by trial. When the first two were set, nodes of 1,122 grains came at most 0.64 % of an edge deep up to 5 %
// shortening; neither was varied since.

/// A contact without cohesion that has slid or opened by more is released to node–edge contacts.
constexpr double release_travel = 0.005;
/// A failed point that has slid or opened by more no longer links its nodes.
constexpr double debonding_travel = 0.001;
/// Pairs nearer than this are listed.
constexpr double buffer = 0.04;
/// One node in so many is faster than the 95th percentile of speed. Intervals follow this percentile, not the largest speed, so
/// that fast fragments do not shorten them.
constexpr std::size_t fastest_one_in = 20;
/// Leading bits of the squared speed that the histogram of speeds keeps: sign, exponent and three of the mantissa. The percentile
/// is then too high by 6 % at most. The bins reach from the speed of the fastest node down to 2⁻⁶⁴ of it.
constexpr int histogram_bits = 15;
constexpr std::int64_t histogram_bins = 1024;
/// After debonding a search waits until nodes at the 95th percentile of speed may have moved so far.
constexpr double rebuild_delay_distance = 1e-3;
/// Largest distances that nodes at the 95th percentile, and the fastest, move between two updates if steps are short enough.
constexpr double max_travel_p95 = 1e-3;
constexpr double max_travel_fastest = 1e-2;
/// A pair is watched if its distance is below the first factor times the travel of its node and edge up to the next update, plus
/// the second factor times the travel at the 95th percentile.
constexpr double safety_factor = 8;
constexpr double safety_factor_p95 = 2;
/// Fewest steps between two updates.
constexpr std::int64_t min_steps = 4;
constexpr std::int64_t detections_between_updates = 8;

/// True if a contact point has no cohesion and no bridge left.
template <class Law>
bool is_lost(const ContactLaw& law, const State& s, std::size_t point) {
    if (s.failed[point] == 0) return false;
    const ContactHistory history = point_history(s, point);
    return history.bridge == 0 && contact_law::damage<Law>(law, history) >= 1;
}

/// The contact points of this rank that have debonded since the last update.
template <class Law>
std::vector<std::int32_t> find_debonded(const Assemblage& a, const ContactLaws& laws, const State& s) {
    std::vector<std::int32_t> debonded_now;
    for_each_own_contact(a, [&](std::int32_t c, std::int32_t contact_class) {
        const ContactLaw& law = laws[contact_class];
        const double far = debonding_travel * 2 * a.contacts[c].point_area / a.contacts[c].strength;
        for (const std::size_t point : points_of(c)) {
            if (s.failed[point] == 0 || s.contact_pairs.debonded[point] != 0) continue;
            const bool has_moved = !law.softens_in_shear && std::max(s.opening[point], std::abs(s.sliding[point])) > far;
            if (has_moved || is_lost<Law>(law, s, point)) debonded_now.push_back(static_cast<std::int32_t>(point));
        }
    });
    return debonded_now;
}

/// The contacts of this rank without cohesion that have moved by more than `release_travel`.
template <class Law>
std::vector<std::int32_t> find_released(const Assemblage& a, const ContactLaws& laws, const State& s) {
    std::vector<std::int32_t> released_now;
    for_each_own_contact(a, [&](std::int32_t c, std::int32_t contact_class) {
        const auto [first, second] = points_of(c);
        if (s.contact_pairs.released[c] != 0 || s.contact_pairs.debonded[first] == 0 || s.contact_pairs.debonded[second] == 0) {
            return;
        }
        const ContactLaw& law = laws[contact_class];
        const double far = release_travel * 2 * a.contacts[c].point_area / a.contacts[c].strength;
        const double moved =
            std::max({std::abs(s.sliding[first]), std::abs(s.sliding[second]), s.opening[first], s.opening[second]});
        if (moved > far && is_lost<Law>(law, s, first) && is_lost<Law>(law, s, second)) released_now.push_back(c);
    });
    return released_now;
}

/// The node–edge contacts of the pairs that were listed before. A contact whose pair is no longer listed, as its node has moved
/// away, ends. Owners of nodes send the contacts of these nodes to other ranks afterwards.
std::vector<NodeEdgeContact> keep_contacts(const Assemblage& a, const ContactLaws& laws, const std::vector<CandidatePair>& pairs,
                                           ContactPairList& list) {
    std::vector<NodeEdgeContact> contacts(pairs.size());
    std::size_t at = 0;  // both lists are ascending
    for (std::size_t i = 0; i < list.pairs.size(); ++i) {
        while (at < pairs.size() && pairs[at] < list.pairs[i]) ++at;
        if (at < pairs.size() && pairs[at] == list.pairs[i]) {
            contacts[at] = list.contacts[i];
        } else if (list.contacts[i].active) {
            list.friction[chunk_of_node(a, list.pairs[i].node)] +=
                node_edge_energy(friction_law(a, laws, list.pairs[i]), list.contacts[i]);
        }
    }
    return contacts;
}

void search(const Assemblage& a, const ContactLaws& laws, State& s) {
    ContactPairList& list = s.contact_pairs;
    std::vector<CandidatePair> pairs = find_pairs(a, buffer * a.surface.mean_length, s);
    list.contacts = keep_contacts(a, laws, pairs, list);
    list.pairs = std::move(pairs);
    list.forces.assign(3 * list.pairs.size(), Vector2{});
    list.watched.clear();
    group_pairs(list);
    list.displacement_at_search = s.displacement;
}

/// Distance that a node has to move along an edge to lie over it but for `inset` (of its length) at its ends, m; at most 0 there.
double distance_along(const PairGeometry& g, double inset) {
    return std::max(inset - g.place, g.place - (1 - inset)) / g.inv_length;
}

/// Distance that a node has to move to a place at which a node–edge contact may begin, m; at most 0 if it is at one.
double travel_to_begin(const PairGeometry& g, double mean_length) {
    return std::min(std::max(-g.depth, distance_along(g, detection_rule::corner_zone)),
                    std::max(detection_rule::deep_node_depth * mean_length - g.depth, distance_along(g, 0)));
}

/// Chooses the pairs of a node that are watched until the next update.
class Watch {
public:
    /// \param duration to the next update, at most, s
    /// \param speed_p95 95th percentile of the speeds of all nodes, m/s
    Watch(const Assemblage& a, double duration, double speed_p95, const State& s)
        : assemblage_(a), state_(s), duration_(duration), speed_p95_(speed_p95) {
        speed_.reserve(s.velocity.size());
        for (const Vector2& v : s.velocity) speed_.push_back(length(v));
    }

    /// Appends to `watched` the pairs of a node that are in contact, or may come into contact or receive a transferred contact
    /// before the next update.
    void add_watched(Range pairs, std::vector<std::int32_t>& watched) {
        const ContactPairList& list = state_.contact_pairs;
        active_.clear();
        overlap_ = 0;
        for (std::int32_t p = pairs.begin; p < pairs.end; ++p) {
            if (list.contacts[p].active) {
                active_.push_back({list.pairs[p].edge, pair_geometry(assemblage_, state_, list.pairs[p]).depth});
                overlap_ = std::max(overlap_, list.contacts[p].overlap);
            }
        }
        for (std::int32_t p = pairs.begin; p < pairs.end; ++p) {
            if (list.contacts[p].is_at_work() || may_be_in_contact(p)) watched.push_back(p);
        }
    }

private:
    [[nodiscard]] const SurfaceEdge& edge_of(std::int32_t pair) const {
        return assemblage_.surface.edges[state_.contact_pairs.pairs[pair].edge];
    }
    [[nodiscard]] double reach(std::int32_t pair) const {
        const SurfaceEdge& edge = edge_of(pair);
        const double closing =
            speed_[state_.contact_pairs.pairs[pair].node] + std::max(speed_[edge.nodes[0]], speed_[edge.nodes[1]]);
        return duration_ * (safety_factor * closing + safety_factor_p95 * speed_p95_);
    }
    [[nodiscard]] bool may_be_in_contact(std::int32_t pair) const {
        const PairGeometry g = pair_geometry(assemblage_, state_, state_.contact_pairs.pairs[pair]);
        const double near = reach(pair);
        if (travel_to_begin(g, assemblage_.surface.mean_length) < near &&
            !belongs_to_neighbour(assemblage_, state_, state_.contact_pairs.pairs[pair], g, 2 * near)) {
            return true;
        }
        if (active_.empty()) return false;
        const double margin = near + detection_rule::end_tolerance / g.inv_length;
        return (g.depth < overlap_ + near && is_beside_active(pair)) ||
               (distance_along(g, 0) < margin && is_at_depth_of_active(g, margin));
    }
    /// True if the edge is the previous or next one of its grain to an edge that the node is in contact with.
    [[nodiscard]] bool is_beside_active(std::int32_t pair) const {
        const SurfaceEdge& edge = edge_of(pair);
        return std::any_of(active_.begin(), active_.end(),
                           [&edge](const Active& active) { return active.edge == edge.previous || active.edge == edge.next; });
    }
    /// True if the node is about as deep behind the edge as behind one that it is in contact with.
    [[nodiscard]] bool is_at_depth_of_active(const PairGeometry& g, double margin) const {
        return std::any_of(active_.begin(), active_.end(),
                           [&](const Active& active) { return std::abs(active.depth - g.depth) < margin; });
    }

    const Assemblage& assemblage_;
    const State& state_;
    double duration_, speed_p95_;
    struct Active {
        std::int32_t edge;
        double depth;  ///< m
    };
    std::vector<double> speed_;  ///< [n] m/s
    std::vector<Active> active_;
    double overlap_ = 0;  ///< largest of the contacts of the node, m
};

/// Chooses the pairs that the steps up to the next update evaluate, node by node. All other pairs have no force.
/// \param duration to the next update, at most, s
/// \param speed_p95 95th percentile of the speeds of all nodes, m/s
void watch_pairs(const Assemblage& a, const ContactLaws& laws, double duration, double speed_p95, State& s) {
    ContactPairList& list = s.contact_pairs;
    Watch watch(a, duration, speed_p95, s);
    list.watched.clear();
    for (const Range pairs : list.groups) watch.add_watched(pairs, list.watched);
    group_watched(a, list);
    load_active(a, laws, list);
    list.is_watched_anywhere = a.part.ranks->any(!list.watched.empty());
}

/// Computes the forces of all node–edge contacts at the present displacements; their states do not change.
void refresh_forces(const Assemblage& a, const ContactLaws& laws, State& s) {
    for (std::size_t i = 0; i < s.contact_pairs.pairs.size(); ++i) {
        if (s.contact_pairs.contacts[i].is_at_work()) {
            const PairGeometry g = pair_geometry(a, s, s.contact_pairs.pairs[i]);
            const FrictionLaw law = friction_law(a, laws, s.contact_pairs.pairs[i]);
            const NodeEdgeForces forces = node_edge_forces(law, s.contact_pairs.contacts[i], g);
            s.contact_pairs.forces[3 * i] = forces.on_node;
            s.contact_pairs.forces[3 * i + 1] = forces.on_first;
            s.contact_pairs.forces[3 * i + 2] = forces.on_second;
        }
    }
}

/// State of a contact point at its release, in terms of the node–edge contact that continues it.
struct ReleasedContact {
    std::int32_t contact, point;
    double overlap, elastic_slip;  ///< m
};

/// Releases contacts and removes their forces. \return the closed points of the contacts that this rank evaluates
template <class Law>
std::vector<ReleasedContact> release_contacts(const Assemblage& a, const ContactLaws& laws,
                                              const std::vector<std::int32_t>& released_now, State& s) {
    std::vector<ReleasedContact> carried;
    for (const std::int32_t c : released_now) {
        const ContactLaw& law = laws[a.contact_chunks[c / contacts_per_chunk].contact_class];
        const double strength = a.contacts[c].strength;
        s.contact_pairs.released[c] = 1;
        if (a.part.evaluates_contacts[c / contacts_per_chunk] == 0) continue;
        for (std::int32_t p = 0; p < 2; ++p) {
            const std::size_t point = 2 * static_cast<std::size_t>(c) + static_cast<std::size_t>(p);
            const ContactHistory h = point_history(s, point);
            if (h.motion.opening < 0) {
                const double shear = contact_law::update<Law>(law, h.motion, h).traction.shear;
                carried.push_back({c, p, -strength * h.motion.opening, strength * shear / law.ks});
            }
        }
        for (std::int32_t k = 0; k < 4; ++k) {
            const std::int32_t slot = slot_of(c, k);
            s.contact_force[slot] = s.contact_force[slot + contacts_per_chunk] = 0;
        }
    }
    return carried;
}

/// Gives each closed point of a released contact to exactly one pair. A rank that owns one of its two nodes has the pairs of
/// both, and does the same as the owner of the other.
void transfer_to_pairs(const Assemblage& a, const ContactLaws& laws, const std::vector<ReleasedContact>& carried, State& s) {
    ContactPairList& list = s.contact_pairs;
    for (const ReleasedContact& h : carried) {
        const ContactGeometry& contact = a.contacts[h.contact];
        if (!a.part.owns(contact.nodes[h.point]) && !a.part.owns(contact.nodes[2 + h.point])) continue;
        // Of the two nodes of the point, the one over the edge of the other grain is chosen; of both, the one farther from the
        // ends.
        std::ptrdiff_t best = -1;
        double inside = -std::numeric_limits<double>::max();
        double depth = 0, place = 0;
        for (std::int32_t side = 0; side < 2; ++side) {
            const CandidatePair pair{contact.nodes[2 * (1 - side) + h.point], 2 * a.specimen_contact[h.contact] + side};
            const auto it = std::lower_bound(list.pairs.begin(), list.pairs.end(), pair);
            if (it == list.pairs.end() || *it != pair) continue;
            const PairGeometry g = pair_geometry(a, s, *it);
            const double margin = std::min(g.place, 1 - g.place);
            if (margin > inside) {
                inside = margin;
                best = it - list.pairs.begin();
                depth = g.depth;
                place = g.place;
            }
        }
        const NodeEdgeContact taken{true, place < 0.5, contact.point_area, depth - h.overlap, h.overlap, h.elastic_slip, 0.0};
        if (best >= 0) {
            list.contacts[best] = taken;
        } else {  // the nodes have passed both edges, or are too deep, since the last search: the springs' energy is lost
            const CandidatePair pair{contact.nodes[h.point], 2 * a.specimen_contact[h.contact] + 1};
            list.friction[chunk_of_node(a, pair.node)] += node_edge_energy(friction_law(a, laws, pair), taken);
        }
    }
}

struct Speeds {
    double p95;      ///< speed that one node in `fastest_one_in` exceeds, m/s; the histogram makes it too high by 6 % at most
    double fastest;  ///< m/s
};
/// Speeds from a histogram, whose counts the ranks can add in any order. \param own velocities of this rank's nodes
/// \param fastest largest squared speed of all ranks \param n_nodes number of nodes of all ranks
Speeds speeds_of_all(std::span<const Vector2> own, const Ranks& ranks, double fastest, std::int32_t n_nodes) {
    constexpr int dropped_bits = 64 - histogram_bits;
    const auto bin_of = [](double squared) {
        return static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(squared) >> dropped_bits);
    };
    const std::int64_t top = bin_of(fastest);
    std::vector<std::int64_t> count(histogram_bins, 0);  // from the fastest down; the last bin has all slower nodes too
    for (const Vector2& v : own) ++count[std::clamp<std::int64_t>(top - bin_of(dot(v, v)), 0, histogram_bins - 1)];
    ranks.take_sums(count);
    std::int64_t faster = n_nodes / fastest_one_in;
    std::int64_t below_top = 0;
    while (below_top < std::min<std::int64_t>(top, histogram_bins - 1) && faster >= count[below_top]) {
        faster -= count[below_top++];
    }
    const auto end_of_bin = std::bit_cast<double>(static_cast<std::uint64_t>(top - below_top + 1) << dropped_bits);
    return {std::sqrt(std::min(end_of_bin, fastest)), std::sqrt(fastest)};
}

/// Upper bound of the steps to the next update. Fast nodes make it small, so that distant pairs need not be watched.
/// \param travel_p95, travel_fastest travel of nodes in a step, m
std::int64_t max_interval(double mean_length, double travel_p95, double travel_fastest) {
    const double steps = mean_length * std::min(max_travel_p95 / std::max(travel_p95, 1e-300),
                                                max_travel_fastest / std::max(travel_fastest, 1e-300));
    return std::clamp(static_cast<std::int64_t>(std::min(steps, 1e6)), min_steps, max_update_interval);
}

/// Largest distance of a node of this rank from its position at the last search, m; 0 before the first search.
double travel_since_search(const Assemblage& a, const State& s) {
    const std::vector<Vector2>& at_search = s.contact_pairs.displacement_at_search;
    if (at_search.empty()) return 0;
    double squared = 0;
    const Range own = a.part.own_nodes();
    for (std::int32_t i = own.begin; i < own.end; ++i) {
        const Vector2 travel = s.displacement[i] - at_search[i];
        squared = std::max(squared, dot(travel, travel));
    }
    return std::sqrt(squared);
}

/// Releases contacts and searches anew.
void rebuild(const Assemblage& a, const ContactLaws& laws, const std::vector<std::int32_t>& released_now, State& s) {
    const std::vector<ReleasedContact> carried = contact_law::with_law(
        laws.variant(), [&](auto kind) { return release_contacts<decltype(kind)>(a, laws, released_now, s); });
    search(a, laws, s);
    transfer_to_pairs(a, laws, carried, s);
    take_contacts_of_owners(a, s.contact_pairs);
    find_ghosts(a, s);
    refresh_forces(a, laws, s);
    s.contact_pairs.wants_rebuild = false;
    s.contact_pairs.travel_since_rebuild = 0;
}

}  // namespace

void update_pair_list(const Assemblage& a, const StepParameters& parameters, State& s) {
    ContactPairList& list = s.contact_pairs;
    const ContactLaws& laws = parameters.laws;
    const Ranks& ranks = *a.part.ranks;
    if (s.ghosts) {  // measuring changes velocities of vertex clusters that platens constrain
        send_motion(s);
        receive_motion(s);
    }
    std::vector<std::int32_t> debonded_now;
    std::vector<std::int32_t> released_now;
    contact_law::with_law(laws.variant(), [&](auto kind) {
        debonded_now = ranks.concatenate(find_debonded<decltype(kind)>(a, laws, s));
        for (const std::int32_t point : debonded_now) list.debonded[point] = 1;
        released_now = ranks.concatenate(find_released<decltype(kind)>(a, laws, s));
    });
    const bool is_first = list.displacement_at_search.empty();
    const Range own = a.part.own_nodes();
    const std::span<const Vector2> velocity = std::span(s.velocity).subspan(own.begin, own.size());
    std::array largest{0.0, travel_since_search(a, s)};
    for (const Vector2& v : velocity) largest[0] = std::max(largest[0], dot(v, v));
    ranks.take_largest(largest);
    const Speeds speeds = speeds_of_all(velocity, ranks, largest[0], a.n_nodes());
    double travel = largest[1];
    const double travel_fastest = speeds.fastest * parameters.time_step;
    const double travel_p95 = speeds.p95 * parameters.time_step;
    const std::int64_t longest = max_interval(a.surface.mean_length, travel_p95, travel_fastest);
    const double allowed = 0.5 * buffer * a.surface.mean_length;  // two nodes may move towards each other
    // After debonding a search may wait while no node has moved far.
    list.wants_rebuild = list.wants_rebuild || !debonded_now.empty() || !released_now.empty();
    list.travel_since_rebuild += list.wants_rebuild ? static_cast<double>(longest) * travel_p95 : 0.0;
    if (is_first || travel + static_cast<double>(longest) * travel_fastest > allowed ||
        list.travel_since_rebuild > rebuild_delay_distance * a.surface.mean_length) {
        rebuild(a, laws, released_now, s);
        travel = 0;
    }
    limit_contact_areas(a, parameters, s);
    list.detection_interval = std::max<std::int64_t>(longest / detections_between_updates, 1);
    watch_pairs(a, laws, static_cast<double>(longest) * parameters.time_step, speeds.p95, s);
    const double steps =
        travel_fastest > 0 ? 0.5 * (allowed - travel) / travel_fastest : static_cast<double>(max_update_interval);
    list.next_update = s.step + std::clamp(static_cast<std::int64_t>(std::min(steps, 1e6)), min_steps, longest);
}

}  // namespace graincrack
