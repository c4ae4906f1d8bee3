// The elastic Brazilian disc, with stiff contacts: its stress is that of a disc under two point loads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesher/mesh.hpp"
#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using std::numbers::pi;

constexpr double disc_diameter = 0.08;
constexpr double disc_radius = disc_diameter / 2;

/// A disc with stiff contacts, compressed to about 1 MPa and held until it is at rest.
SmallRun compressed_disc() {
    ContactParameters contact = augig_contact(PlaneCondition::stress);
    contact.normal_stiffness *= 10;
    contact.shear_stiffness *= 10;
    SmallRun run(mesher::mesh({.region = mesher::disc(disc_diameter), .fabric = {.grains = 452, .elements_per_edge = 2}}),
                 make_contact_law(contact, LawVariant::consistent), PlaneCondition::stress);
    run.load_by({.test = TestKind::brazilian}, 0.7, contact);
    run.parameters.damping = 0.8;
    run.begin();
    const double approach = 5e-6;  // of each platen: some 3 MPa across the disc
    const double transit = disc_diameter / 3120.23;
    const auto steps = static_cast<std::int64_t>(10 * transit / run.parameters.time_step);
    const double speed = approach / (10 * transit);
    run.steps(steps, {{}, {speed, -speed}, nullptr});
    run.steps(steps, {{speed, -speed}, {}, nullptr});
    run.steps(2 * steps);
    return run;
}

/// Stress under a force P (N per metre of thickness) along y (Timoshenko & Goodier, Theory of Elasticity, §41).
struct PointLoads {
    double force;
    [[nodiscard]] std::array<double, 2> normal_stresses(const Vector2& p) const {
        const double above = disc_radius - p.y;
        const double below = disc_radius + p.y;
        const double r1 = p.x * p.x + above * above;
        const double r2 = p.x * p.x + below * below;
        const double factor = -2 * force / pi;
        return {factor * (above * p.x * p.x / (r1 * r1) + below * p.x * p.x / (r2 * r2) - 1 / disc_diameter),
                factor * (above * above * above / (r1 * r1) + below * below * below / (r2 * r2) - 1 / disc_diameter)};
    }
};

/// Means of σx and σy over the elements of a region, measured and by the formula.
struct Means {
    std::array<double, 2> measured{}, expected{};
    int elements = 0;
};
template <class Region>
Means means(const SmallRun& run, const Frame& frame, const PointLoads& loads, Region&& region) {
    Means m;
    double area = 0;
    for (std::size_t e = 0; e < frame.element_stress.size(); ++e) {
        const Vector2 middle = centroid(run.assemblage, e);
        if (!region(middle)) continue;
        const double a = run.assemblage.element_geometry[e].area;
        const std::array<double, 2> formula = loads.normal_stresses(middle);
        for (std::size_t k = 0; k < 2; ++k) {
            m.measured[k] += a * frame.element_stress[e][k];
            m.expected[k] += a * formula[k];
        }
        area += a;
        ++m.elements;
    }
    for (std::size_t k = 0; k < 2; ++k) {
        m.measured[k] /= area;
        m.expected[k] /= area;
    }
    return m;
}

// σx = 2P/(πDt), σy = −6P/(πDt) at the centre and σx along the horizontal diameter (Timoshenko & Goodier, §41), as means over
// regions of elements, to 3 %: cells, and platens that are no points.
TEST(ElasticDisc, HasTheStressOfTwoPointLoads) {
    SmallRun run = compressed_disc();
    const Measurement at_rest = run.measured();
    EXPECT_EQ(run.failed_points(), 0U);
    const double force = -0.5 * (at_rest.force_top - at_rest.force_bottom);
    EXPECT_GT(force, 0.5e6 * disc_diameter);
    expect_close(at_rest.force_top, -at_rest.force_bottom, 2e-3, force);  // 1e-3 measured; runs must stay below 2 %
    EXPECT_LT(at_rest.unbalanced_ratio, 1e-4);
    const PointLoads loads{force};
    expect_close(loads.normal_stresses({})[0], 2 * force / (pi * disc_diameter), 1e-12, force / disc_diameter);
    expect_close(loads.normal_stresses({})[1], -6 * force / (pi * disc_diameter), 1e-12, force / disc_diameter);

    const Frame frame = run.frame();
    const Means centre = means(run, frame, loads, [](const Vector2& p) { return length(p) < disc_radius / 6; });
    EXPECT_GT(centre.elements, 20);
    // Means over the central region, converted to the centre by the ratio of the formula's values.
    const std::array<double, 2> exact = loads.normal_stresses({});
    verify("specimens: elastic disc, centre, sigma_x (MPa)", centre.measured[0] * exact[0] / centre.expected[0] * 1e-6,
           exact[0] * 1e-6, 0.03, "2P/(pi D t)");
    verify("specimens: elastic disc, centre, sigma_y (MPa)", centre.measured[1] * exact[1] / centre.expected[1] * 1e-6,
           exact[1] * 1e-6, 0.03, "-6P/(pi D t)");
    for (int bin = -3; bin < 3; ++bin) {  // of a sixth of the radius
        const Means m = means(run, frame, loads, [bin](const Vector2& p) {
            const double x = 6 * p.x / disc_radius;
            return x >= bin && x < bin + 1 && std::abs(p.y) < disc_radius / 8;
        });
        EXPECT_GT(m.elements, 10);
        const int percent = 100 * (2 * bin + 1) / 12;
        verify("specimens: elastic disc, sigma_x on the horizontal diameter at x/R = " + std::to_string(percent) + " % (MPa)",
               m.measured[0] * 1e-6, m.expected[0] * 1e-6, 0.03, "(2P/pi D t) [(D^2 - 4x^2)/(D^2 + 4x^2)]^2", exact[0] * 1e-6);
    }
}

}  // namespace
}  // namespace graincrack::test
