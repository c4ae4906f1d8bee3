// Meshes of other programs become specimens; what was exported comes back as it was.
#include "tests/end_to_end/same_arrays.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string meshes = GRAINCRACK_TEST_DATA "/meshes/";

std::string digest(const Shell& shell, const std::string& file) {
    return shell.must("graincrack-post info --digest " + file + " | cut -d ' ' -f 1");
}

/// Written by Gmsh 4.8.4: a file of version 4.1 is the same specimen as one of version 2.2.
TEST(Import, FilesOfGmshAgree) {
    const Shell shell;
    const auto import = [&](const std::string& name) {
        shell.must("graincrack-mesh import " + meshes + "two-minerals-" + name + " --scale 1mm --grain element --quiet -o " +
                   name + ".h5 && graincrack-post info --check " + name + ".h5");
        return digest(shell, name + ".h5");
    };
    EXPECT_EQ(import("msh41.msh"), import("msh22.msh"));
}

/// Shapes, flaws, phases, crystals that break: the arrays and a test's history are the same to the byte.
class RoundTrip : public testing::TestWithParam<std::string> {};

TEST_P(RoundTrip, GivesTheSameStrength) {
    const Shell shell;
    const std::string& kind = GetParam();
    const bool is_disc = kind.substr(0, 4) == "disc";
    const std::string crystals =
        kind.find("trigon") == std::string::npos ? "" : " --crystals break --strength-modulus 10 --seed 7";
    shell.must(
        "printf 'x1_mm\\ty1_mm\\tx2_mm\\ty2_mm\\tclass\\n-3\\t-4\\t3\\t2\\tbroken\\n' >flaws.tsv\n"
        "graincrack-mesh " +
        kind +
        " --quiet -o made.h5\n"
        "graincrack-post export made.h5 -o mesh.msh\n"
        "graincrack-mesh import mesh.msh" +
        crystals + " --quiet -o back.h5");
    const H5Input made(shell.file("made.h5"));
    const H5Input back(shell.file("back.h5"));
    for (const char* group : {"/nodes", "/elements", "/contacts", "/boundary", "/grains"}) {
        ASSERT_EQ(made.children(group), back.children(group));
        expect_same_arrays(made, back, group);
    }
    const std::string test = is_disc ? "brazilian " : "uniaxial ";
    for (const std::string file : {"made", "back"}) {
        shell.must("graincrack-solve " + test + file + ".h5" + past_peak + "-o run-" + file + ".h5");
    }
    const std::string columns =
        "peak_compressive_stress_MPa tensile_strength_MPa strain_at_peak tensile_cracks shear_cracks steps";
    const std::string table = shell.must("graincrack-post strength run-made.h5");
    const std::string other = shell.must("graincrack-post strength run-back.h5");
    std::istringstream names(columns);
    for (std::string name; names >> name;) EXPECT_EQ(cell(table, name), cell(other, name)) << name;
    expect_same_arrays(H5Input(shell.file("run-made.h5")), H5Input(shell.file("run-back.h5")), "/history");
}
INSTANTIATE_TEST_SUITE_P(All, RoundTrip,
                         testing::Values("rectangle --width 20mm --height 40mm --grains 200 --flaws flaws.tsv "
                                         "--phases quartz=0.4,mica=0.6 --hole 5mm,8mm,3mm",
                                         "disc --diameter 20mm --grains 90",
                                         "disc --diameter 20mm --grains 40 --tessellation trigon --hole 1mm,0,4mm "
                                         "--phases mica=0.4,quartz=0.6 --strength-modulus 10 --seed 7"));

TEST(Import, SaysWhatItFound) {
    const Shell shell;
    const Outcome outcome = shell.run("graincrack-mesh import " + meshes + "two-squares-neper.msh --scale 10mm -o s.h5");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string said =
        "s.h5: rectangle of 20 × 10 mm, 2 elastic crystals, mean 11.3 mm; 4 triangles, 1 contacts\n"
        "  phases: group_1 50.0 %, group_2 50.0 %\n";
    const std::string warning =
        "graincrack-mesh: warning: 0.89 crystals of the mean diameter across the smaller extent of 10 mm: with fewer than 10 a "
        "strength depends on single crystals and is no material's\n";
    EXPECT_EQ(outcome.err, said + warning);
    const std::string all = shell.run("graincrack-mesh import " + meshes + "two-squares-neper.msh --scale 10mm -v -o s.h5").err;
    EXPECT_NE(all.find(said +
                       "  from Neper (Gmsh 2.2, text): 8 nodes, 6 boundary edges\n"
                       "  edge mean 15.2 mm, CV 0.0000, min 15.2 mm, max 15.2 mm; smallest angle 45.0 deg, psi6 0.143\n"
                       "  parts of the boundary: bottom 20 mm, right 10 mm, top 20 mm, left 10 mm\n" +
                       warning + "  moved by (-10 mm, -5 mm), so that the middle of its extent is the origin\n"),
              std::string::npos)
        << all;
    const std::string source = shell.must("sha256sum " + meshes + "two-squares-neper.msh | cut -d ' ' -f 1");
    EXPECT_NE(shell.must("graincrack-post info s.h5").find("imported_from            SHA-256 " + source), std::string::npos);
    EXPECT_NE(shell.must("cat " + meshes + "two-squares-neper.msh | graincrack-mesh import - --scale 10mm --dry-run")
                  .find("rectangle of 20 × 10 mm, 2 elastic crystals"),
              std::string::npos);
}

// A picture in four colours, of which one knows no numbers: its key is written, named and read, and its grains break.
TEST(Import, APictureInColoursBecomesCrystalsThatBreak) {
    const Shell shell;
    const std::string picture = meshes + "four-minerals.png";
    const std::string labels = shell.must("graincrack-mesh import " + picture + " --write-key key.tsv --dry-run");
    EXPECT_NE(labels.find("  #f0b4a0        31.79 %      10\n"), std::string::npos) << labels;
    EXPECT_EQ(n_lines(labels), 5);
    const std::string dry = shell.must("graincrack-mesh import " + picture + " --pixel-size 0.5mm --dry-run");
    EXPECT_NE(dry.find(labels), std::string::npos) << dry;
    EXPECT_EQ(shell.must("graincrack-mesh import " + picture + " --write-key - --quiet"), content_of(shell.file("key.tsv")));
    const std::string call = "graincrack-mesh import " + picture + " --pixel-size 0.5mm --phase-key key.tsv --element-size 3mm ";
    const Outcome unnamed = shell.run(call + "--dry-run");
    EXPECT_EQ(unnamed.exit_code, 3);
    EXPECT_NE(unnamed.err.find("key.tsv: no phase is named yet"), std::string::npos) << unnamed.err;
    shell.must(
        "sed -i 's/^\\(#c03020\t\\)?/\\1quartz/; s/^\\(#f0b4a0\t\\)?/\\1k_feldspar/; s/^\\(#ffffff\t\\)?/\\1plagioclase/' "
        "key.tsv");
    const Outcome unfinished = shell.run(call + "--dry-run");
    EXPECT_EQ(unfinished.exit_code, 3);
    EXPECT_NE(unfinished.err.find("the label 3 (#102030) has no phase; "), std::string::npos) << unfinished.err;

    shell.must("sed -i 's/^\\(#102030\t\\)?/\\1mica/' key.tsv");
    const Outcome made = shell.run(call + "--crystals break -o s.h5");
    EXPECT_NE(made.err.find("34 crystals, mean 7.33 mm; 490 triangles"), std::string::npos) << made.err;
    EXPECT_NE(made.err.find(": warning: 4.1 crystals of the mean diameter across the smaller extent of 30 mm: "),
              std::string::npos)
        << made.err;
    const std::string info = shell.must("graincrack-post info --check s.h5");
    EXPECT_NE(info.find("  crystals                 34\n"), std::string::npos) << info;
    EXPECT_NE(info.find("  tessellation             imported\n"), std::string::npos) << info;
    shell.must(
        "graincrack-post material with augig-granite --set phases.from=granite >minerals.toml\n"
        "graincrack-solve uniaxial s.h5 --material minerals.toml --rate 100mm/s --max-strain 0.004 --quiet -o run.h5\n"
        "graincrack-post cracks run.h5 --quiet -o cracks");
    const std::string classes = shell.must("graincrack-post classes run.h5 --quiet");
    for (const char* mineral : {"quartz", "k_feldspar", "plagioclase", "mica"}) {
        EXPECT_NE(classes.find("\twithin_" + std::string(mineral) + "\t"), std::string::npos) << classes;
    }
    EXPECT_EQ(n_lines(content_of(shell.file("cracks/crystals.tsv"))), 1 + 34);

    // A key that was named is not lost.
    const std::string key = content_of(shell.file("key.tsv"));
    const Outcome again = shell.run("graincrack-mesh import " + picture + " --write-key key.tsv");
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_NE(again.err.find("--write-key: key.tsv is there already; "), std::string::npos) << again.err;
    shell.must("graincrack-mesh import " + picture + " --phase-key key.tsv --write-key key.tsv --quiet");
    EXPECT_EQ(content_of(shell.file("key.tsv")), key);

    // The numbers of the palette are the same labels.
    shell.must("printf '0\\tquartz\\n1\\tk_feldspar\\n2\\tplagioclase\\n3\\tmica\\n' >key.tsv");
    shell.must(call + "--crystals break --quiet -o numbers.h5");
    const H5Input colours(shell.file("s.h5"));
    const H5Input numbers(shell.file("numbers.h5"));
    for (const char* group : {"/nodes", "/elements"}) expect_same_arrays(colours, numbers, group);
}

TEST(Import, RefusesInOneLine) {
    const Shell shell;
    shell.must(
        "printf '\\x89PNG' >x.png; printf 'key\\tphase\\nx\\ty\\n' >key.tsv; printf '7 7\\n8 8\\n' >labels.txt; mkdir folder");
    const std::string squares = meshes + "two-squares-neper.msh";
    const std::tuple<std::string, int, std::string> cases[] = {
        {"nothing.msh", 3, "nothing.msh: cannot be read: No such file or directory"},
        {"folder", 3, "folder: is a folder; a mesh of Gmsh"},
        {squares + " --format tetgen", 2, "--format: unknown choice \"tetgen\"; one of gmsh|"},
        {squares + " --grain grain", 2, "--grain: unknown choice \"grain\"; one of element|entity|physical fits"},
        {squares + " --shape cube", 2,
         "--shape: unknown choice \"cube\"; one of rectangle|disc|ring|beam|half-disc|polygon fits"},
        {squares + " --origin 1", 2, "--origin: \"1\" is not understood; give X,Y as 40mm,80mm"},
        {squares + " --scale 0mm", 2, "--scale: "},
        {squares + " --phase-key key.tsv", 3, "key.tsv: no row for 1; each grain needs one"},
        {squares + " --crystals brittle", 2, "--crystals: unknown choice \"brittle\"; one of elastic|break fits"},
        {squares + " --crystals break --grain element", 2, "--crystals break: with --grain element each element is a crystal"},
        {squares + " --phases a=0.5,b=0.5", 2, "--phases: the file says of what phases its grains are"},
        {squares + " --edge 4mm", 2, "--edge"},
        {squares + " --pixel-size 1mm", 2, "--pixel-size: "},
        {"labels.txt", 2, "--pixel-size: missing; a picture needs the length of a pixel's side, as 0.1mm"},
        {"labels.txt --write-key new.tsv", 2, "--write-key: makes no specimen; leave -o out"},
        {"x.png --pixel-size 1mm", 3, "x.png: begins with"},
        {"/dev/zero", 3, "/dev/zero: has more than the 512 MB that are read at most"},
        {"- </dev/zero", 3, "stdin: has more than the 512 MB that are read at most"},
        {"- </dev/null", 3, "stdin: empty: the program before wrote nothing; see its message"},
    };
    for (const auto& [call, code, message] : cases) {
        const Outcome outcome = shell.run("graincrack-mesh import " + call + " -o s.h5");
        EXPECT_EQ(outcome.exit_code, code) << call;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
        EXPECT_EQ(content_of(shell.file("s.h5")), "");
    }
}

}  // namespace
}  // namespace graincrack::test
