#include "mesher/fabric/crystals.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "share/file/specimen_validation.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::mesher {
namespace {

TEST(Crystals, ContactsWithinThemAreOfTheClassOfTheirPhase) {
    Specimen s = test::one_diagonal_grid(2, 1, 0.02, 0.01);  // two squares of two triangles each
    s.phase_names = {"quartz", "mica"};
    const auto centre = [&](std::size_t g) {
        double x = 0;
        for (const std::int32_t node : s.element_nodes[g]) x += s.node_position[static_cast<std::size_t>(node)][0] / 3;
        return x;
    };
    std::vector<int> crystals;
    for (std::size_t g = 0; g < s.n_grains(); ++g) crystals.push_back(centre(g) < 0 ? 0 : 1);
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = static_cast<std::uint8_t>(crystals[g]);
    name_crystals(s, crystals);
    validate(s, "s.h5");
    EXPECT_EQ(s.flaw_names, (std::vector<std::string>{"within_quartz", "within_mica"}));
    EXPECT_EQ(s.grain_crystal.size(), 4U);
    ASSERT_EQ(s.n_contacts(), 3U);
    const auto within = static_cast<std::uint8_t>(ContactKind::within_crystal);
    EXPECT_EQ(std::count(s.contact_kind.begin(), s.contact_kind.end(), within), 2);
    std::vector<std::uint8_t> classes = s.contact_flaw;
    std::sort(classes.begin(), classes.end());
    EXPECT_EQ(classes, (std::vector<std::uint8_t>{0, 1, 2}));
    EXPECT_EQ(phase_of_within_class("within_quartz"), "quartz");
    EXPECT_EQ(phase_of_within_class("joint"), "");
}

}  // namespace
}  // namespace graincrack::mesher
