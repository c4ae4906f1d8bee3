// A rock of one's own from its kind: the file, its specimen, a test and the first step of a calibration.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

const std::string values =
    " --set laboratory.young_modulus=60GPa --set laboratory.poisson_ratio=0.2 --set laboratory.density=2700kg/m3"
    " --set laboratory.tensile_strength=9MPa --set laboratory.compressive_strength=150MPa --set laboratory.friction_angle=50deg"
    " --set laboratory.grain_size=4mm --set laboratory.mode_i_toughness=1.4MPa.m^0.5 --set laboratory.crack_initiation=60MPa"
    " --set laboratory.crack_damage=110MPa --quiet";

/// A value of [ratios] of a material.
double ratio(const Shell& shell, const std::string& material, const std::string& key) {
    return std::stod(shell.must("graincrack-post material value ratios." + key + " " + material + ".toml --quiet"));
}

TEST(Kinds, EachIsListedWrittenAndTested) {
    const Shell shell;
    const std::string list = "\n" + shell.must("graincrack-post material init --list");
    for (const std::string kind : {"granite", "gabbro", "marble", "quartzite"}) {
        EXPECT_NE(list.find("\n" + kind + " "), std::string::npos) << list;
        shell.must("graincrack-post material init " + kind + " --kind " + kind + values);
        shell.must("graincrack-mesh rectangle --width 16mm --height 32mm --material " + kind + ".toml --quiet -o s.h5\n" +
                   "graincrack-solve uniaxial s.h5 --material " + kind + ".toml --rate 50mm/s --max-strain 0.0003 --quiet -o " +
                   kind + ".h5");
        const std::string info = shell.must("graincrack-post info " + kind + ".h5");
        EXPECT_NE(info.find("trigon, grain-size 4 mm, spread 0.3, elements-per-crystal 8"), std::string::npos) << info;
        // The run file has what follows from the Brazilian strength.
        const std::string strength = shell.must("graincrack-post --quiet strength " + kind + ".h5 --format tsv");
        EXPECT_NEAR(std::stod(cell(strength, "contact_cohesion_MPa")),
                    ratio(shell, kind, "cohesion") * ratio(shell, kind, "tensile_strength") * 9, 1e-3);
    }
    // An option that moves the tensile strength moves what follows from it.
    shell.must(
        "graincrack-solve uniaxial s.h5 --material quartzite.toml --contact-tensile-strength 4MPa --rate 50mm/s "
        "--max-strain 0.0001 --quiet -o other.h5");
    const std::string other = shell.must("graincrack-post --quiet strength other.h5 --format tsv");
    EXPECT_NEAR(std::stod(cell(other, "contact_cohesion_MPa")), ratio(shell, "quartzite", "cohesion") * 4, 1e-3);
    EXPECT_NEAR(std::stod(cell(other, "contact_fracture_energy_J/m2")),
                ratio(shell, "quartzite", "process_zone") * 4e-3 * 16e12 / 60e9, 1e-4);
}

TEST(Kinds, ACalibrationBeginsWithLaboratoryValues) {
    const Shell shell;
    shell.must("graincrack-post material init my-rock --kind gabbro" + values + "\nmkdir folder");
    EXPECT_EQ(shell.must("graincrack-post calibrate folder --material my-rock.toml"), "folder/wanted.tsv\n");
    const std::string wanted = content_of(shell.file("folder/wanted.tsv"));
    EXPECT_NE(wanted.find("--grain-size 4mm --tessellation trigon --spread 0.3 --elements-per-crystal 8"), std::string::npos)
        << wanted;
    // The rows run: their material is made and read.
    shell.must(
        "graincrack-post material with my-rock.toml $(awk -F '\\t' 'NR == 2 { print $4 }' folder/wanted.tsv) >run.toml\n"
        "graincrack-post plot law --material run.toml -o law.svg");
}

TEST(Kinds, WithoutOneItIsGraniteAndSaysSo) {
    const Shell shell;
    const Outcome made = shell.run("graincrack-post material init my-rock");
    EXPECT_EQ(made.exit_code, 0);
    EXPECT_NE(made.err.find("my-rock.toml: of the kind granite; --kind names another"), std::string::npos) << made.err;
    EXPECT_NE(content_of(shell.file("my-rock.toml")).find("from = \"granite\""), std::string::npos);
    const Outcome bare = shell.run("graincrack-mesh disc --diameter 20mm --material my-rock.toml -o disc.h5");
    EXPECT_EQ(bare.exit_code, 3);
    EXPECT_EQ(n_lines(bare.err), 1);
    EXPECT_NE(bare.err.find("keys are missing: rock.young_modulus"), std::string::npos) << bare.err;
    const Outcome unknown = shell.run("graincrack-post material init other --kind marbel");
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_NE(unknown.err.find("--kind marbel: unknown kind (did you mean marble?)"), std::string::npos) << unknown.err;
    EXPECT_EQ(shell.run("graincrack-post material init").exit_code, 2);
    shell.must("graincrack-post material init every --kind every-key");
    EXPECT_NE(content_of(shell.file("every.toml")).find("law = \"consistent\""), std::string::npos);
}

}  // namespace
}  // namespace graincrack::test
