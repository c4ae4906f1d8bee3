#include "mesher/import/assemble.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesher/fabric/crystals.hpp"
#include "mesher/fabric/fabric.hpp"
#include "mesher/import/clean_mesh.hpp"
#include "mesher/import/outline.hpp"
#include "share/base/error.hpp"
#include "share/file/specimen.hpp"
#include "tests/unit/mesher/import/mesh_files.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

Specimen specimen_of(ImportedMesh mesh, const Placement& placement = {}, std::vector<Remark>* notes = nullptr) {
    std::vector<Remark> unused;
    return assemble(std::move(mesh), placement, CrystalChoice::elastic, "file", notes == nullptr ? unused : *notes);
}

std::ptrdiff_t n_sides(const Specimen& s, const std::string& part) {
    return std::ranges::count_if(s.boundary_part, [&](std::uint8_t number) { return s.part_names[number] == part; });
}

/// Two squares of two triangles each: grains 0 and 1.
ImportedMesh squares() {
    ImportedMesh mesh;
    mesh.points = {{-1, -.5}, {0, -.5}, {1, -.5}, {-1, .5}, {0, .5}, {1, .5}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    mesh.grain_of_triangle = {0, 0, 1, 1};
    mesh.phase_of_grain = {"", ""};
    return mesh;
}

/// A fan of n triangles around the origin, each a grain.
ImportedMesh fan(int n, double radius) {
    ImportedMesh mesh;
    mesh.points = {{0, 0}};
    for (int i = 0; i < n; ++i) {
        const double angle = std::numbers::pi / 2 + (i + 0.5) * 2 * std::numbers::pi / n;  // a facet at the top
        mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        mesh.triangles.push_back({0, i + 1, (i + 1) % n + 1});
        mesh.grain_of_triangle.push_back(i);
        mesh.phase_of_grain.emplace_back();
    }
    return mesh;
}

TEST(Assemble, MakesContactsPartsAndCracks) {
    std::vector<Remark> notes;
    const Specimen s = specimen_of(read_mesh(msh_41), {0.01, {}, ""}, &notes);
    EXPECT_EQ(s.shape, "rectangle");
    EXPECT_DOUBLE_EQ(s.width, 0.02);
    EXPECT_DOUBLE_EQ(s.height, 0.01);
    EXPECT_EQ(s.tessellation, "imported");
    EXPECT_EQ(s.n_grains(), 2U);
    ASSERT_EQ(s.n_contacts(), 1U);
    EXPECT_EQ(s.contact_kind[0], static_cast<std::uint8_t>(ContactKind::pre_existing_crack));
    EXPECT_EQ(s.phase_names, (std::vector<std::string>{"quartz", "feld_spar"}));
    ASSERT_EQ(s.n_boundary_edges(), 6U);
    EXPECT_EQ(s.part_names[s.boundary_part[0]], "loaded");  // those with names come first
    EXPECT_EQ(n_sides(s, "bottom"), 2);
    test::expect_golden(text_of(notes));
    EXPECT_NEAR(s.statistics.mean_edge, std::sqrt(4 * 1e-4 / std::sqrt(3.0)), 1e-9);  // of triangles of the squares' area
}

TEST(Assemble, PutsRightWhatFilesLeave) {
    ImportedMesh mesh = squares();
    mesh.points.push_back({0, -.5 + 1e-10});  // beside point 1, by less than round-off of a file
    mesh.points.push_back({7, 7});            // unused
    mesh.triangles[2] = {6, 2, 5};
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    std::vector<Remark> notes;
    EXPECT_EQ(specimen_of(mesh, {}, &notes).n_contacts(), 1U);
    test::expect_golden(text_of(notes), "points and directions");
    mesh = squares();
    mesh.grain_of_triangle = {0, 1, 1, 0};  // the pieces of grain 1 meet in a point only
    notes.clear();
    EXPECT_EQ(specimen_of(mesh, {}, &notes).n_grains(), 3U);
    test::expect_golden(text_of(notes), "pieces of a grain");
}

TEST(Assemble, MakesGrainsOfTheElementsOfCrystalsThatBreak) {
    ImportedMesh mesh = squares();
    mesh.phase_of_grain = {"quartz", "mica"};
    // Along the diagonal of the left square, inside of its crystal.
    const Triangle& t = mesh.triangles[0];
    mesh.lines.push_back({t[2], t[0], "flaw-vein-broken"});
    std::vector<Remark> notes;
    Specimen s = assemble(mesh, {}, CrystalChoice::breaking, "file", notes);
    give_fabric(s, std::vector<int>(s.grain_crystal), {}, 1, 0, true);
    validate(s, "file");
    EXPECT_EQ(s.n_grains(), 4U);
    EXPECT_EQ(s.tessellation, "imported");
    ASSERT_EQ(s.grain_crystal.size(), 4U);
    for (std::size_t g = 0; g < s.n_grains(); ++g) {
        double x = 0;
        for (const std::int32_t node : s.element_nodes[g]) x += s.node_position[index(node)][0] / 3;
        EXPECT_EQ(s.grain_crystal[g], x < 0 ? 0 : 1);
        EXPECT_EQ(s.phase_names[s.grain_phase[g]], x < 0 ? "quartz" : "mica");
    }
    EXPECT_EQ(s.flaw_names, (std::vector<std::string>{"vein", "within_quartz", "within_mica"}));
    std::vector<std::pair<int, int>> contacts;  // kind and class of flaws
    for (std::size_t c = 0; c < s.n_contacts(); ++c) contacts.emplace_back(s.contact_kind[c], s.contact_flaw[c]);
    std::sort(contacts.begin(), contacts.end());
    EXPECT_EQ(contacts, (std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {2, 3}}));
}

TEST(Assemble, TellsBodiesThatDoNotTouch) {
    ImportedMesh mesh = squares();
    for (const Point& p : squares().points) mesh.points.push_back({p.x, p.y + 1.5});
    for (const Triangle& t : squares().triangles) mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    mesh.grain_of_triangle = {0, 0, 1, 1, 2, 2, 3, 3};
    mesh.phase_of_grain.assign(4, "");
    std::vector<Remark> notes;
    const Specimen s = specimen_of(mesh, {1, {}, "rectangle"}, &notes);
    EXPECT_DOUBLE_EQ(s.height, 2.5);
    test::expect_golden(notes.back().text);
    for (const char* part : {"bottom", "top", "left"}) EXPECT_EQ(n_sides(s, part), 2) << part;
    EXPECT_EQ(n_sides(s, "side"), 4) << "of the gap";
    EXPECT_EQ(specimen_of(mesh).shape, "polygon");
}

TEST(Assemble, RefusesWhatDoesNotConform) {
    test::Refusals refused;
    const auto add = [&](const std::string& what, const ImportedMesh& mesh, const Placement& placement = {}) {
        refused.add<InputError>(what, [&] { specimen_of(mesh, placement); });
    };
    ImportedMesh mesh = squares();
    mesh.points.push_back({0, 0});
    mesh.triangles = {{0, 1, 6}, {0, 6, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    mesh.grain_of_triangle = {0, 0, 0, 1, 1};
    add("a point on the side of the right square", mesh);
    mesh = squares();
    mesh.triangles.push_back({0, 1, 5});
    mesh.grain_of_triangle.push_back(1);
    add("two triangles on a side", mesh);
    mesh = squares();
    mesh.points.insert(mesh.points.end(), {{.5, 0}, {3, -.1}, {3, .1}});
    mesh.triangles.push_back({6, 7, 8});
    mesh.grain_of_triangle.push_back(1);
    add("a triangle across a side", mesh);
    mesh = squares();
    mesh.points[4] = {-.5, -.5};
    add("a flat triangle", mesh);
    for (Point& p : mesh.points) p = {1, 1};
    add("one place", mesh);
    add("2,000 km", squares(), {1e6, {}, ""});
    add("a fan beside the origin", fan(24, 0.04), {1, Point{0.01, 0}, ""});
    std::vector<Remark> notes;
    refused.add<InputError>("crystals of one element that break",
                            [&] { assemble(fan(12, 1), {}, CrystalChoice::breaking, "fan.msh", notes); });
    test::expect_golden(refused.text());
}

TEST(Assemble, LeavesAMeshAroundTheOriginInItsPlace) {
    std::vector<Remark> notes;
    const Specimen s = specimen_of(fan(24, 0.04), {}, &notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(s.shape, "disc");
    EXPECT_EQ(s.height, 2 * 0.04 * std::cos(std::numbers::pi / 24));
    EXPECT_EQ(s.width, s.height);
    EXPECT_NEAR(s.loading_arc, 2 * std::numbers::pi / 24, 1e-12);
    EXPECT_EQ(n_sides(s, "rim"), 24);
}

Outline outline_of(ImportedMesh mesh) {
    std::vector<Remark> notes;
    clean(mesh, "file");
    return outline_of(mesh, "", "file", notes);
}

TEST(Outline, TellsShapes) {
    EXPECT_EQ(outline_of(squares()).shape, "rectangle");
    ImportedMesh trapezium = squares();
    trapezium.points[5].x = 1.2;
    EXPECT_EQ(outline_of(trapezium).shape, "polygon");
    EXPECT_EQ(outline_of(fan(6, 1)).shape, "polygon");
    ImportedMesh half = fan(40, 1);
    half.points.insert(half.points.end(), {{1, 0}, {-1, 0}});
    half.triangles = {{0, 41, 39 - 10 + 2}, {0, 10, 42}};
    for (int i = 1; i <= 9; ++i) {
        half.triangles.push_back({0, i, i + 1});
        half.triangles.push_back({0, 30 + i, 30 + i + 1});
    }
    half.triangles.push_back({0, 40, 1});
    half.grain_of_triangle.assign(half.triangles.size(), 0);
    EXPECT_EQ(outline_of(half).shape, "half-disc");
    ImportedMesh ring = fan(16, 1);
    ring.triangles.clear();
    for (int i = 1; i <= 16; ++i) ring.points.push_back(0.5 * ring.points[index(i)]);
    for (int i = 0; i < 16; ++i) {
        const int j = (i + 1) % 16;
        ring.triangles.push_back({i + 1, j + 1, 17 + i});
        ring.triangles.push_back({j + 1, 17 + j, 17 + i});
    }
    ring.grain_of_triangle.assign(32, 0);
    const Outline outline = outline_of(ring);
    EXPECT_EQ(outline.shape, "ring");
    EXPECT_EQ(outline.part_names[4], "outer");
    EXPECT_EQ(outline.part_names[outline.sides.back().part], "inner");
}

TEST(Outline, HasTheNamesOfLinesAsParts) {
    ImportedMesh mesh = squares();
    mesh.lines = {{2, 5, "punch"}, {4, 1, "flaw-joint"}, {1, 4, "crack"}, {0, 4, "crack"}, {1, 5, "strange"}};
    std::vector<Remark> notes;
    clean(mesh, "file");
    const Outline outline = outline_of(mesh, "", "file", notes);
    EXPECT_EQ(outline.sides.front().part, 5);
    EXPECT_EQ(outline.part_names[5], "punch");
    EXPECT_EQ(outline.sides.size(), 7U);
    EXPECT_EQ(outline.sides.back().kind, (FlawKind{ContactKind::grain_boundary, "joint"}));  // the first name of a side counts
    test::expect_golden(text_of(notes));
}

TEST(Outline, KnowsTheNamesOfFlaws) {
    EXPECT_EQ(flaw_of_line("crack"), FlawKind{ContactKind::pre_existing_crack});
    EXPECT_EQ(flaw_of_line("open-boundary"), FlawKind{ContactKind::open_boundary});
    EXPECT_EQ(flaw_of_line("flaw-joint"), (FlawKind{ContactKind::grain_boundary, "joint"}));
    EXPECT_EQ(flaw_of_line("flaw-joint-broken"), (FlawKind{ContactKind::pre_existing_crack, "joint"}));
    EXPECT_FALSE(flaw_of_line("flaw-"));
    EXPECT_FALSE(flaw_of_line("top"));
}

}  // namespace
}  // namespace graincrack::mesher
