#include "solver/restart/whole_state.hpp"

#include <algorithm>

#include "solver/detection/pair_exchange.hpp"
#include "solver/model/gather.hpp"

namespace graincrack {
namespace {

/// Histories of the points of a chunk of contacts.
struct ChunkHistories {
    std::int64_t chunk = 0;
    std::array<ContactHistory, 2UL * contacts_per_chunk> points;
};

void gather_histories(const Assemblage& a, PointHistories& histories) {
    std::vector<ChunkHistories> own;
    for (const std::int32_t chunk : a.part.contacts.own) {
        const Range contacts = a.contact_chunks[chunk].contacts;
        ChunkHistories of_chunk;
        of_chunk.chunk = chunk;
        bool any = false;
        for (std::int32_t k = 0; k < 2 * contacts.size(); ++k) {
            of_chunk.points[k] = histories[2UL * contacts.begin + k];
            any = any || of_chunk.points[k] != ContactHistory{};
        }
        if (any) own.push_back(of_chunk);
    }
    for (const std::vector<ChunkHistories>& of_rank : a.part.ranks->gather_first(own)) {
        for (const ChunkHistories& of_chunk : of_rank) {
            const Range contacts = a.contact_chunks[of_chunk.chunk].contacts;
            for (std::int32_t k = 0; k < 2 * contacts.size(); ++k) histories.of(2UL * contacts.begin + k) = of_chunk.points[k];
        }
    }
}

template <class Value>
std::vector<Value> slice(const std::vector<Value>& values, std::size_t begin, std::size_t end) {
    return {values.begin() + static_cast<std::ptrdiff_t>(begin), values.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// Indices of items from `begin` on, counted from there.
std::vector<std::int32_t> counted_from(std::size_t begin, std::vector<std::int32_t> indices) {
    for (std::int32_t& i : indices) i = i < 0 ? i : i - static_cast<std::int32_t>(begin);
    return indices;
}
/// Indices of each rank in lists of `sizes` that follow each other.
std::vector<std::int32_t> joined(const std::vector<std::vector<std::int32_t>>& indices, const std::vector<std::size_t>& sizes) {
    std::vector<std::int32_t> all;
    std::size_t begin = 0;
    for (std::size_t rank = 0; rank < indices.size(); ++rank) {
        for (const std::int32_t i : indices[rank]) all.push_back(i < 0 ? i : i + static_cast<std::int32_t>(begin));
        begin += sizes[rank];
    }
    return all;
}
template <class Value>
std::vector<Value> joined(const std::vector<std::vector<Value>>& values) {
    std::vector<Value> all;
    for (const std::vector<Value>& of_rank : values) all.insert(all.end(), of_rank.begin(), of_rank.end());
    return all;
}

/// Brings together the pairs of the nodes that each rank owns. They follow each other as the nodes do.
void gather_pairs(const Assemblage& a, ContactPairList& list) {
    const Ranks& ranks = *a.part.ranks;
    const auto is_before = [&](std::int32_t node, bool own_too) {
        const Range own = a.part.own_nodes();
        return node < (own_too ? own.end : own.begin);
    };
    const auto count = [&](bool own_too, const auto& items, const auto& node_of) {
        return static_cast<std::size_t>(
            std::count_if(items.begin(), items.end(), [&](const auto& item) { return is_before(node_of(item), own_too); }));
    };
    const auto node_of_pair = [](const CandidatePair& pair) { return pair.node; };
    const auto node_of_watched = [&](std::int32_t pair) { return list.pairs[pair].node; };
    const auto node_of_chunk = [&](std::int32_t chunk) { return a.node_chunks[chunk].nodes.begin; };
    const std::size_t pairs = count(false, list.pairs, node_of_pair);
    const std::size_t pairs_end = count(true, list.pairs, node_of_pair);
    const std::size_t watched = count(false, list.watched, node_of_watched);
    const std::size_t watched_end = count(true, list.watched, node_of_watched);
    const std::size_t chunks = count(false, list.node_chunks, node_of_chunk);
    const std::size_t chunks_end = count(true, list.node_chunks, node_of_chunk);
    const std::vector<std::vector<CandidatePair>> of_ranks = ranks.gather_first(slice(list.pairs, pairs, pairs_end));
    std::vector<std::size_t> sizes;
    for (const std::vector<CandidatePair>& of_rank : of_ranks) sizes.push_back(of_rank.size());
    list.contacts = joined(ranks.gather_first(slice(list.contacts, pairs, pairs_end)));
    list.forces = joined(ranks.gather_first(slice(list.forces, 3 * pairs, 3 * pairs_end)));
    const auto active = counted_from(pairs, slice(list.active.pair, watched, watched_end));
    list.watched = joined(ranks.gather_first(counted_from(pairs, slice(list.watched, watched, watched_end))), sizes);
    list.active.pair = joined(ranks.gather_first(active), sizes);
    list.active.count = joined(ranks.gather_first(slice(list.active.count, chunks, chunks_end)));
    list.pairs = joined(of_ranks);
}

std::vector<std::int32_t> owners_of_clusters(const Assemblage& a) {
    std::vector<std::int32_t> owner(a.n_clusters());
    for (std::int32_t chunk = 0; chunk < a.part.nodes.count; ++chunk) {
        const Range clusters = a.node_chunks[chunk].clusters;
        std::fill(owner.begin() + clusters.begin, owner.begin() + clusters.end, a.part.nodes.owner_of(chunk));
    }
    return owner;
}

/// Makes an array of the first rank that of the owners of its items.
struct GatherArray {
    const Assemblage& assemblage;
    template <class Value>
    void operator()(const char* name, ArrayOf of, std::vector<Value>& values) const {
        if (name == not_saved) return;
        const Part& part = assemblage.part;
        switch (of) {
            case ArrayOf::nodes:
            case ArrayOf::nodes_once_found:
                gather_items(
                    part, [&](std::int32_t node) { return part.owner_of_node(node); }, values);
                break;
            case ArrayOf::points: gather_chunks(part, part.contacts, 2UL * contacts_per_chunk, values); break;
            case ArrayOf::contact_slots: gather_chunks(part, part.contacts, slot_stride, values); break;
            case ArrayOf::node_chunks:
            case ArrayOf::node_chunks_once_found: gather_chunks(part, part.nodes, 1, values); break;
            case ArrayOf::contact_chunks: gather_chunks(part, part.contacts, 1, values); break;
            case ArrayOf::element_chunks: gather_chunks(part, part.elements, 1, values); break;
            case ArrayOf::clusters: {
                const std::vector<std::int32_t> owner = owners_of_clusters(assemblage);
                gather_items(
                    part, [&](std::int32_t i) { return owner[i]; }, values);
                break;
            }
            default: break;
        }
    }
    void operator()(const char* /*name*/, ArrayOf /*of*/, std::vector<PlatenPoint>& points) const {
        gather_items(
            assemblage.part, [&](std::int32_t i) { return assemblage.part.owner_of_node(points[i].node); }, points);
    }
    void operator()(const char* /*name*/, ArrayOf /*of*/, PointHistories& histories) const {
        gather_histories(assemblage, histories);
    }
};

State gather_state(const Assemblage& a, const State& state) {
    State s = state;
    s.ghosts.reset();
    visit_arrays(s, GatherArray{a});
    gather_pairs(a, s.contact_pairs);
    return s;
}

}  // namespace

WholeState::WholeState(const Assemblage& a, const State& state) : own_(state) {
    if (!a.part.is_alone()) gathered_ = gather_state(a, state);
}

void keep_own_pairs(const Assemblage& a, ContactPairList& list) {
    if (a.part.is_alone()) return;
    const ContactPairList all = list;
    keep_pairs_of_own_nodes(a, list.pairs);
    std::vector<std::int32_t> index(all.pairs.size(), -1);  // in the new list
    list.contacts.clear();
    list.forces.clear();
    for (std::size_t i = 0, kept = 0; i < all.pairs.size() && kept < list.pairs.size(); ++i) {
        if (all.pairs[i] != list.pairs[kept]) continue;
        index[i] = static_cast<std::int32_t>(kept++);
        list.contacts.push_back(all.contacts[i]);
        for (std::size_t k = 0; k < 3; ++k) list.forces.push_back(all.forces[3 * i + k]);
    }
    group_pairs(list);
    list.watched.clear();
    for (const std::int32_t pair : all.watched) {
        if (index[pair] >= 0) list.watched.push_back(index[pair]);
    }
    group_watched(a, list);
    list.active.pair.assign(list.watched.size(), -1);
    list.active.count.assign(list.chunks.size(), 0);
    for (std::size_t chunk = 0; chunk < all.chunks.size(); ++chunk) {
        const auto at = std::lower_bound(list.node_chunks.begin(), list.node_chunks.end(), all.node_chunks[chunk]);
        if (at == list.node_chunks.end() || *at != all.node_chunks[chunk]) continue;
        const auto kept = static_cast<std::int32_t>(at - list.node_chunks.begin());
        const std::int32_t first = all.first_watched(static_cast<std::int32_t>(chunk));
        for (std::int32_t i = first; i < first + all.active.count[chunk]; ++i) {
            const std::int32_t pair = index[all.active.pair[i]];
            if (pair >= 0) list.active.pair[list.first_watched(kept) + list.active.count[kept]++] = pair;
        }
    }
}

}  // namespace graincrack
