// Shapes of specimens and their outlines: where the boundary points of a mesh lie.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesher/geometry.hpp"
#include "mesher/random_numbers.hpp"
#include "share/specimen.hpp"

namespace graincrack::mesher {

enum class ShapeKind { rectangle, disc };
/// Part of a disc's rim that meets the platens at (0, ±D/2): the middle of a facet, or a vertex.
enum class Pole { facet, vertex };

/// A shape centred on the origin, load along y. Sizes in m.
struct Shape {
    ShapeKind kind = ShapeKind::rectangle;
    double width = 0;   ///< along x; of a disc the diameter
    double height = 0;  ///< along y; of a disc the diameter
    Pole pole = Pole::facet;
    /// Of a disc: number of diameters with a pole at both ends, at equal angles, the first along y; and the index, counted
    /// counter-clockwise, of the one that is loaded: the specimen is turned so that this diameter lies along y.
    int diameters = 1;
    int loaded_diameter = 0;

    [[nodiscard]] double area() const;       ///< m²; of a disc that of the true circle
    [[nodiscard]] double perimeter() const;  ///< m
    [[nodiscard]] std::string name() const;  ///< as in the specimen file
};

/// Closed convex polygon with the boundary points of a mesh, counter-clockwise; edge i runs from point i to i + 1.
struct Outline {
    std::vector<Point> points;
    std::vector<BoundaryPart> parts;  ///< of each edge
    std::vector<int> corners;         ///< points with a right angle, where one triangle could cut off the corner
    double loading_arc = 0;           ///< angle that a pole facet subtends at the centre, rad; 0 without a facet
};

/// Number of boundary points nearest to `wanted` that the shape allows, of the requested parity.
/// \param odd true if the number must be odd
int admissible_boundary_count(const Shape& shape, double wanted, bool odd);

/// Places `n` boundary points. Spacings vary at random with coefficient of variation `spread`; the length of pole facets does not
/// vary.
///
/// A disc's points lie at the radius that gives the polygon the area of the circle; the pole facets' nodes (or the pole
/// vertices) are moved along y to meet y = ±D/2 exactly.
/// \param n from `admissible_boundary_count`
Outline make_outline(const Shape& shape, int n, double spread, RandomNumbers& random);

/// Turns points of a disc so that the loaded diameter lies along y; its poles come to y = ±D/2 exactly.
void turn_to_load(const Shape& shape, std::vector<Point>& points);

/// Distance of a point from the boundary, positive inside, m (of a disc: from the true circle).
double depth_inside(const Shape& shape, Point p);

}  // namespace graincrack::mesher
