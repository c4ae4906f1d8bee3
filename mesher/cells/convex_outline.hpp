// The outline of a convex region as a polygon.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesher/region/region.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// A convex polygon, counter-clockwise.
struct ConvexOutline {
    std::vector<Point> corners;
    std::vector<std::uint8_t> parts;  ///< of the boundary, of the side from each corner to the next
    double loading_arc = 0;           ///< as of `Seeds`

    [[nodiscard]] std::size_t size() const { return corners.size(); }
    [[nodiscard]] Point corner(std::size_t i) const { return corners[i < size() ? i : i - size()]; }
};

/// The outline of a plain region (`is_plain`): straight sides whole, round ones by the fixed points of meshes at a distance of
/// about `edge`, so that a circle keeps its area and the facets at its poles their places.
/// \param size over `edge`
/// \throws UsageError naming --tessellation if round sides do not make a convex polygon
ConvexOutline convex_outline(const Region& region, double edge, const SizeField& size = {});

/// Number of points that polygons have on the loops of a region, about `edge` times the local size apart, more on small round
/// ones.
double outline_count(const Region& region, double edge, const SizeField& size);

/// Area of a polygon, m², and its centroid.
struct PolygonMoments {
    double area = 0;
    Point centroid;
};
PolygonMoments moments(const std::vector<Point>& corners);

}  // namespace graincrack::mesher
