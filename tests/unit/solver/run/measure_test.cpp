// Energies of states set by hand.
#include "solver/run/measure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

// One contact opened by hand to half its critical opening.
TEST(Measure, HasTheEnergyOfAnOpenedContact) {
    SmallRun run(one_diagonal_column(2, 0.02, 0.02), augig_law(LawVariant::literal));
    const ContactLaw& law = run.parameters.laws[0];
    const double opening = 0.5 * law.dct;
    for (std::size_t i = 4; i < 8; ++i) run.state.displacement[i].y = opening;
    run.begin();
    const Energies e = run.measured().energies;
    const double expected = 0.02 * law.tc * law.dct * std::numbers::e * (1 - 1.5 * std::exp(-0.5));  // ∫ Eq 7 over the edge
    expect_close(e.contact, expected, 1e-12, expected);
    EXPECT_EQ(e.strain, 0);
    EXPECT_EQ(e.stored(), e.contact);
    const Frame frame = run.frame();
    ASSERT_EQ(frame.opening.size(), 1U);
    for (const std::size_t p : {0U, 1U}) {
        expect_close(frame.opening[0][p], opening, 1e-12, opening);
        expect_close(frame.sliding[0][p], 0, 1e-12, opening);
        expect_close(frame.traction[0][2 * p], law.kt * opening * std::exp(-0.5), 1e-12, law.tc);
        expect_close(frame.traction[0][2 * p + 1], 0, 1e-12, law.tc);
        EXPECT_EQ(frame.damage[0][p], 0);
        EXPECT_EQ(frame.state[0][p], 0);
    }
}

// An octagon, whose slanted edges are the rim: loads on it press from the side, and are no confining pressure.
TEST(Measure, TakesTheConfiningPressureFromTheLeftAndTheRight) {
    const double a = 0.01;
    const double b = 0.02;
    const Specimen octagon =
        specimen_of_triangles({{0, 0}, {-a, -b}, {a, -b}, {b, -a}, {b, a}, {a, b}, {-a, b}, {-b, a}, {-b, -a}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 8}, {0, 8, 1}});
    const auto force = [&](const std::vector<BoundaryPart>& parts, double pressure) {
        SmallRun run(octagon, augig_law());
        run.press_on(parts, 0.5);
        run.begin();
        LinearPressure load;
        load.set(pressure);
        run.steps_under(load, pressure, 2);
        return run.measured().confining_force;
    };
    using enum BoundaryPart;
    const double whole = 1e6 * 2 * a;
    expect_close(force({left, right}, 1e6), whole, 1e-4, whole);
    expect_close(force({left, right, rim, top, bottom}, 1e6), whole, 1e-4, whole);
    expect_close(force({left}, 1e6), whole / 2, 1e-4, whole);
    expect_close(force({left, right}, -1e6), -whole, 1e-4, whole);
    EXPECT_EQ(force({rim, top, bottom}, 1e6), 0);
}

}  // namespace
}  // namespace graincrack::test
