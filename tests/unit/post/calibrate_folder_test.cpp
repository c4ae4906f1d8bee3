// A calibration by its files: the same decisions as in memory, from tables as `strength` and `moduli` write them.
#include "post/calibrate/folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "post/table/table_file.hpp"
#include "share/error.hpp"
#include "synthetic_rock.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::calibrate {
namespace {

using test::expect_one_line;
using test::SyntheticRock;

class CalibrateFolder : public ::testing::Test {
protected:
    void SetUp() override { write_material("[study]\npredicted_pressures = [\"12 MPa\", \"20 MPa\"]\n"); }
    void write_material(const std::string& study) {
        std::ifstream file(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml");
        std::ofstream(folder_.file("material.toml")) << file.rdbuf() << "\n" << study;
    }
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(folder_.file(name)); }
    [[nodiscard]] std::string text(const std::string& name) const {
        std::ifstream file(folder_.file(name));
        std::ostringstream out;
        out << file.rdbuf();
        return out.str();
    }
    [[nodiscard]] std::string folder() const { return std::filesystem::path(folder_.file("x")).parent_path().string(); }

    /// "Runs" all rows of wanted.tsv, from what they say and their materials alone; adds them to the tables.
    void run_wanted(const SyntheticRock& synthetic, double max_strain) {
        const TableFile wanted(folder_.file("wanted.tsv"));
        const auto tests = wanted.texts("test");
        const auto materials = wanted.texts("material");
        const auto seeds = wanted.numbers("seed");
        const auto pressures = wanted.numbers("confining_pressure_MPa");
        const auto limits = wanted.numbers_or_nan("max_strain");
        for (std::size_t i = 0; i < wanted.n_rows(); ++i) {
            if (!materials_.contains(materials[i])) materials_[materials[i]] = read_material(folder_.file(materials[i]));
            WantedRun run{tests[i], pressures[i] * 1e6, static_cast<std::int64_t>(seeds[i]), {}, std::nullopt, ""};
            for (const ParameterRow& row : parameters()) {
                if (!wanted.has(row.column)) continue;
                const double value = wanted.numbers_or_nan(row.column)[i];
                if (!std::isnan(value)) run.point[row.parameter] = value * row.si;
            }
            if (!std::isnan(limits[i])) run.max_strain = limits[i];
            add(synthetic.run(materials_[materials[i]], run, max_strain));
        }
        std::ofstream(folder_.file("strength.tsv")) << strength_;
        std::ofstream(folder_.file("moduli.tsv")) << moduli_;
    }
    void add(const FinishedRun& run) {
        const std::string file = fmt::format("run{}.h5", ++n_runs_);
        const bool disc = run.test == "brazilian";
        strength_ +=
            fmt::format("{}\t{}\t{}\t{:.7g}\t{:.7g}\t{}\t{}\tdrop\t{:.7g}", file, run.test, run.seed, run.mean_edge * 1e3,
                        run.confining_pressure * 1e-6, disc ? "" : fmt::format("{:.7g}", run.strength * 1e-6),
                        disc ? fmt::format("{:.7g}", run.strength * 1e-6) : "", run.max_strain);
        for (std::size_t i = 0; i < n_parameters; ++i) strength_ += fmt::format("\t{:.7g}", run.values[i] / parameters()[i].si);
        strength_ += "\n";
        if (run.young_modulus) {
            moduli_ += fmt::format("{}\t{:.7g}\t{:.7g}\t{:.7g}\t{:.7g}\n", file, *run.young_modulus * 1e-9, *run.poisson_ratio,
                                   *run.predicted_young_modulus * 1e-9, *run.predicted_poisson_ratio);
        }
    }

    test::TemporaryFolder folder_;
    std::map<std::string, Material> materials_;
    std::size_t n_runs_ = 0;
    std::string strength_ =
        "file\ttest\tseed\tmean_edge_mm\tconfining_pressure_MPa\tpeak_compressive_stress_MPa\ttensile_strength_MPa\tpeak_"
        "kind\tmax_strain\t"
        "grain_young_modulus_GPa\tgrain_poisson_ratio\tcontact_tensile_strength_MPa\tcontact_cohesion_MPa\tcontact_friction_"
        "angle_deg\t"
        "contact_fracture_energy_J/m2\tcontact_open_shear_strength_MPa\n";
    std::string moduli_ = "file\tyoung_modulus_GPa\tpoisson_ratio\tpredicted_young_modulus_GPa\tpredicted_poisson_ratio\n";
};

TEST_F(CalibrateFolder, FromMaterialToCalibratedMaterial) {
    Decision decision = calibrate_folder(folder());
    int calls = 1;
    for (; decision.ending == Ending::wanted && calls < 60; ++calls) {
        ASSERT_TRUE(has("wanted.tsv"));
        EXPECT_FALSE(has("report.md"));
        const std::size_t before = n_runs_;
        run_wanted({}, 0.015);
        EXPECT_GT(n_runs_, before);
        decision = calibrate_folder(folder());
    }
    ASSERT_EQ(decision.ending, Ending::calibrated) << decision.reason;
    EXPECT_FALSE(has("wanted.tsv"));
    const Material calibrated = read_material(folder_.file("calibrated.toml"));  // a material like any other
    EXPECT_NEAR(calibrated.contact.cohesion / *decision.point[Parameter::cohesion], 1, 1e-6);
    EXPECT_NEAR(calibrated.rock.young_modulus / *decision.point[Parameter::young_modulus], 1, 1e-6);
    EXPECT_EQ(calibrated.rock.mode_i_toughness, 1.5e6);
    EXPECT_NE(text("calibrated.toml").find("[fitted]"), std::string::npos);
    const std::string report = text("report.md");
    for (const char* part : {"# Augig granite: calibrated", "## Targets", "σ1 at 12 MPa", "predicted", "## Values", "## Steps",
                             "d ln σt/d ln tc", "until half of the 95 % interval is within 3 %"}) {
        EXPECT_NE(report.find(part), std::string::npos) << part;
    }
    // Asked again it answers the same.
    EXPECT_EQ(calibrate_folder(folder()).ending, Ending::calibrated);
    EXPECT_EQ(text("report.md"), report);
}

TEST_F(CalibrateFolder, StudyIsReadAndChecked) {
    write_material("[study]\nmax_discs = 12\nmax_strain = 0.01\nmean_edge = \"3 mm\"\n");
    const Study study = read_study(read_material(folder_.file("material.toml")));
    EXPECT_EQ(study.discs.most, 12U);
    EXPECT_EQ(study.max_strain, 0.01);
    EXPECT_NEAR(study.mean_edge, 3e-3, 1e-15);
    write_material("");
    EXPECT_EQ(read_study(read_material(folder_.file("material.toml"))).max_strain, 0.015);  // UCS/E as of Augig granite
    const auto refused = [&](const std::string& line, const std::vector<std::string>& parts) {
        write_material("[study]\n" + line + "\n");
        expect_one_line<InputError>([&] { read_study(read_material(folder_.file("material.toml"))); }, parts);
    };
    refused("max_disks = 12", {"study.max_disks", "known are", "max_discs"});
    refused("max_discs = 0", {"study.max_discs"});
    refused("max_discs = [1, 2]", {"study.max_discs", "one value"});
}

TEST_F(CalibrateFolder, AMissingColumnIsOneLine) {
    std::ofstream(folder_.file("strength.tsv")) << "file\ttest\nrun.h5\tuniaxial\n";
    expect_one_line<InputError>([&] { calibrate_folder(folder()); }, {"strength.tsv", "no column peak_kind"});
}

}  // namespace
}  // namespace graincrack::calibrate
