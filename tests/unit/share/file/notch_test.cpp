#include "share/file/specimen_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/specimens.hpp"

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

}  // namespace
}  // namespace graincrack
