#include "mesher/region/region_files.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "share/base/error.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::mesher {
namespace {

/// What is read of a file of this text.
template <class Read>
auto read_text(const Read& read, const std::string& text) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("table.tsv")) << text;
    return read(folder.file("table.tsv"));
}

TEST(RegionFiles, HaveTheCornersAndPartsOfPolygons) {
    const Region region =
        read_text(read_polygon, "# a triangle, clockwise\nx_mm\ty_mm\tpart\n0\t0\tleft\n0\t20\t\n40\t0\tbottom\n0\t0\t\n");
    ASSERT_EQ(region.loops.size(), 1U);
    EXPECT_EQ(region.loops[0].corners.size(), 3U) << "the first corner again at the end is none";
    EXPECT_NEAR(area(region), 0.5 * 0.02 * 0.04, 1e-15);
}

TEST(RegionFiles, HaveTheCentresAndRadiiOfHoles) {
    const std::vector<Hole> holes = read_text(read_holes, "x_mm\ty_mm\tradius_mm\n1\t-2\t3\n4\t5\t6.5\n");
    ASSERT_EQ(holes.size(), 2U);
    EXPECT_NEAR(holes[0].centre.y, -0.002, 1e-15);
    EXPECT_NEAR(holes[1].radius, 0.0065, 1e-15);
}

TEST(RegionFiles, HaveTheEndsClassAndStateOfFlaws) {
    const std::string header = "x1_mm\ty1_mm\tx2_mm\ty2_mm\tclass\tstate\n";
    const auto kind = [&](const std::string& text) {
        const auto flaws = read_text(read_flaws, header + "0\t0\t4\t3\t" + text + "\n");
        EXPECT_NEAR(length(flaws.at(0).to - flaws[0].from), 0.005, 1e-15);
        return flaws[0].kind;
    };
    EXPECT_EQ(kind("\t"), FlawKind(ContactKind::pre_existing_crack));
    EXPECT_EQ(kind("\tintact"), FlawKind(ContactKind::grain_boundary));
    EXPECT_EQ(kind("broken\t"), FlawKind(ContactKind::pre_existing_crack));
    EXPECT_EQ(kind("intact\t"), FlawKind(ContactKind::grain_boundary));
    EXPECT_EQ(kind("joint\t"), FlawKind(ContactKind::grain_boundary, "joint"));
    EXPECT_EQ(kind("joint\tbroken"), FlawKind(ContactKind::pre_existing_crack, "joint"));
}

TEST(RegionFiles, AreRefusedInOneLine) {
    test::Refusals refused;
    const auto add = [&](const std::string& what, const auto& read, const std::string& text) {
        refused.add<InputError>(what, [&] { read_text(read, text); });
    };
    add("sides that cross", read_polygon, "x_mm\ty_mm\n0\t0\n10\t10\n10\t0\n0\t10\n");
    add("a corner that is no number", read_polygon, "x_mm\ty_mm\n0\t0\n10\tten\n10\t0\n");
    add("corners without y", read_polygon, "x_mm\n0\n");
    add("a radius of 0", read_holes, "x_mm\ty_mm\tradius_mm\n1\t2\t0\n");
    const std::string header = "x1_mm\ty1_mm\tx2_mm\ty2_mm\tclass\tstate\n";
    for (const std::string kind : {"broken\tintact", "Joint\t", "joint\thealed"}) {
        add("a kind of flaw that is none", read_flaws, header + "0\t0\t4\t3\t" + kind + "\n");
    }
    add("a flaw without a length", read_flaws, header + "4\t3\t4\t3\t\t\n");
    test::expect_golden(refused.text());
}

}  // namespace
}  // namespace graincrack::mesher
