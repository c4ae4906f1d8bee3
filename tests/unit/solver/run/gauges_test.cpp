// Strains of displacements set by hand.
#include "solver/run/gauges.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

TEST(Gauges, ReadAUniformStrainExactly) {
    const SmallRun run(jittered_grid(6, 8, 0.04, 0.08, 0.2), augig_law());
    const Gauges gauges = make_gauges(run.assemblage, run.specimen);
    std::vector<Vector2> u;
    for (const Vector2& p : run.assemblage.position) {
        u.push_back({0.001 + 2e-4 * p.x + 7e-4 * p.y, -0.002 - 5e-4 * p.y + 1e-4 * p.x});
    }
    // jittered points: shear adds the little by which x and y are correlated in the gauge
    EXPECT_NE(gauges.strains(run.assemblage, u).axial, 0);
    for (std::size_t i = 0; i < u.size(); ++i) {
        u[i] = {0.001 + 2e-4 * run.assemblage.position[i].x, -0.002 - 5e-4 * run.assemblage.position[i].y};
    }
    expect_close(gauges.strains(run.assemblage, u).axial, -5e-4, 1e-12, 5e-4);
    expect_close(gauges.strains(run.assemblage, u).lateral, 2e-4, 1e-12, 2e-4);
    expect_close(gauges.strains(run.assemblage, u).widening, 2e-4, 1e-12, 2e-4);
}

TEST(Gauges, LieInTheCentralHalf) {
    const SmallRun run(one_diagonal_grid(4, 8, 0.04, 0.08), augig_law());
    const Gauges gauges = make_gauges(run.assemblage, run.specimen);
    EXPECT_FALSE(gauges.axial.terms.empty());
    for (const Gauge::Term& term : gauges.axial.terms) {
        EXPECT_LE(std::abs(run.assemblage.position[term.node].y), 0.02);
    }
    for (const Gauge::Term& term : gauges.widening.terms) {
        expect_close(std::abs(run.assemblage.position[term.node].x), 0.02, 1e-12, 0.02);
    }
}

}  // namespace
}  // namespace graincrack::test
