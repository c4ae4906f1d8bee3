// Meshes of specimens and runs for other programs, read back by a few lines.
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

/// What a .msh file holds.
struct GmshMesh {
    std::map<std::pair<int, int>, std::string> names;  ///< by dimension and number
    std::vector<std::pair<std::string, std::string>> points;
    std::map<std::string, int> lines;      ///< their number, by name
    std::map<std::string, int> triangles;  ///< their number, by phase
    std::vector<int> grains;               ///< of the triangles
};

GmshMesh read_gmsh(const std::string& text) {
    GmshMesh mesh;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        int n = 0;
        if (word == "$PhysicalNames") {
            words >> n;
            for (int i = 0; i < n; ++i) {
                int dimension = 0;
                int number = 0;
                words >> dimension >> number >> word;
                mesh.names[{dimension, number}] = word.substr(1, word.size() - 2);
            }
        } else if (word == "$Nodes") {
            words >> n;
            for (int i = 0; i < n; ++i) {
                std::string x;
                std::string y;
                words >> word >> x >> y >> word;
                mesh.points.emplace_back(x, y);
            }
        } else if (word == "$Elements") {
            words >> n;
            for (int i = 0; i < n; ++i) {
                int type = 0;
                int physical = 0;
                int elementary = 0;
                words >> word >> type >> word >> physical >> elementary;
                for (int corner = 0; corner <= type; ++corner) words >> word;
                ++(type == 1 ? mesh.lines : mesh.triangles)[mesh.names.at({type, physical})];
                if (type == 2) mesh.grains.push_back(elementary);
            }
        }
    }
    return mesh;
}

/// A value of `graincrack-post info`.
int count_of(const Shell& shell, const std::string& file, const std::string& name) {
    return std::atoi(shell.must("graincrack-post info " + file + " | sed -n 's/^  " + name + "  *//p'").c_str());
}

int sum_of(const std::map<std::string, int>& counts) {
    int sum = 0;
    for (const auto& [name, n] : counts) sum += n;
    return sum;
}

const std::string make_flawed =
    "printf "
    "'x1_mm\\ty1_mm\\tx2_mm\\ty2_mm\\tclass\\tstate\\n-20\\t-12\\t20\\t12\\tvein\\tintact\\n-5\\t10\\t5\\t10\\tjoint\\tbroken\\n"
    "-5\\t-10\\t-1\\t-10\\tbroken\\t\\n' >flaws.tsv\n"
    "graincrack-mesh rectangle --width 20mm --height 40mm --edge 3mm --elements-per-edge 2 --flaws flaws.tsv "
    "--phases quartz=0.4,mica=0.6 --quiet -o specimen.h5\n";

TEST(Export, GmshHasGrainsPhasesPartsCracksAndFlaws) {
    const Shell shell;
    shell.must(make_flawed);
    const Outcome outcome = shell.run("graincrack-post export specimen.h5 -o mesh.msh");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
    const GmshMesh mesh = read_gmsh(content_of(shell.file("mesh.msh")));
    std::set<std::string> names;
    for (const auto& [key, name] : mesh.names) names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"quartz", "mica", "bottom", "right", "top", "left", "crack", "flaw-vein",
                                            "flaw-joint-broken"}));
    EXPECT_EQ(static_cast<int>(mesh.grains.size()), count_of(shell, "specimen.h5", "elements"));
    EXPECT_EQ(mesh.grains.back(), count_of(shell, "specimen.h5", "grains"));
    EXPECT_EQ(mesh.grains[3], 1);  // four triangles to a grain
    EXPECT_EQ(mesh.grains[4], 2);
    EXPECT_TRUE(std::is_sorted(mesh.grains.begin(), mesh.grains.end()));
    EXPECT_GT(mesh.triangles.at("quartz"), 0);
    EXPECT_EQ(sum_of(mesh.triangles), static_cast<int>(mesh.grains.size()));
    for (const char* name : {"crack", "flaw-vein", "flaw-joint-broken"}) EXPECT_GT(mesh.lines.at(name), 0) << name;
    EXPECT_EQ(mesh.lines.at("bottom") + mesh.lines.at("right") + mesh.lines.at("top") + mesh.lines.at("left"),
              count_of(shell, "specimen.h5", "boundary_edges"));
    const std::set<std::pair<std::string, std::string>> places(mesh.points.begin(), mesh.points.end());
    EXPECT_EQ(places.size(), mesh.points.size()) << "each point is once";
    EXPECT_LT(static_cast<int>(mesh.points.size()), count_of(shell, "specimen.h5", "nodes") / 2);
}

TEST(Export, ARunAndAPipeGiveTheMeshOfTheirSpecimen) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + elastic);
    for (const auto& [format, ending] : {std::pair{"gmsh", "msh"}, {"vtu", "vtu"}, {"abaqus", "inp"}}) {
        const std::string name = std::string("mesh.") + ending;
        shell.must("graincrack-post export disc.h5 --quiet -o " + name);
        const std::string mesh = content_of(shell.file(name));
        EXPECT_FALSE(mesh.empty()) << name;
        const std::string choice = std::string(" --quiet --format ") + format;
        EXPECT_EQ(shell.must("graincrack-post export run.h5 -o -" + choice), mesh) << name;
        EXPECT_EQ(shell.must("graincrack-post export - -o /dev/stdout <disc.h5" + choice), mesh) << name;
        shell.must("graincrack-post export disc.h5 -o mesh.text" + choice + " && cmp mesh.text " + name + " && rm mesh.text");
    }
    EXPECT_EQ(shell.names(), "disc.h5\nmesh.inp\nmesh.msh\nmesh.vtu\nrun.h5\n");
}

TEST(Export, AbaqusAndVtuAgreeWithGmsh) {
    const Shell shell;
    shell.must(make_flawed + "for ending in msh inp vtu; do graincrack-post export --quiet specimen.h5 -o mesh.$ending; done");
    const GmshMesh mesh = read_gmsh(content_of(shell.file("mesh.msh")));
    const std::string abaqus = content_of(shell.file("mesh.inp"));
    std::map<std::string, int> rows;  // by the line above them
    std::string head;
    std::istringstream lines(abaqus);
    for (std::string line; std::getline(lines, line);) {
        if (line[0] == '*') {
            head = line;
        } else {
            ++rows[head];
        }
    }
    EXPECT_EQ(rows.at("*Node"), static_cast<int>(mesh.points.size()));
    EXPECT_EQ(rows.at("*Element, type=CPE3"), static_cast<int>(mesh.grains.size()));
    for (const auto& [name, n] : mesh.lines) EXPECT_EQ(rows.at("*Element, type=T2D2, elset=" + name), n) << name;
    EXPECT_EQ(rows.count("*Elset, elset=face" + std::to_string(mesh.grains.back())), 1U);
    EXPECT_EQ(rows.count("*Elset, elset=PHASE_quartz"), 1U);
    const std::string vtu = content_of(shell.file("mesh.vtu"));
    EXPECT_NE(vtu.find("NumberOfPoints=\"" + std::to_string(mesh.points.size()) + "\""), std::string::npos);
    EXPECT_NE(vtu.find("NumberOfCells=\"" + std::to_string(mesh.grains.size()) + "\""), std::string::npos);
    for (const char* array : {"grain", "phase", "grain_area", "phase_names"}) {
        EXPECT_NE(vtu.find(std::string("Name=\"") + array + "\""), std::string::npos) << array;
    }
}

TEST(Export, WhatAFormatDoesNotCarryIsSaidInOneLine) {
    const Shell shell;
    shell.must("graincrack-mesh disc --diameter 20mm --grains 60 --strength-modulus 5 --quiet -o disc.h5");
    EXPECT_EQ(shell.run("graincrack-post export disc.h5 -o disc.msh").err,
              "graincrack-post: export: disc.msh leaves out strength factors of contacts\n");
    EXPECT_EQ(shell.run("graincrack-post export disc.h5 --format vtu -o - >disc.vtu").err,
              "graincrack-post: export: stdout leaves out strength factors of contacts, parts of the boundary, "
              "pre-existing cracks and flaws\n");
    EXPECT_EQ(shell.run("graincrack-post export --quiet disc.h5 -o disc.inp").err, "");
}

TEST(Export, SpecimensAreNotReplaced) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\nsha256sum disc.h5 >sum");
    const Outcome outcome = shell.run("graincrack-post export disc.h5 --format gmsh -o disc.h5");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
    shell.must("sha256sum --check --quiet sum");
}

}  // namespace
}  // namespace graincrack::test
