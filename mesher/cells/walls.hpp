// Walls are lines that polygonal cells must follow; they divide the plane into zones.
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
    std::vector<Side> sides;    ///< sides of loops, with the region on their left, then of prescribed edges between meetings
    ConvexOutline hull;         ///< the first loop if it is convex, else a box around it
    bool is_convex = true;      ///< true if the hull is the first loop
    double loading_arc = 0;     ///< see `Seeds`

    /// True if there are walls within the hull.
    [[nodiscard]] bool divide() const { return !is_convex || sides.size() > n_sides_of_outline(); }
    /// True if a point is inside the loops.
    [[nodiscard]] bool contains(Point p) const;
    /// The number of sides of the first loop, which come first.
    [[nodiscard]] std::size_t n_sides_of_outline() const;
    [[nodiscard]] Point at(int p) const { return points[index(p)]; }
};

/// Makes the walls of a region. Straight sides stay whole. Round ones get the fixed points of meshes about `edge` times the local
/// size apart, or more points if they are small, so that circles keep their areas and pole facets their places. \param edge
/// distance of points on round sides, m \param stretch elongation of cells: walls are those of the plane where they are equiaxed
/// \param size relative to `edge`, if it varies
Walls walls_of(const Region& region, double edge, const Stretch& stretch = {}, const SizeField& size = {});

/// The parts of the hull that walls separate.
class Zones {
public:
    explicit Zones(const Walls& walls);

    [[nodiscard]] std::size_t size() const { return areas_.size(); }
    [[nodiscard]] double area(std::size_t zone) const { return areas_[zone]; }
    /// Integral of one over the squared graded size, m², to which the number of cells of a zone is proportional.
    [[nodiscard]] double graded_area(std::size_t zone, const SizeField& size) const;
    [[nodiscard]] bool is_inside(std::size_t zone) const { return is_inside_[zone] != 0; }
    [[nodiscard]] std::size_t zone_at(Point p) const;
    [[nodiscard]] Point random_point(std::size_t zone, RandomNumbers& random) const;
    /// A seed moved towards a place within its zone, and away from walls that are nearer than `distance` (m).
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

/// The fraction of a segment at its point nearest to a point.
double nearest_fraction(Point p, Point from, Point to);

}  // namespace graincrack::mesher
