#include "solver/model/part.hpp"

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

/// The chunks of a kind that are own or have a node of this rank; their other nodes become ghosts.
/// \param items_of (chunk) a range \param nodes_of (item) those of an element, contact or loaded edge
template <class ItemsOf, class NodesOf>
EvaluatedChunks find_evaluated(const ChunkShare& share, const ItemsOf& items_of, const NodesOf& nodes_of, Part& part) {
    EvaluatedChunks evaluated;
    for (std::int32_t chunk = 0; chunk < share.count; ++chunk) {
        bool has_own = share.owner_of(chunk) == part.ranks->rank();
        std::vector<std::int32_t> ghosts;
        for (std::int32_t item = items_of(chunk).begin; item < items_of(chunk).end; ++item) {
            for (const std::int32_t node : nodes_of(item)) {
                has_own = has_own || part.owns(node);
                if (!part.owns(node)) ghosts.push_back(node);
            }
        }
        if (!has_own) continue;
        (ghosts.empty() ? evaluated.inner : evaluated.outer).push_back(chunk);
        part.ghosts.insert(part.ghosts.end(), ghosts.begin(), ghosts.end());
    }
    return evaluated;
}

/// Mean index of the nodes of a chunk of contacts.
double mean_node(const Assemblage& a, std::int32_t chunk) {
    const Range contacts = a.contact_chunks[chunk].contacts;
    double sum = 0;
    for (std::int32_t c = contacts.begin; c < contacts.end; ++c) sum += a.contacts[c].nodes[0] + a.contacts[c].nodes[2];
    return sum / (2 * contacts.size());
}

/// Sorts the chunks of contacts, which lie class by class, like the nodes.
void order_like_nodes(const Assemblage& a, EvaluatedChunks& contacts) {
    std::vector<double> place;
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(a.contact_chunks.size()); ++k) place.push_back(mean_node(a, k));
    for (auto* const chunks : {&contacts.inner, &contacts.outer}) {
        std::stable_sort(chunks->begin(), chunks->end(), [&](std::int32_t k, std::int32_t l) { return place[k] < place[l]; });
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
    order_like_nodes(a, part.evaluated_contacts);
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
    for (int rank = 0; rank < n_ranks; ++rank) {  // one without nodes begins where the next one does
        const auto& owner = part.nodes.owner;
        const auto sum = static_cast<std::int32_t>(std::lower_bound(owner.begin(), owner.end(), rank) - owner.begin());
        if (sum == part.nodes.n_sums()) break;
        part.first_node[rank] = a.node_chunks[part.nodes.chunks_of_sum(sum).begin].nodes.begin;
    }
    share_like_nodes(
        part, [&](std::int32_t chunk) { return a.element_nodes[a.element_chunks[chunk].begin][0]; }, part.elements);
    share_like_nodes(
        part, [&](std::int32_t chunk) { return a.contacts[a.contact_chunks[chunk].contacts.begin].nodes[0]; }, part.contacts);
    for (ChunkShare* share : {&part.nodes, &part.elements, &part.contacts}) find_own(ranks, *share);
    part.evaluated_elements = find_evaluated(
        part.elements, [&](std::int32_t chunk) { return a.element_chunks[chunk]; },
        [&](std::int32_t e) { return a.element_nodes[e]; }, part);
    part.evaluated_contacts = find_evaluated(
        part.contacts, [&](std::int32_t chunk) { return a.contact_chunks[chunk].contacts; },
        [&](std::int32_t c) { return a.contacts[c].nodes; }, part);
    order_like_nodes(a, part.evaluated_contacts);
    part.evaluates_contacts.assign(part.contacts.count, 0);
    for_each_evaluated(part.evaluated_contacts, [&](std::int32_t chunk) { part.evaluates_contacts[chunk] = 1; });
    const EvaluatedChunks loaded = find_evaluated(
        part.nodes, [&](std::int32_t chunk) { return prescribed.edges.empty() ? Range{} : prescribed.edges_of_chunk[chunk]; },
        [&](std::int32_t i) { return prescribed.edges[i].nodes; }, part);
    part.loaded_chunks = loaded.inner;
    part.loaded_chunks.insert(part.loaded_chunks.end(), loaded.outer.begin(), loaded.outer.end());
    std::sort(part.ghosts.begin(), part.ghosts.end());
    part.ghosts.erase(std::unique(part.ghosts.begin(), part.ghosts.end()), part.ghosts.end());
    return part;
}

}  // namespace graincrack
