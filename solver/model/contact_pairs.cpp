#include "solver/model/contact_pairs.hpp"

namespace graincrack {

ContactPairList make_contact_pair_list(const Assemblage& a) {
    ContactPairList list;
    list.debonded.assign(2 * a.contacts.size(), 0);
    list.released.assign(a.contacts.size(), 0);
    list.node_forces_of_chunk.assign(a.node_chunks.size(), Range{});
    list.friction.assign(a.node_chunks.size(), 0.0);
    return list;
}

void group_pairs(ContactPairList& list) {
    list.groups.clear();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(list.pairs.size()); ++i) {
        if (i == 0 || list.pairs[i].node != list.pairs[i - 1].node) list.groups.push_back({i, i});
        ++list.groups.back().end;
    }
}

void group_watched(const Assemblage& a, ContactPairList& list) {
    list.watched_groups.clear();
    list.chunks.clear();
    list.node_chunks.clear();
    std::int32_t node_before = -1;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(list.watched.size()); ++i) {
        const std::int32_t node = list.pairs[list.watched[i]].node;
        if (node != node_before) {
            const auto group = static_cast<std::int32_t>(list.watched_groups.size());
            if (list.chunks.empty() || node >= a.node_chunks[list.node_chunks.back()].nodes.end) {
                list.chunks.push_back({group, group});
                list.node_chunks.push_back(chunk_of_node(a, node));
            }
            list.watched_groups.push_back({i, i});
            ++list.chunks.back().end;
        }
        ++list.watched_groups.back().end;
        node_before = node;
    }
}

}  // namespace graincrack
