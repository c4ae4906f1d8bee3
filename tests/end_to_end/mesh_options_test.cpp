// graincrack-mesh from outside: its files, messages and exit codes.
#include <string>
#include <vector>

#include "share/file/h5_file.hpp"
#include "share/file/specimen.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string small = "graincrack-mesh rectangle --width 40mm --height 60mm --grains 200 ";

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }
std::string hash_of(const Shell& shell, const std::string& file) { return H5Input(shell.file(file)).digest(); }

/// Makes a.h5, and from the printed configuration b.h5, which must be the same. \return what was said of it
std::string made_twice(const Shell& shell, const std::string& command) {
    const Outcome made = shell.run(command + " --verbose -o a.h5");
    EXPECT_EQ(made.exit_code, 0) << command << "\n" << made.err;
    shell.must(command + " -o b.h5 --print-config >b.toml");
    const std::string words = command.substr(0, command.find(' ', command.find(' ') + 1));  // the program and its subcommand
    EXPECT_EQ(shell.run(words + " --quiet --config b.toml").err, "") << command;
    EXPECT_EQ(hash_of(shell, "b.h5"), hash_of(shell, "a.h5")) << command;
    return made.err;
}

TEST(MeshOptions, ASpecimenAndItsStatisticsAreWritten) {
    const Shell shell;
    const std::string said =
        made_twice(shell, "graincrack-mesh rectangle --width 80mm --height 160mm --grains 1122 --material augig-granite");
    EXPECT_TRUE(has(said, "a.h5: rectangle of 80 × 160 mm, 1,122 grains, mean 3.81 mm; 1,122 triangles, 1,637 contacts\n"))
        << said;
    EXPECT_TRUE(has(said, "0.66 elements a contact zone between crystals")) << said;
    const Specimen s = read_specimen(H5Input(shell.file("a.h5"), "specimen"));
    EXPECT_EQ(s.n_grains(), 1122U);
    EXPECT_DOUBLE_EQ(s.width, 0.08);
    shell.must(small + "--quiet -o - >piped.h5\n" + small + "--quiet -o file.h5\n" + small + "--seed 4 --quiet -o other.h5");
    EXPECT_EQ(hash_of(shell, "piped.h5"), hash_of(shell, "file.h5"));
    EXPECT_NE(hash_of(shell, "other.h5"), hash_of(shell, "file.h5"));
    EXPECT_FALSE(H5Input(shell.file("file.h5")).has("/contacts/strength_factor"));
}

TEST(MeshOptions, ADryRunTellsCountsAndWritesNothing) {
    const Shell shell;
    const std::string told = shell.must(small + "--dry-run -o a.h5");
    EXPECT_TRUE(has(told, "rectangle of 200 grains, mean about 3.91 mm\n  about 200 elements and 300 contacts, a file of "))
        << told;
    EXPECT_TRUE(has(shell.must("graincrack-mesh disc --diameter 80mm --grains 60 --tessellation trigon --dry-run"),
                    "disc of 60 crystals, mean about 10.3 mm\n  about 4"));
    EXPECT_EQ(shell.names(), "");
}

TEST(MeshOptions, PhasesAndStrengthFactorsAreInTheFile) {
    const Shell shell;
    const std::string said =
        made_twice(shell, small +
                              "--phases quartz=0.3,mica=0.7 --phase-seed 4 --phase-cluster 3 --strength-modulus 5 "
                              "--strength-correlation 10mm --strength-seed 6 --open-boundaries 0.2");
    EXPECT_TRUE(has(said, "  phases: quartz 29.8 %") && has(said, "modulus 5, correlated over 10 mm")) << said;
    const H5Input file(shell.file("a.h5"), "specimen");
    const Specimen s = read_specimen(file);
    EXPECT_EQ(s.phase_names, (std::vector<std::string>{"quartz", "mica"}));
    EXPECT_EQ(s.contact_strength_factor.size(), s.n_contacts());
    EXPECT_EQ(file.attribute<std::vector<double>>("/grains/phase", "fractions"), phase_fractions(s));
}

TEST(MeshOptions, EveryKindIsWrittenAndRepeated) {
    const Shell shell;
    write_text(shell.file("l.tsv"),
               "x_mm\ty_mm\tpart\n0\t0\tbottom\n40\t0\tright\n40\t20\t\n20\t20\t\n20\t40\ttop\n0\t40\tleft\n");
    write_text(shell.file("flaws.tsv"), "# two\nx1_mm\ty1_mm\tx2_mm\ty2_mm\tclass\n5\t3\t12\t3\tbroken\n-9\t8\t9\t9\tvein\n");
    write_text(shell.file("holes.tsv"), "x_mm\ty_mm\tradius_mm\n3\t-5\t2\n");
    const std::string cuts = " --edge 2mm --holes holes.tsv --flaws flaws.tsv";
    const std::string crystals = " --spread 0.5 --size-distribution lognormal --element-size 4mm --tessellation ";
    for (const std::string& arguments :
         {"rectangle --width 40mm --height 40mm --slit 12mm --slit-angle 90deg --joint-set spacing=15mm,dip=-80deg" + cuts,
          "disc --diameter 40mm" + cuts,
          std::string("disc --diameter 40mm --flats 20deg --slit 12mm --slit-angle 60deg --edge 2mm --elements-per-edge 2"),
          "disc --diameter 80mm --grains 60" + crystals + "voronoi", "disc --diameter 80mm --grains 60" + crystals + "trigon",
          std::string("ring --diameter 40mm --inner-diameter 14mm --edge 2mm --hole 12mm,5mm,3mm"),
          std::string("beam --length 80mm --height 20mm --slit 8mm --edge 2mm --hole -20mm,0,3mm --hole 20mm,0,3mm"),
          std::string("half-disc --diameter 40mm --slit 8mm --edge 1.5mm"),
          std::string("polygon l.tsv --edge 2mm --hole 10mm,30mm,3mm --flaws flaws.tsv")}) {
        const std::string said = made_twice(shell, "graincrack-mesh " + arguments);
        const std::string shape = arguments.substr(0, arguments.find(' '));
        EXPECT_EQ(has(said, "moved by (-20 mm, -20 mm)"), shape == "polygon") << said;
        EXPECT_EQ(has(said, ", 60 "), has(arguments, "tessellation")) << said;
        EXPECT_EQ(read_specimen(H5Input(shell.file("a.h5"), "specimen")).shape, shape);
    }
}

TEST(MeshOptions, TwoLinesAreSaidAndWhatIsWrong) {
    const Shell shell;
    shell.must(
        "graincrack-post material with augig-granite-calibrated --set ratios.process_zone=0.1 >brittle.toml\n"
        "graincrack-post material with augig-granite-calibrated --set ratios.process_zone=1 >tough.toml");
    const std::string made = "graincrack-mesh rectangle --width 24mm --height 48mm --grain-size 2mm --material ";
    const std::string two = shell.run(made + "tough.toml -o s.h5").err;
    EXPECT_EQ(n_lines(two), 2) << two;
    EXPECT_TRUE(has(two, "s.h5: rectangle of 24 × 48 mm, 336 crystals, mean 2 mm; 2,") && has(two, "\n  phases: k_feldspar 33."))
        << two;
    // The zone of boundaries is 9 pi/32 of 0.1 grain sizes of 4 mm; within crystals it is longer.
    const std::string short_zone = shell.run(made + "brittle.toml -o s.h5").err;
    EXPECT_EQ(n_lines(short_zone), 3);
    EXPECT_TRUE(has(short_zone, "warning: 0.37 elements a contact zone between crystals, 353 um long: ")) << short_zone;
    const std::string round = "graincrack-mesh rectangle --width 40mm --height 40mm --grains 250 --hole 0,0,6mm -o s.h5";
    EXPECT_TRUE(has(shell.run(round).err, "warning: hole_1 is a polygon of ")) << "of triangles";
    EXPECT_FALSE(has(shell.run(round + " --tessellation trigon --seed 3").err, "hole_1"));
    const Specimen s = read_specimen(H5Input(shell.file("s.h5"), "specimen"));
    EXPECT_GE(std::count(s.boundary_part.begin(), s.boundary_part.end(), 5), 16);
}

TEST(MeshOptions, WorkEndsAtTheFirstSignalWhereverItIs) {
    const Shell shell;
    const std::string stopped = " -o s.h5 & sleep 0.5; kill -TERM $!; SECONDS=0; wait $!; code=$?; ((SECONDS < 4)) && exit $code";
    for (const std::string call : {"mkfifo pipe; graincrack-mesh import pipe",
                                   "graincrack-mesh rectangle --width 1m --height 1m --grains 900000 --tessellation trigon"}) {
        const Outcome outcome = shell.run(call + stopped);
        EXPECT_EQ(outcome.exit_code, 128 + 15) << call;
        EXPECT_EQ(outcome.err, "graincrack-mesh: stopped by signal 15\n") << call;
        EXPECT_EQ(shell.names(), "pipe\n") << call;
    }
}

TEST(MeshOptions, PipesAndLongPicturesAreRead) {
    const Shell shell;
    shell.must(
        "yes 7 | head -100000 >long.txt\n"
        "timeout 100 graincrack-mesh import long.txt --pixel-size 0.1mm --quiet -o long.h5\n"
        "printf '1 1 2\\n1 3 2\\n3 3 2\\n' >s.txt; printf '1\\ta\\n2\\tb\\n3\\tc\\n' >key.tsv\n"
        "import='--smallest-piece 1 --pixel-size 1mm --quiet -o'\n"
        "graincrack-mesh import s.txt --phase-key key.tsv $import a.h5\n"
        "graincrack-mesh import <(cat s.txt) --phase-key <(cat key.tsv) $import b.h5");
    EXPECT_EQ(hash_of(shell, "a.h5"), hash_of(shell, "b.h5"));
}

}  // namespace
}  // namespace graincrack::test
