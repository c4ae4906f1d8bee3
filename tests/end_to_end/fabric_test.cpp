// A rock's own grains: what [fabric] of a material makes, and what options make of it.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string rectangle = "graincrack-mesh rectangle --width 20mm --height 40mm --material ";
const std::string silent = " --quiet -o ";

/// A granite of crystals of 4 mm beside Augig granite.
void write_granite(const Shell& shell) {
    shell.must(
        "graincrack-post material with augig-granite --set fabric.tessellation=trigon --set 'fabric.grain_size=4 mm' "
        "--set fabric.size_variation=0.4 --set fabric.elements_per_crystal=16 >granite.toml");
}
/// The value of a line of `graincrack-post info`.
std::string fact(const Shell& shell, const std::string& file, const std::string& key) {
    std::string text = shell.must("graincrack-post info " + file + " | sed -n 's/^  " + key + "  *//p'");
    if (!text.empty()) text.pop_back();
    return text;
}
std::string content_digest(const Shell& shell, const std::string& file) {
    return shell.must("graincrack-post info --digest " + file).substr(0, 64);
}

TEST(Fabric, AMaterialMakesItsOwnGrains) {
    const Shell shell;
    write_granite(shell);
    shell.must(rectangle + "granite.toml" + silent + "s.h5");
    // 20 x 40 mm² over π (4 mm)²/4 are 63.66, and diameters that vary by 0.4 have 1 + 0.4² times the area of their mean.
    EXPECT_EQ(fact(shell, "s.h5", "crystals"), "55");
    EXPECT_EQ(fact(shell, "s.h5", "asked_for"),
              "trigon, grains 55, spread 0.4, elements-per-crystal 16 (material Augig granite)");
    EXPECT_NEAR(std::stod(fact(shell, "s.h5", "elements_per_crystal")), 16, 0.02 * 16);  // tolerance of the trials
    EXPECT_NEAR(std::stod(fact(shell, "s.h5", "crystal_variation")), 0.4, 1e-3);  // sizes are drawn so that they vary as wanted
    EXPECT_NEAR(std::stod(fact(shell, "s.h5", "grain_size")), 4, 4 * 0.5 / 55);   // whole polygons
    // The options that the material stands for make the same.
    shell.must(rectangle + "granite.toml --tessellation trigon --grains 55 --spread 0.4 --elements-per-crystal 16" + silent +
               "same.h5");
    EXPECT_EQ(content_digest(shell, "same.h5"), content_digest(shell, "s.h5"));
    // So does its printed configuration, and a run tells of its specimen.
    shell.must(rectangle + "granite.toml -o again.h5 --print-config >again.toml\n" +
               "graincrack-mesh rectangle --config again.toml --quiet");
    EXPECT_EQ(content_digest(shell, "again.h5"), content_digest(shell, "s.h5"));
    shell.must(
        "graincrack-solve uniaxial s.h5 --material granite.toml --rate 50mm/s --max-strain 0.0005 --quiet -o run.h5\n"
        "graincrack-post report run.h5 --material granite.toml -o report.html");
    EXPECT_EQ(fact(shell, "run.h5", "asked_for"), fact(shell, "s.h5", "asked_for"));
    EXPECT_NE(
        content_of(shell.file("report.html")).find("elements-per-crystal 16 (material Augig granite) asked for; 55 crystals"),
        std::string::npos);
}

TEST(Fabric, OptionsOverrideItOneByOne) {
    const Shell shell;
    write_granite(shell);
    const auto asked = [&](const std::string& options) {
        shell.must(rectangle + "granite.toml " + options + silent + "s.h5");
        return fact(shell, "s.h5", "asked_for");
    };
    const std::string end = " (material Augig granite)";
    EXPECT_EQ(asked("--grains 30"), "trigon, grains 30, spread 0.4, elements-per-crystal 16" + end);
    EXPECT_EQ(fact(shell, "s.h5", "crystals"), "30");
    EXPECT_EQ(asked("--edge 5mm"), "trigon, edge 5 mm, spread 0.4, elements-per-crystal 16" + end);
    EXPECT_EQ(asked("--spread 0.2"), "trigon, grains 61, spread 0.2, elements-per-crystal 16" + end);
    EXPECT_EQ(asked("--element-size 2mm"), "trigon, grains 55, spread 0.4, element-size 2 mm" + end);
    EXPECT_EQ(asked("--tessellation voronoi"), "voronoi, grains 55, spread 0.4, elements-per-crystal 16" + end);
    // The variation is that of diameters of polygons, not of edges of triangles.
    EXPECT_EQ(asked("--tessellation delaunay"), "delaunay, grains 64, spread 0.1" + end);
    EXPECT_EQ(fact(shell, "s.h5", "grains"), "64");
    EXPECT_EQ(shell.must(rectangle + "granite.toml --spread 0.3 --print-config | grep -E '^(spread|# edge)'"),
              "# edge =\nspread = 0.3\n");
}

TEST(Fabric, AGraniteOfTrianglesHasTheGrainsOfItsCalibration) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 80mm --height 160mm --material augig-granite-triangles --quiet -o own.h5\n"
        "graincrack-mesh rectangle --width 80mm --height 160mm --grains 1122 --material augig-granite-triangles --quiet -o "
        "counted.h5");
    EXPECT_EQ(fact(shell, "own.h5", "grains"), "1122");
    EXPECT_EQ(content_digest(shell, "own.h5"), content_digest(shell, "counted.h5"));
}

TEST(Fabric, WhatDoesNotFitIsRefusedInALine) {
    const Shell shell;
    write_granite(shell);
    const auto refused = [&](const std::string& options) {
        const Outcome outcome = shell.run(rectangle + options + " -o s.h5");
        EXPECT_NE(outcome.exit_code, 0) << options;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        return outcome.err;
    };
    EXPECT_NE(refused("augig-granite").find("[fabric]"), std::string::npos) << "it has none, and no option gives a size";
    EXPECT_NE(refused("granite.toml --grain-size 4mm --grains 30").find("--grains and --grain-size"), std::string::npos);
    EXPECT_NE(refused("granite.toml --tessellation delaunay --elements-per-crystal 8").find("is for crystals"),
              std::string::npos);
    shell.must("sed -i 's/^tessellation.*/tessellation = \"hexagons\"/' granite.toml");
    EXPECT_NE(refused("granite.toml").find("granite.toml: line "), std::string::npos);
}

}  // namespace
}  // namespace graincrack::test
