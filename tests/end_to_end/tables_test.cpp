// Commands that studies and scripts take values and tables from.
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Tables, AMaterialGivesItsValuesAndTakesOthers) {
    const Shell shell;
    EXPECT_EQ(shell.must("graincrack-post material value contact.cohesion augig-granite"), "74.57\n");
    EXPECT_EQ(shell.must("graincrack-post material value contact.friction_angle augig-granite"), "48.76\n");
    EXPECT_EQ(shell.must("graincrack-post material value rock.mode_i_toughness augig-granite"), "1.5\n");
    EXPECT_EQ(shell.must("graincrack-post material value rock.young_modulus augig-granite --unit GPa"), "25.8\n");
    EXPECT_EQ(shell.must("graincrack-post material with augig-granite --set 'contact.cohesion=71 MPa' >stiff.toml\n"
                         "graincrack-post material value contact.cohesion stiff.toml"),
              "71\n");
    EXPECT_EQ(shell.must("graincrack-post fpz --material stiff.toml | wc -l"),
              shell.must("graincrack-post fpz --material augig-granite | wc -l"));
}

TEST(Tables, WhatAMaterialDoesNotHaveIsSaid) {
    const Shell shell;
    const auto refused = [&shell](const std::string& arguments, int code, const std::string& message) {
        const Outcome outcome = shell.run("graincrack-post material " + arguments);
        EXPECT_EQ(outcome.exit_code, code) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
    };
    refused("value contact.cohesoin augig-granite", 2, "contact.cohesoin: unknown key (did you mean contact.cohesion?)");
    refused("value contact.residual_cohesion augig-granite", 3, "augig-granite.toml: has no contact.residual_cohesion");
    refused("value contact.cohesion augig-granite --unit mm", 2, "--unit mm: contact.cohesion is a stress; one of Pa");
    refused("with augig-granite --set contact.cohesion", 2, "--set contact.cohesion: KEY=VALUE is needed");
    refused("with augig-granite --set contact.cohesion=5mm", 2, "contact.cohesion");
}

TEST(Tables, PropertiesOfTests) {
    const Shell shell;
    const std::string test = " --mass-scaling none --rate 400mm/s --max-strain 0.03 --peak-drop 0.01 --quiet ";
    shell.must(make_disc + "disc.h5\ngraincrack-mesh rectangle --width 20mm --height 40mm --edge 5mm --quiet -o rectangle.h5\n" +
               "graincrack-solve brazilian disc.h5 -o brazilian.h5 --material augig-granite" + test +
               "\ngraincrack-solve uniaxial rectangle.h5 -o uniaxial.h5 --material augig-granite" + test);
    const std::string table = shell.must("graincrack-post properties uniaxial.h5 brazilian.h5 --material augig-granite");
    EXPECT_EQ(n_lines(table), 5);
    EXPECT_EQ(cell(table, "property"), "young_modulus_GPa");
    EXPECT_EQ(cell(table, "laboratory"), "25.8");
    const auto strength = [&](const std::string& file, const std::string& column) {
        return cell(shell.must("graincrack-post strength " + file), column);
    };
    EXPECT_NE(table.find("tensile_strength_MPa\t8.8\t8.7\t" + strength("brazilian.h5", "tensile_strength_MPa")),
              std::string::npos);
    EXPECT_NE(table.find("s1_at_0_MPa\t122\t125.4\t" + strength("uniaxial.h5", "peak_compressive_stress_MPa")),
              std::string::npos);
}

TEST(Tables, SummariesForPeople) {
    const Shell shell;
    shell.must(
        "printf 'file\\ttest\\tstress\\na.h5\\tdisc\\t8\\nb.h5\\tdisc\\t10\\nc.h5\\tdisc\\t9\\n' >strength.tsv\n"
        "printf 'file\\tvariant\\na.h5\\tslow\\nb.h5\\tslow\\nc.h5\\tfast\\n' >variants.tsv");
    shell.must(
        "printf '%s\\n' \"SELECT variant, mean_and_half(stress, '.1f') AS [σt, MPa] FROM strength JOIN variants USING (file)\" "
        "'GROUP BY variant ORDER BY variant DESC' >means.sql");
    EXPECT_EQ(shell.must("graincrack-post summarize strength=- variants.tsv --sql means.sql --format markdown <strength.tsv"),
              "| variant | σt, MPa |\n|---|---|\n| slow | 9.0 ± 12.7 |\n| fast | 9.0 |\n");
    EXPECT_EQ(shell.must("graincrack-post summarize strength.tsv --sql 'SELECT test, file, stress FROM strength' --pivot"),
              "test\ta.h5\tb.h5\tc.h5\ndisc\t8\t10\t9\n");
    const auto exit_code = [&](const std::string& sql) {
        const Outcome outcome = shell.run("graincrack-post summarize strength.tsv --sql '" + sql + "'");
        EXPECT_EQ(outcome.out, "") << sql;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        return outcome.exit_code;
    };
    EXPECT_EQ(exit_code("SELECT strain\nFROM strength"), 2);
    EXPECT_EQ(exit_code("PRAGMA table_list"), 2);
    EXPECT_EQ(exit_code("SELECT mean(file) FROM strength"), 3);
}

}  // namespace
}  // namespace graincrack::test
