#include "mesher/import/labels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "mesher/import/label_pieces.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "share/base/error.hpp"
#include "tests/unit/mesher/import/png_writer.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

/// A picture as text, from the label of each pixel.
template <class LabelOf>
std::string picture(int width, int height, const LabelOf& label_of) {
    std::string text;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) text += std::to_string(label_of(column, row)) + '\t';
        text += '\n';
    }
    return text;
}

LabelOptions options_of(int smallest_piece = 10) { return {.pixel_size = 1, .smallest_piece = smallest_piece}; }

Point at(const ImportedMesh& mesh, int p) { return mesh.points[index(p)]; }

double area_at(const ImportedMesh& mesh, const Triangle& t) {
    return signed_area(at(mesh, t[0]), at(mesh, t[1]), at(mesh, t[2]));
}

std::vector<double> grain_areas(const ImportedMesh& mesh) {
    std::vector<double> areas(mesh.phase_of_grain.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        areas[index(mesh.grain_of_triangle[i])] += area_at(mesh, mesh.triangles[i]);
    }
    return areas;
}

/// Whether triangles are counter-clockwise, fill the picture and share their sides, and no grain meets itself in a point.
void expect_conforming(const ImportedMesh& mesh, double width, double height, const std::string& what) {
    std::map<std::pair<int, int>, int> grain_of_side;
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Triangle& t = mesh.triangles[i];
        ASSERT_GT(area_at(mesh, t), 0) << what;
        area += area_at(mesh, t);
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_TRUE(grain_of_side.emplace(std::pair{t[k], t[(k + 1) % 3]}, mesh.grain_of_triangle[i]).second) << what;
        }
    }
    EXPECT_NEAR(area, width * height, 1e-12 * width * height) << what;
    double outline = 0;
    std::map<std::pair<int, int>, int> ends;  // of the boundary of a grain, at a point
    for (const auto& [side, grain] : grain_of_side) {
        const auto other = grain_of_side.find({side.second, side.first});
        if (other == grain_of_side.end()) outline += length(at(mesh, side.second) - at(mesh, side.first));
        if (other != grain_of_side.end() && other->second == grain) continue;
        ++ends[{side.first, grain}];
    }
    EXPECT_NEAR(outline, 2 * (width + height), 1e-12 * (width + height)) << what;
    for (const auto& [end, n] : ends) ASSERT_EQ(n, 1) << what << ": grain " << end.second << " meets itself in a point";
    std::set<int> grains(mesh.grain_of_triangle.begin(), mesh.grain_of_triangle.end());
    EXPECT_EQ(grains.size(), mesh.phase_of_grain.size()) << what;
    EXPECT_EQ(*grains.begin(), 0);
    EXPECT_EQ(*grains.rbegin() + 1, static_cast<int>(grains.size()));
}

TEST(Labels, StandUprightInMetres) {
    const LabelOptions options{
        .pixel_size = 5e-6, .smallest_piece = 1, .phases = {{{7, "quartz"}, {9, "mica"}, {8, "feldspar"}}, {}}};
    const ImportedMesh mesh = import_labels(picture(4, 2, [](int, int row) { return row == 0 ? 7 : 8; }), options, "section");
    EXPECT_EQ(mesh.phase_of_grain, (std::vector<std::string>{"quartz", "feldspar"}));
    test::expect_golden(mesh.format + "\n" + text_of(mesh.notes));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Point sum;
        for (const int p : mesh.triangles[i]) sum = sum + at(mesh, p);
        EXPECT_EQ(sum.y > 3 * 5e-6, mesh.grain_of_triangle[i] == 0) << "the first row is the top";
    }
}

TEST(Labels, MakeASlantedBoundaryStraight) {
    // Its ends are corners of pixels, at most 0.5 pixels from the line; nothing between may lie farther off.
    for (const double slope : {0.05, 0.37, 0.9, 2.4}) {
        const auto height_at = [&](double x) { return 50 + slope * (x - 50); };
        const ImportedMesh mesh =
            import_labels(picture(100, 100, [&](int column, int row) { return height_at(column + 0.5) > 99.5 - row ? 1 : 2; }),
                          options_of(), "");
        expect_conforming(mesh, 100, 100, "slant");
        std::map<int, std::set<int>> grains_of_point;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            for (const int p : mesh.triangles[i]) grains_of_point[p].insert(mesh.grain_of_triangle[i]);
        }
        std::erase_if(grains_of_point, [](const auto& point) { return point.second.size() < 2; });
        EXPECT_GE(grains_of_point.size(), 3U);
        for (const auto& [p, grains] : grains_of_point) {
            EXPECT_LT(std::abs(at(mesh, p).y - height_at(at(mesh, p).x)) / std::hypot(1, slope), 0.5) << slope;
        }
    }
}

TEST(Labels, KeepTheAreaOfACircle) {
    for (const double radius : {6.0, 15.0, 30.0}) {
        int pixels = 0;
        const auto inside = [&](int column, int row) {
            const bool is_in = std::hypot(column + 0.5 - 40, row + 0.5 - 40) < radius;
            pixels += is_in ? 1 : 0;
            return is_in ? 1 : 0;
        };
        const ImportedMesh mesh = import_labels(picture(80, 80, inside), options_of(), "");
        expect_conforming(mesh, 80, 80, "circle");
        const std::vector<double> areas = grain_areas(mesh);
        ASSERT_EQ(areas.size(), 2U);
        EXPECT_NEAR(areas[1] / pixels, 1, 0.005) << radius;
    }
}

TEST(Labels, MakeGrainsOfPiecesAndJoinSmallOnes) {
    const ImportedMesh mesh = import_labels(
        picture(20, 10, [](int column, int row) { return column == 3 && row == 4 ? 9 : (column < 8 || column > 12 ? 1 : 2); }),
        options_of(), "");
    EXPECT_EQ(mesh.phase_of_grain.size(), 3U);
    test::expect_golden(text_of(mesh.notes));
    expect_conforming(mesh, 20, 10, "pieces");
}

TEST(Labels, MakeConformingMeshesOfOddPictures) {
    const auto modulo = [](int n) { return [n](int column, int row) { return (column + row) % n; }; };
    const std::vector<std::pair<std::string, std::string>> pictures{
        {"one pixel", "7"},
        {"one row", picture(30, 1, [](int column, int) { return column; })},
        {"one column", picture(1, 30, [](int, int row) { return row / 2; })},
        {"one label", picture(30, 10, [](int, int) { return 3; })},
        {"a long row", picture(300, 1, [](int, int) { return 3; })},
        {"stripes", picture(20, 30, [](int column, int) { return column; })},
        {"checkerboard", picture(12, 12, modulo(2))},
        {"diagonals", picture(12, 12, modulo(3))},
        {"enclosed pixel", picture(3, 3, [](int column, int row) { return column == 1 && row == 1 ? 1 : 0; })},
        {"enclosed grain",
         picture(20, 20, [](int column, int row) { return std::abs(column - 9) + std::abs(row - 9) < 6 ? 1 : 0; })},
        {"nested", picture(21, 21, [](int column, int row) { return std::max(std::abs(column - 10), std::abs(row - 10)); })},
        {"ring that meets itself", "0 0 0 0 0\n0 1 1 0 0\n0 1 2 1 0\n0 1 1 1 0\n0 0 0 0 0\n"},
        {"ring that meets itself twice", "0 0 0 0 0 0\n0 1 1 1 0 0\n0 1 2 0 1 0\n0 1 0 2 1 0\n0 0 1 1 1 0\n0 0 0 0 0 0\n"},
        {"spiral", "1 1 1 1 1\n2 2 2 2 1\n1 1 1 2 1\n1 2 2 2 1\n1 1 1 1 1\n"},
    };
    for (const auto& [what, text] : pictures) {
        const LabelImage image = read_label_image(text, what);
        for (const int smallest_piece : {1, 4}) {
            for (const double element : {0.0, 0.7, 4.0, 500.0}) {
                LabelOptions options = options_of(smallest_piece);
                if (element > 0) options.element_size = element;
                expect_conforming(import_labels(text, options, what), image.width, image.height, what);
            }
        }
    }
}

/// Grains of points at random: each pixel belongs to the nearest.
std::string cells_picture(int size, int n, std::uint64_t seed) {
    RandomNumbers random(seed);
    std::vector<Point> points(static_cast<std::size_t>(n));
    for (Point& p : points) p = {size * random.uniform(), size * random.uniform()};
    return picture(size, size, [&](int column, int row) {
        const Point pixel{column + 0.5, row + 0.5};
        const auto nearest = std::min_element(points.begin(), points.end(), [&](Point a, Point b) {
            return squared_length(a - pixel) < squared_length(b - pixel);
        });
        return nearest - points.begin();
    });
}

TEST(Labels, KeepTheAreasOfGrainsAndMakeGoodTriangles) {
    const std::string text = cells_picture(200, 60, 3);
    const LabelPieces pieces = label_pieces(read_label_image(text, ""), 10, "");
    const ImportedMesh mesh = import_labels(text, options_of(), "");
    expect_conforming(mesh, 200, 200, "grains");
    const std::vector<double> areas = grain_areas(mesh);
    ASSERT_EQ(areas.size(), pieces.size());
    for (std::size_t i = 0; i < areas.size(); ++i) {
        // Junctions that became one move by up to a pixel at a boundary of ten to twenty.
        EXPECT_NEAR(areas[i] / pieces.pixels_of_piece[i], 1, 0.05) << pieces.pixels_of_piece[i] << " pixels";
    }
    double sum = 0;
    double smallest = 180;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point a = at(mesh, t[(k + 1) % 3]) - at(mesh, t[k]);
            const Point b = at(mesh, t[(k + 2) % 3]) - at(mesh, t[k]);
            sum += length(a);
            smallest = std::min(smallest, std::atan2(cross(a, b), dot(a, b)) * 180 / std::numbers::pi);
        }
    }
    EXPECT_GT(smallest, 15);
    const double requested = std::sqrt(4 / std::numbers::pi * 200 * 200 / static_cast<double>(pieces.size())) / 3;
    EXPECT_NEAR(sum / (3 * static_cast<double>(mesh.triangles.size())), requested, 0.15 * requested);
}

TEST(Labels, AreTheSameOfAPngAndItsText) {
    std::vector<int> samples;
    const std::string text = picture(30, 20, [&](int column, int row) {
        samples.push_back(column + row < 25 ? 300 : 4);
        return samples.back();
    });
    const ImportedMesh of_text = import_labels(text, options_of(), "");
    const ImportedMesh of_png = import_labels(png_of(30, 20, samples, {PNG_COLOR_TYPE_GRAY, 16}), options_of(), "");
    test::expect_golden(of_png.format);
    EXPECT_EQ(of_png.points, of_text.points);
    EXPECT_EQ(of_png.triangles, of_text.triangles);
}

/// A PNG of a red and a white half, or of two of them and a third colour, whose slanted boundary is soft.
std::string soft_picture(int third) {
    std::vector<int> samples;
    for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 60; ++column) {
            const double share = std::clamp(column - 25.3 - row / 6.0, 0.0, 1.0);
            const int soft = static_cast<int>(std::lround(48 + share * 207));
            const bool is_third = third != 0 && row > 30;
            samples.insert(samples.end(), {is_third ? third : static_cast<int>(std::lround(192 + share * 63)), soft, soft});
        }
    }
    return png_of(60, 40, samples, {PNG_COLOR_TYPE_RGB, 8});
}

TEST(Labels, HaveTheNearestColourOfTheKeyAtSoftEdges) {
    LabelOptions options = options_of();
    options.phases.by_colour = {{0xc03030, "quartz"}, {0xffffff, "mica"}, {0xe09898, "of_the_edge_alone"}};
    const ImportedMesh mesh = import_labels(soft_picture(0), options, "");
    ASSERT_EQ(mesh.labels.size(), 2U);  // not the third, of which the soft edge has a pixel somewhere
    EXPECT_EQ(mesh.labels[0].phase, "mica");
    EXPECT_EQ(mesh.labels[1].phase, "quartz");
    EXPECT_EQ(mesh.phase_of_grain.size(), 2U);
    test::expect_golden(text_of(mesh.notes));
}

TEST(Labels, AreRefusedInOneLine) {
    test::Refusals refused;
    LabelOptions options = options_of();
    options.phases.by_number = {{7, "quartz"}};
    refused.add<InputError>("a label without a phase", [&] { import_labels("7\n8\n", options, "section.tsv"); });
    options.phases = {{}, {{0xc03030, "quartz"}, {0xffffff, "mica"}}};
    refused.add<InputError>("a colour that the key lacks", [&] { import_labels(soft_picture(90), options, "minerals.png"); });
    std::vector<int> samples;
    for (int i = 0; i < 3 * 30 * 30; ++i) samples.push_back(i * i % 251);
    const std::string photo = png_of(30, 30, samples, {PNG_COLOR_TYPE_RGB, 8});
    refused.add<InputError>("a photo", [&] { import_labels(photo, options_of(), "photo.png"); });
    options = options_of();
    options.element_size = 1e-6;
    refused.add<InputError>("elements of 1 um", [&] { import_labels("1 2", options, "section.tsv"); });
    test::expect_golden(refused.text());
}

}  // namespace
}  // namespace graincrack::mesher
