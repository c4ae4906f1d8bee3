// Polygonal grains that break: where, their strengths decide.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "share/file/run_file.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

/// Cracks at the end in classes whose names begin so.
double cracks_of(const std::string& table, const std::string& prefix) {
    std::istringstream lines(table);
    double sum = 0;
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> fields;
        std::istringstream words(line);
        for (std::string word; std::getline(words, word, '\t');) fields.push_back(word);
        if (fields.size() < 9 || fields[0] == "file") continue;
        if (fields[1].substr(0, prefix.size()) == prefix) sum += std::atof(fields[7].c_str()) + std::atof(fields[8].c_str());
    }
    return sum;
}

TEST(Crystals, TwoInARowBreakWithinOrBetweenAsTheirStrengthsSay) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 10mm --height 24mm --grains 2 --tessellation trigon --element-size 3mm --seed 3 "
        "--quiet -o s.h5\n"
        "graincrack-post info --check s.h5");
    const auto table = [&](const std::string& name, const std::string& strength) {
        return shell.must("graincrack-post material with augig-granite --set 'flaws.within_rock.tensile_strength=" + strength +
                          "' >" + name +
                          ".toml\n"
                          "graincrack-solve tension s.h5 --material " +
                          name + ".toml --rate 20mm/s --max-strain 0.004 --quiet -o " + name +
                          ".h5\n"
                          "graincrack-post classes " +
                          name + ".h5");
    };
    const std::string weak = table("weak", "2 MPa");
    EXPECT_GT(cracks_of(weak, "within_"), 0) << weak;
    EXPECT_EQ(cracks_of(weak, "rock-"), 0) << weak;
    const std::string strong = table("strong", "60 MPa");
    EXPECT_EQ(cracks_of(strong, "within_"), 0) << strong;
    EXPECT_GT(cracks_of(strong, "rock-"), 0) << strong;
    const std::string text = shell.must("graincrack-post classes weak.h5 --format table");
    EXPECT_NE(text.find("within crystals"), std::string::npos) << text;
    EXPECT_NE(text.find("between crystals"), std::string::npos) << text;
    // Without a table of their own they are as contacts between two crystals of the phase.
    shell.must(
        "graincrack-solve tension s.h5 --material augig-granite --rate 20mm/s --max-strain 0.001 --quiet -o plain.h5\n"
        "graincrack-post plot cracks plain.h5 --class within --quiet -o within.png\n"
        "graincrack-post plot cracks plain.h5 --class between --quiet -o between.png");
}

TEST(Crystals, OpenBoundariesWeakenATestAndAreNoCracksOfIt) {
    const Shell shell;
    const auto strength = [&](const std::string& name, const std::string& options) {
        shell.must(
            "graincrack-mesh rectangle --width 20mm --height 20mm --grains 40 --tessellation trigon --elements-per-crystal 8 " +
            options + "--quiet -o " + name + "-s.h5\ngraincrack-solve tension " + name +
            "-s.h5 --material augig-granite --rate 20mm/s --max-strain 0.002 --quiet -o " + name + ".h5");
        const History history = RunReader(shell.file(name + ".h5")).history();
        const auto& stress = history[HistoryColumn::axial_stress];
        return *std::max_element(stress.begin(), stress.end());
    };
    EXPECT_LT(strength("open", "--open-boundaries 30% "), 0.9 * strength("closed", ""));
    const RunReader run(shell.file("open.h5"));
    const std::vector<std::uint8_t> kinds = run.specimen().contact_kind;
    EXPECT_GT(run.cracks().size(), 0U);
    for (const Crack& crack : run.cracks()) EXPECT_FALSE(starts_broken(kinds[static_cast<std::size_t>(crack.contact)]));
    const std::string open = shell.must("graincrack-post info open.h5 | grep open_boundaries");
    EXPECT_NE(open.find(" of their length"), std::string::npos) << open;
    for (const char* frame : {"peak", "before,peak"}) {
        shell.must(std::string("graincrack-post plot cracks open.h5 --quiet --frame ") + frame + " -o map.svg");
        EXPECT_NE(content_of(shell.file("map.svg")).find("pre-existing"), std::string::npos) << frame;
    }
}

}  // namespace
}  // namespace graincrack::test
