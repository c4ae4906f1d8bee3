// A calibration by its files: the same decisions as in memory, from tables as `strength`, `moduli` and `toughness` write them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "post/calibrate/folder.hpp"
#include "share/base/error.hpp"
#include "share/base/table_file.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/synthetic_rock.hpp"
#include "tests/unit/post/calibrate/material_folder.hpp"

namespace graincrack::calibrate {
namespace {

using test::SyntheticRock;

class CalibrationFolder : public MaterialFolder {
protected:
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(folder_.file(name)); }
    [[nodiscard]] std::string text(const std::string& name) const { return text_of_file(folder_.file(name)); }
    [[nodiscard]] nlohmann::json outcome() const { return nlohmann::json::parse(text("outcome.json")); }
    [[nodiscard]] FolderDecision ask() const {
        std::ostringstream notes;
        return calibrate_folder(folder_.file(""), "", {}, notes);
    }
    /// Finishes at most so many of the requested runs.
    void finish(const std::vector<RequestedRun>& requested, std::size_t most = 1000) {
        const Material rock = material();
        const Study study = read_problem(rock).study;
        for (std::size_t i = 0; i < std::min(requested.size(), most); ++i) {
            const std::string file = row_of(rock, study, requested[i]).file;
            EXPECT_TRUE(finished_.emplace(file, rock_.measure(requested[i])).second) << file << " is requested twice";
        }
        for (const auto& [table, columns] : tables) {
            std::ofstream out(folder_.file(table));
            out << fmt::format("file\t{}\n", fmt::join(columns, "\t"));
            for (const auto& [file, measures] : finished_) {
                out << "augig-granite.1234/" << file;
                for (const std::string& column : columns) {
                    out << (measures.contains(column) ? fmt::format("\t{:.7g}", measures.at(column)) : "\t");
                }
                out << '\n';
            }
        }
    }
    /// Asks and finishes runs until the end. \param fraction of the requested runs that are finished before the next question
    FolderDecision to_the_end(double fraction = 1) {
        FolderDecision out = ask();
        for (int calls = 1; out.decision.ending == Ending::requested && calls < 200; ++calls) {
            EXPECT_FALSE(has("report.md"));
            const std::vector<RequestedRun>& requested = out.decision.requested;
            finish(requested, static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(requested.size()))));
            out = ask();
        }
        return out;
    }
    /// The lines of a report about toughness and the first guess.
    static std::string some_lines(const std::string& report) {
        std::istringstream lines(report);
        std::string found;
        for (std::string line; std::getline(lines, line);) {
            if (std::regex_search(line, std::regex("K_IC (was|of)|^. K_IC|first guess, with"))) found += line + "\n";
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
        rock.responses["bend mode_i_toughness_MPa.m^0.5"].reference = 1.2;
        return rock;
    }

    static inline const std::map<std::string, std::vector<std::string>> tables{
        {"strength.tsv", {"tensile_strength_MPa", "first_peak_MPa", "residual_MPa", "wall_time_s"}},
        {"moduli.tsv", {"young_modulus_GPa", "poisson_ratio", "crack_initiation_MPa"}},
        {"toughness.tsv", {"mode_i_toughness_MPa.m^0.5"}}};
    SyntheticRock rock_ = rock();
    FinishedRuns finished_;
};

TEST_F(CalibrationFolder, EndsWithACalibratedMaterial) {
    const std::string behind =
        "# of the user\n[study] # usual\npoints = 20\n[temperature]\ntemperatures = [0, # K\n 300]\nyoung_modulus = [1, 1]";
    granite_and("[fitted] # earlier\nporosity = \"1\" # %\n# on discs\ntensile_strength = \"1\" # MPa\n\n" + behind);
    const FolderDecision first = ask();
    EXPECT_EQ(first.decision.ending, Ending::requested);
    EXPECT_EQ(first.requested_time, 0);
    test::expect_golden(text("outcome.json"), "outcome of no run");
    finish(first.decision.requested);
    EXPECT_EQ(ask().requested_time, 2 * 6);  // two uniaxial tests at 6 s each
    ASSERT_EQ(to_the_end().decision.ending, Ending::calibrated);
    EXPECT_FALSE(has("wanted.tsv"));
    EXPECT_FALSE(has("nearest.toml"));
    const Material calibrated = read_material(folder_.file("calibrated.toml"));  // a material like any other
    EXPECT_NEAR(calibrated.contact.cohesion.value(), 55e6, 3e6);
    EXPECT_NEAR(calibrated.rock.young_modulus, 25.8e9 / 0.95, 0.02e9);
    EXPECT_EQ(calibrated.rock.mode_i_toughness, 1.5e6);
    const std::string file = text("calibrated.toml");
    EXPECT_TRUE(file.ends_with(behind)) << file;
    const std::string report = text("report.md");
    test::expect_golden(std::regex_replace(report, std::regex(R"(\d\.\d+e-1\d %)"), "0 %"), "report");  // rounding errors
    const std::size_t fitted = file.find("[fitted]");
    test::expect_golden(file.substr(fitted, file.size() - behind.size() - fitted), "fitted");

    const nlohmann::json found = outcome();
    EXPECT_EQ(found["state"], "calibrated");
    EXPECT_EQ(found["files"]["material"], "calibrated.toml");
    EXPECT_EQ(found["runs"]["finished"], finished_.size());
    const nlohmann::json value = found["values"]["contact.cohesion"];
    EXPECT_NEAR(value["value"], calibrated.contact.cohesion.value(), 100);  // Pa; the material has six digits
    EXPECT_GT(value["value"], value["low"]);
    EXPECT_EQ(found["values"]["rock.young_modulus"]["low"], nullptr);
    EXPECT_EQ(found["targets"]["uniaxial"]["laboratory"], 122e6);
    EXPECT_NEAR(found["targets"]["uniaxial"]["value"], 122e6, 6e6);
    EXPECT_EQ(found["targets"]["uniaxial"]["verdict"], "within");
    EXPECT_EQ(found["caveats"][0]["code"], "missing_values");
    EXPECT_EQ(found["caveats"][0]["of"], "crack_damage");
    // d ln UCS / d ln cc = 0.6 and twice the curvature times ln(cc/55 MPa), which is nearly 0.
    const TableFile identify(folder_.file("identify.tsv"));
    std::map<std::string, double> exponents;
    for (std::size_t i = 0; i < identify.n_rows(); ++i) {
        exponents[identify.text(i, "response") + " " + identify.text(i, "parameter")] = identify.number(i, "exponent");
    }
    EXPECT_NEAR(exponents.at("UCS contact.cohesion"), 0.6, 0.06);
    // Asked again it answers the same.
    EXPECT_EQ(ask().decision.ending, Ending::calibrated);
    EXPECT_EQ(text("report.md"), report);
    // Interrupted many times, with no run made twice, it comes to the same end.
    const std::size_t all = finished_.size();
    finished_.clear();
    for (const auto& [table, columns] : tables) std::filesystem::remove(folder_.file(table));
    EXPECT_EQ(to_the_end(0.4).decision.ending, Ending::calibrated);
    EXPECT_EQ(finished_.size(), all);
    EXPECT_EQ(text("report.md"), report);
}

// Two rectangles, then two rectangles and three discs, whose strengths are told before the others are made.
TEST_F(CalibrationFolder, BeginsADesignWithOnePointOfEachTest) {
    FolderDecision out = ask();
    test::expect_golden(text("wanted.tsv"), "elastic");
    for (int attempt = 0; attempt < 2; ++attempt) {
        EXPECT_EQ(out.decision.ending, Ending::requested);
        finish(out.decision.requested);
        out = ask();
    }
    EXPECT_EQ(out.decision.requested.size(), 5U);
    EXPECT_EQ(out.requested_time, 0);  // discs and rectangles under pressure: none is finished
    test::expect_golden(text("wanted.tsv"), "first point");
    finish(out.decision.requested);
    out = ask();
    EXPECT_EQ(out.decision.requested.size(), 19U * 5);
    EXPECT_EQ(out.requested_time, 570);  // s: 95 runs of 6 s
    EXPECT_EQ(TableFile(folder_.file("wanted.tsv")).n_rows(), 95U);
    test::expect_golden(out.decision.reason, "other points");
}

TEST_F(CalibrationFolder, HasTheNearestPointAsAMaterialWithoutAnEndInReach) {
    rock_.responses["brazilian tensile_strength_MPa"].exponents.clear();
    rock_.responses["brazilian tensile_strength_MPa"].reference = 4;
    ASSERT_EQ(to_the_end().decision.ending, Ending::not_reached);
    EXPECT_FALSE(has("calibrated.toml"));
    EXPECT_TRUE(has("identify.tsv"));
    const std::string name = read_material(folder_.file("nearest.toml")).name;
    const nlohmann::json found = outcome();
    test::expect_golden(name + "\n" + found["state"].dump() + "\n" + found["files"].dump());
}

TEST_F(CalibrationFolder, ReportsWhatIsOfNoTest) {
    Material rock = material();
    const Problem problem = read_problem(rock);
    Decision decision;
    decision.fit.emplace().optimum.condition = INFINITY;
    for (const Target& target : problem.targets) decision.outcomes.push_back({target, {}, 1, ""});
    test::expect_golden(report_text({rock, problem, decision}, rock));
    rock.rock.mode_i_toughness = rock.rock.tensile_strength / fpz::tensile_strength_from_toughness(1);
    decision.fit->optimum.prior = 4;  // widened, where the usual one missed targets
    test::expect_golden(some_lines(report_text({rock, problem, decision}, rock)), "K_IC not measured, wide first guess");
}

TEST_F(CalibrationFolder, ComparesToughnessOnHalfDiscs) {
    write(granite_with("mode_i_toughness = \"1.3 MPa.m^0.5\"\n", "friction_angle = \"53 deg\""));
    EXPECT_EQ(to_the_end().decision.ending, Ending::calibrated);
    test::expect_golden(some_lines(text("report.md")), "size not known");
    write(granite() + "mode_i_toughness = {value = \"1.3 MPa.m^0.5\", method = \"half-disc\", diameter = \"80 mm\"}\n");
    EXPECT_EQ(ask().decision.ending, Ending::calibrated);
    test::expect_golden(some_lines(text("report.md")), "as in the laboratory");
    EXPECT_EQ(read_material(folder_.file("calibrated.toml")).toughness_test.size, 0.08);
}

TEST_F(CalibrationFolder, NeedsNoContactsThatAreParametersAndRefusesOtherLacks) {
    std::string text = granite();
    const std::size_t contact = text.find("[contact]");
    text.erase(contact, text.find("[platen]") - contact);
    write(text);
    const FolderDecision first = ask();
    EXPECT_EQ(first.decision.ending, Ending::requested);
    test::GoldenRefusals refused;
    const auto add = [&](const std::string& what) {
        refused.add<InputError>(what, [&] { (void)ask(); });
        EXPECT_FALSE(has("outcome.json"));  // that of the call before
    };
    write(text + "\n[parameters]\n\"contact.cohesion\" = {}\n");
    add("contact.cohesion alone");
    write(granite());
    finish(ask().decision.requested);
    std::filesystem::remove(folder_.file("moduli.tsv"));
    add("no moduli.tsv");
    std::ofstream(folder_.file("strength.tsv")) << "test\nuniaxial\n";
    add("no files in strength.tsv");
    write(text.replace(text.find("density ="), 9, "#"));
    add("no density");
}

}  // namespace
}  // namespace graincrack::calibrate
