// Crystals of triangles with a flaw of a class of its own, and their material.
#pragma once

#include "mesher/mesh.hpp"
#include "tests/support/augig_granite.hpp"

namespace graincrack::test {

/// A flaw across the middle, broken from the start, that ends within the specimen.
inline Specimen crystals_with_flaw() {
    mesher::Region region = mesher::rectangle(0.04, 0.08);
    region.edges = {{{-0.01, -0.012}, {0.012, 0.01}, {ContactKind::pre_existing_crack, "joint"}, "joint"}};
    const mesher::Fabric fabric{.tessellation = mesher::Tessellation::trigon, .grains = 40, .spread = 0.3};
    return mesher::mesh({.region = region, .fabric = fabric, .seed = 4});
}

inline Material granite_with_flaw() {
    Material material = augig_granite();
    material.fabric.flaws["joint"].friction_angle = 10 * degree;
    return material;
}

}  // namespace graincrack::test
