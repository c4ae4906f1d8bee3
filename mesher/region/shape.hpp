// The shapes of standard specimens, and their regions.
#pragma once

#include <string>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

enum class ShapeKind { rectangle, disc };

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
};

Region region_of(const Shape& shape);

/// Angle by which a specimen is turned to its load, rad.
double turn_to_load(const Shape& shape);
/// Turns points of a disc so that the loaded diameter lies along y; its poles come to y = ±D/2 exactly.
void turn_to_load(const Shape& shape, std::vector<Point>& points);

}  // namespace graincrack::mesher
