#include "mesher/fabric/crystals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "share/file/specimen.hpp"
#include "share/file/specimen_measures.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::mesher {
namespace {

/// Two squares of two triangles each, of quartz and mica. \return the crystal of each grain
std::vector<int> make_crystals(Specimen& s) {
    s = test::one_diagonal_grid(2, 1, 0.02, 0.01);
    s.phase_names = {"quartz", "mica"};
    const auto centre = [&](std::size_t g) {
        double x = 0;
        for (const std::int32_t node : s.element_nodes[g]) x += s.node_position[static_cast<std::size_t>(node)][0] / 3;
        return x;
    };
    std::vector<int> crystals;
    for (std::size_t g = 0; g < s.n_grains(); ++g) crystals.push_back(centre(g) < 0 ? 0 : 1);
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = static_cast<std::uint8_t>(crystals[g]);
    return crystals;
}

TEST(Crystals, ContactsWithinThemAreOfTheClassOfTheirPhase) {
    Specimen s;
    const std::vector<int> crystals = make_crystals(s);
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

TEST(Crystals, FlawsWithinThemStayFlaws) {
    Specimen s;
    const std::vector<int> crystals = make_crystals(s);
    s.flaw_names = {"joint"};
    s.contact_flaw.assign(s.n_contacts(), 1);
    s.contact_kind.assign(s.n_contacts(), static_cast<std::uint8_t>(ContactKind::pre_existing_crack));
    name_crystals(s, crystals);
    validate(s, "s.h5");
    EXPECT_EQ(s.contact_flaw, (std::vector<std::uint8_t>{1, 1, 1}));
    for (const std::uint8_t kind : s.contact_kind) EXPECT_EQ(kind, static_cast<std::uint8_t>(ContactKind::pre_existing_crack));
}

TEST(Crystals, FewAcrossASpecimenAreNoted) {
    // Triangles of a grid of n columns have the diameter of half a square: 0.8 of its side.
    const Specimen many = test::one_diagonal_grid(9, 18, 0.09, 0.18);
    EXPECT_EQ(note_on_few_crystals(many), "");
    Specimen few = test::one_diagonal_grid(7, 14, 0.07, 0.14);
    few.tessellation = "delaunay";
    EXPECT_EQ(
        note_on_few_crystals(few),
        "8.8 grains of the mean diameter across the smaller extent of 70 mm: with fewer than 10 a strength depends on single "
        "grains and is no material's");
    // Pairs of triangles are crystals of a square.
    Specimen pairs = test::one_diagonal_grid(9, 18, 0.09, 0.18);
    for (std::size_t g = 0; g < pairs.n_grains(); ++g) pairs.grain_crystal.push_back(static_cast<std::int32_t>(g / 2));
    EXPECT_EQ(number_of_crystals(pairs), pairs.n_grains() / 2);
    EXPECT_EQ(note_on_few_crystals(pairs).substr(0, 12), "8 crystals o");
}

TEST(Crystals, ContactsOnFlawsKeepTheirClass) {
    Specimen s;
    const std::vector<int> crystals = make_crystals(s);
    s.flaw_names = {"joint", "vein"};
    s.contact_flaw.assign(s.n_contacts(), 0);
    const auto nodes = grain_of_nodes(s);
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto crystal_at = [&](std::size_t k) {
            return crystals[static_cast<std::size_t>(nodes[static_cast<std::size_t>(s.contact_nodes[c][k])])];
        };
        if (crystal_at(0) != crystal_at(2)) s.contact_flaw[c] = 2;
    }
    name_crystals(s, crystals);
    validate(s, "s.h5");
    EXPECT_EQ(s.flaw_names, (std::vector<std::string>{"joint", "vein", "within_quartz", "within_mica"}));
    std::vector<std::uint8_t> classes = s.contact_flaw;
    std::sort(classes.begin(), classes.end());
    EXPECT_EQ(classes, (std::vector<std::uint8_t>{2, 3, 4}));
}

}  // namespace
}  // namespace graincrack::mesher
