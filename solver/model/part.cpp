#include "solver/model/part.hpp"

#include <array>
#include <numeric>

#include "solver/model/assemblage.hpp"
#include "solver/model/prescribed.hpp"

namespace graincrack {
namespace {

/// Most sums of a kind: what ranks tell each other for a row of the history does not grow beyond it.
constexpr std::int32_t most_sums = 4096;

ChunkShare make_share(std::size_t count) {
    ChunkShare share;
    share.count = static_cast<std::int32_t>(count);
    share.chunks_per_sum = 1 + (share.count - 1) / most_sums;
    share.owner.assign(share.n_sums(), 0);
    return share;
}

void find_own(const Ranks& ranks, ChunkShare& share) {
    const int rank = ranks.rank();
    share.n_sums_of.assign(ranks.size(), 0);
    for (const std::int32_t owner : share.owner) ++share.n_sums_of[owner];
    share.own_sums.clear();
    share.own.clear();
    for (std::int32_t sum = 0; sum < share.n_sums(); ++sum) {
        if (share.owner[sum] != rank) continue;
        share.own_sums.push_back(sum);
        const Range range = share.chunks_of_sum(sum);
        for (std::int32_t chunk = range.begin; chunk < range.end; ++chunk) share.own.push_back(chunk);
    }
}

/// Work on each chunk of nodes with its elements and contacts, in evaluations of a node.
std::vector<double> find_work(const Assemblage& a) {
    constexpr double of_element_node = 0.5;
    constexpr double of_contact_node = 2;
    std::vector<double> of_node(a.position.size(), 1.0);
    for (const auto& nodes : a.element_nodes) {
        for (const std::int32_t node : nodes) of_node[node] += of_element_node;
    }
    for_each_contact(a, [&](std::int32_t c, std::int32_t /*contact_class*/) {
        for (const std::int32_t node : a.contacts[c].nodes) of_node[node] += of_contact_node;
    });
    std::vector<double> work;
    for (const auto& chunk : a.node_chunks) work.push_back(sum_over(chunk.nodes, [&](std::int32_t i) { return of_node[i]; }));
    return work;
}

/// Gives each rank sums of nodes that follow each other, with equal work.
void share_nodes(const std::vector<double>& work, int n_ranks, ChunkShare& nodes) {
    const double total = std::accumulate(work.begin(), work.end(), 0.0);
    double before = 0;
    for (std::int32_t sum = 0; sum < nodes.n_sums(); ++sum) {
        const Range range = nodes.chunks_of_sum(sum);
        const double of_sum = std::accumulate(work.begin() + range.begin, work.begin() + range.end, 0.0);
        const double middle = before + 0.5 * of_sum;
        nodes.owner[sum] = std::min(static_cast<int>(middle / total * n_ranks), n_ranks - 1);
        before += of_sum;
    }
}

/// Gives the sums of elements or contacts to the owners of their first nodes. \param node_of (chunk): its first node
template <class NodeOf>
void share_like_nodes(const Part& part, const NodeOf& node_of, ChunkShare& share) {
    for (std::int32_t sum = 0; sum < share.n_sums(); ++sum) {
        share.owner[sum] = part.owner_of_node(node_of(share.chunks_of_sum(sum).begin));
    }
}

/// \param visit_nodes (chunk, act) calls `act` with each node of a chunk
template <class VisitNodes>
EvaluatedChunks find_evaluated(const Part& part, const ChunkShare& share, const VisitNodes& visit_nodes,
                               std::vector<std::int32_t>& ghosts) {
    EvaluatedChunks evaluated;
    for (std::int32_t chunk = 0; chunk < share.count; ++chunk) {
        bool has_own = share.owner_of(chunk) == part.ranks->rank();
        bool has_ghost = false;
        visit_nodes(chunk, [&](std::int32_t node) { (part.owns(node) ? has_own : has_ghost) = true; });
        if (!has_own) continue;
        (has_ghost ? evaluated.outer : evaluated.inner).push_back(chunk);
        if (has_ghost) {
            visit_nodes(chunk, [&](std::int32_t node) {
                if (!part.owns(node)) ghosts.push_back(node);
            });
        }
    }
    return evaluated;
}

/// The chunks of nodes with loaded edges that have an own node; of edges without ghosts, those of all own chunks.
void find_loaded(const PrescribedConditions& prescribed, Part& part) {
    part.loaded_chunks = part.nodes.own;
    for (std::int32_t chunk = 0; chunk < part.nodes.count && !prescribed.edges.empty(); ++chunk) {
        const Range edges = prescribed.edges_of_chunk[chunk];
        bool has_own = part.nodes.owner_of(chunk) == part.ranks->rank();
        for (std::int32_t i = edges.begin; i < edges.end; ++i) has_own = has_own || part.owns(prescribed.edges[i].nodes[1]);
        if (!has_own) continue;
        if (part.nodes.owner_of(chunk) != part.ranks->rank()) part.loaded_chunks.push_back(chunk);
        for (std::int32_t i = edges.begin; i < edges.end; ++i) {
            for (const std::int32_t node : prescribed.edges[i].nodes) {
                if (!part.owns(node)) part.ghosts.push_back(node);
            }
        }
    }
}

}  // namespace

Part whole_part(const Assemblage& a) {
    Part part;
    part.nodes = make_share(a.node_chunks.size());
    part.elements = make_share(a.element_chunks.size());
    part.contacts = make_share(a.contact_chunks.size());
    for (ChunkShare* share : {&part.nodes, &part.elements, &part.contacts}) find_own(Ranks::alone(), *share);
    part.first_node = {0, a.n_nodes()};
    part.evaluated_elements.inner = part.elements.own;
    part.evaluated_contacts.inner = part.contacts.own;
    part.evaluates_contacts.assign(part.contacts.count, 1);
    part.loaded_chunks = part.nodes.own;
    return part;
}

Part make_part(const Assemblage& a, const PrescribedConditions& prescribed, const Ranks& ranks) {
    Part part = whole_part(a);
    if (ranks.is_alone()) return part;
    part.ranks = &ranks;
    const int n_ranks = ranks.size();
    share_nodes(find_work(a), n_ranks, part.nodes);
    part.first_node.assign(n_ranks + 1, a.n_nodes());
    part.first_node[0] = 0;
    for (std::int32_t sum = part.nodes.n_sums() - 1; sum >= 0; --sum) {
        const std::int32_t first = a.node_chunks[part.nodes.chunks_of_sum(sum).begin].nodes.begin;
        // Ranks without nodes begin where the next one does.
        const int before = sum == 0 ? -1 : part.nodes.owner[sum - 1];
        for (int rank = before + 1; rank <= part.nodes.owner[sum]; ++rank) part.first_node[rank] = sum == 0 ? 0 : first;
    }
    share_like_nodes(
        part, [&](std::int32_t chunk) { return a.element_nodes[a.element_chunks[chunk].begin][0]; }, part.elements);
    share_like_nodes(
        part, [&](std::int32_t chunk) { return a.contacts[a.contact_chunks[chunk].contacts.begin].nodes[0]; }, part.contacts);
    for (ChunkShare* share : {&part.nodes, &part.elements, &part.contacts}) find_own(ranks, *share);
    part.evaluated_elements = find_evaluated(
        part, part.elements,
        [&](std::int32_t chunk, const auto& act) {
            const Range elements = a.element_chunks[chunk];
            for (std::int32_t e = elements.begin; e < elements.end; ++e) {
                for (const std::int32_t node : a.element_nodes[e]) act(node);
            }
        },
        part.ghosts);
    part.evaluated_contacts = find_evaluated(
        part, part.contacts,
        [&](std::int32_t chunk, const auto& act) {
            const Range contacts = a.contact_chunks[chunk].contacts;
            for (std::int32_t c = contacts.begin; c < contacts.end; ++c) {
                for (const std::int32_t node : a.contacts[c].nodes) act(node);
            }
        },
        part.ghosts);
    part.evaluates_contacts.assign(part.contacts.count, 0);
    for_each_evaluated(part.evaluated_contacts, [&](std::int32_t chunk) { part.evaluates_contacts[chunk] = 1; });
    find_loaded(prescribed, part);
    std::sort(part.ghosts.begin(), part.ghosts.end());
    part.ghosts.erase(std::unique(part.ghosts.begin(), part.ghosts.end()), part.ghosts.end());
    return part;
}

}  // namespace graincrack
