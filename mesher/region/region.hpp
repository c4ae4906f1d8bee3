// A region of the plane: loops with named parts around it, and edges that grains must follow inside.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesher/plane/geometry.hpp"
#include "mesher/plane/stretch.hpp"
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
    /// Index, counted counter-clockwise from 0, of the diameter that is loaded: the specimen is turned so that it lies along y.
    int loaded_diameter = 0;
};

/// A closed line with the region on its left: a polygon, counter-clockwise around the region and clockwise around a hole; or a
/// circle, which needs no direction. Sides of a polygon around a region may be arcs of circles that bulge outwards.
struct Loop {
    std::vector<Point> corners;       ///< of a polygon; side i runs from corner i to the next
    std::vector<std::uint8_t> parts;  ///< index into `part_names` of each side; of a circle one
    std::optional<Circle> circle = {};
    /// Of each side that is an arc the centre, around which it runs counter-clockwise by less than 180°; empty without arcs.
    std::vector<std::optional<Point>> centres = {};

    [[nodiscard]] std::optional<Point> centre(std::size_t side) const { return centres.empty() ? std::nullopt : centres[side]; }
    /// A point in the direction in which a side leaves its first corner, and one from which it reaches its last: of a straight
    /// side its other end.
    [[nodiscard]] Point ahead(std::size_t side) const;
    [[nodiscard]] Point behind(std::size_t side) const;
};

/// What contacts along a flaw are: how they start, and the class whose parameters they have, "" for those of grain boundaries.
struct FlawKind {
    // (Implicit: most flaws have no class of their own.)
    FlawKind(ContactKind start_ = ContactKind::grain_boundary,
             std::string contact_class_ = {})  // NOLINT(google-explicit-constructor)
        : start(start_), contact_class(std::move(contact_class_)) {}
    ContactKind start;
    std::string contact_class;
    friend bool operator==(const FlawKind&, const FlawKind&) = default;
};
/// The kind that a table or an option describes. \param contact_class "broken", "intact" or the name of a class of flaws; ""
/// \param state "broken" or "intact"; "": broken without a class, intact of a named one. \return nothing if it is none
std::optional<FlawKind> flaw_kind(std::string_view contact_class, std::string_view state);
/// What is understood, for messages.
inline constexpr const char* kinds_of_flaws =
    "a class is broken, intact or the name of one (a-z, 0-9, _), which may have the state broken or intact";

/// A straight edge inside a region that grain sides follow to round-off. The contacts along it are of its kind.
struct PrescribedEdge {
    Point from, to;
    FlawKind kind = {};
    std::string name = "a prescribed edge";  ///< for messages: "flaws.tsv: line 3"
    bool needed = true;                      ///< false: left out where it has no room, as a joint drawn at random is
};

/// The first loop lies around the region, the others around its holes. Loops neither cross nor touch each other.
struct Region {
    std::string name;  ///< as in the specimen file
    std::vector<Loop> loops;
    std::vector<PrescribedEdge> edges;
    std::vector<std::string> part_names = Specimen{}.part_names;
    double flats = 0;  ///< of a disc with flat poles: angle under which a flat is seen from the centre, rad
};

Box bounds(const Region& region);
double area(const Region& region);       ///< m²; of circles, not of the polygons that meshes have for them
double perimeter(const Region& region);  ///< of all loops, m
bool contains(const Region& region, Point p);
/// Distance from the nearest loop, positive inside, m.
double depth_inside(const Region& region, Point p);
/// Whether a circle lies around a region, as around a disc or a ring.
bool is_round(const Region& region);
/// Whether a region is convex, without holes and prescribed edges.
bool is_plain(const Region& region);
/// The pieces of an edge that lie inside, in its direction. Their new ends lie on loops to round-off.
std::vector<PrescribedEdge> clip(const Region& region, const PrescribedEdge& edge);

/// Whether a corner is convex, sharp enough that one triangle could cut it off, and blunt enough that two should share it.
bool can_be_cut_off(Point before, Point at, Point after);

/// What distances are measured from: a straight side, an arc, a circle or a prescribed edge.
struct Curve {
    enum class Kind { side, prescribed, circle, circular_hole, arc } kind = Kind::side;
    Point from;  ///< of a straight curve or an arc
    Point to;
    Point along;    ///< unit vector of a straight curve
    Circle circle;  ///< also of an arc

    [[nodiscard]] bool is_circle() const { return kind == Kind::circle || kind == Kind::circular_hole; }
    [[nodiscard]] double arc_angle() const;  ///< that an arc is seen under from its centre, rad
    [[nodiscard]] double length() const;     ///< m
    [[nodiscard]] double distance(Point p) const;
    /// A point moved straight away from the curve, to a distance `depth` inside the region; from a prescribed edge within
    /// its side.
    /// \param inside whether the point lies inside the region
    [[nodiscard]] Point moved_off(Point p, bool inside, double depth) const;
};

/// The curves of all loops, then the prescribed edges.
std::vector<Curve> curves_of(const Region& region);

/// The image of a region under `Stretch::equiaxed`; the region itself without elongation. Circles and arcs, which would become
/// ellipses, become polygons with sides of about a length `side` before the map.
Region stretched(const Region& region, const Stretch& stretch, double side);

}  // namespace graincrack::mesher
