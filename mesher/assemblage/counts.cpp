#include "mesher/assemblage/counts.hpp"

namespace graincrack::mesher {

AssemblageCounts assemblage_counts(std::int64_t n_grains, std::int64_t n_boundary, int elements_per_edge) {
    const std::int64_t n = elements_per_edge;
    return {n_grains, n_grains * (n + 1) * (n + 2) / 2, n_grains * n * n, (3 * n_grains - n_boundary) / 2 * n, n_boundary * n};
}

std::int64_t uncompressed_size(const AssemblageCounts& counts) {
    const std::int64_t per_node = 16 + 24;                       // position, VTKHDF point
    const std::int64_t per_element = 3 * 4 + 4 + 3 * 8 + 8 + 1;  // nodes, grain, connectivity, offset, type
    const std::int64_t per_grain = 1 + 8;                        // phase, area
    const std::int64_t per_contact = 4 * 4 + 4 + 1;              // nodes, grain boundary, kind
    const std::int64_t per_boundary_edge = 2 * 4 + 1;            // nodes, part
    return counts.nodes * per_node + counts.elements * per_element + counts.grains * per_grain + counts.contacts * per_contact +
           counts.boundary_edges * per_boundary_edge;
}

}  // namespace graincrack::mesher
