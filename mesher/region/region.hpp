// A region of the plane: loops with named parts around it, and edges that grains must follow inside.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// What lies on a circle where its loaded diameters end: the middle of a facet, or a vertex.
enum class Pole { facet, vertex };

/// A circle of the boundary. Meshes follow it by a polygon of the same area.
struct Circle {
    Point centre;
    double radius = 0;         ///< m
    Pole pole = Pole::vertex;  ///< at both ends of each diameter; the polygon has the circle's extent there
    int diameters = 1;         ///< at equal angles, the first along y
};

/// A closed line with the region on its left: a polygon, counter-clockwise around the region and clockwise around a hole; or a
/// circle, which needs no direction.
struct Loop {
    std::vector<Point> corners;       ///< of a polygon; side i runs from corner i to the next
    std::vector<std::uint8_t> parts;  ///< index into `part_names` of each side; of a circle one
    std::optional<Circle> circle = {};
};

/// A straight edge inside a region that grain sides follow to round-off. The contacts along it are of its kind.
struct PrescribedEdge {
    Point from;
    Point to;
    ContactKind kind = ContactKind::grain_boundary;
};

/// The first loop lies around the region, the others around its holes. Loops neither cross nor touch each other.
struct Region {
    std::string name;  ///< as in the specimen file
    std::vector<Loop> loops;
    std::vector<PrescribedEdge> edges;
    std::vector<std::string> part_names = Specimen{}.part_names;
};

/// A rectangle centred on the origin, with the parts bottom, right, top and left.
Region rectangle(double width, double height);
/// A disc centred on the origin, of the part rim.
Region disc(double diameter, Pole pole, int diameters);

/// Checks that loops have three corners, a part for each side and the right direction, that they neither cross nor touch each
/// other and that holes lie inside; that prescribed edges have a length.
/// \throws UsageError naming the first violation
void check(const Region& region);

struct Box {
    Point low;
    Point high;
    [[nodiscard]] double width() const { return high.x - low.x; }
    [[nodiscard]] double height() const { return high.y - low.y; }
};

Box bounds(const Region& region);
double area(const Region& region);       ///< m²; of circles, not of the polygons that meshes have for them
double perimeter(const Region& region);  ///< of all loops, m
bool contains(const Region& region, Point p);
/// Distance from the nearest loop, positive inside, m.
double depth_inside(const Region& region, Point p);
/// Whether a region is one circle, as a disc is.
bool is_round(const Region& region);
/// Whether a region is convex, without holes and prescribed edges.
bool is_plain(const Region& region);
/// The pieces of an edge that lie inside, in its direction. Their new ends lie on loops to round-off.
std::vector<PrescribedEdge> clip(const Region& region, const PrescribedEdge& edge);

/// Whether a corner is convex, sharp enough that one triangle could cut it off, and blunt enough that two should share it.
bool can_be_cut_off(Point before, Point at, Point after);

/// What distances are measured from: a straight side, a circle or a prescribed edge.
struct Curve {
    enum class Kind { side, prescribed, circle, circular_hole } kind = Kind::side;
    Point from;  ///< of a straight curve
    Point to;
    Point along;  ///< unit vector
    Circle circle;

    [[nodiscard]] bool is_circle() const { return kind == Kind::circle || kind == Kind::circular_hole; }
    [[nodiscard]] double distance(Point p) const;
    /// A point moved straight away from the curve, to a distance `depth` inside the region; from a prescribed edge within
    /// its side.
    /// \param inside whether the point lies inside the region
    [[nodiscard]] Point moved_off(Point p, bool inside, double depth) const;
};

/// The curves of all loops, then the prescribed edges.
std::vector<Curve> curves_of(const Region& region);

}  // namespace graincrack::mesher
