// Meshes of specimens and runs go where they are wanted; what is in them is tested with post/export and by importing it again.
#include <utility>

#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Export, ARunAndAPipeGiveTheMeshOfTheirSpecimen) {
    const Shell shell;
    shell.must(make_disc + "disc.h5\ngraincrack-solve brazilian disc.h5 -o run.h5" + elastic);
    for (const auto& [format, ending] : {std::pair{"gmsh", "msh"}, {"vtu", "vtu"}}) {
        const std::string name = std::string("mesh.") + ending;
        shell.must("graincrack-post export disc.h5 --quiet -o " + name);
        const std::string mesh = content_of(shell.file(name));
        EXPECT_FALSE(mesh.empty()) << name;
        const std::string choice = std::string(" --quiet --format ") + format;
        EXPECT_EQ(shell.must("graincrack-post export run.h5 -o -" + choice), mesh) << name;
        EXPECT_EQ(shell.must("graincrack-post export - -o /dev/stdout <disc.h5" + choice), mesh) << name;
        shell.must("graincrack-post export disc.h5 -o mesh.text" + choice + " && cmp mesh.text " + name + " && rm mesh.text");
    }
    EXPECT_EQ(shell.names(), "disc.h5\nmesh.msh\nmesh.vtu\nrun.h5\n");
}

TEST(Export, WhatAFormatDoesNotCarryIsSaidInOneLine) {
    const Shell shell;
    shell.must("graincrack-mesh disc --diameter 20mm --grains 60 --strength-modulus 5 --quiet -o disc.h5");
    EXPECT_EQ(shell.run("graincrack-post export disc.h5 -o disc.msh").err,
              "graincrack-post: export: disc.msh leaves out strength factors of contacts (import --seed 1 draws them again with "
              "their modulus or material)\n");
    EXPECT_EQ(
        shell.run("graincrack-post export disc.h5 --format vtu -o - >disc.vtu").err,
        "graincrack-post: export: stdout leaves out strength factors of contacts (import --seed 1 draws them again with their "
        "modulus or material), parts of the boundary, pre-existing cracks and flaws\n");
    EXPECT_EQ(shell.run("graincrack-post export --quiet disc.h5 -o disc.vtu").err, "");
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
