// Lines that polygonal cells must follow, and the zones that they divide the plane into.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "mesher/plane/stretch.hpp"
#include "mesher/seeds/seeds.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// The loops of a region as polygons, its prescribed edges, and a convex outline around both.
struct Walls {
    std::vector<Point> points;  ///< corners of loops; ends and meetings of prescribed edges
    std::vector<Side> sides;    ///< of loops, with the region on their left, then of prescribed edges from meeting to meeting
    ConvexOutline hull;         ///< the first loop if that is convex, else a box around it
    bool is_convex = true;      ///< whether the hull is the first loop
    double loading_arc = 0;     ///< as of `Seeds`

    /// Whether there are walls within the hull.
    [[nodiscard]] bool divide() const { return !is_convex || sides.size() > n_sides_of_outline(); }
    /// Whether a point is inside of the loops.
    [[nodiscard]] bool contains(Point p) const;
    /// The number of sides of the first loop, which come first.
    [[nodiscard]] std::size_t n_sides_of_outline() const;
    [[nodiscard]] Point at(int p) const { return points[index(p)]; }
};

/// Straight sides are whole, round ones have the fixed points of meshes at a distance of about `edge` times the local size, more
/// on small ones, so that a circle keeps its area and the facets at its poles their places. \param edge distance of points on
/// round sides, m \param stretch of elongated cells: walls are those of the plane in which they are equiaxed \param size over
/// `edge`, if that varies
Walls walls_of(const Region& region, double edge, const Stretch& stretch = {}, const SizeField& size = {});

/// Parts of the hull that walls separate from one another.
class Zones {
public:
    explicit Zones(const Walls& walls);

    [[nodiscard]] std::size_t size() const { return areas_.size(); }
    [[nodiscard]] double area(std::size_t zone) const { return areas_[zone]; }
    /// Integral of one over the square of the graded size: the cells of a zone are a share of all by it, m².
    [[nodiscard]] double graded_area(std::size_t zone, const SizeField& size) const;
    [[nodiscard]] bool is_inside(std::size_t zone) const { return is_inside_[zone] != 0; }
    [[nodiscard]] std::size_t zone_at(Point p) const;
    [[nodiscard]] Point random_point(std::size_t zone, RandomNumbers& random) const;
    /// A seed moved towards a place within its zone, and away from walls that are nearer than a distance.
    [[nodiscard]] Point moved(Point from, Point to, double distance) const;

private:
    struct Face {
        std::array<Point, 3> corners;
        std::size_t zone;
    };
    struct Segment {
        Point from, to;
        bool is_inner;  ///< cells lie on both sides
    };
    [[nodiscard]] bool is_free(Point from, Point to) const;

    const Walls& walls_;
    std::vector<Segment> segments_;
    std::vector<Face> faces_;
    std::vector<double> areas_;
    std::vector<char> is_inside_;
};

/// The point of a segment that is nearest to a point, as a fraction of the segment.
double nearest_fraction(Point p, Point from, Point to);

}  // namespace graincrack::mesher
