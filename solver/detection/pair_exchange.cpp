#include "solver/detection/pair_exchange.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "share/base/error.hpp"
#include "solver/detection/pair_geometry.hpp"

namespace graincrack {
namespace {

/// Longest edge that a search counts on, over the longest one in the reference: far more than rock stretches.
constexpr double most_stretch = 1.5;

/// Calls `act` with the nodes of an edge and of those before and after it on its grain.
template <class Act>
void for_each_node_near(const GrainSurface& surface, std::int32_t edge, const Act& act) {
    for (const std::int32_t e : {edge, surface.edges[edge].previous, surface.edges[edge].next}) {
        if (e < 0) continue;
        for (const std::int32_t node : surface.edges[e].nodes) act(node);
    }
}

double longest_edge(const Assemblage& a) {
    double longest = 0;
    for (const SurfaceEdge& edge : a.surface.edges) {
        longest = std::max(longest, length(a.position[edge.nodes[1]] - a.position[edge.nodes[0]]));
    }
    return most_stretch * longest;
}

bool is_debonded(const ContactPairList& list, std::int32_t contact) {
    return contact >= 0 && (list.debonded[2 * static_cast<std::size_t>(contact)] != 0 ||
                            list.debonded[2 * static_cast<std::size_t>(contact) + 1] != 0);
}

bool is_exposed(const ContactPairList& list, const GrainSurface& surface, const SurfaceEdge& edge) {
    const auto has_debonded = [&](std::int32_t e) { return e >= 0 && is_debonded(list, surface.edges[e].contact); };
    return edge.contact < 0 || is_debonded(list, edge.contact) || has_debonded(edge.previous) || has_debonded(edge.next);
}

/// Calls `act` with the node and the range of each group of pairs of one node.
template <class Act>
void for_each_group(const std::vector<CandidatePair>& pairs, const Act& act) {
    for (std::int32_t begin = 0; begin < static_cast<std::int32_t>(pairs.size());) {
        std::int32_t end = begin;
        while (end < static_cast<std::int32_t>(pairs.size()) && pairs[end].node == pairs[begin].node) ++end;
        act(pairs[begin].node, Range{begin, end});
        begin = end;
    }
}

}  // namespace

std::vector<std::int32_t> find_exposed_edges(const Assemblage& a, const ContactPairList& list) {
    std::vector<std::int32_t> edges;
    for (std::int32_t e = 0; e < static_cast<std::int32_t>(a.surface.edges.size()); ++e) {
        if (is_exposed(list, a.surface, a.surface.edges[e])) edges.push_back(e);
    }
    return edges;
}

std::vector<std::uint8_t> exchange_exposed_nodes(const Assemblage& a, const std::vector<std::int32_t>& exposed_edges,
                                                 double margin, State& s) {
    if (a.part.is_alone()) return std::vector<std::uint8_t>(a.position.size(), 1);
    const Ranks& ranks = *a.part.ranks;
    const Range own = a.part.own_nodes();
    std::vector<std::uint8_t> is_listed(own.size(), 0);
    for (const std::int32_t edge : exposed_edges) {
        for_each_node_near(a.surface, edge, [&](std::int32_t node) {
            if (a.part.owns(node)) is_listed[node - own.begin] = 1;
        });
    }
    Rectangle region;
    std::vector<std::int32_t> listed;
    for (std::int32_t node = own.begin; node < own.end; ++node) {
        if (is_listed[node - own.begin] == 0) continue;
        listed.push_back(node);
        region.include(position_of(a, s, node));
    }
    // A pair may act on an own node over an edge; its node may have other pairs; these have edges beside them.
    const double reach = 2 * margin + 4 * longest_edge(a);
    struct Motion {
        std::int64_t node;
        Vector2 displacement;
    };
    const std::vector<std::vector<Rectangle>> regions = ranks.gather_all(std::vector<Rectangle>{region});
    std::vector<std::vector<Motion>> to(regions.size());
    for (const std::int32_t node : listed) {
        const Vector2 p = position_of(a, s, node);
        for (int rank = 0; rank < ranks.size(); ++rank) {
            const bool is_near = rank != ranks.rank() && regions[rank].front().contains(p, reach);
            if (is_near) to[rank].push_back({node, s.displacement[node]});
        }
    }
    std::vector<std::uint8_t> is_known(a.position.size(), 0);
    std::fill(is_known.begin() + own.begin, is_known.begin() + own.end, std::uint8_t{1});
    for (const std::vector<Motion>& of_rank : ranks.exchange(to)) {
        for (const Motion& motion : of_rank) {
            s.displacement[motion.node] = motion.displacement;
            is_known[motion.node] = 1;
        }
    }
    return is_known;
}

void keep_pairs_of_own_nodes(const Assemblage& a, std::vector<CandidatePair>& pairs) {
    if (a.part.is_alone()) return;
    std::vector<CandidatePair> kept;
    for_each_group(pairs, [&](std::int32_t node, Range group) {
        const bool acts_on_own =
            a.part.owns(node) ||
            std::any_of(pairs.begin() + group.begin, pairs.begin() + group.end, [&](const CandidatePair& pair) {
                const auto [first, second] = a.surface.edges[pair.edge].nodes;
                return a.part.owns(first) || a.part.owns(second);
            });
        if (acts_on_own) kept.insert(kept.end(), pairs.begin() + group.begin, pairs.begin() + group.end);
    });
    pairs = std::move(kept);
}

void find_ghosts(const Assemblage& a, State& s) {
    if (a.part.is_alone()) return;
    std::vector<std::int32_t> ghosts = a.part.ghosts;
    const auto add = [&](std::int32_t node) {
        if (!a.part.owns(node)) ghosts.push_back(node);
    };
    for (const CandidatePair& pair : s.contact_pairs.pairs) {
        add(pair.node);
        for_each_node_near(a.surface, pair.edge, add);
    }
    std::sort(ghosts.begin(), ghosts.end());
    ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
    s.ghosts.reset();  // its channels, before new ones are opened
    s.ghosts =
        std::make_shared<const GhostNodes>(*a.part.ranks, ghosts, [&a](std::int32_t node) { return a.part.owner_of_node(node); });
    send_motion(s);
    receive_motion(s);
}

void take_contacts_of_owners(const Assemblage& a, ContactPairList& list) {
    if (a.part.is_alone()) return;
    const Ranks& ranks = *a.part.ranks;
    struct Group {
        std::int32_t node, n_pairs;
    };
    std::vector<std::vector<Group>> requested(static_cast<std::size_t>(ranks.size()));
    for_each_group(list.pairs, [&](std::int32_t node, Range group) {
        if (!a.part.owns(node)) requested[a.part.owner_of_node(node)].push_back({node, group.size()});
    });
    struct Shared {
        CandidatePair pair;
        NodeEdgeContact contact;
    };
    std::vector<std::vector<Shared>> replies(requested.size());
    const std::vector<std::vector<Group>> asked = ranks.exchange(requested);
    for (std::size_t rank = 0; rank < asked.size(); ++rank) {
        for (const auto& [node, n_pairs] : asked[rank]) {
            const auto begin = std::lower_bound(list.pairs.begin(), list.pairs.end(), CandidatePair{node, 0});
            const auto end = std::lower_bound(begin, list.pairs.end(), CandidatePair{node + 1, 0});
            if (end - begin != n_pairs) {
                throw NumericalError(
                    fmt::format("rank {} has {} pairs of node {}, its owner {}: an edge is stretched too far; use "
                                "fewer ranks",
                                rank, n_pairs, node, end - begin));
            }
            for (auto pair = begin; pair != end; ++pair) {
                const NodeEdgeContact& contact = list.contacts[pair - list.pairs.begin()];
                if (contact.is_at_work()) replies[rank].push_back({*pair, contact});
            }
        }
    }
    for (std::size_t i = 0; i < list.pairs.size(); ++i) {
        if (!a.part.owns(list.pairs[i].node)) list.contacts[i] = NodeEdgeContact{};
    }
    for (const std::vector<Shared>& of_rank : ranks.exchange(replies)) {
        for (const Shared& shared : of_rank) {
            const auto at = std::lower_bound(list.pairs.begin(), list.pairs.end(), shared.pair);
            if (at == list.pairs.end() || *at != shared.pair) throw NumericalError("a rank lacks a pair that its owner has");
            list.contacts[at - list.pairs.begin()] = shared.contact;
        }
    }
}

}  // namespace graincrack
