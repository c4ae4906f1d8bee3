// The response of softening points without a branch is that of the full law wherever it says that it holds: for every law that
// has one.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/augig_granite.hpp"
#include "tests/support/contact_walk.hpp"

namespace graincrack {
namespace {

using test::MPa;

/// How often the softening response held on a path, and how often a point slid against friction then.
struct Count {
    int held = 0;
    int slid = 0;
};

void expect_equal(const ContactLaw& law, const SofteningResponse& softening, const ContactResponse& full) {
    EXPECT_EQ(softening.normal, full.traction.normal);
    EXPECT_EQ(softening.shear, full.traction.shear);
    EXPECT_EQ(softening.integrity, full.history.integrity);
    EXPECT_EQ(softening.slip, full.history.slip);
    EXPECT_EQ(softening.largest_open, full.history.largest_open);
    EXPECT_EQ(softening.largest_slid, full.history.largest_slid);
    EXPECT_EQ(softening.bridge, full.history.bridge);
    EXPECT_EQ(softening.remaining_cohesion, remaining_cohesion(law, full.history));
    EXPECT_EQ(softening.fracture, full.dissipation.fracture);
    EXPECT_EQ(softening.friction, full.dissipation.friction);
    EXPECT_EQ(full.dissipation.non_conservative_work, 0);
}

/// A path that starts just past the peak of sliding under a pressure, then swings between pressure and opening, past its peak at
/// last, while it slides to and fro, farther and farther.
template <class Law>
Count compare_on_path(const ContactLaw& law, double peak_sliding, int seed) {
    Count count;
    ContactHistory pressed;
    const double opening = -5 * MPa / law.kt;
    pressed.motion.opening = opening;
    test::ContactWalk walk(law, pressed);
    walk.go({opening, 1.01 * peak_sliding}, 10);
    for (int k = 1; k < 500; ++k) {
        const ContactHistory h = walk.history();
        const ContactMotion to{opening * (1 + (1.2 + 0.03 * k) * std::sin(0.013 * k * (1 + seed))),
                               peak_sliding * (1 + 0.2 * k * std::sin(0.05 * k + seed))};
        const SofteningResponse softening = contact_law::softening_response<Law>(law, contact_law::moved_point(h, to));
        const ContactResponse full = update_contact(law, to, h);
        walk.to(to);
        if (softening.holds != 0 && !Law::is_residual(law, h)) {
            ++count.held;
            count.slid += softening.friction > 0 ? 1 : 0;
            expect_equal(law, softening, full);
        }
    }
    return count;
}

template <class Law>
void compare(double peak_factor, double bridge = 0) {
    ContactParameters c = test::weak_contact();
    c.residual_friction_angle = 20 * test::degree;
    c.bridging_strength = bridge * c.tensile_strength;
    c.bridging_energy = bridge * c.fracture_energy;
    const ContactLaw law = make_contact_law(c, Law::description.variant);
    Count all;
    for (int seed = 0; seed < 20; ++seed) {
        const Count count = compare_on_path<Law>(law, peak_factor * c.cohesion / c.shear_stiffness, seed);
        all.held += count.held;
        all.slid += count.slid;
    }
    EXPECT_GT(all.held, 500);
    EXPECT_GT(all.slid, 100);
}

// The peaks of sliding are at e cc/ks and at 2 cc/ks.
TEST(SofteningResponse, OfCohesiveFrictionalAgreesWithTheFullLaw) {
    for (const double bridge : {0.0, 0.5}) compare<contact_law::CohesiveFrictional>(std::exp(1.0), bridge);
}
TEST(SofteningResponse, OfCombinedAgreesWithTheFullLaw) { compare<contact_law::Combined>(2); }

}  // namespace
}  // namespace graincrack
