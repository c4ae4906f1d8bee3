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
#include "tests/support/check.hpp"
#include "tests/unit/mesher/import/mesh_files.hpp"

namespace graincrack::mesher {
namespace {

Specimen specimen_of(ImportedMesh mesh, const Placement& placement = {}, std::vector<Remark>* notes = nullptr) {
    std::vector<Remark> unused;
    return assemble(std::move(mesh), placement, CrystalChoice::elastic, "file", notes == nullptr ? unused : *notes);
}

std::vector<std::string> texts_of(const std::vector<Remark>& notes) {
    std::vector<std::string> texts;
    for (const Remark& note : notes) texts.push_back(note.text);
    return texts;
}

std::string assembly_message(ImportedMesh mesh, const Placement& placement = {}) {
    try {
        specimen_of(std::move(mesh), placement);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
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
    ImportRequest request;
    request.file = "file";
    request.placement.scale = 0.01;
    std::vector<Remark> notes;
    const Specimen s = assemble(import_mesh(test::msh_41, request), request.placement, request.crystals, "file", notes);
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
    int n_bottom = 0;
    for (const std::uint8_t part : s.boundary_part) n_bottom += part == static_cast<std::uint8_t>(BoundaryPart::bottom) ? 1 : 0;
    EXPECT_EQ(n_bottom, 2);
    EXPECT_EQ(texts_of(notes),
              std::vector<std::string>{"moved by (-10 mm, -5 mm), so that the middle of its extent is the origin"});
    EXPECT_NEAR(s.statistics.mean_edge, std::sqrt(4 * 1e-4 / std::sqrt(3.0)), 1e-9);  // of triangles of the squares' area
}

TEST(Assemble, PutsRightWhatFilesLeave) {
    ImportedMesh mesh = squares();
    mesh.points.push_back({0, -.5 + 1e-10});  // beside point 1, by less than round-off of a file
    mesh.points.push_back({7, 7});            // unused
    mesh.triangles[2] = {6, 2, 5};
    std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
    std::vector<Remark> notes;
    const Specimen s = specimen_of(mesh, {}, &notes);
    EXPECT_EQ(s.n_contacts(), 1U);
    EXPECT_EQ(texts_of(notes),
              (std::vector<std::string>{"1 point that no corner of a triangle lies at was left out",
                                        "1 of 7 points lie where others do and were joined with them; sides that "
                                        "were apart there are grain boundaries "
                                        "now (lines of the name crack make broken ones)",
                                        "1 of 4 triangles were clockwise and were turned"}));
}

TEST(Assemble, PiecesOfAGrainAreGrains) {
    ImportedMesh mesh = squares();
    mesh.grain_of_triangle = {0, 1, 1, 0};  // the pieces of grain 1 meet in a point only
    std::vector<Remark> notes;
    const Specimen s = specimen_of(mesh, {}, &notes);
    EXPECT_EQ(s.n_grains(), 3U);
    EXPECT_EQ(texts_of(notes), std::vector<std::string>{"grains of several pieces: 1 further piece is a grain of its own"});
}

TEST(Assemble, ElementsOfCrystalsThatBreakAreGrains) {
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
    ASSERT_EQ(s.n_contacts(), 3U);
    std::vector<std::pair<int, int>> contacts;  // kind and class of flaws
    for (std::size_t c = 0; c < s.n_contacts(); ++c) contacts.emplace_back(s.contact_kind[c], s.contact_flaw[c]);
    std::sort(contacts.begin(), contacts.end());
    EXPECT_EQ(contacts, (std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {2, 3}}));
}

TEST(Assemble, CrystalsOfOneElementDoNotBreak) {
    std::vector<Remark> notes;
    graincrack::test::expect_one_line<InputError>(
        [&] { assemble(fan(12, 1), {}, CrystalChoice::breaking, "fan.msh", notes); },
        {"fan.msh: --crystals break: each crystal is one element", "smaller elements, another --grain"});
}

TEST(Assemble, TellsBodiesThatDoNotTouch) {
    ImportedMesh mesh = squares();
    for (const Point& p : squares().points) mesh.points.push_back({p.x, p.y + 1.5});
    for (const Triangle& t : squares().triangles) mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    mesh.grain_of_triangle = {0, 0, 1, 1, 2, 2, 3, 3};
    mesh.phase_of_grain.assign(4, "");
    std::vector<Remark> notes;
    Placement placement;
    placement.shape = "rectangle";
    const Specimen s = specimen_of(mesh, placement, &notes);
    EXPECT_DOUBLE_EQ(s.height, 2.5);
    EXPECT_EQ(notes.back().text, "the grains make 2 bodies that share no sides");
    const auto n_sides = [&](const std::string& part) {
        return std::count_if(s.boundary_part.begin(), s.boundary_part.end(),
                             [&](std::uint8_t number) { return s.part_names[number] == part; });
    };
    EXPECT_EQ(n_sides("bottom"), 2);
    EXPECT_EQ(n_sides("top"), 2);
    EXPECT_EQ(n_sides("side"), 4);  // of the gap
    EXPECT_EQ(n_sides("left"), 2);
    EXPECT_EQ(specimen_of(mesh).shape, "polygon");
}

TEST(Assemble, RefusesWhatDoesNotConform) {
    ImportedMesh hanging = squares();
    hanging.points.push_back({0, 0});
    hanging.triangles = {{0, 1, 6}, {0, 6, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};  // a point on the side of the right square
    hanging.grain_of_triangle = {0, 0, 0, 1, 1};
    EXPECT_EQ(
        assembly_message(hanging),
        "file: the mesh does not conform: the point (0, 0) lies on the side from (0, 0.5) to (0, -0.5) without being its end");
    ImportedMesh twice = squares();
    twice.triangles.push_back({0, 1, 5});
    twice.grain_of_triangle.push_back(1);
    EXPECT_EQ(assembly_message(twice),
              "file: two triangles overlap: both have the side from (-1, -0.5) to (0, -0.5) with themselves on its left");
    ImportedMesh crossing = squares();
    crossing.points.insert(crossing.points.end(), {{.5, 0}, {3, -.1}, {3, .1}});
    crossing.triangles.push_back({6, 7, 8});
    crossing.grain_of_triangle.push_back(1);
    EXPECT_EQ(assembly_message(crossing).substr(0, 38), "file: the mesh overlaps itself: the si");
    ImportedMesh flat = squares();
    flat.points[4] = {-.5, -.5};
    EXPECT_EQ(assembly_message(flat), "file: a triangle at (-1, -0.5) has no area");
    ImportedMesh one_point = squares();
    for (Point& p : one_point.points) p = {1, 1};
    EXPECT_EQ(assembly_message(one_point), "file: all points lie at one place, or too far apart");
    Placement placement;
    placement.scale = 1e6;
    EXPECT_EQ(assembly_message(squares(), placement).substr(0, 16), "file: 2000 km ac");
}

TEST(Assemble, AMeshAroundTheOriginIsNotMoved) {
    std::vector<Remark> notes;
    const ImportedMesh mesh = fan(24, 0.04);
    const Specimen s = specimen_of(mesh, {}, &notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(s.shape, "disc");
    EXPECT_EQ(s.height, 2 * 0.04 * std::cos(std::numbers::pi / 24));
    EXPECT_EQ(s.width, s.height);
    EXPECT_NEAR(s.loading_arc, 2 * std::numbers::pi / 24, 1e-12);
    for (const std::uint8_t part : s.boundary_part) EXPECT_EQ(s.part_names[part], "rim");
    Placement placement;
    placement.origin = Point{0.01, 0};
    EXPECT_NE(assembly_message(mesh, placement).find("the middle of the nodes along x is more than 0.1 %"), std::string::npos);
}

TEST(Outline, TellsShapes) {
    std::vector<Remark> notes;
    const auto shape = [&](ImportedMesh mesh) {
        clean(mesh, "file");
        return outline_of(mesh, "", "file", notes).shape;
    };
    EXPECT_EQ(shape(squares()), "rectangle");
    ImportedMesh trapezium = squares();
    trapezium.points[5].x = 1.2;
    EXPECT_EQ(shape(trapezium), "polygon");
    EXPECT_EQ(shape(fan(6, 1)), "polygon");
    ImportedMesh half = fan(40, 1);
    half.points.push_back({1, 0});
    half.points.push_back({-1, 0});
    half.triangles = {{0, 41, 39 - 10 + 2}, {0, 10, 42}};
    half.grain_of_triangle = {0, 1};
    for (int i = 1; i <= 9; ++i) {
        half.triangles.push_back({0, i, i + 1});
        half.triangles.push_back({0, 30 + i, 30 + i + 1});
    }
    half.triangles.push_back({0, 40, 1});
    half.grain_of_triangle.resize(half.triangles.size(), 1);
    EXPECT_EQ(shape(half), "half-disc");
    ImportedMesh ring = fan(16, 1);
    ring.triangles.clear();
    ring.grain_of_triangle.clear();
    for (int i = 1; i <= 16; ++i) ring.points.push_back(0.5 * ring.points[index(i)]);
    for (int i = 0; i < 16; ++i) {
        const int j = (i + 1) % 16;
        ring.triangles.push_back({i + 1, j + 1, 17 + i});
        ring.triangles.push_back({j + 1, 17 + j, 17 + i});
        ring.grain_of_triangle.insert(ring.grain_of_triangle.end(), {i, i});
    }
    clean(ring, "file");
    const Outline outline = outline_of(ring, "", "file", notes);
    EXPECT_EQ(outline.shape, "ring");
    EXPECT_EQ(outline.part_names[4], "outer");
    EXPECT_EQ(outline.part_names[outline.sides.back().part], "inner");
}

TEST(Outline, NamesOfLinesAreParts) {
    ImportedMesh mesh = squares();
    mesh.lines = {{2, 5, "punch"}, {4, 1, "flaw-joint"}, {1, 4, "crack"}, {0, 4, "crack"}, {1, 5, "strange"}};
    std::vector<Remark> notes;
    clean(mesh, "file");
    const Outline outline = outline_of(mesh, "", "file", notes);
    EXPECT_EQ(outline.sides.front().part, 5);
    EXPECT_EQ(outline.part_names[5], "punch");
    EXPECT_EQ(outline.sides.size(), 7U);
    EXPECT_EQ(outline.sides.back().kind, (FlawKind{ContactKind::grain_boundary, "joint"}));  // the first name of a side counts
    EXPECT_EQ(texts_of(notes),
              (std::vector<std::string>{
                  "1 lines of cracks and flaws lie between no two grains and were passed over",
                  "lines \"strange\" lie inside and say nothing there; contacts along lines of the name crack, flaw-NAME or "
                  "flaw-NAME-broken are cracks or of a class of flaws"}));
}

TEST(Outline, NamesOfFlaws) {
    EXPECT_EQ(flaw_of_line("crack"), FlawKind{ContactKind::pre_existing_crack});
    EXPECT_EQ(flaw_of_line("open-boundary"), FlawKind{ContactKind::open_boundary});
    EXPECT_EQ(flaw_of_line("flaw-joint"), (FlawKind{ContactKind::grain_boundary, "joint"}));
    EXPECT_EQ(flaw_of_line("flaw-joint-broken"), (FlawKind{ContactKind::pre_existing_crack, "joint"}));
    EXPECT_FALSE(flaw_of_line("flaw-"));
    EXPECT_FALSE(flaw_of_line("top"));
}

}  // namespace
}  // namespace graincrack::mesher
