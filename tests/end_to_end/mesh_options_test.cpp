// graincrack-mesh from outside: the executable, its files, messages and exit codes.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "share/file/h5_file.hpp"
#include "share/file/specimen.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;

struct Answer {
    int code = 0;
    std::string text;
    [[nodiscard]] bool has(const std::string& words) const { return text.find(words) != std::string::npos; }
};

/// Runs a shell command with `mesh` standing for the tool; stderr and stdout together unless redirected.
Answer run(const std::string& arguments) {
    const std::string command = "(" GRAINCRACK_BIN "/graincrack-mesh " + arguments + ") 2>&1";
    Answer answer;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {-1, "no shell"};
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) answer.text.append(buffer.data(), n);
    answer.code = WEXITSTATUS(pclose(pipe));
    return answer;
}

class GraincrackMesh : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(fs::exists(GRAINCRACK_BIN "/graincrack-mesh")) << "build graincrack-mesh first";
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() / ("graincrack_mesh_" + std::string(test->name()) + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
};

const std::string small = "rectangle --width 40mm --height 60mm --grains 200 ";

TEST_F(GraincrackMesh, WritesASpecimenAndItsStatistics) {
    const Answer answer = run("rectangle --width 80mm --height 160mm --grains 1122 --material augig-granite -o " + file("a.h5"));
    ASSERT_EQ(answer.code, 0) << answer.text;
    EXPECT_TRUE(answer.has("rectangle of 1122 grains"));
    EXPECT_TRUE(answer.has("psi6"));
    EXPECT_TRUE(answer.has("contact zone"));
    const Specimen s = read_specimen(H5Input(file("a.h5"), "specimen"));
    EXPECT_EQ(s.n_grains(), 1122U);
    EXPECT_EQ(s.shape, "rectangle");
    EXPECT_DOUBLE_EQ(s.width, 0.08);
    EXPECT_GT(s.statistics.mean_edge, 0.005);
}

TEST_F(GraincrackMesh, SameSeedSameDigest) {
    for (const char* name : {"a.h5", "b.h5"}) {
        EXPECT_EQ(run("disc --diameter 80mm --grains 452 --seed 3 --elements-per-edge 2 -q -o " + file(name)).text, "");
    }
    EXPECT_EQ(run("disc --diameter 80mm --grains 452 --seed 4 --elements-per-edge 2 -q -o " + file("c.h5")).code, 0);
    const std::string digest = H5Input(file("a.h5")).digest();
    EXPECT_EQ(H5Input(file("b.h5")).digest(), digest);
    EXPECT_NE(H5Input(file("c.h5")).digest(), digest);
}

TEST_F(GraincrackMesh, DiscsOfFewGrainsAreValid) {
    for (const std::string grains : {"12", "40", "150"}) {
        ASSERT_EQ(run("disc --diameter 80mm --grains " + grains + " -q -o " + file("a.h5")).code, 0);
        EXPECT_NO_THROW(read_specimen(H5Input(file("a.h5"), "specimen"))) << grains;
    }
}

TEST_F(GraincrackMesh, WritesToStdout) {
    EXPECT_EQ(run(small + "--quiet -o - > " + file("piped.h5")).text, "");
    EXPECT_EQ(run(small + "--quiet -o " + file("file.h5")).code, 0);
    EXPECT_EQ(H5Input(file("piped.h5")).digest(), H5Input(file("file.h5")).digest());
}

TEST_F(GraincrackMesh, DryRunTellsCountsAndWritesNothing) {
    const Answer answer = run(small + "--dry-run -o " + file("a.h5"));
    EXPECT_EQ(answer.code, 0);
    EXPECT_TRUE(answer.has("200 grains"));
    EXPECT_TRUE(answer.has("600 nodes"));
    EXPECT_TRUE(answer.has("MB"));
    EXPECT_FALSE(fs::exists(file("a.h5")));
    EXPECT_EQ(run("disc --diameter 80mm --edge 5mm --dry-run").code, 0) << "needs no output";
}

TEST_F(GraincrackMesh, PrintedConfigurationLoadsAgain) {
    ASSERT_EQ(run(small + "--seed 9 -o " + file("a.h5") + " --print-config > " + file("a.toml")).code, 0);
    EXPECT_FALSE(fs::exists(file("a.h5")));
    ASSERT_EQ(run("rectangle --quiet --config " + file("a.toml")).text, "");
    ASSERT_EQ(run(small + "--seed 9 --quiet -o " + file("b.h5")).text, "");
    EXPECT_EQ(H5Input(file("a.h5")).digest(), H5Input(file("b.h5")).digest());
}

TEST_F(GraincrackMesh, PhasesAndStrengthFactorsAreInTheFile) {
    const std::string fabric =
        "--phases quartz=0.3,mica=0.7 --phase-seed 4 --phase-cluster 3 --strength-modulus 5 "
        "--strength-correlation 10mm --strength-seed 6 ";
    const Answer answer = run(small + fabric + "-o " + file("a.h5"));
    ASSERT_EQ(answer.code, 0) << answer.text;
    EXPECT_TRUE(answer.has("quartz 0.")) << answer.text;
    EXPECT_TRUE(answer.has("(0.3 requested) in ")) << answer.text;
    EXPECT_TRUE(answer.has("modulus 5, correlated over 10 mm")) << answer.text;
    const H5Input read(file("a.h5"), "specimen");
    const Specimen s = read_specimen(read);
    EXPECT_EQ(s.phase_names, (std::vector<std::string>{"quartz", "mica"}));
    EXPECT_EQ(s.contact_strength_factor.size(), s.n_contacts());
    EXPECT_EQ(read.attribute<std::vector<double>>("/grains/phase", "fractions"), phase_fractions(s));
    ASSERT_EQ(run(small + fabric + "-o " + file("b.h5") + " --print-config > " + file("b.toml")).code, 0);
    ASSERT_EQ(run("rectangle --quiet --config " + file("b.toml")).text, "");
    EXPECT_EQ(H5Input(file("b.h5")).digest(), read.digest());
    ASSERT_EQ(run(small + "--quiet -o " + file("plain.h5")).text, "");
    const H5Input plain(file("plain.h5"));
    EXPECT_FALSE(plain.has("/contacts/strength_factor") || plain.has("/contacts/class"));
    EXPECT_FALSE(plain.has_attribute("/grains/phase", "fractions"));
}

TEST_F(GraincrackMesh, PolygonsAreWrittenAndRepeated) {
    const std::string disc = "disc --diameter 80mm --grains 60 --tessellation ";
    const std::string sizes = " --spread 0.5 --size-distribution lognormal --element-size 4mm ";
    for (const std::string tessellation : {"voronoi", "trigon"}) {
        const Answer answer = run(disc + tessellation + sizes + "-o " + file("a.h5"));
        ASSERT_EQ(answer.code, 0) << answer.text;
        EXPECT_TRUE(answer.has("60 polygons (" + tessellation + ")")) << answer.text;
        EXPECT_TRUE(answer.has("short edges were removed")) << answer.text;
        const Specimen s = read_specimen(H5Input(file("a.h5"), "specimen"));
        EXPECT_EQ(s.tessellation, tessellation);
        ASSERT_EQ(run(disc + tessellation + sizes + "-o " + file("b.h5") + " --print-config > " + file("b.toml")).code, 0);
        ASSERT_EQ(run("disc --quiet --config " + file("b.toml")).text, "");
        EXPECT_EQ(H5Input(file("b.h5")).digest(), H5Input(file("a.h5")).digest());
        EXPECT_TRUE(run(disc + tessellation + " --dry-run").has("60 polygons"));
    }
}

TEST_F(GraincrackMesh, EveryKindIsWrittenAndRepeated) {
    std::ofstream(file("l.tsv"))
        << "x_mm\ty_mm\tpart\n0\t0\tbottom\n40\t0\tright\n40\t20\t\n20\t20\t\n20\t40\ttop\n0\t40\tleft\n";
    std::ofstream(file("flaws.tsv")) << "# two\nx1_mm\ty1_mm\tx2_mm\ty2_mm\tclass\n5\t3\t12\t3\tbroken\n-9\t8\t9\t9\tvein\n";
    std::ofstream(file("holes.tsv")) << "x_mm\ty_mm\tradius_mm\n3\t-5\t2\n";
    const std::string cuts = " --edge 2mm --holes " + file("holes.tsv") + " --flaws " + file("flaws.tsv");
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"rectangle",
         "rectangle --width 40mm --height 40mm --notch 12mm --notch-angle 90deg --joint-set spacing=15mm,dip=-80deg" + cuts},
        {"disc", "disc --diameter 40mm" + cuts},
        {"disc", "disc --diameter 40mm --flats 20deg --slit 12mm --slit-angle 60deg --edge 2mm"},
        {"ring", "ring --diameter 40mm --inner-diameter 14mm --edge 2mm --hole 12mm,5mm,3mm"},
        {"beam", "beam --length 80mm --height 20mm --notch 8mm --edge 2mm --hole -20mm,0,3mm --hole 20mm,0,3mm"},
        {"half-disc", "half-disc --diameter 40mm --slit 8mm --edge 1.5mm"},
        {"polygon", "polygon " + file("l.tsv") + " --edge 2mm --hole 10mm,30mm,3mm --flaws " + file("flaws.tsv")}};
    for (const auto& [shape, arguments] : kinds) {
        const Answer answer = run(arguments + " -o " + file("a.h5"));
        ASSERT_EQ(answer.code, 0) << arguments << answer.text;
        EXPECT_EQ(answer.has("moved by (-20 mm, -20 mm)"), shape == "polygon") << answer.text;
        const H5Input written(file("a.h5"), "specimen");
        EXPECT_EQ(read_specimen(written).shape, shape);
        ASSERT_EQ(run(arguments + " -o " + file("b.h5") + " --print-config > " + file("b.toml")).code, 0);
        const Answer again = run(arguments.substr(0, arguments.find(' ')) + " --quiet --config " + file("b.toml"));
        ASSERT_EQ(again.text, "") << arguments;
        EXPECT_EQ(H5Input(file("b.h5")).digest(), written.digest()) << arguments;
    }
}

TEST_F(GraincrackMesh, UnknownKeyIsAnError) {
    std::ofstream(file("bad.toml")) << "[rectangle]\ngrain = 7\n";
    const Answer answer = run(small + "-o " + file("a.h5") + " --config " + file("bad.toml"));
    EXPECT_EQ(answer.code, 2);
    EXPECT_TRUE(answer.has("grain")) << answer.text;
    EXPECT_FALSE(fs::exists(file("a.h5")));
}

TEST_F(GraincrackMesh, BadInputGivesOneLineAndItsCode) {
    const std::string out = " -o " + file("never.h5");
    const std::string size = "rectangle --width 80mm --height 160mm ";
    const std::vector<std::tuple<std::string, int, std::string>> cases{
        {"", 2, "subcommand"},
        {"rectangle --width -80mm --height 160mm --edge 4mm" + out, 2, "--width"},
        {"rectangle --height 160mm --edge 4mm" + out, 2, "--width"},
        {size + "--edge 4kg" + out, 2, "--edge"},
        {size + "--edge 4m" + out, 2, "--edge"},
        {size + "--edge 90mm" + out, 2, "--edge"},
        {size + "--grains 0" + out, 2, "--grains"},
        {size + "--grains 4.5" + out, 2, "--grains"},
        {size + "--grains 3" + out, 2, "--grains"},
        {size + out, 2, "--grains"},
        {size + "--edge 4mm --grains 1122" + out, 2, "--grains"},
        {size + "--edge 4mm --spread 0.9" + out, 2, "--spread"},
        {size + "--edge 4mm --spread 0.4" + out, 2, "--spread"},
        {size + "--edge 4mm --grade along=y" + out, 2, "--grade"},
        {size + "--edge 4mm --grade along=y,from=0.01,to=1" + out, 2, "from"},
        {size + "--edge 4mm --grade towards=flaws,from=0.5,distance=20mm" + out, 2, "no flaw"},
        {size + "--edge 4mm --grade towards=boundary,from=0.2,distance=4mm" + out, 2, "distance"},
        {size + "--edge 4mm --elongation 5" + out, 2, "--elongation"},
        {size + "--edge 4mm --elements-per-edge 0" + out, 2, "--elements-per-edge"},
        {size + "--edge 4mm --tessellation hexagons" + out, 2, "--tessellation"},
        {size + "--edge 4mm --tessellation voronoi --hole 0mm,0mm,2mm" + out, 2, "--edge"},
        {size + "--edge 4mm --tessellation voronoi --notch 1mm" + out, 2, "--notch"},
        {size + "--edge 4mm --tessellation trigon --spread 0.7" + out, 2, "--spread"},
        {size + "--edge 4mm --tessellation trigon --elements-per-edge 2" + out, 2, "--elements-per-edge"},
        {size + "--edge 4mm --tessellation voronoi --size-distribution even" + out, 2, "--size-distribution"},
        {size + "--edge 4mm --element-size 1mm" + out, 2, "--element-size"},
        {size + "--edge 4mm --phases quartz=0.6,mica=0.5" + out, 2, "--phases"},
        {size + "--edge 4mm --phases quartz" + out, 2, "--phases"},
        {size + "--edge 4mm --phase-cluster 3" + out, 2, "--phase-cluster"},
        {size + "--edge 4mm --phase-seed 3" + out, 2, "--phase-seed"},
        {size + "--edge 4mm --strength-correlation 10mm" + out, 2, "--strength-correlation"},
        {size + "--edge 4mm --strength-modulus 0" + out, 2, "--strength-modulus"},
        {size + "--edge 4mm --open-boundaries 1" + out, 2, "--open-boundaries"},
        {size + "--edge 4mm --open-boundaries 120%" + out, 2, "--open-boundaries"},
        {size + "--edge 4mm --open-seed 3" + out, 2, "--open-seed"},
        {size + "--edge 4mm", 2, "-o"},
        {"disc --diameter 80mm --edge 4mm --pole corner" + out, 2, "--pole"},
        {"disc --diameter 80mm --edge 4mm --material no-such-rock" + out, 3, "no-such-rock"},
        {"disc --diameter 80mm --edge 4mm -o " + file("no/such/folder/a.h5"), 5, "a.h5"},
    };
    for (const auto& [arguments, code, words] : cases) {
        const Answer answer = run(arguments);
        EXPECT_EQ(answer.code, code) << arguments << "\n" << answer.text;
        EXPECT_TRUE(answer.has(words)) << arguments << "\n" << answer.text;
        EXPECT_EQ(answer.text.rfind("graincrack-mesh: ", 0), 0U) << answer.text;
        EXPECT_EQ(std::count(answer.text.begin(), answer.text.end(), '\n'), 1) << answer.text;
    }
    EXPECT_TRUE(fs::is_empty(folder_)) << "failed calls leave nothing";
}

TEST_F(GraincrackMesh, HelpNamesUnits) {
    const Answer help = run("--help");
    EXPECT_EQ(help.code, 0);
    EXPECT_TRUE(run("rectangle --help").has("mm"));
    EXPECT_TRUE(run("--version").has("CGAL"));
}

}  // namespace
}  // namespace graincrack
