#include "post/cracks/fragments.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "post/cracks/crack_counts.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

using State = std::vector<std::array<std::uint8_t, 2>>;
constexpr auto separated = static_cast<std::uint8_t>(PointState::separated);

/// A cell of two grains is a crystal: two crystals side by side.
Specimen two_crystals() {
    Specimen s = test::grid_specimen(2, 1, 0.02, 0.01);
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_crystal.push_back(static_cast<std::int32_t>(g / 2));
    s.phase_names = {"quartz", "feldspar"};
    s.grain_phase = {0, 0, 1, 1};
    return s;
}

/// The contact between two grains.
std::int32_t contact_of(const Specimen& s, std::int32_t a, std::int32_t b) {
    const auto grain = grain_of_nodes(s);
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto at = [&](std::size_t k) { return grain[static_cast<std::size_t>(s.contact_nodes[c][k])]; };
        if ((at(0) == a && at(2) == b) || (at(0) == b && at(2) == a)) return static_cast<std::int32_t>(c);
    }
    return -1;
}

Crack crack_of(std::int32_t contact, CrackMode mode, double time) {
    Crack crack;
    crack.contact = contact;
    crack.mode = mode;
    crack.time = time;
    return crack;
}

struct Broken {
    Specimen specimen = two_crystals();
    std::vector<Crack> cracks;
    State state = State(specimen.n_contacts(), {0, 0});
    std::int32_t within = contact_of(specimen, 0, 1);
    std::int32_t between = -1;
    Broken() {
        for (const auto& [a, b] : {std::pair{0, 2}, {0, 3}, {1, 2}, {1, 3}}) {
            between = std::max(between, contact_of(specimen, a, b));
        }
        for (const double time : {1.0, 2.0}) cracks.push_back(crack_of(within, CrackMode::tensile, time));
        cracks.push_back(crack_of(between, CrackMode::shear, 1));
    }
};

TEST(CrackedCrystals, CracksAreWithinOrAround) {
    Broken b;
    ASSERT_GE(b.within, 0);
    ASSERT_GE(b.between, 0);
    b.state[static_cast<std::size_t>(b.within)] = {separated, separated};
    const Fragments fragments = find_fragments(b.specimen, b.state);
    const auto crystals = find_crystals(b.specimen, b.cracks, b.state, fragments);
    ASSERT_EQ(crystals.size(), 2U);
    EXPECT_EQ(crystals[0].phase, "quartz");
    EXPECT_EQ(crystals[0].grains, 2U);
    EXPECT_NEAR(crystals[0].area, 1e-4, 1e-15);
    EXPECT_NEAR(crystals[0].centre[0], -0.005, 1e-12);
    EXPECT_DOUBLE_EQ(crystals[0].within.tensile, 1);
    EXPECT_DOUBLE_EQ(crystals[0].within.shear, 0);
    EXPECT_DOUBLE_EQ(crystals[0].around.shear, 0.5);
    EXPECT_DOUBLE_EQ(crystals[1].around.shear, 0.5);
    EXPECT_DOUBLE_EQ(crystals[1].within.tensile, 0);
    // One half has lost the other, and is alone: the other half hangs on the neighbour.
    EXPECT_EQ(crystals[0].pieces, 2U);
    EXPECT_EQ(crystals[0].fragments, 2U);
    EXPECT_EQ(crystals[1].pieces, 1U);
    EXPECT_EQ(fragments.all[0].crystals, 2U);
    EXPECT_EQ(fragments.all[1].crystals, 1U);
    EXPECT_EQ(count_split_crystals(b.specimen, b.state), 1U);
    std::ostringstream out;
    write_crystals(out, crystals, TableFormat::tsv);
    EXPECT_EQ(test::field(out.str(), "tensile_cracks_within"), "1");
    EXPECT_EQ(test::field(out.str(), "pieces"), "2");
}

TEST(CrackedCrystals, AreCountedOnceForEachMode) {
    const Broken b;
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks).tensile, 1);
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks).shear, 0) << "the crack in shear is between two crystals";
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks, 0.5).tensile, 0) << "before the first crack";
    const RunClasses classes = classes_of_run("run", b.specimen, b.cracks, {}, 0.5);
    ASSERT_TRUE(classes.crystals.has_value());
    EXPECT_EQ(classes.crystals->contacts, 2U);
    EXPECT_DOUBLE_EQ(classes.crystals->at_peak.value().tensile, 0);
    EXPECT_DOUBLE_EQ(classes.crystals->at_end.tensile, 1);
}

TEST(CrackedCrystals, WithoutThemEachGrainIsOne) {
    Broken b;
    b.specimen.grain_crystal.clear();
    b.state.assign(b.specimen.n_contacts(), {separated, separated});
    const auto crystals = find_crystals(b.specimen, b.cracks, b.state, find_fragments(b.specimen, b.state));
    ASSERT_EQ(crystals.size(), 4U);
    EXPECT_DOUBLE_EQ(crystals[0].around.tensile, 1);
    EXPECT_EQ(crystals[0].pieces, 1U);
    EXPECT_EQ(count_split_crystals(b.specimen, b.state), 0U);
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks).tensile, 0);
    EXPECT_FALSE(classes_of_run("run", b.specimen, b.cracks, {}, {}).crystals.has_value());
}

}  // namespace
}  // namespace graincrack
