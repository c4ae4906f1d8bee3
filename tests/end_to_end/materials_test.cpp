// Materials through the three programs: kinds of rock, minerals, flaws and crystals that break.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "share/file/run_file.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string values =
    " --set laboratory.young_modulus=60GPa --set laboratory.poisson_ratio=0.2 --set laboratory.density=2700kg/m3"
    " --set laboratory.tensile_strength=9MPa --set laboratory.compressive_strength=150MPa --set laboratory.friction_angle=50deg"
    " --set laboratory.grain_size=4mm --set laboratory.mode_i_toughness=1.4MPa.m^0.5 --set laboratory.crack_initiation=60MPa"
    " --set laboratory.crack_damage=110MPa --quiet";

/// Sum of a column over the rows of `graincrack-post classes` whose class begins so.
double sum_of_classes(const Shell& shell, const std::string& run, const std::string& column, const std::string& start = "") {
    return std::stod(shell.must("graincrack-post classes " + run + ".h5 --format tsv | awk -F '\\t' -v name=" + column +
                                " -v start='" + start +
                                "' 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } "
                                "NR > 1 && index($at[\"class\"], start) == 1 { sum += $at[name] } END { print sum + 0 }'"));
}

TEST(Kinds, EachIsWrittenAndTestedWithWhatFollowsFromTheStrength) {
    const Shell shell;
    const std::string list = "\n" + shell.must("graincrack-post material init --list");
    for (const std::string kind : {"granite", "gabbro", "marble", "quartzite"}) {
        EXPECT_NE(list.find("\n" + kind + " "), std::string::npos) << list;
        shell.must("graincrack-post material init " + kind + " --kind " + kind + values +
                   "\ngrep -q '; numbers behind a # are' " + kind +
                   ".toml\ngraincrack-mesh rectangle --width 16mm --height 32mm --material " + kind +
                   ".toml --quiet -o s.h5\n"
                   "graincrack-solve uniaxial s.h5 --material " +
                   kind + ".toml --rate 50mm/s --max-strain 0.0003 --quiet -o " + kind + ".h5");
        const auto ratio = [&](const std::string& key) {
            return std::stod(shell.must("graincrack-post material value ratios." + key + " " + kind + ".toml --quiet"));
        };
        const std::string strength = shell.must("graincrack-post --quiet strength " + kind + ".h5 --format tsv --all-columns");
        EXPECT_NEAR(std::stod(cell(strength, "contact_cohesion_MPa")), ratio("cohesion") * ratio("tensile_strength") * 9, 1e-3);
    }
    shell.must("mkdir folder\ngraincrack-post calibrate folder --material gabbro.toml");
    EXPECT_NE(content_of(shell.file("folder/wanted.tsv")).find("--grain-size 4mm --tessellation trigon --spread 0.3"),
              std::string::npos);
}

TEST(Kinds, WithoutOneItIsGraniteWhoseValuesAreMissing) {
    const Shell shell;
    const Outcome made = shell.run("graincrack-post material init my-rock");
    EXPECT_EQ(made.exit_code, 0);
    EXPECT_NE(made.err.find("my-rock.toml: of the kind granite; --kind names another"), std::string::npos) << made.err;
    const Outcome bare = shell.run("graincrack-mesh disc --diameter 20mm --material my-rock.toml -o disc.h5");
    EXPECT_EQ(bare.exit_code, 3);
    EXPECT_NE(bare.err.find("keys are missing: rock.young_modulus"), std::string::npos) << bare.err;
    EXPECT_EQ(shell.run("graincrack-post material init").exit_code, 2);
}

TEST(Materials, GiveTheirValuesToScripts) {
    const Shell shell;
    const std::string value = "graincrack-post material value ";
    EXPECT_EQ(shell.must(value + "contact.friction_angle augig-granite"), "48.76\n");
    EXPECT_EQ(shell.must(value + "rock.young_modulus augig-granite --unit GPa"), "25.8\n");
    EXPECT_EQ(shell.must("graincrack-post material with augig-granite --set 'contact.cohesion=71 MPa' >other.toml\n" + value +
                         "contact.cohesion other.toml"),
              "71\n");
}

// Else what is computed of the run would count bridges that it did not have.
TEST(Materials, ARunByALawWithoutBridgesHasNoneOfTheMaterials) {
    const Shell shell;
    shell.must(
        "graincrack-post material with augig-granite --set ratios.bridging_strength=0.5 --set ratios.bridging_energy=1 >m.toml\n"
        "graincrack-mesh rectangle --width 10mm --height 20mm --grains 30 --quiet -o s.h5");
    for (const auto& [law, bridges] : {std::pair("consistent", true), std::pair("combined", false)}) {
        shell.must(
            std::string("graincrack-solve tension s.h5 --material m.toml --rate 20mm/s --max-strain 1e-5 --quiet -o run.h5 "
                        "--contact-law ") +
            law);
        EXPECT_EQ(RunReader(shell.file("run.h5")).header().contact.bridging_energy > 0, bridges) << law;
    }
}

TEST(Materials, CracksByMineralAndFlawAddUpToThoseOfTheTest) {
    const Shell shell;
    write_text(shell.file("rock.toml"), content_of(GRAINCRACK_SOURCE "/share/materials/augig-granite.toml") + R"(
[phases.quartz]
fraction = 0.3
relative_young_modulus = 1.4
[phases.feldspar]
fraction = 0.6
[phases.mica]
fraction = 0.1
relative_young_modulus = 0.4
[strength]
modulus = 5
[flaws.vein]
tensile_strength = 1e6
cohesion = "2 MPa"
fracture_energy = "4 J/m2"
)");
    write_text(shell.file("flaws.tsv"), "x1_mm\ty1_mm\tx2_mm\ty2_mm\tclass\n-20\t-12\t20\t12\tvein\n");
    shell.must(
        "graincrack-mesh rectangle --width 20mm --height 40mm --edge 4mm --material rock.toml --flaws flaws.tsv --quiet -o s.h5\n"
        "graincrack-solve uniaxial s.h5 --material rock.toml --rate 400mm/s --max-strain 0.01 --quiet -o run.h5\n"
        "graincrack-post plot cracks run.h5 --class vein -o map.svg");
    const std::string strength = shell.must("graincrack-post --quiet strength run.h5 --format tsv");
    for (const char* column : {"tensile_cracks", "shear_cracks"}) {
        EXPECT_EQ(sum_of_classes(shell, "run", column), std::stod(cell(strength, column))) << column;
    }
    EXPECT_GT(sum_of_classes(shell, "run", "tensile_cracks"), 0);
    EXPECT_GT(sum_of_classes(shell, "run", "tensile_cracks", "vein") + sum_of_classes(shell, "run", "shear_cracks", "vein"), 0);
    EXPECT_NE(content_of(shell.file("map.svg")).find("contacts of vein"), std::string::npos);
    // The strength without a unit is told by what reads the material.
    EXPECT_NE(shell.run("graincrack-post fpz --material rock.toml").err.find(": note: rock.toml: line "), std::string::npos);
    const Outcome missing = shell.run("graincrack-solve uniaxial s.h5 --material augig-granite --quiet -o other.h5");
    EXPECT_EQ(missing.exit_code, 3);
    EXPECT_NE(missing.err.find("[flaws.vein]"), std::string::npos) << missing.err;
}

TEST(Crystals, TwoInARowBreakWithinOrBetweenAsTheirStrengthsSay) {
    const Shell shell;
    shell.must(
        "graincrack-mesh rectangle --width 10mm --height 24mm --grains 2 --tessellation trigon --element-size 3mm --seed 3 "
        "--quiet -o s.h5");
    const auto cracks = [&](const std::string& name, const std::string& classes) {
        return sum_of_classes(shell, name, "tensile_cracks", classes) + sum_of_classes(shell, name, "shear_cracks", classes);
    };
    for (const auto& [name, strength] : {std::pair{"weak", "2 MPa"}, std::pair{"strong", "60 MPa"}}) {
        shell.must(std::string("graincrack-post material with augig-granite --set 'flaws.within_rock.tensile_strength=") +
                   strength + "' >m.toml\ngraincrack-solve tension s.h5 --material m.toml --rate 20mm/s --max-strain 0.004 " +
                   "--quiet -o " + name + ".h5");
        const bool is_weak = name == std::string("weak");
        EXPECT_EQ(cracks(name, "within_") > 0, is_weak);
        EXPECT_EQ(cracks(name, "rock-") > 0, !is_weak);
    }
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
    shell.must("graincrack-post plot cracks open.h5 --quiet --frame before,peak -o map.svg");
    EXPECT_NE(content_of(shell.file("map.svg")).find("pre-existing"), std::string::npos);
}

}  // namespace
}  // namespace graincrack::test
