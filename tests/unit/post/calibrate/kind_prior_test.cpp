#include "post/calibrate/kind_prior.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/synthetic_kind.hpp"

namespace graincrack::calibrate {
namespace {

// The surface is of bridges between crystals alone.
TEST(KindPrior, KnowsFreeBridgesWhereNoneAreWithinCrystals) {
    const auto kind = std::make_shared<const KindSurface>(test::SyntheticKind{}.rows(70), "granite");
    Material rock = read_material("lac-du-bonnet-granite-calibrated");
    rock.ratios.bridging_energy = 1;
    const std::vector<Parameter> bridges{{"ratios.bridging_strength", true, 0.4, 0.8, 0.3, 0.9, 0.6}};
    const auto lacking = [&] { return KindPrior(kind, rock, bridges, Study{}).lacks({}); };
    EXPECT_EQ(lacking(), "the kind granite does not know ratios.bridging_strength");
    rock.fabric.within.bridging_strength = rock.fabric.within.bridging_energy = 0;
    EXPECT_EQ(lacking().find("does not know"), std::string::npos) << lacking();
}

}  // namespace
}  // namespace graincrack::calibrate
