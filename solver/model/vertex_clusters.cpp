#include "solver/model/vertex_clusters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "share/error.hpp"

namespace graincrack {

/// Representative of `i` in a forest of parents, with the way there shortened.
std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

namespace {

constexpr std::int32_t groups_per_block = 32;

/// The lowest node that each node shares a vertex with.
std::vector<std::int32_t> vertex_of_nodes(const Assemblage& a) {
    std::vector<std::int32_t> parent(a.position.size());
    std::iota(parent.begin(), parent.end(), 0);
    for (const ContactGeometry& g : a.contacts) {
        for (std::size_t p = 0; p < 2; ++p) {
            const std::int32_t i = root_of(parent, g.nodes[p]);
            const std::int32_t j = root_of(parent, g.nodes[2 + p]);
            parent[std::max(i, j)] = std::min(i, j);
        }
    }
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        parent[i] = root_of(parent, i);
    }
    return parent;
}

/// Cuts a sequence sorted by group into one range a group.
template <class GroupOf>
std::vector<Range> ranges_of_groups(std::int32_t count, std::int32_t n_groups, GroupOf&& group_of) {
    std::vector<Range> ranges(n_groups);
    std::int32_t i = 0;
    for (std::int32_t g = 0; g < n_groups; ++g) {
        ranges[g].begin = i;
        while (i < count && group_of(i) == g) {
            ++i;
        }
        ranges[g].end = i;
    }
    return ranges;
}

/// Cuts groups into blocks.
void cut_blocks(MassScaling& m) {
    for (std::int32_t g = 0; g < static_cast<std::int32_t>(m.groups.size()); ++g) {
        if (m.groups[g].size() > members_per_block) {
            throw InputError(fmt::format("{} nodes meet at one vertex; mass scaling can take {}: use --mass-scaling none",
                                         m.groups[g].size(), members_per_block));
        }
        const bool fits = !m.blocks.empty() && m.blocks.back().size() < groups_per_block &&
                          m.groups[g].end - m.groups[m.blocks.back().begin].begin <= members_per_block;
        if (fits) {
            m.blocks.back().end = g + 1;
        } else {
            m.blocks.push_back({g, g + 1});
        }
    }
}

}  // namespace

MassScaling make_mass_scaling(const Assemblage& a, double factor) {
    MassScaling m;
    m.factor = factor;
    if (!m.is_on()) {
        return m;
    }
    const std::vector<std::int32_t> vertex = vertex_of_nodes(a);
    m.members.resize(a.position.size());
    std::iota(m.members.begin(), m.members.end(), 0);
    std::stable_sort(m.members.begin(), m.members.end(), [&](std::int32_t i, std::int32_t j) { return vertex[i] < vertex[j]; });
    std::vector<std::int32_t> member_of_node(a.position.size());
    std::vector<std::int32_t> group_of_node(a.position.size());
    std::int32_t n_groups = 0;
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        const std::int32_t node = m.members[i];
        n_groups += vertex[node] == node ? 1 : 0;  // the lowest node comes first
        member_of_node[node] = i;
        group_of_node[node] = n_groups - 1;
    }
    for (std::int32_t point = 0; point < 2 * a.n_contacts(); ++point) {
        const auto& nodes = a.contacts[point / 2].nodes;
        m.links.push_back({member_of_node[nodes[point % 2]], member_of_node[nodes[2 + point % 2]], point,
                           cluster_reach * 2 * a.contacts[point / 2].point_area});
    }
    const auto group_of_link = [&](const MassScaling::Link& tie) { return group_of_node[m.members[tie.first]]; };
    std::stable_sort(m.links.begin(), m.links.end(),
                     [&](const MassScaling::Link& l, const MassScaling::Link& r) { return group_of_link(l) < group_of_link(r); });
    m.groups = ranges_of_groups(a.n_nodes(), n_groups, [&](std::int32_t i) { return group_of_node[m.members[i]]; });
    m.links_of_group = ranges_of_groups(static_cast<std::int32_t>(m.links.size()), n_groups,
                                        [&](std::int32_t t) { return group_of_link(m.links[t]); });
    cut_blocks(m);
    for (const std::int32_t node : m.members) {
        m.mass.insert(m.mass.end(), 2, a.mass[node]);
        m.inverse_mass.insert(m.inverse_mass.end(), 2, a.inverse_mass[node]);
    }
    return m;
}

}  // namespace graincrack
