// Regions that several tests use.
#pragma once

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// An L of three squares of side 40 mm with a square hole and a round hole; the hole's sides have parts of their own.
inline Region l_with_holes() {
    Region region;
    region.name = "polygon";
    region.part_names = {"bottom", "right", "top", "left", "rim", "notch", "hole"};
    region.loops.push_back({{{0, 0}, {0.08, 0}, {0.08, 0.04}, {0.04, 0.04}, {0.04, 0.08}, {0, 0.08}}, {0, 1, 5, 5, 2, 3}});
    region.loops.push_back({{{0.01, 0.01}, {0.01, 0.02}, {0.02, 0.02}, {0.02, 0.01}}, {6, 6, 6, 6}});
    region.loops.push_back({{}, {4}, Circle{{0.06, 0.02}, 0.008}});
    return region;
}
inline constexpr double area_of_l = 3 * 0.04 * 0.04 - 0.01 * 0.01 - 3.14159265358979323846 * 0.008 * 0.008;

}  // namespace graincrack::mesher
