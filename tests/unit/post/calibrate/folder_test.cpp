// A calibration by its files: the same decisions as in memory, from tables as `strength` and `moduli` write them.
#include "post/calibrate/folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>

#include "share/base/error.hpp"
#include "share/base/table_file.hpp"
#include "share/base/units.hpp"
#include "share/rock/material.hpp"
#include "tests/support/check.hpp"
#include "tests/support/synthetic_rock.hpp"
#include "tests/support/synthetic_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::calibrate {
namespace {

using test::expect_one_line;
using test::SyntheticRock;

std::string granite() { return test::read_text(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml"); }

/// The box of a parameter. \throws std::out_of_range
Parameter box_of(const Problem& problem, const std::string& key) {
    for (const Parameter& p : problem.parameters) {
        if (p.key == key) return p;
    }
    throw std::out_of_range(key);
}

class CalibrateFolder : public ::testing::Test {
protected:
    void SetUp() override { write_material(""); }
    void write_material(const std::string& more) { write_rock(granite() + "\n" + more); }
    void write_rock(const std::string& text) { std::ofstream(folder_.file("material.toml")) << text; }
    /// The row of a run on the material of the file.
    [[nodiscard]] RunRow row_for(const calibrate::Test& test, const std::vector<std::string>& settings = {},
                                 const Point& point = {}) const {
        return row_of(material(), read_problem(material(), settings).study, {test, 7, point, {}, "d1p01", ""});
    }
    [[nodiscard]] Material material() const { return read_material(folder_.file("material.toml")); }
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(folder_.file(name)); }
    [[nodiscard]] std::string text(const std::string& name) const { return test::read_text(folder_.file(name)); }
    [[nodiscard]] nlohmann::json outcome() const { return nlohmann::json::parse(text("outcome.json")); }
    [[nodiscard]] std::string folder() const { return std::filesystem::path(folder_.file("x")).parent_path().string(); }
    [[nodiscard]] FolderDecision ask() const {
        std::ostringstream notes;
        return calibrate_folder(folder(), "", {}, notes);
    }

    /// The words behind each `flag` in the options of a tool.
    static std::vector<std::string> values_of(const std::string& options, const std::string& flag) {
        std::vector<std::string> values;
        std::istringstream words(options);
        for (std::string word; words >> word;) {
            if (word == flag && words >> word) values.push_back(word);
        }
        return values;
    }
    /// "Runs" at most so many rows of requested.tsv, from the options of the tools in them alone; adds them to the tables.
    void run_wanted(const SyntheticRock& synthetic, std::size_t most) {
        const TableFile requested(folder_.file("wanted.tsv"));
        const auto files = requested.texts("file");
        const auto meshes = requested.texts("mesh");
        const auto materials = requested.texts("material");
        const auto solves = requested.texts("solve");
        for (std::size_t i = 0; i < std::min(requested.n_rows(), most); ++i) {
            EXPECT_TRUE(made_.insert(files[i]).second) << files[i] << " is wanted twice";
            RequestedRun run;
            run.test.name = solves[i].substr(0, solves[i].find(' '));
            run.seed = std::stoll(values_of(meshes[i], "--seed").at(0));
            if (run.test.name == "bend") {
                EXPECT_EQ(meshes[i].find("half-disc --diameter 80mm --slit 20mm --grains 226 "), 0U) << meshes[i];
                toughness_ += fmt::format("augig-granite.1234/{}\t1.2\n", files[i]);
            }
            for (const std::string& pressure : values_of(solves[i], "--confining-pressure")) {
                run.test.confining_pressure = parse_quantity(pressure, quantity::confining_pressure, "pressure");
            }
            for (const std::string& setting : values_of(materials[i], "--set")) {
                const std::string key = setting.substr(0, setting.find('='));
                run.point.emplace_back(key, parse_quantity(setting.substr(key.size() + 1), material_quantity(key), key));
            }
            const Measures measures = synthetic.measure(run);
            const auto row = [&](const std::vector<std::string>& columns) {
                std::string line = "augig-granite.1234/" + files[i];
                for (const std::string& column : columns) {
                    line += measures.contains(column) ? fmt::format("\t{:.7g}", measures.at(column)) : "\t";
                }
                return line + "\n";
            };
            strength_ += row(strength_columns);
            if (run.test.loading() == Loading::compression) moduli_ += row(moduli_columns);
        }
        std::ofstream(folder_.file("strength.tsv")) << strength_;
        std::ofstream(folder_.file("moduli.tsv")) << moduli_;
        if (toughness_.find(".h5") != std::string::npos) std::ofstream(folder_.file("toughness.tsv")) << toughness_;
    }
    /// Asks and runs until the end. \param share of the requested runs that are made before the next interruption
    FolderDecision to_the_end(const SyntheticRock& synthetic, double share) {
        FolderDecision out = ask();
        for (int calls = 1; out.decision.ending == Ending::requested && calls < 200; ++calls) {
            EXPECT_FALSE(has("report.md"));
            const std::size_t n = out.decision.requested.size();
            run_wanted(synthetic, static_cast<std::size_t>(std::ceil(share * static_cast<double>(n))));
            out = ask();
        }
        return out;
    }
    void expect_outcome(const Material& calibrated) const {
        const nlohmann::json found = outcome();
        EXPECT_EQ(found["state"], "calibrated");
        EXPECT_EQ(found["files"]["material"], "calibrated.toml");
        EXPECT_EQ(found["runs"]["finished"], made_.size());
        const nlohmann::json value = found["values"]["contact.cohesion"];
        EXPECT_NEAR(value["value"], calibrated.contact.cohesion.value(), 100);  // Pa; the material has six digits
        EXPECT_GT(value["value"], value["low"]);
        EXPECT_EQ(found["values"]["rock.young_modulus"]["low"], nullptr);
        EXPECT_EQ(found["targets"]["uniaxial"]["laboratory"], 122e6);
        EXPECT_NEAR(found["targets"]["uniaxial"]["value"], 122e6, 6e6);
        EXPECT_EQ(found["targets"]["uniaxial"]["verdict"], "within");
        EXPECT_EQ(found["caveats"][0]["code"], "missing_values");
        EXPECT_EQ(found["caveats"][0]["of"], "crack_damage");
    }
    /// Of the rows of identify.tsv.
    [[nodiscard]] std::vector<double> exponents_of(const std::string& response, const std::string& parameter) const {
        const TableFile identify(folder_.file("identify.tsv"));
        std::vector<double> found;
        for (std::size_t i = 0; i < identify.n_rows(); ++i) {
            const bool is_it = identify.text(i, "response") == response && identify.text(i, "parameter") == parameter;
            if (is_it) found.push_back(identify.number(i, "exponent"));
        }
        return found;
    }
    static SyntheticRock rock() {
        SyntheticRock rock = SyntheticRock::usual();
        rock.scatter = 0.3;
        rock.reference = {{"contact.tensile_strength", 20e6}, {"contact.cohesion", 55e6}, {"contact.friction_angle", 0.65}};
        for (auto& [name, response] : rock.responses) {
            response.exponents.erase("contact.fracture_energy");
            response.exponents.erase("contact.residual_friction_angle");
        }
        return rock;
    }

    static inline const std::vector<std::string> strength_columns{"tensile_strength_MPa", "first_peak_MPa", "residual_MPa",
                                                                  "wall_time_s"};
    static inline const std::vector<std::string> moduli_columns{"young_modulus_GPa", "poisson_ratio", "crack_initiation_MPa"};
    test::TemporaryFolder folder_;
    std::set<std::string> made_;
    std::string strength_ = "file\ttensile_strength_MPa\tfirst_peak_MPa\tresidual_MPa\twall_time_s\n";
    std::string toughness_ = "file\tmode_i_toughness_MPa.m^0.5\n";
    std::string moduli_ = "file\tyoung_modulus_GPa\tpoisson_ratio\tcrack_initiation_MPa\n";
};

TEST_F(CalibrateFolder, FromMaterialToCalibratedMaterial) {
    const std::string behind =
        "# of the user\n[study] # usual\npoints = 20\n[temperature]\ntemperatures = [0, # K\n 300]\nyoung_modulus = [1, 1]";
    write_material("[fitted] # earlier\nporosity = \"1\" # %\n# on discs\ntensile_strength = \"1\" # MPa\n\n" + behind);
    const FolderDecision first = ask();
    EXPECT_EQ(first.decision.ending, Ending::requested);
    EXPECT_EQ(first.requested_time, 0);
    EXPECT_EQ(outcome()["state"], "running");
    EXPECT_EQ(outcome()["runs"], (nlohmann::json{{"finished", 0}, {"wanted", 2}}));
    EXPECT_EQ(outcome()["files"]["wanted"], "wanted.tsv");
    run_wanted(rock(), 100);
    run_wanted(rock(), 0);
    EXPECT_EQ(ask().requested_time, 2 * 6);  // two uniaxial tests at 6 s each
    const FolderDecision out = to_the_end(rock(), 1);
    ASSERT_EQ(out.decision.ending, Ending::calibrated) << out.decision.reason;
    EXPECT_FALSE(has("wanted.tsv"));
    EXPECT_FALSE(has("nearest.toml"));
    const Material calibrated = read_material(folder_.file("calibrated.toml"));  // a material like any other
    EXPECT_EQ(calibrated.name, "Augig granite, calibrated");
    EXPECT_NEAR(calibrated.contact.cohesion.value(), 55e6, 3e6);
    EXPECT_NEAR(calibrated.rock.young_modulus, 25.8e9 / 0.95, 0.02e9);
    EXPECT_EQ(calibrated.rock.mode_i_toughness, 1.5e6);
    ASSERT_EQ(calibrated.fitted.size(), 5U);
    EXPECT_EQ(calibrated.fitted.at("confined_strength_8MPa").find("193.5 MPa; "), 0U);
    EXPECT_EQ(calibrated.fitted.count("tensile_strength"), 1U);
    const std::string file = text("calibrated.toml");
    EXPECT_TRUE(file.ends_with(behind)) << file;
    EXPECT_NE(file.find("\n[fitted] # earlier\n# on discs\ntensile_strength = \"8.8 MPa; "), std::string::npos) << file;
    expect_outcome(calibrated);
    const std::string report = text("report.md");
    for (const char* part :
         {"# Augig granite: calibrated",
          "- 3 free parameters: contact.tensile_strength, contact.cohesion, contact.friction_angle\n",
          "- 5 fitted targets: E, ν, Brazilian strength, UCS, first peak at 8 MPa\n",
          "- 2 predicted targets: first peak at 4 MPa", "- K_IC was not tested.", "√(Ẽ G) = 1.5 MPa √m",
          "contact.fracture_energy 78.", "J/m2 (derived)",
          "- first peaks: UCS in 20 of 20 tests; first peak at 8 MPa in 20 of 20 tests", "## Targets", "## Values", "## Surfaces",
          "## What tells what", "## Steps", "| crack damage, MPa | not measured |  |  | 0 of 3 |"}) {
        EXPECT_NE(report.find(part), std::string::npos) << part;
    }
    // d ln UCS / d ln cc = 0.6 and twice the curvature times ln(cc/55 MPa), which is nearly 0.
    EXPECT_NEAR(exponents_of("UCS", "contact.cohesion").at(0), 0.6, 0.06);
    // Asked again it answers the same.
    EXPECT_EQ(ask().decision.ending, Ending::calibrated);
    EXPECT_EQ(text("report.md"), report);
    // Interrupted many times, with no run made twice, it comes to the same end.
    for (const char* name : {"strength.tsv", "moduli.tsv"}) std::filesystem::remove(folder_.file(name));
    strength_.resize(strength_.find('\n') + 1);
    moduli_.resize(moduli_.find('\n') + 1);
    const std::size_t all = made_.size();
    made_.clear();
    EXPECT_EQ(to_the_end(rock(), 0.4).decision.ending, Ending::calibrated);
    EXPECT_EQ(made_.size(), all);
    EXPECT_EQ(text("report.md"), report);
}

// Two rectangles and three discs, whose strengths are told before the others are made.
TEST_F(CalibrateFolder, ADesignBeginsWithOnePointOfEachTest) {
    for (int attempt = 0; attempt < 2; ++attempt) {
        EXPECT_EQ(ask().decision.ending, Ending::requested);
        run_wanted(rock(), 100);
    }
    FolderDecision out = ask();
    EXPECT_EQ(out.decision.requested.size(), 5U);
    EXPECT_EQ(out.requested_time, 0);  // discs and rectangles under pressure: none is finished
    run_wanted(rock(), 100);
    out = ask();
    EXPECT_EQ(out.decision.requested.size(), 19U * 5);
    EXPECT_EQ(out.requested_time, 570);  // s: 95 runs of 6 s
    EXPECT_EQ(out.decision.reason,
              "design 1, point 2 of 20; the middle of the ranges has Brazilian strength 9.39 MPa (target 8.8 MPa), "
              "UCS 133 MPa (target 122 MPa), first peak at 8 MPa 199 MPa (target 193.5 MPa)");
}

TEST_F(CalibrateFolder, WithoutAnEndInReachTheNearestPointIsAMaterial) {
    SyntheticRock weak = rock();
    weak.responses["brazilian tensile_strength_MPa"].exponents.clear();
    weak.responses["brazilian tensile_strength_MPa"].reference = 4;
    const FolderDecision out = to_the_end(weak, 1);
    ASSERT_EQ(out.decision.ending, Ending::not_reached) << out.decision.reason;
    EXPECT_FALSE(has("calibrated.toml"));
    const Material nearest = read_material(folder_.file("nearest.toml"));
    EXPECT_EQ(nearest.name, "Augig granite, nearest point");
    EXPECT_TRUE(has("identify.tsv"));
    EXPECT_EQ(outcome()["state"], "not reached");
    EXPECT_EQ(outcome()["files"]["material"], "nearest.toml");
}

TEST_F(CalibrateFolder, TheReportSaysWhatIsOfNoTest) {
    Material rock = material();
    const Problem problem = read_problem(rock);
    Decision decision;
    decision.fit.emplace().optimum.condition = INFINITY;
    for (const Target& target : problem.targets) decision.outcomes.push_back({target, {}, 1, ""});
    const auto expect = [&](const char* part) {
        const std::string report = report_text({rock, problem, decision}, rock);
        EXPECT_NE(report.find(part), std::string::npos) << part << report;
    };
    expect("| UCS, MPa | fitted | 122 |");
    expect("| first peak at 4 MPa, MPa | predicted | 157.73 (φ line, no test) |");
    expect("There are fewer fitted targets beside E and ν, which scale the grains, than parameters.");
    expect("; the rock has 1.5 MPa √m");
    rock.rock.mode_i_toughness = rock.rock.tensile_strength / fpz::tensile_strength_from_toughness(1);
    expect("; K_IC was not measured, and σt/6.88 is 1.28 MPa √m");
    expect("the first guess, with a standard deviation of half the width of the first box. ");
    decision.fit->optimum.prior = 4;  // widened, where the usual one missed targets
    expect("the first guess, with a standard deviation of 4 times half the width of the first box. ");
}

TEST_F(CalibrateFolder, ToughnessIsComparedOnHalfDiscs) {
    std::string stone = granite();
    stone.insert(stone.find("friction_angle = \"53 deg\""), "mode_i_toughness = \"1.3 MPa.m^0.5\"\n");
    write_rock(stone);
    EXPECT_EQ(to_the_end(rock(), 1).decision.ending, Ending::calibrated);
    const std::string report = text("report.md");
    EXPECT_NE(report.find("| K_IC, MPa√m | predicted | 1.3 | 1.2 (1.2 to 1.2) | 3 of 3 | -7.69 % | ± 10 % | size not known |"),
              std::string::npos)
        << report;
    EXPECT_NE(
        report.find("- K_IC was tested on: half-disc, diameter 80 mm, notch 20 mm, span 48 mm; the laboratory's is of a size "
                    "that the material does not name."),
        std::string::npos);
}

TEST_F(CalibrateFolder, ToughnessIsTestedOnTheSpecimenOfTheLaboratory) {
    const auto row = [&](const std::string& test, const std::vector<std::string>& settings = {}) {
        write_rock(granite() + "mode_i_toughness = {value = \"1.3 MPa.m^0.5\", " + test + "}\n");
        return row_for(tests_of(read_problem(material(), settings).targets).back(), settings);
    };
    const std::string half_disc = "method = \"half-disc\", diameter = \"75 mm\", notch = \"18 mm\"";
    EXPECT_EQ(row(half_disc).mesh, "half-disc --diameter 75mm --slit 18mm --grains 199 --seed 7");
    EXPECT_EQ(row(half_disc).solve, "bend --span 45mm --plane stress");
    EXPECT_EQ(row(half_disc, {"half_disc_diameter=150mm"}).mesh, "half-disc --diameter 150mm --slit 36mm --grains 795 --seed 7");
    EXPECT_EQ(row("method = \"beam\", height = \"40 mm\", notch = \"12 mm\"").mesh,
              "beam --width 176mm --height 40mm --slit 12mm --grains 633 --seed 7");
    EXPECT_EQ(row("method = \"short-rod\", diameter = \"50 mm\"").mesh.find("half-disc --diameter 80mm --slit 20mm "), 0U);
    row("method = \"half-disc\", diameter = \"80 mm\"");
    EXPECT_EQ(to_the_end(rock(), 1).decision.ending, Ending::calibrated);
    EXPECT_NE(text("report.md").find("| -7.69 % | ± 10 % | within |"), std::string::npos) << text("report.md");
    EXPECT_NE(text("report.md").find("span 48 mm, as in the laboratory."), std::string::npos);
    EXPECT_EQ(read_material(folder_.file("calibrated.toml")).toughness_test.size, 0.08);
}

TEST_F(CalibrateFolder, HalfDiscsHaveTheGrainsOfDiscs) {
    write_material("[targets]\ntoughness = {value = \"1.5 MPa.m^0.5\"}\nbrazilian = {value = \"8.8 MPa\"}\n");
    const Problem problem = read_problem(material(), {"diameter=60mm"});
    EXPECT_DOUBLE_EQ(problem.targets.at(0).deviation, 0.15e6);
    const auto tests = tests_of(problem.targets);
    ASSERT_EQ(tests.size(), 2U);
    // The last: discs keep their specimens with it.
    EXPECT_EQ(tests[1].label(), "bend");
    const auto row = [&](const std::vector<std::string>& settings) { return row_for(tests[1], settings); };
    EXPECT_EQ(row({"diameter=60mm"}).mesh, "half-disc --diameter 60mm --slit 15mm --grains 226 --seed 7");
    EXPECT_EQ(row({"diameter=60mm"}).specimen, "half-disc60g226-s7");
    EXPECT_EQ(row({"diameter=60mm"}).solve, "bend --span 36mm --plane stress");
    const RunRow wider = row({"diameter=60mm", "half_disc_diameter=120mm"});
    EXPECT_EQ(wider.mesh, "half-disc --diameter 120mm --slit 30mm --grains 904 --seed 7");
    EXPECT_EQ(wider.solve, "bend --span 72mm --plane stress");
    EXPECT_EQ(row({"mean_edge=4mm"}).mesh, "half-disc --diameter 80mm --slit 20mm --edge 4mm --seed 7");
}

TEST_F(CalibrateFolder, TargetsAndParametersAreRows) {
    write_material(R"([targets]
young_modulus = {value = "25.8 GPa"}
brazilian = {value = "8.8 MPa", deviation = "0.5 MPa"}
first_peak_4MPa = {value = "157 MPa", deviation = "3 %"}
residual_8MPa = {value = "150 MPa", use = "predict"}
direct_tension = {use = "predict"}
[parameters]
"contact.cohesion" = {low = "20 MPa", high = "80 MPa"}
"contact.friction_angle" = {low = "20 deg", high = "50 deg", scale = "linear", first = "30 deg"}
"contact.fracture_energy" = {}
"contact.shear_stiffness" = {low = "1e13", high = "1e15"}
)");
    const Problem problem = read_problem(material());
    ASSERT_EQ(problem.targets.size(), 5U);
    EXPECT_EQ(problem.targets[1].deviation, 0.5e6);
    EXPECT_NEAR(problem.targets[2].deviation, 0.03 * 157e6, 1);
    EXPECT_EQ(problem.targets[2].confining_pressure, 4e6);
    EXPECT_EQ(problem.targets[3].use, Use::predict);
    ASSERT_EQ(problem.parameters.size(), 4U);
    EXPECT_NEAR(problem.parameters[0].value(0), 40e6, 1);  // logarithmic
    EXPECT_NEAR(problem.parameters[1].first, std::numbers::pi / 6, 1e-12);
    // K_IC²/Ẽ in plane strain is 82.6 J/m²: G_I stays between half of it and all of it.
    EXPECT_NEAR(problem.parameters[2].least, 41.3, 0.1);
    EXPECT_NEAR(problem.parameters[2].most, 82.6, 0.1);
    // Tests end behind the first peak, unless a target asks for what comes after: that of a prediction in the end only.
    const std::vector<calibrate::Test> tests = tests_of(problem.targets);
    EXPECT_EQ(row_for(tests[0]).solve,
              "triaxial --confining-pressure 8MPa --max-strain 0.015 --peak-drop none --rate-tolerance 0.006");
    EXPECT_EQ(row_for(tests[1]).solve,
              "triaxial --confining-pressure 4MPa --max-strain 0.015 --peak-drop 0.1 --rate-tolerance 0.006");
    const auto refused = [&](const std::string& more, const std::vector<std::string>& parts) {
        write_material(more);
        expect_one_line<InputError>([&] { read_problem(material()); }, parts);
    };
    refused("[targets]\nbrasilian = {value = \"8 MPa\"}\n", {"targets.brasilian", "did you mean brazilian?"});
    refused("[targets]\nfirst_peak = {value = \"8 MPa\"}\n", {"unknown target", "first_peak_8MPa"});
    refused("[targets]\nbrazilian = {deviation = \"1 MPa\"}\n", {"targets.brazilian", "value is missing"});
    refused("[targets]\nbrazilian = {use = \"predict\"}\n", {"none to be fitted"});
    refused("[targets]\nbrazilian = {value = \"8 MPa\", use = \"maybe\"}\n", {"neither fit nor predict"});
    refused("[targets]\nbrazilian = \"8 MPa\"\n", {"targets.brazilian: a row is needed"});
    refused("[parameters]\n\"contact.cohesions\" = {}\n", {"parameters.contact.cohesions", "unknown key"});
    refused("[parameters]\n\"contact.shear_stiffness\" = {low = \"1e13\"}\n", {"no default bounds", "give low and high"});
    refused("[parameters]\n\"contact.cohesion\" = {low = \"80 MPa\", high = \"20 MPa\"}\n", {"low must be below high"});
    refused("[parameters]\n\"contact.cohesion\" = {middle = \"80 MPa\"}\n", {"unknown key", "first, high, low, scale"});
}

TEST_F(CalibrateFolder, TheLawHasItsParametersAndSpecimensTheMinerals) {
    std::string text = granite();
    text.replace(text.find("[platen]"), 8, "law = \"cohesive-frictional\"\n[phases]\nfrom = \"granite\"\n[platen]");
    write_rock(text);
    const Problem problem = read_problem(material());
    ASSERT_EQ(problem.parameters.size(), 4U);
    EXPECT_EQ(problem.parameters[3].key, "contact.residual_friction_angle");
    const RequestedRun run{{"brazilian", 0, 0.3}, 7, {{"contact.cohesion", 4e7}}, {}, "d1p01", ""};
    const RunRow row = row_of(material(), problem.study, run);
    EXPECT_EQ(row.mesh,
              "disc --diameter 80mm --grains 452 --phases k_feldspar=0.33,mica=0.06,plagioclase=0.29,quartz=0.32 --seed 7");
    EXPECT_EQ(row.specimen, "disc80g452k_33mi6pl29qu32-s7");
    EXPECT_EQ(row.material, "--set contact.cohesion=40MPa");
    EXPECT_EQ(row.solve, "brazilian");
    // A name changes with what the rock is made of, not with what the laboratory has.
    Material other = material();
    other.laboratory["tensile_strength"] = 1;
    EXPECT_EQ(row_of(other, problem.study, run).file, row.file);
    other.fabric.contrast = 0.5;
    EXPECT_NE(row_of(other, problem.study, run).file, row.file);
    // The contrast of the modal table may vary within what is published: its coefficient of variation is 0.214.
    std::ofstream(folder_.file("material.toml"), std::ios::app) << "\n[parameters]\n\"phases.contrast\" = {}\n";
    const Parameter contrast = read_problem(material()).parameters.at(0);
    EXPECT_NEAR(contrast.low, 0.17 / 0.214, 0.01);
    EXPECT_NEAR(contrast.high, 0.32 / 0.214, 0.01);
}

TEST_F(CalibrateFolder, SpecimensHaveTheFabricOfTheMaterial) {
    const std::string fabric =
        "[fabric]\ntessellation = \"trigon\"\ngrain_size = \"6 mm\"\nsize_variation = 0.3\nelements_per_crystal = 12\n"
        "elongation = 1.5\nelongation_angle = \"30 deg\"\n";
    const auto row = [&] { return row_for({"uniaxial", 0, 0.3}); };
    const std::string size = "rectangle --width 68mm --height 136mm ";  // in proportion to the crystals
    const std::string grains =
        " --tessellation trigon --spread 0.3 --elements-per-crystal 12 --elongation 1.5 --elongation-angle 30deg --seed 7";
    write_material(fabric);
    EXPECT_EQ(row().mesh, size + "--grain-size 6mm" + grains);
    EXPECT_EQ(row().specimen, "rectangle68x136d6trigonv0.3t12l1.5a30-s7");
    // The equilateral triangle of the area of that diameter has the edge d √(π/√3).
    EXPECT_NEAR(read_problem(material()).study.specimens.mean_edge(), 6e-3 * std::sqrt(3.14159265 / std::sqrt(3.0)), 1e-9);
    write_material(fabric + "[study]\ngrains = 300\n");
    EXPECT_EQ(row().mesh, size + "--grains 300" + grains);
    write_material(fabric + "[study]\nmean_edge = \"5 mm\"\n");
    EXPECT_EQ(row().mesh, size + "--edge 5mm" + grains);
}

// A calibration knows its runs by their files: those of another fabric are made again, those of other targets are not.
TEST_F(CalibrateFolder, AChangeOfTheFabricMakesItsRunsAgainAndNoOther) {
    const auto files = [&](const std::string& size, const std::string& elements, const std::string& more) {
        write_material("[fabric]\ntessellation = \"trigon\"\ngrain_size = \"" + size + "\"\nelements_per_crystal = " + elements +
                       "\n" + more);
        const Point point{{"contact.cohesion", 4e7}, {"ratios.process_zone", 0.7}};
        // By numbers of grains too: a process zone is as long as the grain size of the fabric says.
        std::vector<std::string> all;
        for (const std::vector<std::string>& settings : {std::vector<std::string>{}, {"grains=300", "disc_grains=200"}}) {
            for (const char* test : {"uniaxial", "brazilian", "bend"}) all.push_back(row_for({test}, settings, point).file);
        }
        return all;
    };
    const std::vector<std::string> before = files("4 mm", "8", "");
    const auto n_changed = [&](const std::vector<std::string>& now) {
        std::size_t n = 0;
        for (std::size_t i = 0; i < before.size(); ++i) n += before[i] != now[i] ? 1 : 0;
        return n;
    };
    EXPECT_EQ(n_changed(files("5 mm", "8", "")), before.size());
    EXPECT_EQ(n_changed(files("4 mm", "12", "")), before.size());
    EXPECT_EQ(n_changed(files("4 mm", "8", "elongation = 1.5\n")), before.size());
    EXPECT_EQ(
        n_changed(files("4 mm", "8", "[targets]\nbrazilian = {value = \"9 MPa\"}\n[parameters]\n\"contact.cohesion\" = {}\n")),
        0U);
}

TEST_F(CalibrateFolder, CrystalsThatBreakBeginWithTheirRatios) {
    std::string stone = granite();
    stone.insert(stone.find("cohesion = \"74.57 MPa\""), "law = \"cohesive-frictional\"\n");
    const auto parameters = [&](const std::string& more) {
        write_rock(stone + "\n[fabric]\ntessellation = \"trigon\"\ngrain_size = \"4 mm\"\n" + more);
        return read_problem(material());
    };
    const auto expect_box = [](const Problem& problem, const std::string& key, double low, double first, double high) {
        const Parameter p = box_of(problem, key);
        EXPECT_NEAR(p.low, low, 1e-6 * low) << key;
        EXPECT_NEAR(p.first, first, 1e-6 * first) << key;
        EXPECT_NEAR(p.high, high, 1e-6 * high) << key;
    };
    const double degree = std::numbers::pi / 180;
    const Problem usual = parameters("");
    ASSERT_EQ(usual.parameters.size(), 4U);
    expect_box(usual, "contact.tensile_strength", 0.6 * 8.8e6, 0.9 * 8.8e6, 1.4 * 8.8e6);
    expect_box(usual, "contact.cohesion", 0.15 * 122e6, 0.3 * 122e6, 0.6 * 122e6);
    expect_box(usual, "contact.friction_angle", 0.65 * 53 * degree, 0.85 * 53 * degree, 1.05 * 53 * degree);
    expect_box(usual, "contact.residual_friction_angle", 0.4 * 53 * degree, 0.57 * 53 * degree, 0.75 * 53 * degree);
    // A cohesion that is given as a ratio stays one.
    stone.insert(stone.find("cohesion = \"74.57 MPa\""), "# ");
    const Problem by_ratio = parameters("[ratios]\ncohesion = 6\n");
    ASSERT_EQ(by_ratio.parameters.size(), 4U);
    expect_box(by_ratio, "ratios.cohesion", 3, 6, 12);

    const std::string named =
        "[parameters]\n\"ratios.process_zone\" = {}\n\"pairs.within.tensile_strength\" = {}\n"
        "\"pairs.within.fracture_energy\" = {}\n\"contact.cohesion\" = {}\n\"ratios.bridging_strength\" = {}\n"
        "\"ratios.bridging_energy\" = {}\n";
    stone.erase(stone.find("# cohesion = \"74.57 MPa\""), 2);
    const Problem ratios = parameters(named);
    expect_box(ratios, "ratios.process_zone", 0.3, 0.7, 3);
    expect_box(ratios, "pairs.within.tensile_strength", 1, 1.25, 1.5);
    expect_box(ratios, "pairs.within.fracture_energy", 1, 8, 30);
    expect_box(ratios, "ratios.bridging_strength", 0.3, 0.55, 0.8);
    expect_box(ratios, "ratios.bridging_energy", 0.3, 1, 2);
    EXPECT_TRUE(box_of(ratios, "ratios.bridging_energy").logarithmic);
    EXPECT_FALSE(box_of(ratios, "ratios.bridging_strength").logarithmic);
    EXPECT_EQ(box_of(ratios, "ratios.bridging_strength").most, 0.95);
    EXPECT_TRUE(box_of(ratios, "ratios.process_zone").logarithmic);
    EXPECT_FALSE(box_of(ratios, "pairs.within.tensile_strength").logarithmic);
    // The material's own are the first guess; outside of the box there is one about them.
    const Problem own = parameters("[ratios]\nprocess_zone = 0.1\n[pairs.within]\nfracture_energy = 20\n" + named);
    expect_box(own, "ratios.process_zone", 0.05, 0.1, 0.2);
    expect_box(own, "pairs.within.fracture_energy", 1, 20, 30);
    // Residual friction of worn faces is no parameter.
    stone.insert(stone.find("cohesion = \"74.57 MPa\""), "residual_friction_angle = \"10 deg\"\nwear_slip = \"0.2 mm\"\n");
    EXPECT_EQ(parameters("").parameters.size(), 3U);
}

TEST_F(CalibrateFolder, RatiosAreParametersAndChangeRuns) {
    std::string stone = granite();
    stone.insert(stone.find("cohesion = \"74.57 MPa\""), "# ");
    stone.insert(stone.find("tensile_strength = \"24.15"), "law = \"cohesive-frictional\"\n");
    const auto with = [&](const std::string& more, const std::string& size = "4 mm") {
        write_rock(stone + "\n[fabric]\ngrain_size = \"" + size + "\"\n[ratios]\ncohesion = 2\nprocess_zone = 0.5\n" + more);
    };
    const auto file = [&] { return row_for({"uniaxial"}, {"grains=300"}).file; };
    with("");
    const std::string before = file();
    with("open_shear_strength = 4\n");
    EXPECT_NE(file(), before);
    with("", "5 mm");  // the process zone is over the grain size
    EXPECT_NE(file(), before);
    // By default a box lies about the first guess, which is by the ratio where there is one: 2 tc; the default is 0.15 to 0.6 UCS
    // about 0.3.
    with("");
    const Parameter strength = box_of(read_problem(material()), "contact.cohesion");
    EXPECT_NEAR(strength.first, 48.3e6, 1);
    EXPECT_NEAR(strength.low, 24.15e6, 1);
    EXPECT_NEAR(strength.high, 96.6e6, 1);

    with(
        "[parameters]\n\"pairs.within.tensile_strength\" = {low = 0.8, high = 1.6}\n"
        "\"contact.cohesion\" = {low = \"50 %\", high = \"150 %\", first = \"40 MPa\"}\n");
    const Problem problem = read_problem(material());
    EXPECT_EQ(box_of(problem, "pairs.within.tensile_strength").high, 1.6);
    EXPECT_DOUBLE_EQ(box_of(problem, "contact.cohesion").low, 20e6);
    EXPECT_DOUBLE_EQ(box_of(problem, "contact.cohesion").high, 60e6);
    const Point point{{"ratios.process_zone", 0.7}, {"pairs.within.tensile_strength", 1.25}};
    EXPECT_EQ(row_for({"uniaxial"}, {}, point).material,
              "--set ratios.process_zone=0.7 --set pairs.within.tensile_strength=1.25");
    with("[parameters]\n\"ratios.open_shear_strength\" = {}\n");
    expect_one_line<InputError>([&] { read_problem(material()); }, {"ratios.open_shear_strength", "give low and high"});
}

TEST_F(CalibrateFolder, LaboratoryValuesAreTargets) {
    std::string stone = granite();
    for (const char* key : {"friction_angle = \"53 deg\"", "cohesion = \"21 MPa\""}) stone.insert(stone.find(key), "# ");
    const auto targets = [&](const std::string& more) {
        std::ofstream(folder_.file("material.toml"))
            << stone << more << "direct_tensile_strength = \"7 MPa\"\ncrack_initiation = \"55 MPa\"\n";
        std::map<std::string, Target> all;
        for (const Target& target : read_problem(material()).targets) all.emplace(target.name(), target);
        return all;
    };
    const auto all = targets("confined_strength = \"222 MPa\"\nconfining_pressure = \"10 MPa\"\n");
    EXPECT_EQ(all.at("first_peak_10MPa").value, 222e6);
    EXPECT_EQ(all.at("first_peak_10MPa").use, Use::fit);
    EXPECT_EQ(all.count("first_peak_8MPa"), 0U);
    EXPECT_DOUBLE_EQ(all.at("first_peak_4MPa").value, 122e6 + 4 * 10e6);  // the line from UCS = 122 MPa
    EXPECT_EQ(all.at("direct_tension").value, 7e6);
    EXPECT_EQ(all.at("direct_tension").use, Use::predict);
    EXPECT_EQ(all.at("crack_initiation").value, 55e6);
    EXPECT_TRUE(std::isnan(all.at("crack_damage").value));
    expect_one_line<InputError>([&] { targets("confined_strength = \"100 MPa\"\nconfining_pressure = \"10 MPa\"\n"); },
                                {"laboratory.confined_strength is not above compressive_strength"});
    expect_one_line<InputError>([&] { targets("confined_strength = \"222 MPa\"\n"); },
                                {"neither friction_angle nor cohesion, nor confined_strength with its confining_pressure"});
}

TEST_F(CalibrateFolder, StudyIsReadAndChecked) {
    write_material("[study]\nconfirmation_discs = 12\nmax_strain = 0.01\nmean_edge = \"3 mm\"\n");
    const Study study = read_problem(material()).study;
    EXPECT_EQ(study.confirmation_discs, 12U);
    EXPECT_EQ(study.max_strain, 0.01);
    EXPECT_NEAR(study.specimens.mean_edge(), 3e-3, 1e-15);
    const Study set = read_problem(material(), {"points=14", "width=40mm", "predicted_pressures=3 MPa,5 MPa"}).study;
    EXPECT_EQ(set.points, 14U);
    EXPECT_EQ(set.specimens.width, 0.04);
    EXPECT_EQ(set.predicted_pressures, (std::vector<double>{3e6, 5e6}));
    EXPECT_EQ(set.max_strain, 0.01);  // of the file
    expect_one_line<UsageError>([&] { read_problem(material(), {"disks=3"}); }, {"--set disks=3", "did you mean discs?"});
    expect_one_line<UsageError>([&] { read_problem(material(), {"discs"}); }, {"--set discs", "KEY=VALUE"});
    expect_one_line<UsageError>([&] { read_problem(material(), {"width=-1mm"}); }, {"--set width=-1mm"});
    write_material("");
    EXPECT_EQ(read_problem(material()).study.max_strain, 0.015);  // UCS/E as of Augig granite
    write_material("[study]\npoints = [10, 20]\n");
    expect_one_line<InputError>([&] { read_problem(material()); }, {"study.points", "one value"});
}

TEST_F(CalibrateFolder, ContactsThatAreFoundNeedNotBeGiven) {
    std::string text = granite();
    const std::size_t contact = text.find("[contact]");
    text.erase(contact, text.find("[platen]") - contact);
    write_rock(text);
    EXPECT_EQ(ask().decision.ending, Ending::requested);
    write_rock(text + "\n[parameters]\n\"contact.cohesion\" = {}\n");
    expect_one_line<InputError>([&] { (void)ask(); }, {"contact.tensile_strength is neither given nor a row of [parameters]"});
    write_rock(text.replace(text.find("density ="), 9, "#"));
    expect_one_line<InputError>([&] { (void)ask(); }, {"material.toml: missing: rock.density;", "all of [rock]"});
}

TEST_F(CalibrateFolder, WhatTheTablesLackIsOneLine) {
    (void)ask();
    run_wanted(rock(), 100);
    std::filesystem::remove(folder_.file("moduli.tsv"));
    expect_one_line<InputError>([&] { (void)ask(); }, {"uniaxial runs have no young_modulus", "moduli"});
    EXPECT_FALSE(has("outcome.json"));  // that of the call before
    std::ofstream(folder_.file("strength.tsv")) << "test\nuniaxial\n";
    expect_one_line<InputError>([&] { (void)ask(); }, {"strength.tsv", "no column file"});
}

}  // namespace
}  // namespace graincrack::calibrate
