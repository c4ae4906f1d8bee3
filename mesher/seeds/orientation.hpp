// Measures the six-fold orientational order of edges: how closely a mesh, or a part of it, resembles a triangular lattice.
#pragma once

#include <span>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/stretch.hpp"
#include "mesher/plane/triangulation.hpp"
#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// Neighbours of each point in a compressed list (CSR): those of point i are items[start[i]] … items[start[i + 1] − 1].
struct Neighbours {
    std::vector<int> start;
    std::vector<int> items;
};
Neighbours neighbours_of(std::span<const Edge> edges, std::size_t n_points);

/// e^(6iθ) of a direction, as a point of the complex plane; (0, 0) for a zero vector.
Point six_fold(Point direction);

/// ⟨e^(6iθ)⟩| over the edges: 0 without a preferred direction, 1 for a lattice.
double psi6(std::span<const Point> points, std::span<const Edge> edges);

/// Partitions of a region into eight equal parts: of a disc by circles and radii, of other regions by a grid over their extent.
enum class Partition {
    blocks,  ///< grid: 2 × 4 blocks, 4 along the longer side; disc: octants
    turned,  ///< grid: 4 × 2 blocks; disc: octants turned by 22.5°
    bands,   ///< grid: 8 bands across the longer side; disc: quadrants cut into halves of equal area by a circle
};

/// Returns the largest |⟨e^(6iθ)⟩| among eight equal parts of a region. An edge belongs to the part of its midpoint. Grid parts
/// with less than half of the average number of edges, which the region does not fill, do not count.
/// \param stretch elongation of grains; directions are those in the plane where they are equiaxed
double largest_psi6_of_parts(const Region& region, Partition partition, std::span<const Point> points,
                             std::span<const Edge> edges, const Stretch& stretch = {});

/// ⟨e^(6iθ)⟩ around each point, averaged over its edges and smoothed over neighbours `n_smoothings` times.
std::vector<Point> local_orientation(std::span<const Point> points, const Neighbours& neighbours, int n_smoothings);

}  // namespace graincrack::mesher
