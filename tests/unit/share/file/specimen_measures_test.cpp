#include "share/file/specimen_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "share/file/h5_file.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

Specimen notched(double from, double to) {
    Specimen s = test::union_jack_grid(8, 4, 0.08, 0.04);
    test::break_contacts(s, [=](double x, double y) { return std::abs(x) < 1e-9 && y > from - 1e-9 && y < to + 1e-9; });
    return s;
}

TEST(EdgeNotch, ReachesFromTheLowerRimToItsTip) {
    EXPECT_FALSE(edge_notch(notched(1, 1)));
    EXPECT_FALSE(edge_notch(notched(-0.01, 0.01)));
    Specimen s = notched(-0.02, 0);
    test::break_contacts(s, [](double x, double y) { return std::abs(x) < 1e-9 && y > 0.01 - 1e-9; });  // a flaw above
    const auto notch = edge_notch(s);
    ASSERT_TRUE(notch);
    EXPECT_NEAR(notch->length(), 0.02, 1e-12);
    EXPECT_NEAR(notch->tip[0], 0, 1e-12);
}

// Flat poles of a disc are parts bottom and top, and yet it is loaded along its diameter.
TEST(EndFaces, AreAtLeastHalfAsWideAsTheSpecimen) {
    Specimen s = test::union_jack_grid(8, 4, 0.08, 0.04);
    EXPECT_TRUE(has_end_faces(s));
    EXPECT_EQ(loaded_width(s), 0.08);
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        const double x = s.node_position[static_cast<std::size_t>(s.boundary_edges[e][0])][0] +
                         s.node_position[static_cast<std::size_t>(s.boundary_edges[e][1])][0];
        if (std::abs(x) > 0.02) s.boundary_part[e] = static_cast<std::uint8_t>(BoundaryPart::rim);
    }
    EXPECT_NEAR(width_of_part(s, BoundaryPart::top), 0.02, 1e-12);
    EXPECT_FALSE(has_end_faces(s));
    EXPECT_EQ(loaded_width(s), 0.04);
}

// Two squares of two triangles each, 1 cm wide: two diagonals and the side between the squares.
TEST(OpenBoundaries, AreCountedByCrystalsAndLength) {
    Specimen s = test::one_diagonal_grid(2, 1, 0.02, 0.01);
    ASSERT_EQ(s.n_contacts(), 3U);
    EXPECT_EQ(open_boundaries_text(s), "");
    std::size_t upright = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        if (std::abs(contact_length(s, c) - 0.01) < 1e-9) upright = c;
    }
    s.contact_kind[upright] = static_cast<std::uint8_t>(ContactKind::open_boundary);
    const std::string one_of_three = open_boundaries_text(s);  // 1/(1 + 2√2) of their length
    // Flaws and what is within crystals do not count.
    s.contact_kind[(upright + 1) % 3] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    s.contact_kind[(upright + 2) % 3] = static_cast<std::uint8_t>(ContactKind::within_crystal);
    test::expect_golden(one_of_three + "\n" + open_boundaries_text(s));
}

TEST(Flaws, AreCountedByClassWhetherTheyAreBrokenOrIntact) {
    Specimen s = test::one_diagonal_grid(3, 1, 0.03, 0.01);
    EXPECT_EQ(flaws_text(s), "");
    s.flaw_names = {"joint", "vein"};
    s.contact_flaw.assign(s.n_contacts(), 0);
    std::vector<std::size_t> diagonals;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        if (contact_length(s, c) > 0.011) diagonals.push_back(c);
    }
    ASSERT_EQ(diagonals.size(), 3U);
    s.contact_flaw[diagonals[0]] = s.contact_flaw[diagonals[1]] = 2;
    std::string text = flaws_text(s) + "\n";
    s.contact_kind[diagonals[1]] = s.contact_kind[diagonals[2]] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    text += flaws_text(s) + "\n";
    s.contact_kind[diagonals[0]] = static_cast<std::uint8_t>(ContactKind::within_crystal);  // whose class is no flaw
    test::expect_golden(text + flaws_text(s));
}

TEST(OpenBoundaries, AreAKindThatFilesNameIfThereAreAny) {
    const test::TemporaryFolder folder;
    Specimen s = test::one_diagonal_grid(2, 1, 0.02, 0.01);
    const auto kinds = [&](const char* name) {
        H5Output out(folder.file(name), "specimen");
        write_specimen(out, s);
        out.commit();
        return H5Input(folder.file(name), "specimen").attribute<std::vector<std::string>>("/contacts/kind", "names").size();
    };
    EXPECT_EQ(kinds("closed.h5"), 2U);
    s.contact_kind[1] = static_cast<std::uint8_t>(ContactKind::open_boundary);
    EXPECT_EQ(kinds("open.h5"), 4U);
    EXPECT_EQ(read_specimen(H5Input(folder.file("open.h5"), "specimen")).contact_kind, s.contact_kind);
}

}  // namespace
}  // namespace graincrack
