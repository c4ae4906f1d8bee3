#include "mesher/import/import_specimen.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <tuple>

#include "mesher/import/gmsh.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/rows.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/mesher/import/mesh_files.hpp"

namespace graincrack::mesher {
namespace {

using Names = std::vector<std::string>;

TEST(MeshFile, IsTheSameMeshInEachFormat) {
    const Names minerals{"quartz", "feld_spar"};
    for (const auto& [bytes, name, phases, n_lines] :
         {std::tuple(msh_22, "MSH 2.2", minerals, 2U), std::tuple(msh_41, "MSH 4.1", minerals, 2U),
          std::tuple(neper_msh, "Neper", Names{"group_1", "group_2"}, 0U)}) {
        SCOPED_TRACE(name);
        const ImportedMesh mesh = read_mesh(bytes);
        test::expect_golden(mesh.format, name);
        ASSERT_EQ(mesh.triangles.size(), 4U);
        EXPECT_EQ(mesh.grain_of_triangle, (std::vector<int>{0, 0, 1, 1}));
        EXPECT_EQ(mesh.phase_of_grain, phases);
        Point centres[2];  // of two triangles each
        for (std::size_t t = 0; t < 4; ++t) {
            const auto at = [&](std::size_t k) { return mesh.points[index(mesh.triangles[t][k])]; };
            centres[t / 2] = centres[t / 2] + (1.0 / 6) * (at(0) + at(1) + at(2));
            EXPECT_DOUBLE_EQ(std::abs(signed_area(at(0), at(1), at(2))), 0.5);
        }
        EXPECT_DOUBLE_EQ(centres[0].x, 0.5);
        EXPECT_DOUBLE_EQ(centres[1].x, 1.5);
        ASSERT_EQ(mesh.lines.size(), n_lines);
        if (mesh.lines.empty()) continue;
        EXPECT_EQ(mesh.lines[0].name, "crack");
        EXPECT_EQ(mesh.lines[1].name, "loaded");
        EXPECT_EQ(mesh.points[index(mesh.lines[0].from)], (Point{1, 0}));
        EXPECT_EQ(mesh.points[index(mesh.lines[1].to)], (Point{2, 1}));
    }
}

TEST(MeshFile, HasGrainsOfElementsEntitiesOrPhysicalGroups) {
    ImportRequest request{.grains = GrainChoice::element};
    EXPECT_EQ(read_mesh(msh_22, request).grain_of_triangle, (std::vector<int>{0, 1, 2, 3}));
    request.grains = GrainChoice::physical;
    const std::string one_entity = std::regex_replace(msh_22, std::regex("2 2 2 9"), "2 2 2 7");
    EXPECT_EQ(read_mesh(one_entity, request).grain_of_triangle, (std::vector<int>{0, 0, 1, 1}));
    test::Refusals refused;
    refused.add<InputError>("groups of Neper", [&] { read_mesh(neper_msh, request); });
    request.grains = GrainChoice::entity;
    refused.add<InputError>("an entity of two phases", [&] { read_mesh(one_entity, request); });
    test::expect_golden(refused.text(), "refused");
    request.grains.reset();
    const ImportedMesh told = read_mesh(one_entity, request);
    EXPECT_EQ(told.grain_of_triangle, (std::vector<int>{0, 1, 2, 3}));
    test::expect_golden(told.notes.front().text);
}

TEST(MeshFile, HasThePhasesOfAKey) {
    const test::TemporaryFolder folder;
    const auto phases = [&](const std::string& key, const std::string& bytes) {
        std::ofstream(folder.file("key.tsv")) << key;
        return read_mesh(bytes, {.phase_key = folder.file("key.tsv")}).phase_of_grain;
    };
    for (const auto& [key, bytes] : {std::pair{"key\tphase\nQuartz\tq\nfeld spar\tf\n", msh_22},
                                     {"key\tphase\n1\tq\n2\tf\n", msh_41},
                                     {"2\tf\n1\tq\n", neper_msh}}) {
        EXPECT_EQ(phases(key, bytes), (Names{"q", "f"})) << key;
    }
}

TEST(MeshFile, DividesQuadranglesAlongTheirShorterInnerDiagonal) {
    const auto triangles = [](const std::string& third) {
        return read_mesh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 2 0 0\n3 " + third +
                         " 0\n4 0 2 0\n$EndNodes\n$Elements\n1\n1 3 2 0 1 1 2 3 4\n$EndElements\n")
            .triangles;
    };
    EXPECT_EQ(triangles("1.5 1.5"), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(triangles("2.5 2.5"), (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(triangles(".5 .5"), (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));  // not convex at 3
}

TEST(MeshFile, HasGrainsOfTheElementsOfPictures) {
    const test::TemporaryFolder folder;
    ImportRequest request{
        .grains = GrainChoice::element, .phase_key = folder.file("key.tsv"), .labels = {.pixel_size = 1, .smallest_piece = 1}};
    std::ofstream(request.phase_key) << "5\ta\n6\tb\n";
    const ImportedMesh picture = read_mesh("5 5 5 5\n5 5 5 5\n6 6 6 6\n6 6 6 6\n", request);
    ASSERT_EQ(picture.phase_of_grain.size(), picture.triangles.size());
    for (std::size_t t = 0; t < picture.triangles.size(); ++t) {
        double sum = 0;
        for (const int p : picture.triangles[t]) sum += picture.points[index(p)].y;
        EXPECT_EQ(picture.phase_of_grain[t], sum > 6 ? "a" : "b");
    }
    request.grains = GrainChoice::physical;
    EXPECT_THROW(read_mesh("5 5\n6 6\n", request), UsageError);
}

TEST(MeshFile, IsRefusedInOneLine) {
    EXPECT_EQ(test::expect_refused<InputError>("mesher/import/mesh_file.toml", [](const std::string& text) { read_mesh(text); }),
              16U);
}

}  // namespace
}  // namespace graincrack::mesher
