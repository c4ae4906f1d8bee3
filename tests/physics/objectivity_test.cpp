// Nothing depends on how a specimen is turned: forces turn with it, in a rigid turn as in the loading of a turned specimen.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/check.hpp"
#include "tests/support/linear_statics.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_law;
using test::LinearPressure;
using test::SmallRun;
using test::verify;

constexpr LawVariant all_variants[] = {LawVariant::literal, LawVariant::consistent};

Vector2 turned(const Vector2& v, double angle) {
    return {std::cos(angle) * v.x - std::sin(angle) * v.y, std::sin(angle) * v.x + std::cos(angle) * v.y};
}
/// Displacements of the points p + u turned about the origin.
std::vector<Vector2> turned(const SmallRun& run, const std::vector<Vector2>& u, double angle) {
    std::vector<Vector2> result;
    for (std::size_t i = 0; i < u.size(); ++i) {
        const Vector2 p = run.assemblage.position[i];
        result.push_back(turned(p + u[i], angle) - p);
    }
    return result;
}
double largest(const std::vector<Vector2>& vectors) {
    double most = 0;
    for (const Vector2& v : vectors) most = std::max(most, length(v));
    return most;
}
double largest_difference(const std::vector<Vector2>& a, const std::vector<Vector2>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, length(a[i] - b[i]));
    return most;
}

// Through a whole turn: none of the forces of an unstrained specimen, and those of a strained one turned. Displacements of 0.04 m
// are known to 7e-18 m, which times kt and half an edge is 1e-5 N against the 1e4 N of strains that crack.
TEST(Objectivity, ForcesTurnWithTheSpecimen) {
    for (const LawVariant variant : all_variants) {
        const SmallRun run(test::jittered_grid(4, 6, 0.02, 0.03, 0.2), augig_law(variant));
        std::vector<Vector2> still(run.assemblage.position.size());
        std::vector<Vector2> strained(still.size());
        for (std::size_t i = 0; i < strained.size(); ++i) {
            const double k = static_cast<double>(i);
            strained[i] = {4e-8 * std::sin(3 * k), 4e-8 * std::sin(5 * k + 1)};  // contacts at half their critical opening
        }
        const std::vector<Vector2> forces = forces_at(run, run.state, strained);
        const double scale = largest(forces);
        EXPECT_GT(scale, 1e4);
        for (int degrees = 5; degrees <= 360; degrees += 5) {
            const double angle = degrees * std::numbers::pi / 180;
            verify("elements: specimen turned through 360 deg, largest force over that of strains that crack",
                   largest(forces_at(run, run.state, turned(run, still, angle))), 0, 1e-9, "no force from rotation", scale);
            std::vector<Vector2> back = forces_at(run, run.state, turned(run, strained, angle));
            for (Vector2& f : back) f = turned(f, -angle);
            verify("elements: strained specimen turned through 360 deg, difference of forces turned back",
                   largest_difference(back, forces), 0, 1e-9, "forces turn with it", scale);
        }
        EXPECT_GT(largest(turned(run, still, std::numbers::pi)), 0.03);  // it really turns
    }
}

/// A pulse of pressure on the left and right sides, undamped, in steps of the same length (what the iteration finds as the stable
/// one depends on the angle by its last digits).
SmallRun loaded_run(double angle) {
    SmallRun run(test::rotated(test::jittered_grid(4, 6, 0.02, 0.03, 0.2), angle), augig_law());
    run.press_on({BoundaryPart::left, BoundaryPart::right}, 0.5);
    EXPECT_NEAR(run.parameters.time_step, 3e-8, 1e-8);
    run.parameters.time_step = 2e-8;
    run.begin();
    LinearPressure pressure;
    run.steps_under(pressure, 20e6, 1000);
    run.steps_under(pressure, 20e6, 1000);
    EXPECT_GT(run.measured().energies.strain, 0);  // and leaves the nodal forces of now
    return run;
}

TEST(Objectivity, ElasticLoadingOfATurnedSpecimen) {
    const SmallRun upright = loaded_run(0);
    EXPECT_EQ(upright.failed_points(), 0U);
    const double force = largest(upright.state.force);
    const double displacement = largest(upright.state.displacement);
    EXPECT_GT(displacement, 5e-6);  // p/E of half the width, and the swing on top
    EXPECT_GT(force, 1e3);
    for (const double degrees : {30.0, 90.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        SmallRun run = loaded_run(angle);
        for (std::size_t i = 0; i < run.state.force.size(); ++i) {
            run.state.force[i] = turned(run.state.force[i], -angle);
            run.state.displacement[i] = turned(run.state.displacement[i], -angle);
        }
        const std::string name = "elements: elastic loading turned by " + std::to_string(static_cast<int>(degrees)) + " deg, ";
        verify(name + "forces", largest_difference(run.state.force, upright.state.force), 0, 1e-9, "the same", force);
        verify(name + "displacements", largest_difference(run.state.displacement, upright.state.displacement), 0, 1e-9,
               "the same", displacement);
    }
}

}  // namespace
}  // namespace graincrack
