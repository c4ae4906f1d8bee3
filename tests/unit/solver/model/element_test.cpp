// Pieces of the triangle; what they add up to is in tests/physics.
#include "solver/model/element.hpp"

#include <gtest/gtest.h>

#include "tests/support/check.hpp"

namespace graincrack {
namespace {

using test::expect_close;

TEST(Triangle, GeometryOfARightTriangle) {
    const TriangleGeometry g = make_triangle_geometry({1, 1}, {3, 1}, {1, 5});
    EXPECT_EQ(g.area, 4);
    EXPECT_EQ(g.gradient1.x, 0.5);
    EXPECT_EQ(g.gradient1.y, 0);
    EXPECT_EQ(g.gradient2.x, 0);
    EXPECT_EQ(g.gradient2.y, 0.25);
}

TEST(Triangle, Elasticity) {
    const double E = 25.8e9;
    const PlaneElasticity stress = make_plane_elasticity(E, 0.23, PlaneCondition::stress);
    expect_close(stress.c11, E / (1 - 0.23 * 0.23), 1e-14, E);
    expect_close(stress.c12, 0.23 * stress.c11, 1e-14, E);
    EXPECT_EQ(stress.czz, 0);
    const PlaneElasticity strain = make_plane_elasticity(E, 0.23, PlaneCondition::strain);
    expect_close(strain.c11, E * 0.77 / (1.23 * 0.54), 1e-14, E);
    expect_close(strain.c12, E * 0.23 / (1.23 * 0.54), 1e-14, E);
    EXPECT_EQ(strain.mu, stress.mu);
    EXPECT_EQ(strain.czz, 0.23);
}

TEST(Triangle, StretchIsBiotStrainWithoutRotation) {
    const TriangleGeometry g = make_triangle_geometry({0, 0}, {2, 0}, {0, 1});
    const PlaneElasticity c = make_plane_elasticity(1, 0, PlaneCondition::stress);
    const TriangleState s = triangle_state(g, c, {0.2, 0}, {0, -0.1});
    EXPECT_EQ(s.sine, 0);
    expect_close(s.exx, 0.1, 1e-15, 1);
    expect_close(s.eyy, -0.1, 1e-15, 1);
    EXPECT_EQ(s.exy, 0);
    // ½ A E (ε² + ε²), and forces E ε times half of the facing side
    expect_close(triangle_energy(g, s), 0.5 * 1 * (0.01 + 0.01), 1e-14, 0.01);
    const TriangleForces f = triangle_forces(g, s);
    expect_close(f.on_node1.x, -0.1 * 0.5, 1e-14, 0.1);
    expect_close(f.on_node2.y, 0.1 * 1, 1e-14, 0.1);
    expect_close(f.on_node0().x, 0.05, 1e-14, 0.1);
}

TEST(Triangle, AtRestThereIsExactlyNothing) {
    const TriangleGeometry g = make_triangle_geometry({0.1, 0.2}, {0.7, 0.3}, {0.3, 0.9});
    const TriangleState s = triangle_state(g, make_plane_elasticity(1e9, 0.3, PlaneCondition::strain), {}, {});
    EXPECT_EQ(s.txx, 0);
    EXPECT_EQ(s.tyy, 0);
    EXPECT_EQ(s.txy, 0);
    EXPECT_EQ(triangle_energy(g, s), 0);
}

}  // namespace
}  // namespace graincrack
