#include "post/calibrate/kind_prior.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/synthetic_kind.hpp"

namespace graincrack::calibrate {
namespace {

// Bridges are a coordinate of the surface, their stiffness is none.
TEST(KindPrior, KnowsBridgesAndNamesWhatItDoesNotKnow) {
    const auto kind = std::make_shared<const KindSurface>(test::SyntheticKind{}.rows(70), "granite");
    const Material rock = read_material("granite-crystals");
    const auto lacking = [&](const char* key) {
        return KindPrior(kind, rock, {{key, true, 0.4, 0.8, 0.3, 0.9, 0.6}}, Study{}).lacks({});
    };
    EXPECT_EQ(lacking("ratios.bridging_strength"), "");
    EXPECT_EQ(lacking("ratios.open_shear_strength"), "the kind granite does not know ratios.open_shear_strength");
}

}  // namespace
}  // namespace graincrack::calibrate
