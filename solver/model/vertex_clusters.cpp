#include "solver/model/vertex_clusters.hpp"

#include <fmt/format.h>

#include "share/base/error.hpp"

namespace graincrack {

MassScaling make_mass_scaling(const Assemblage& a, double factor) {
    MassScaling m;
    m.factor = factor;
    if (!m.is_on()) return m;
    for (const NodeChunk& chunk : a.node_chunks) {
        if (chunk.nodes.size() > nodes_per_chunk) {
            throw InputError(fmt::format("{} nodes meet at one vertex; mass scaling can take {}: use --mass-scaling none",
                                         chunk.nodes.size(), nodes_per_chunk));
        }
    }
    m.cluster_mass.resize(a.n_clusters());
    for (std::int32_t i = 0; i < a.n_nodes(); ++i) {
        m.cluster_mass[a.cluster_of_node[i]] += a.mass[i];
        m.mass.insert(m.mass.end(), 2, a.mass[i]);
        m.inverse_mass.insert(m.inverse_mass.end(), 2, a.inverse_mass[i]);
    }
    return m;
}

}  // namespace graincrack
