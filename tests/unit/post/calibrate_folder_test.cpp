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
#include "share/material_edit.hpp"
#include "share/units.hpp"
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

    /// The words behind each `flag` in the options of a tool.
    static std::vector<std::string> values_of(const std::string& options, const std::string& flag) {
        std::vector<std::string> values;
        std::istringstream words(options);
        for (std::string word; words >> word;) {
            if (word == flag && words >> word) values.push_back(word);
        }
        return values;
    }
    /// The material of a row: that of the folder with the settings that the row says.
    const Material& material_with_options(const std::string& options) {
        const auto known = materials_.find(options);
        if (known != materials_.end()) return known->second;
        std::vector<MaterialSetting> settings;
        for (const std::string& text : values_of(options, "--set"))
            settings.emplace_back(text.substr(0, text.find('=')), text.substr(text.find('=') + 1));
        std::ofstream(folder_.file("with.toml")) << material_with(folder_.file("material.toml"), settings);
        return materials_[options] = read_material(folder_.file("with.toml"));
    }
    /// "Runs" all rows of wanted.tsv, from the options of the tools in them alone; adds them to the tables.
    void run_wanted(const SyntheticRock& synthetic, double max_strain) {
        const TableFile wanted(folder_.file("wanted.tsv"));
        const auto meshes = wanted.texts("mesh");
        const auto materials = wanted.texts("material");
        const auto solves = wanted.texts("solve");
        for (std::size_t i = 0; i < wanted.n_rows(); ++i) {
            WantedRun run{
                solves[i].substr(0, solves[i].find(' ')), 0, std::stoll(values_of(meshes[i], "--seed").at(0)), {}, {}, ""};
            for (const std::string& text : values_of(solves[i], "--confining-pressure"))
                run.confining_pressure = parse_quantity(text, quantity::confining_pressure, "pressure");
            for (const std::string& text : values_of(solves[i], "--max-strain"))
                run.max_strain = parse_quantity(text, quantity::max_strain, "limit");
            run.notched = !values_of(meshes[i], "--notch").empty();
            add(synthetic.run(material_with_options(materials[i]), run, max_strain));
        }
        std::ofstream(folder_.file("strength.tsv")) << strength_;
        std::ofstream(folder_.file("moduli.tsv")) << moduli_;
        if (std::count(toughness_.begin(), toughness_.end(), '\n') > 1)
            std::ofstream(folder_.file("toughness.tsv")) << toughness_;
    }
    void add(const FinishedRun& run) {
        const std::string file = fmt::format("run{}.h5", ++n_runs_);
        const bool disc = run.test == "brazilian" || run.test == "tension";
        strength_ +=
            fmt::format("{}\t{}\t{}\t{:.7g}\t{:.7g}\t{}\t{}\tdrop\t{:.7g}\t6", file, run.test, run.seed, run.mean_edge * 1e3,
                        run.confining_pressure * 1e-6, disc ? "" : fmt::format("{:.7g}", run.strength * 1e-6),
                        disc ? fmt::format("{:.7g}", run.strength * 1e-6) : "", run.max_strain);
        for (std::size_t i = 0; i < n_parameters; ++i) strength_ += fmt::format("\t{:.7g}", run.values[i] / parameters()[i].si);
        strength_ += "\n";
        if (run.young_modulus) {
            moduli_ += fmt::format("{}\t{:.7g}\t{:.7g}\t{:.7g}\t{:.7g}\t{:.7g}\t{:.7g}\n", file, *run.young_modulus * 1e-9,
                                   *run.poisson_ratio, *run.predicted_young_modulus * 1e-9, *run.predicted_poisson_ratio,
                                   *run.crack_initiation * 1e-6, *run.crack_damage * 1e-6);
        }
        if (run.mode_i_toughness) toughness_ += fmt::format("{}\t{:.7g}\n", file, *run.mode_i_toughness * 1e-6);
    }

    test::TemporaryFolder folder_;
    std::map<std::string, Material> materials_;
    std::size_t n_runs_ = 0;
    std::string strength_ =
        "file\ttest\tseed\tmean_edge_mm\tconfining_pressure_MPa\tpeak_compressive_stress_MPa\ttensile_strength_MPa\tpeak_"
        "kind\tmax_strain\twall_time_s\t"
        "grain_young_modulus_GPa\tgrain_poisson_ratio\tcontact_tensile_strength_MPa\tcontact_cohesion_MPa\tcontact_friction_"
        "angle_deg\t"
        "contact_fracture_energy_J/m2\tcontact_open_shear_strength_MPa\n";
    std::string moduli_ =
        "file\tyoung_modulus_GPa\tpoisson_ratio\tpredicted_young_modulus_GPa\tpredicted_poisson_ratio\t"
        "crack_initiation_count_MPa\tcrack_damage_2d_MPa\n";
    std::string toughness_ = "file\tmode_i_toughness_MPa.m^0.5\n";
};

TEST_F(CalibrateFolder, FromMaterialToCalibratedMaterial) {
    Decision decision = calibrate_folder(folder());
    int calls = 1;
    double longest_wait = 0;
    std::size_t most_wanted = 0;
    for (; decision.ending == Ending::wanted && calls < 60; ++calls) {
        ASSERT_TRUE(has("wanted.tsv"));
        EXPECT_FALSE(has("report.md"));
        if (decision.wanted_time > longest_wait) {
            longest_wait = decision.wanted_time;
            most_wanted = decision.wanted.size();
        }
        const std::size_t before = n_runs_;
        run_wanted({}, 0.015);
        EXPECT_GT(n_runs_, before);
        decision = calibrate_folder(folder());
    }
    ASSERT_EQ(decision.ending, Ending::calibrated) << decision.reason;
    EXPECT_EQ(longest_wait, 6.0 * static_cast<double>(most_wanted));  // each finished run took 6 s
    EXPECT_FALSE(has("wanted.tsv"));
    EXPECT_FALSE(has("nearest.toml"));
    const Material calibrated = read_material(folder_.file("calibrated.toml"));  // a material like any other
    EXPECT_NEAR(calibrated.contact.cohesion.value() / *decision.point[Parameter::cohesion], 1, 1e-6);
    EXPECT_NEAR(calibrated.rock.young_modulus / *decision.point[Parameter::young_modulus], 1, 1e-6);
    EXPECT_EQ(calibrated.rock.mode_i_toughness, 1.5e6);
    EXPECT_EQ(calibrated.fitted.size(), 5U);
    EXPECT_EQ(calibrated.fitted.at("confined_strength_8MPa").find("193.46 MPa; "), 0U);
    const std::string report = text("report.md");
    for (const char* part : {"# Augig granite: calibrated", "## Targets", "σ1 at 12 MPa", "predicted", "## Values", "## Steps",
                             "| K_IC, MPa √m | predicted | 1.5 | 1.6 (1.6 to 1.6) | 5 | +6.67 % | ± 10 % | within |",
                             "| direct tensile strength, MPa | predicted |  | 11 (11 to 11) | 5 |  |  |  |  |",
                             "| crack damage by reversal of volume, MPa | predicted |  | 9", "d ln σt/d ln tc",
                             "until half of the 95 % interval is within 3 %"}) {
        EXPECT_NE(report.find(part), std::string::npos) << part;
    }
    // Asked again it answers the same.
    EXPECT_EQ(calibrate_folder(folder()).ending, Ending::calibrated);
    EXPECT_EQ(text("report.md"), report);
}

// Friction that no contact reaches: the nearest point is a material too, and is not called calibrated.
TEST_F(CalibrateFolder, WithoutAnEndInReachTheNearestPointIsAMaterial) {
    SyntheticRock smooth;
    smooth.friction_limit = 35;
    Decision decision = calibrate_folder(folder());
    for (int calls = 1; decision.ending == Ending::wanted && calls < 60; ++calls) {
        EXPECT_FALSE(has("nearest.toml"));
        run_wanted(smooth, 0.015);
        decision = calibrate_folder(folder());
    }
    ASSERT_NE(decision.ending, Ending::calibrated);
    EXPECT_FALSE(has("calibrated.toml"));
    const Material nearest = read_material(folder_.file("nearest.toml"));
    EXPECT_EQ(nearest.name, "Augig granite, nearest point");
    EXPECT_NEAR(nearest.contact.cohesion.value() / *decision.point[Parameter::cohesion], 1, 1e-6);
    EXPECT_NEAR(nearest.contact.friction_angle.value() / *decision.point[Parameter::friction_angle], 1, 1e-6);
}

TEST_F(CalibrateFolder, StudyIsReadAndChecked) {
    write_material("[study]\nmax_discs = 12\nmax_strain = 0.01\nmean_edge = \"3 mm\"\n");
    const Study study = read_study(read_material(folder_.file("material.toml")));
    EXPECT_EQ(study.discs.most, 12U);
    EXPECT_EQ(study.max_strain, 0.01);
    EXPECT_NEAR(study.specimens.mean_edge(), 3e-3, 1e-15);
    const Material rock = read_material(folder_.file("material.toml"));
    const Study set = read_study(rock, {"max_discs=14", "width=40mm", "predicted_pressures=3 MPa,5 MPa"});
    EXPECT_EQ(set.discs.most, 14U);
    EXPECT_EQ(set.specimens.width, 0.04);
    EXPECT_EQ(set.targets.predicted_pressures, (std::vector<double>{3e6, 5e6}));
    EXPECT_EQ(set.max_strain, 0.01);  // of the file
    expect_one_line<UsageError>([&] { read_study(rock, {"max_disks=14"}); }, {"--set max_disks=14", "unknown key"});
    expect_one_line<UsageError>([&] { read_study(rock, {"max_discs"}); }, {"--set max_discs", "KEY=VALUE"});
    expect_one_line<UsageError>([&] { read_study(rock, {"width=-1mm"}); }, {"--set width=-1mm"});
    write_material("");
    EXPECT_EQ(read_study(read_material(folder_.file("material.toml"))).max_strain, 0.015);  // UCS/E as of Augig granite
    Material weak = read_material(folder_.file("material.toml"));
    weak.laboratory["compressive_strength"] = 1e-300;
    EXPECT_LT(read_study(weak).max_strain, 1e-300);  // below the normal numbers, and still no failure
    const auto refused = [&](const std::string& line, const std::vector<std::string>& parts) {
        write_material("[study]\n" + line + "\n");
        expect_one_line<InputError>([&] { read_study(read_material(folder_.file("material.toml"))); }, parts);
    };
    refused("max_disks = 12", {"study.max_disks", "known are", "max_discs"});
    refused("max_discs = 0", {"study.max_discs"});
    refused("max_discs = [1, 2]", {"study.max_discs", "one value"});
}

TEST_F(CalibrateFolder, ContactsNeedNotBeGiven) {
    std::string text;
    std::ifstream file(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("[contact]")) {
            while (std::getline(file, line) && !line.starts_with("[platen]")) {
            }
        }
        text += line + "\n";
    }
    std::ofstream(folder_.file("material.toml")) << text;
    EXPECT_EQ(calibrate_folder(folder()).ending, Ending::wanted);
    EXPECT_TRUE(has("wanted.tsv"));
    text.replace(text.find("density ="), 9, "#");
    std::ofstream(folder_.file("material.toml")) << text;
    expect_one_line<InputError>([&] { calibrate_folder(folder()); }, {"material.toml: missing: rock.density;", "all of [rock]"});
}

TEST_F(CalibrateFolder, RunsNeedNamesOfTheirOwn) {
    (void)calibrate_folder(folder());
    run_wanted({}, 0.015);
    moduli_ += moduli_.substr(moduli_.find("run1.h5"), moduli_.find("run2.h5") - moduli_.find("run1.h5"));
    std::ofstream(folder_.file("moduli.tsv")) << moduli_;
    EXPECT_NO_THROW((void)read_finished(folder()));  // the same row again is the same run
    std::ofstream(folder_.file("moduli.tsv")) << moduli_ << "run1.h5\t27.2\t0.22\t27\t0.22\t50\t100\n";
    expect_one_line<InputError>([&] { (void)read_finished(folder()); },
                                {"moduli.tsv: run1.h5 has young_modulus_GPa = ", "27.2", "two runs of one name"});
}

TEST_F(CalibrateFolder, AMissingColumnIsOneLine) {
    std::ofstream(folder_.file("strength.tsv")) << "file\ttest\nrun.h5\tuniaxial\n";
    expect_one_line<InputError>([&] { calibrate_folder(folder()); }, {"strength.tsv", "no column peak_kind"});
}

}  // namespace
}  // namespace graincrack::calibrate
