#include "mesher/fabric/crystals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "share/file/specimen.hpp"
#include "share/file/specimen_measures.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/specimens.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

constexpr auto crack = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
constexpr auto within = static_cast<std::uint8_t>(ContactKind::within_crystal);

/// Two squares of two triangles each, of quartz and mica. \return the crystal of each grain
std::vector<int> make_crystals(Specimen& s) {
    s = test::one_diagonal_grid(2, 1, 0.02, 0.01);
    s.phase_names = {"quartz", "mica"};
    std::vector<int> crystals;
    for (std::size_t g = 0; g < s.n_grains(); ++g) {
        Point sum;
        for (const std::int32_t node : s.element_nodes[g]) sum = sum + place_of(s, node);
        crystals.push_back(sum.x < 0 ? 0 : 1);
        s.grain_phase[g] = static_cast<std::uint8_t>(crystals[g]);
    }
    return crystals;
}

/// Classes or kinds of contacts, the lowest first.
std::vector<std::uint8_t> sorted(std::vector<std::uint8_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

TEST(CrystalNames, GiveContactsWithinThemTheClassOfTheirPhase) {
    Specimen s;
    const std::vector<int> crystals = make_crystals(s);
    name_crystals(s, crystals);
    validate(s, "s.h5");
    EXPECT_EQ(s.flaw_names, (std::vector<std::string>{"within_quartz", "within_mica"}));
    EXPECT_EQ(s.grain_crystal.size(), 4U);
    EXPECT_EQ(sorted(s.contact_kind), (std::vector<std::uint8_t>{0, within, within}));
    EXPECT_EQ(sorted(s.contact_flaw), (std::vector<std::uint8_t>{0, 1, 2}));
    EXPECT_EQ(phase_of_within_class("within_quartz"), "quartz");
    EXPECT_EQ(phase_of_within_class("joint"), "");
}

TEST(CrystalNames, LeaveContactsOnFlawsTheirClassAndKind) {
    for (const bool are_flaws_within : {true, false}) {
        Specimen s;
        const std::vector<int> crystals = make_crystals(s);
        s.flaw_names = {"joint", "vein"};
        s.contact_flaw.assign(s.n_contacts(), 0);
        const auto between = crystals_of_contacts(s, crystals);
        for (std::size_t c = 0; c < s.n_contacts(); ++c) {
            if (!are_flaws_within && between[c].first == between[c].second) continue;
            s.contact_flaw[c] = 2;
            s.contact_kind[c] = crack;
        }
        name_crystals(s, crystals);
        validate(s, "s.h5");
        EXPECT_EQ(s.flaw_names, (std::vector<std::string>{"joint", "vein", "within_quartz", "within_mica"}));
        using Numbers = std::vector<std::uint8_t>;
        EXPECT_EQ(sorted(s.contact_flaw), are_flaws_within ? (Numbers{2, 2, 2}) : (Numbers{2, 3, 4}));
        EXPECT_EQ(sorted(s.contact_kind), are_flaws_within ? (Numbers{crack, crack, crack}) : (Numbers{crack, within, within}));
    }
}

TEST(FewCrystals, AreNotedAcrossASpecimen) {
    // Triangles of a grid of n columns have the diameter of half a square: 0.8 of its side.
    const Specimen many = test::one_diagonal_grid(9, 18, 0.09, 0.18);
    EXPECT_EQ(note_on_few_crystals(many), "");
    Specimen few = test::one_diagonal_grid(7, 14, 0.07, 0.14);
    few.tessellation = "delaunay";
    // Pairs of triangles are crystals of a square.
    Specimen pairs = many;
    for (std::size_t g = 0; g < pairs.n_grains(); ++g) pairs.grain_crystal.push_back(static_cast<std::int32_t>(g / 2));
    EXPECT_EQ(number_of_crystals(pairs), pairs.n_grains() / 2);
    test::expect_golden(note_on_few_crystals(few) + "\n" + note_on_few_crystals(pairs));
}

}  // namespace
}  // namespace graincrack::mesher
