#include "share/file/platen_faces.hpp"

#include <gtest/gtest.h>

#include "share/file/h5_file.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

TEST(PlatenFaces, AreReadAsTheyWereWritten) {
    const test::TemporaryFolder folder;
    const PlatenFaceSet rollers{1.2, {{-1, -0.021, -0.019, -0.01}, {-1, 0.019, 0.021, -0.01}, {1, -0.001, 0.001, 0.01}}};
    test::write_run(folder.file("run.h5"), {});
    const auto read = [&](const std::string& name) {
        const RunReader run(folder.file(name));
        return read_platen_faces(run.file(), run.specimen());
    };
    EXPECT_EQ(read("run.h5").faces, (std::vector<PlatenFace>{{-1, -0.04, 0.04, -0.08}, {1, -0.04, 0.04, 0.08}}));
    RunWriter writer(H5Output(folder.file("rollers.h5"), "run"), test::Recipe{}.specimen, test::synthetic_header({}));
    writer.append_history(test::synthetic_history({}));
    write_platen_faces(writer.file(), rollers);
    writer.finish(test::synthetic_header({}), {}, {});
    EXPECT_EQ(read("rollers.h5").faces, rollers.faces);
    EXPECT_EQ(read("rollers.h5").direction, 1.2);
}

TEST(PlatenFaces, HaveBarsThatLieOutsideAndMoveInwards) {
    const PlatenFaceSet upright{std::numbers::pi / 2, {}};
    using Corners = std::array<std::array<double, 2>, 4>;
    EXPECT_EQ(upright.bar({1, -1, 2, 5}, 0.5, 0.25), (Corners{{{-1, 4.75}, {2, 4.75}, {2, 5.25}, {-1, 5.25}}}));
    EXPECT_EQ(upright.bar({-1, -1, 2, -5}, 0.5, 0.25), (Corners{{{-1, -4.75}, {2, -4.75}, {2, -5.25}, {-1, -5.25}}}));
    EXPECT_EQ(upright.displacement({-1, -1, 2, -5}, 0.25), (std::array{0.0, 0.25}));
    const PlatenFaceSet level{0, {}};  // across is upwards then
    EXPECT_EQ(level.bar({1, -1, 2, 5}, 0.5, 0), (Corners{{{5, -1}, {5, 2}, {5.5, 2}, {5.5, -1}}}));
}

}  // namespace
}  // namespace graincrack
