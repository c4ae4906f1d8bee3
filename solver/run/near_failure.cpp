#include "solver/run/near_failure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "share/base/union_find.hpp"
#include "solver/detection/node_edge_contact.hpp"
#include "solver/detection/pair_geometry.hpp"

namespace graincrack {
namespace {

// An intact point is near failure if it would fail at so many times its jumps. Chosen by trial (2 at first); no measurement kept.
constexpr double near_growth = 1.25;
// Up to this fraction of all points near failure is scattered. Fitted: 0.06 for 0.035, with contacts at their friction limit left
// out, changes no strength beyond its scatter and saves up to 37 % of the steps; with 0.07, and open softening contacts left out
// too, UCS is 0.4 ± 0.3 % higher (share/studies/equilibrium).
constexpr double scattered_fraction = 0.06;
// A chain of this fraction of the width involves the section. Chosen by trial; not varied since.
constexpr double involving_share = 0.5;

/// True if the friction of a point without cohesion lies between half its limit and the limit. At the limit the point bears all
/// that it can. Both bounds were chosen by trial; with them joints slide at 0.1 to 0.5 % above Jaeger's strength.
bool is_near_sliding(double shear, double limit) { return std::abs(shear) >= 0.5 * limit && std::abs(shear) < 0.999 * limit; }

/// Chains of vertex clusters that contacts near sliding join, each with its bounding rectangle.
class SlidingChains {
public:
    explicit SlidingChains(const Assemblage& a) : a_(a), sets_(static_cast<std::size_t>(a.n_clusters())) {}
    void join(std::int32_t node, std::int32_t other) {
        sets_.join(static_cast<std::size_t>(a_.cluster_of_node[node]), static_cast<std::size_t>(a_.cluster_of_node[other]));
        nodes_.insert(nodes_.end(), {node, other});
    }
    /// Length of the longest chain, m.
    [[nodiscard]] double longest() {
        std::vector<Rectangle> rectangles(static_cast<std::size_t>(a_.n_clusters()));
        double longest = 0;
        for (const std::int32_t node : nodes_) {
            Rectangle& r = rectangles[sets_.find(static_cast<std::size_t>(a_.cluster_of_node[node]))];
            r.include(a_.position[node]);
            longest = std::max(longest, length(r.high - r.low));
        }
        return longest;
    }

private:
    const Assemblage& a_;
    UnionFind sets_;
    std::vector<std::int32_t> nodes_;
};

using NodePairs = std::vector<std::array<std::int32_t, 2>>;

struct ChunkFailure {
    std::int64_t intact = 0;  // points that are near failure
    NodePairs joined;         // nodes of contacts that are near sliding
};

template <class Law>
ChunkFailure failure_of(const Assemblage& a, const ContactLaws& laws, std::int32_t index, const State& s) {
    const ContactChunk& chunk = a.contact_chunks[index];
    const ContactLaw& law = laws[chunk.contact_class];
    ChunkFailure found;
    for (std::int32_t c = chunk.contacts.begin; c < chunk.contacts.end; ++c) {
        bool slides = false;
        for (const std::size_t i : points_of(c)) {
            const double opening = s.opening[i];
            const double sliding = s.sliding[i];
            if (s.failed[i] == 0) {
                const MovedPoint grown{opening, sliding, near_growth * opening, near_growth * sliding, s.integrity[i]};
                found.intact += Law::intact(law, grown).holds == 0 ? 1 : 0;
                continue;
            }
            if (law.softens_in_shear && s.residual[i] == 0 && s.integrity[i] > 0) {
                slides = slides || opening >= 0;  // a crack grows; in shear, friction replaces the cohesion
            } else if (opening < 0 && s.contact_pairs.released[c] == 0) {
                const double limit = contact_law::residual_limit(law, -contact_law::joint_traction(law, opening));
                slides = slides || is_near_sliding(law.ks * (sliding - s.slip[i]), limit);
            }
        }
        if (slides) found.joined.push_back({a.contacts[c].nodes[0], a.contacts[c].nodes[1]});
    }
    return found;
}

}  // namespace

double near_failure(const Assemblage& a, const ContactLaws& laws, const State& s, double width, double friction,
                    ThreadTeam& team) {
    const std::vector<std::int32_t>& own = a.part.contacts.own;
    std::vector<ChunkFailure> found(own.size());
    contact_law::with_law(laws.variant(), [&](auto kind) {
        for_each_of_team(team, own.size(), [&](std::size_t i) { found[i] = failure_of<decltype(kind)>(a, laws, own[i], s); });
    });
    std::array<std::int64_t, 1> intact{};
    NodePairs joined;  // of this rank's own contacts
    for (const ChunkFailure& of_chunk : found) {
        intact.front() += of_chunk.intact;
        joined.insert(joined.end(), of_chunk.joined.begin(), of_chunk.joined.end());
    }
    const ContactPairList& list = s.contact_pairs;
    for (std::size_t i = 0; i < list.contacts.size(); ++i) {
        const NodeEdgeContact& contact = list.contacts[i];
        if (contact.active && contact.overlap > 0 && a.part.owns(list.pairs[i].node)) {
            const FrictionLaw law = friction_law(a, laws, list.pairs[i]);
            const double worn = s.worn.empty() ? 0 : s.worn[list.pairs[i].node];
            const double limit = friction_limit(law, law.normal_stiffness * contact.overlap, worn);
            if (is_near_sliding(law.shear_stiffness * contact.elastic_slip, limit)) {
                const auto& [first, second] = a.surface.edges[list.pairs[i].edge].nodes;
                joined.insert(joined.end(), {{list.pairs[i].node, first}, {list.pairs[i].node, second}});
            }
        }
    }
    a.part.ranks->take_sums(intact);
    SlidingChains chains(a);
    for (const auto& [node, other] : a.part.ranks->concatenate(joined)) chains.join(node, other);
    const double points = 2.0 * std::max(a.n_contacts(), 1);
    const double scattered = std::max(0.5 * std::sqrt(points), scattered_fraction * points);
    const double most = std::lerp(most_scattered, 1.0, std::min(1.0, friction / sliding_section));
    const double points_near_failure = std::min(most, static_cast<double>(intact.front()) / scattered);
    return std::min(1.0, std::max(points_near_failure, chains.longest() / (involving_share * width)));
}

}  // namespace graincrack
