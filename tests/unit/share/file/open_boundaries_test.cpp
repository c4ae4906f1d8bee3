#include "share/file/specimen_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "share/file/h5_file.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

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
    EXPECT_EQ(open_boundaries_text(s), "1 of 3, 0.2612 of their length");  // 1/(1 + 2√2)
    // Flaws and what is within crystals do not count.
    s.contact_kind[(upright + 1) % 3] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
    s.contact_kind[(upright + 2) % 3] = static_cast<std::uint8_t>(ContactKind::within_crystal);
    EXPECT_EQ(open_boundaries_text(s), "1 of 1, 1.0000 of their length");
}

TEST(OpenBoundaries, KeepTheirKindInAFileThatOthersDoNotName) {
    const test::TemporaryFolder folder;
    Specimen s = test::one_diagonal_grid(2, 1, 0.02, 0.01);
    const auto written = [&](const char* name) {
        H5Output out(folder.file(name), "specimen");
        write_specimen(out, s);
        out.commit();
        return H5Input(folder.file(name), "specimen").attribute<std::vector<std::string>>("/contacts/kind", "names");
    };
    EXPECT_EQ(written("closed.h5"), (std::vector<std::string>{"grain boundary", "pre-existing crack"}));
    s.contact_kind[1] = static_cast<std::uint8_t>(ContactKind::open_boundary);
    EXPECT_EQ(written("open.h5"),
              (std::vector<std::string>{"grain boundary", "pre-existing crack", "within a crystal", "open boundary"}));
    EXPECT_EQ(read_specimen(H5Input(folder.file("open.h5"), "specimen")).contact_kind, s.contact_kind);
}

}  // namespace
}  // namespace graincrack
