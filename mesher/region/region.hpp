// A region of the plane: surrounding loops with named parts, and inner edges that grains must follow.
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

/// Shape of a circle at the ends of its loaded diameters: a facet's middle, or a vertex.
enum class Pole { facet, vertex };

/// A circle of the boundary. Meshes replace it by a polygon of the same area.
struct Circle {
    Point centre;
    double radius = 0;         ///< m
    Pole pole = Pole::vertex;  ///< at both ends of each diameter; the polygon has the circle's extent there
    int diameters = 1;         ///< at equal angles, the first along y
    /// Index of the loaded diameter, counter-clockwise from 0: the specimen is rotated until it lies along y.
    int loaded_diameter = 0;
};

/// A closed line with the region on its left: a polygon, counter-clockwise around the region and clockwise around a hole, or a
/// circle, which has no direction. Sides of a polygon around a region may be arcs of circles that bulge outwards.
struct Loop {
    std::vector<Point> corners;       ///< polygon: side i runs from corner i to the next
    std::vector<std::uint8_t> parts;  ///< [sides] index into `part_names`; one for a circle
    std::optional<Circle> circle = {};
    /// [sides] centre of an arc, which runs counter-clockwise around it by less than 180°; empty without arcs.
    std::vector<std::optional<Point>> centres = {};

    [[nodiscard]] std::optional<Point> centre(std::size_t side) const { return centres.empty() ? std::nullopt : centres[side]; }
    /// Points that show the direction in which a side leaves its first corner, and reaches its last: the other end of a straight
    /// side.
    [[nodiscard]] Point ahead(std::size_t side) const;
    [[nodiscard]] Point behind(std::size_t side) const;
};

/// Kind of the contacts along a flaw: their state at the start, and the class of their parameters, "" for grain boundaries.
struct FlawKind {
    // The conversion is implicit: most flaws have no class of their own.
    FlawKind(ContactKind start_ = ContactKind::grain_boundary,
             std::string contact_class_ = {})  // NOLINT(google-explicit-constructor)
        : start(start_), contact_class(std::move(contact_class_)) {}
    ContactKind start;
    std::string contact_class;
    friend bool operator==(const FlawKind&, const FlawKind&) = default;
};
/// Returns the kind described by a table or an option. \param contact_class "broken", "intact", a class of flaws, or "" \param
/// state "broken" or "intact"; "": broken without a class, intact with one. \return empty if it is invalid
std::optional<FlawKind> flaw_kind(std::string_view contact_class, std::string_view state);
/// The valid kinds, for messages.
inline constexpr const char* kinds_of_flaws =
    "a class is broken, intact or the name of one (a-z, 0-9, _), which may have the state broken or intact";

/// A straight edge inside a region, which grain sides follow to round-off. It gives its kind to the contacts along it.
struct PrescribedEdge {
    Point from, to;
    FlawKind kind = {};
    std::string name = "a prescribed edge";  ///< for messages: "flaws.tsv: line 3"
    bool needed = true;                      ///< false: left out if it has no room, as a random joint
};

/// The first loop surrounds the region, the others its holes. Loops neither cross nor meet.
struct Region {
    std::string name;  ///< name in the specimen file
    std::vector<Loop> loops;
    std::vector<PrescribedEdge> edges;
    std::vector<std::string> part_names = Specimen{}.part_names;
    double flats = 0;  ///< disc with flat poles: angle under which a flat is seen from the centre, rad
};

Box bounds(const Region& region);
double area(const Region& region);       ///< m²; of circles themselves, not of the polygons of meshes
double perimeter(const Region& region);  ///< of all loops, m
bool contains(const Region& region, Point p);
/// Distance from the nearest loop, positive inside, m.
double depth_inside(const Region& region, Point p);
/// True if a circle surrounds the region, as for a disc or a ring.
bool is_round(const Region& region);
/// True if a region is convex, without holes and prescribed edges.
bool is_plain(const Region& region);
/// The pieces of an edge inside the region, in its direction. Their new ends lie on loops to round-off.
std::vector<PrescribedEdge> clip(const Region& region, const PrescribedEdge& edge);

/// True if a corner is convex, sharp enough to be cut off by one triangle, and blunt enough for two to share it.
bool can_be_cut_off(Point before, Point at, Point after);

/// A curve for distances: a straight side, an arc, a circle or a prescribed edge.
struct Curve {
    enum class Kind { side, prescribed, circle, circular_hole, arc } kind = Kind::side;
    Point from;  ///< start of a straight curve or an arc
    Point to;
    Point along;    ///< unit vector of a straight curve
    Circle circle;  ///< also of an arc

    [[nodiscard]] bool is_circle() const { return kind == Kind::circle || kind == Kind::circular_hole; }
    [[nodiscard]] double arc_angle() const;  ///< angle of an arc seen from its centre, rad
    [[nodiscard]] double length() const;     ///< m
    [[nodiscard]] double distance(Point p) const;
    /// Moves a point straight away from the curve to a distance `depth` inside the region; from a prescribed edge on its own
    /// side.
    /// \param inside true if the point lies inside the region
    [[nodiscard]] Point moved_off(Point p, bool inside, double depth) const;
};

/// The curves of all loops, then the prescribed edges.
std::vector<Curve> curves_of(const Region& region);

/// The image of a region under `Stretch::equiaxed`; the region itself without elongation. Circles and arcs, which would become
/// ellipses, become polygons with sides of about `side` (m) before the map.
Region stretched(const Region& region, const Stretch& stretch, double side);

}  // namespace graincrack::mesher
