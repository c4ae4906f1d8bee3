#include "mesher/import/import_specimen.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "mesher/import/gmsh.hpp"
#include "share/base/error.hpp"
#include "tests/unit/mesher/import/mesh_files.hpp"

namespace graincrack::mesher {
namespace {

using test::read;
using test::with;

/// The message of an error.
std::string reading_message(const std::string& bytes, const ImportRequest& request = {}) {
    try {
        read(bytes, request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

struct Case {
    const char* name;
    std::string bytes;
    bool has_lines;
    std::vector<std::string> phases;
};
void PrintTo(const Case& c, std::ostream* stream) { *stream << c.name; }

class Formats : public testing::TestWithParam<Case> {};

TEST_P(Formats, GiveTheSameMesh) {
    const ImportedMesh mesh = read(GetParam().bytes);
    ASSERT_EQ(mesh.triangles.size(), 4U);
    EXPECT_EQ(mesh.grain_of_triangle, (std::vector<int>{0, 0, 1, 1}));
    EXPECT_EQ(mesh.phase_of_grain, GetParam().phases);
    double left = 0;
    double right = 0;
    for (std::size_t t = 0; t < 4; ++t) {
        const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(mesh.triangles[t][k])]; };
        (t < 2 ? left : right) += (at(0).x + at(1).x + at(2).x) / 6;
        EXPECT_DOUBLE_EQ(std::abs(signed_area(at(0), at(1), at(2))), 0.5);
    }
    EXPECT_DOUBLE_EQ(left, 0.5);  // mean of two centres
    EXPECT_DOUBLE_EQ(right, 1.5);
    ASSERT_EQ(mesh.lines.size(), GetParam().has_lines ? 2U : 0U);
    if (!GetParam().has_lines) return;
    EXPECT_EQ(mesh.lines[0].name, "crack");
    EXPECT_EQ(mesh.lines[1].name, "loaded");
    EXPECT_EQ(mesh.points[static_cast<std::size_t>(mesh.lines[0].from)], (Point{1, 0}));
    EXPECT_EQ(mesh.points[static_cast<std::size_t>(mesh.lines[1].to)], (Point{2, 1}));
}

const std::vector<std::string> minerals{"quartz", "feld_spar"};
INSTANTIATE_TEST_SUITE_P(All, Formats,
                         testing::Values(Case{"msh_22", test::msh_22, true, minerals},
                                         Case{"msh_41", test::msh_41, true, minerals},
                                         Case{"neper_msh", test::neper_msh, false, {"group_1", "group_2"}}),
                         [](const auto& each) { return each.param.name; });

TEST(MeshFile, TellsFormatsByTheirContent) {
    EXPECT_EQ(read(test::msh_22).format, "Gmsh 2.2, text");
    EXPECT_EQ(read(test::neper_msh).format, "Neper (Gmsh 2.2, text)");
    const std::string needed = "\"; a mesh of Gmsh or Neper (.msh) or a picture of labels (PNG, or integers as text) is needed";
    EXPECT_EQ(reading_message("solid cube\n"), "file: begins with \"solid cube" + needed);
    EXPECT_EQ(reading_message("\n *Node\n1, 0., 0.\n"),
              "file: begins with \"*Node\"; a file of Abaqus is converted by: meshio convert --ascii --output-format gmsh22 "
              "mesh.inp mesh.msh");
}

TEST(MeshFile, GrainsAreElementsEntitiesOrPhysicalGroups) {
    ImportRequest request;
    request.grains = GrainChoice::element;
    EXPECT_EQ(read(test::msh_22, request).grain_of_triangle, (std::vector<int>{0, 1, 2, 3}));
    request.grains = GrainChoice::physical;
    const std::string one_entity = with(with(test::msh_22, "2 2 2 9 2 3 6", "2 2 2 7 2 3 6"), "2 2 2 9 2 6 5", "2 2 2 7 2 6 5");
    EXPECT_EQ(read(one_entity, request).grain_of_triangle, (std::vector<int>{0, 0, 1, 1}));
    request.grains.reset();
    const ImportedMesh told = read(one_entity, request);
    EXPECT_EQ(told.grain_of_triangle, (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(told.notes.front().text, "all elements are of one entity: each element is a grain (--grain element)");
    request.grains = GrainChoice::entity;
    EXPECT_EQ(reading_message(one_entity, request),
              "file: elements 4 and 6 of entity 7 are of the physical groups 1 and 2; a grain is of one phase");
    request.grains = GrainChoice::physical;
    EXPECT_EQ(reading_message(test::neper_msh, request),
              "file: --grain physical: physical groups: none; Gmsh's Mesh.SaveAll drops them in MSH 2.2");
}

TEST(MeshFile, AKeyGivesPhases) {
    const std::string path = testing::TempDir() + "/mesh_file_key.tsv";
    const auto phases = [&](const std::string& key, const std::string& bytes) {
        std::ofstream(path) << key;
        ImportRequest request;
        request.phase_key = path;
        const ImportedMesh mesh = read(bytes, request);
        return mesh.phase_of_grain;
    };
    EXPECT_EQ(phases("key\tphase\nQuartz\tq\nfeld spar\tf\n", test::msh_22), (std::vector<std::string>{"q", "f"}));
    EXPECT_EQ(phases("key\tphase\n1\tq\n2\tf\n", test::msh_41), (std::vector<std::string>{"q", "f"}));
    EXPECT_EQ(phases("2\tf\n1\tq\n", test::neper_msh), (std::vector<std::string>{"q", "f"}));
    const auto error = [&](const std::string& key) {
        std::ofstream(path) << key;
        ImportRequest request;
        request.phase_key = path;
        const std::string message = reading_message(test::msh_22, request);
        return message.substr(0, path.size()) == path ? message.substr(path.size()) : message;
    };
    EXPECT_EQ(error("key\tphase\nQuartz\tq\n"), ": no row for feld spar; each grain needs one");
    EXPECT_EQ(error("Quartz\n"), ": line 1: \"Quartz\" is no row; a key, a tab and the name of a phase (a-z, 0-9, _) are needed");
    EXPECT_EQ(error("1\tQ\n"), ": line 1: \"1\\x09Q\" is no row; a key, a tab and the name of a phase (a-z, 0-9, _) are needed");
    EXPECT_EQ(error("1\tq\n1\tf\n"), ": line 2: 1 has a phase already");
    EXPECT_EQ(error("key\tphase\n"), ": no rows; a table with the columns key and phase is needed");
}

TEST(MeshFile, QuadranglesAlongTheirShorterInnerDiagonal) {
    const auto file = [](const char* third) {
        return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 2 0 0\n3 " + std::string(third) +
               " 0\n4 0 2 0\n$EndNodes\n$Elements\n1\n1 3 2 0 1 1 2 3 4\n$EndElements\n";
    };
    EXPECT_EQ(read(file("1.5 1.5")).triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(read(file("2.5 2.5")).triangles, (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(read(file(".5 .5")).triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));  // not convex at 3
    EXPECT_EQ(reading_message(file("-1 3")), "file: quadrangle 1 has no area or crosses itself");
}

TEST(MeshFile, ElementsOfPicturesCanBeGrains) {
    ImportRequest request;
    request.grains = GrainChoice::element;
    const std::string path = testing::TempDir() + "/mesh_file_labels.tsv";
    std::ofstream(path) << "5\ta\n6\tb\n";
    request.phase_key = path;
    request.labels.pixel_size = 1;
    request.labels.smallest_piece = 1;
    const ImportedMesh picture = read("5 5 5 5\n5 5 5 5\n6 6 6 6\n6 6 6 6\n", request);
    ASSERT_EQ(picture.phase_of_grain.size(), picture.triangles.size());
    for (std::size_t t = 0; t < picture.triangles.size(); ++t) {
        double sum = 0;
        for (const int p : picture.triangles[t]) sum += picture.points[index(p)].y;
        EXPECT_EQ(picture.phase_of_grain[t], sum > 6 ? "a" : "b");
    }
    request.grains = GrainChoice::physical;
    EXPECT_THROW(read("5 5\n6 6\n", request), UsageError);
}

TEST(MeshFile, SaysWhatWasFound) {
    const std::string& m = test::msh_22;
    const std::pair<std::string, std::string> cases[] = {
        {with(m, "2.2 0 8", "4.0 0 8"),
         "file: line 2: the format is MSH 4; 2.2 or 4.1 is needed (gmsh FILE -save -format msh41)"},
        {with(m, "2.2 0 8", "2.2 1 8"), "file: line 2: the file is binary; text is needed (gmsh FILE -save -bin 0)"},
        {with(test::msh_41, "$Entities", "$PartitionedEntities"),
         "file: line 12: the mesh is partitioned; give it in one part (in Gmsh: Mesh, Unpartition)"},
        {with(m, "2.2 0 8", "2.2 0 4"), "file: line 2: numbers of 4 bytes; 8 are needed"},
        {with(m, "$Nodes\n6", "$Nodes\n60000"), "file: line 12: the number of nodes is 60000, for which the file is too short"},
        {with(m, "2 1 0 0", "2 1 nan 0"), "file: line 14: \"nan\" stands where a coordinate is expected, a number"},
        {with(m, "6 2 1 0", "5 2 1 0"), "file: node 5 stands twice in the file"},
        {with(m, "9 2 6 5", "9 2 6 15"), "file: element 7 names node 15, which is not in the file"},
        {with(m, "7 2 2 2 9 2 6 5", "7 4 2 2 9 2 6 5"),
         "file: line 28: elements of type 4; triangles (2) or quadrangles (3) are needed (gmsh FILE -save -order 1)"},
        {with(m, "6 2 1 0", "6 2 1 .5"),
         "file: z of the triangles' nodes runs from 0 to 0.5; a plane mesh, with one z, is needed"},
        {with(m, "$EndElements", "$End"), "file: line 30: $Elements has no end"},
        {m.substr(0, m.find("$Elements")), "file: line 20: no lines, triangles or quadrangles"},
        {m.substr(0, m.find("4 2 2 1")) + "$EndElements",
         "file: line 25: \"$EndElements\" stands where the number of an element is expected, an integer"},
    };
    for (const auto& [bytes, message] : cases) EXPECT_EQ(reading_message(bytes), message);
}

}  // namespace
}  // namespace graincrack::mesher
