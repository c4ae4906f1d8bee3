#include "post/command_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_kind.hpp"
#include "tests/support/synthetic_run.hpp"

namespace graincrack {
namespace {

class Commands : public ::testing::Test {
protected:
    void SetUp() override {
        test::write_run(folder_.file("run.h5"), {});
        H5Output file(folder_.file("specimen.h5"), "specimen");
        write_specimen(file, test::grid_specimen(2, 2, 0.1, 0.1));
        file.commit();
    }
    /// The output on stdout of a call without the name of the tool.
    std::string output_of(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"graincrack-post", "--quiet"});
        std::vector<const char*> argv;
        for (const std::string& argument : arguments) argv.push_back(argument.c_str());
        std::ostringstream out;
        run_command_line(static_cast<int>(argv.size()), argv.data(), out);
        return out.str();
    }
    test::TemporaryFolder folder_;
};

TEST_F(Commands, InfoNamesKindCountsAndDatasets) {
    const std::string run = output_of({"info", folder_.file("run.h5")});
    const std::string schema = ", schema " + std::to_string(schema_version);
    for (const std::string& words : std::initializer_list<std::string>{"run" + schema, "uniaxial", "Augig granite",
                                                                       "/contacts/nodes", "/history/axial_stress"}) {
        EXPECT_NE(run.find(words), std::string::npos) << words;
    }
    const std::string specimen = output_of({"info", folder_.file("specimen.h5"), "--check"});
    EXPECT_NE(specimen.find("specimen" + schema), std::string::npos);
    EXPECT_NE(specimen.find("every dataset was read"), std::string::npos);
}

TEST_F(Commands, InfoDoesNotInventWhatIsMissing) {
    H5Output file(folder_.file("bare.h5"), "run");
    file.create_group("/specimen");
    file.create_group("/run");
    file.commit();
    const std::string info = output_of({"info", folder_.file("bare.h5")});
    EXPECT_NE(info.find("  seed                     unknown\n"), std::string::npos) << info;
    EXPECT_NE(info.find("  steps                    unknown\n"), std::string::npos) << info;
}

TEST_F(Commands, DigestIsThatOfTheContent) {
    const std::vector<std::string> call{"info", folder_.file("run.h5"), "--digest"};
    const std::string first = output_of(call);
    EXPECT_EQ(first.find("  "), 64U);
    test::write_run(folder_.file("run.h5"), {});
    EXPECT_EQ(output_of(call), first);
    test::Recipe other;
    other.peak *= 1.0000001;
    test::write_run(folder_.file("run.h5"), other);
    EXPECT_NE(output_of(call), first);
}

TEST_F(Commands, HistoryHasUnitsAndTheSignsOfTheFile) {
    const std::string table = output_of({"history", folder_.file("run.h5")});
    EXPECT_EQ(test::parse_tsv(table).size(), 112U);
    EXPECT_EQ(test::field(table, "time_s", 100), "1");
    EXPECT_EQ(test::field(table, "axial_stress_Pa", 100), "-1.25e+08");  // compression is negative here
    EXPECT_EQ(test::field(table, "tensile_cracks", 100), "20");
}

TEST_F(Commands, StagesAreThoseOfAProgram) {
    test::expect_one_line<InputError>(
        [&] {
            output_of({"history", folder_.file("run.h5"), "--stages"});
        },
        {"run.h5", "recorded only for runs of `graincrack-solve program`"});
    RunWriter writer(H5Output(folder_.file("program.h5"), "run"), test::Recipe{}.specimen, test::synthetic_header({}));
    writer.append_history(test::synthetic_history({}));
    H5Output& file = writer.file();
    const std::vector<double> times{0, 1};
    for (const char* dataset : {"/program/begin", "/program/end"}) {
        file.write<double>(dataset, times, {times.size()}, "s", "of each stage");
    }
    file.attribute("/program", "stages", std::vector<std::string>{"press", "push"});
    file.attribute("/program", "ended_by", std::vector<std::string>{"rest"});
    Provenance provenance;
    provenance.tool = "synthetic";
    provenance.command_line = {"synthetic"};
    provenance.libraries = {"none"};
    writer.finish(test::synthetic_header({}), {}, provenance);
    test::expect_one_line<InputError>(
        [&] {
            output_of({"history", folder_.file("program.h5"), "--stages"});
        },
        {"program.h5", "stages differ in number"});
}

TEST_F(Commands, TheKindOfRockNeedsNoRuns) {
    const test::KindFolder folder(test::SyntheticKind{}.rows(70));
    const std::vector<std::string> call{"properties", "--material", "lac-du-bonnet-granite-calibrated"};
    EXPECT_NE(output_of(call).find("\ns1_at_0_MPa\t200\t"), std::string::npos);
    test::expect_one_line<UsageError>(
        [&] {
            output_of({"properties", "--material", "augig-granite"});
        },
        {"runs: missing", "augig-granite.toml: its contact.law is not given"});
    EXPECT_EQ(test::field(output_of({"kind"}), "term", 1), "ln(cohesion/5)");
    EXPECT_EQ(output_of({"kind", folder.table()}), output_of({"kind"}));
    EXPECT_EQ(test::parse_tsv(output_of({"kind", "--rocks"})).size(), 1U);
    test::expect_one_line<UsageError>([&] { output_of({"kind", folder.table(), folder.table()}); }, {"kind: takes one file"});
}

TEST_F(Commands, FpzTableHoldsThePapersNumbers) {
    const std::string material = std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml";
    const auto rows = test::parse_tsv(output_of({"fpz", "--material", material}));
    ASSERT_EQ(rows[0], (std::vector<std::string>{"quantity", "plane", "value", "unit", "equation"}));
    const auto value = [&](const std::string& quantity, const std::string& plane) {
        for (const auto& row : rows) {
            EXPECT_EQ(row.size(), 5U);
            EXPECT_NE(row[4], "") << row[0];
            if (row[0] == quantity && row[1] == plane) return std::stod(row[2]);
        }
        ADD_FAILURE() << "no row " << quantity << " " << plane;
        return 0.0;
    };
    // MODEL's table for Augig granite, printed to three or four digits.
    EXPECT_NEAR(value("contact_normal_stiffness", "stress"), 6.51e5, 0.01e5);
    EXPECT_NEAR(value("contact_normal_stiffness", "strain"), 6.87e5, 0.01e5);
    EXPECT_NEAR(value("contact_shear_stiffness", "strain"), 6.98e4, 0.01e4);
    EXPECT_NEAR(value("mixed_mode_fracture_energy", "stress"), 436.0, 0.1);
    EXPECT_NEAR(value("mode_i_fracture_energy", "strain"), 82.6, 0.1);
    EXPECT_NEAR(value("min_grain_size", ""), 0.4, 0.01);
    EXPECT_NEAR(value("min_grain_size_shear", ""), 1.59, 0.01);
    EXPECT_NEAR(value("max_grain_size", ""), 8.6, 0.1);
    EXPECT_NEAR(value("mixed_mode_contact_zone_length", "strain"), 17.0, 0.1);
    EXPECT_NEAR(value("mode_i_contact_zone_length", "strain"), 3.4, 0.1);
    EXPECT_NEAR(value("lennard_jones_b(8,13)", ""), 0.298187, 1e-6);
    EXPECT_NEAR(value("contact_tensile_strength_from_toughness(4 mm)", ""), 26.8, 0.05);
    EXPECT_NEAR(value("contact_tensile_strength_from_toughness(5.13 mm)", ""), 23.6, 0.05);
    EXPECT_NEAR(value("tensile_strength_from_toughness", ""), 10.3, 0.05);
}

TEST_F(Commands, FpzNeedsLaboratoryValuesAlone) {
    std::ofstream(folder_.file("marble.toml")) << "name = \"marble\"\n[laboratory]\nyoung_modulus = \"49 GPa\"\n"
                                                  "poisson_ratio = 0.19\ntensile_strength = \"7 MPa\"\ngrain_size = \"2 mm\"\n";
    const auto values = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"fpz", "--material", folder_.file("marble.toml")});
        std::map<std::string, double> found;
        const auto rows = test::parse_tsv(output_of(more));
        for (std::size_t i = 1; i < rows.size(); ++i) found[rows[i][0]] = std::stod(rows[i][2]);
        return found;
    };
    const auto of_rock = values({});
    const double toughness = 7 / 6.88;  // MPa√m, by Zhang (2002)
    EXPECT_NEAR(of_rock.at("tensile_strength_from_toughness"), 7, 1e-5);
    // Eq 40: 2 K_IC/√(π dp)
    const auto strength = [&](double edge) { return 2 * toughness / std::sqrt(std::numbers::pi * edge); };
    EXPECT_NEAR(of_rock.at("contact_tensile_strength_from_toughness(2 mm)"), strength(2e-3), 1e-4);
    EXPECT_EQ(of_rock.count("contact_tensile_strength_from_toughness(5.13 mm)"), 0U);  // grains of another rock
    EXPECT_EQ(of_rock.count("critical_opening"), 0U);
    const auto asked = values({"--edge", "1.5mm", "--edge", "3mm"});
    EXPECT_NEAR(asked.at("contact_tensile_strength_from_toughness(1.5 mm)"), strength(1.5e-3), 1e-4);
    EXPECT_NEAR(asked.at("contact_tensile_strength_from_toughness(3 mm)"), strength(3e-3), 1e-4);
    EXPECT_EQ(asked.count("contact_tensile_strength_from_toughness(2 mm)"), 0U);
    EXPECT_THROW((void)values({"--edge", "far"}), UsageError);
}

TEST_F(Commands, DesignFitAndSolveByTheirTables) {
    const std::string design = output_of({"ccd", "design", "--factor", "contact_cohesion_MPa=30.525:91.575", "--factor",
                                          "contact_friction_angle_deg=45.05:60.95"});
    EXPECT_EQ(test::parse_tsv(design).size(), 14U);
    EXPECT_EQ(design.substr(0, design.find('\n')), "run\tx1\tx2\tcontact_cohesion_MPa\tcontact_friction_angle_deg");
    EXPECT_EQ(test::field(design, "contact_cohesion_MPa", 4), "17.88113");

    const std::string runs = std::string(GRAINCRACK_TEST_DATA) + "/table7.csv";
    const auto fit = [&](const std::string& table) {
        return output_of({"ccd", "fit", runs, "--response", "C_MPa", "--response", "phi_deg", "--table", table});
    };
    const std::string terms = fit("terms");
    EXPECT_EQ(test::field(terms, "term", 3), "x1 x2");
    EXPECT_NEAR(std::stod(test::field(terms, "coefficient", 3)), -7.48, 0.006);  // Eq 19
    const std::string anova = fit("anova");
    double parts = 0;  // model and residual make up the total
    for (std::size_t row : {0U, 6U}) parts += std::stod(test::field(anova, "sum_of_squares", row));
    EXPECT_NEAR(parts, std::stod(test::field(anova, "sum_of_squares", 9)), 1e-3);
    EXPECT_EQ(test::field(anova, "source", 7), "lack of fit");
    EXPECT_NEAR(std::stod(test::field(fit("summary"), "r_squared", 1)), 0.944, 0.0005);
    const std::string solution = output_of({"ccd", "solve", runs, "--target", "C_MPa=21", "--target", "phi_deg=53"});
    EXPECT_LT(std::stod(test::field(solution, "cc_MPa_region_low")), 72);
    EXPECT_GT(std::stod(test::field(solution, "cc_MPa_region_high")), 77);
    EXPECT_EQ(test::field(solution, "region_reaches_edge"), "no");
    const std::string picture = folder_.file("surface.svg");
    (void)output_of({"plot", "surface", runs, "--target", "C_MPa=21", "--target", "phi_deg=53", "-o", picture});
    EXPECT_NE(test::read_text(picture).find("cc 74.57 MPa"), std::string::npos);
    EXPECT_THROW((void)output_of({"ccd", "solve", runs}), UsageError);
}

TEST_F(Commands, ThresholdsShowOtherDefinitionsOnRequest) {
    const std::string run = folder_.file("run.h5");
    const auto picture = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"plot", "thresholds", run, "-o", folder_.file("t.svg")};
        words.insert(words.end(), more.begin(), more.end());
        (void)output_of(words);
        return test::read_text(folder_.file("t.svg"));
    };
    EXPECT_EQ(picture({}).find("count of cracks"), std::string::npos);
    EXPECT_EQ(picture({"--definitions", "default"}), picture({}));
    EXPECT_NE(picture({"--definitions", "all"}).find("CI by count of cracks"), std::string::npos);
    test::expect_one_line<UsageError>([&] { (void)picture({"--definitions", "some"}); }, {"--definitions", "all"});
}

TEST_F(Commands, WrongUseIsRefused) {
    const std::string run = folder_.file("run.h5");
    EXPECT_THROW((void)output_of({"strength", "-", "-"}), UsageError);
    EXPECT_THROW((void)output_of({"history", run, run}), UsageError);
    EXPECT_THROW((void)output_of({"strength", folder_.file("specimen.h5")}), InputError);
    EXPECT_THROW((void)output_of({"plot", "curve", run, "-o", folder_.file("curve.gif")}), UsageError);
    test::expect_one_line<UsageError>([&] { (void)output_of({"strength"}); },
                                      {"runs: missing; strength needs a file, or --files-from"});
    test::expect_one_line<UsageError>(
        [&] {
            (void)output_of({"plot", "energy", run, run, "-o", folder_.file("a.svg")});
        },
        {"plot energy: takes one file, not 2"});
}

}  // namespace
}  // namespace graincrack
