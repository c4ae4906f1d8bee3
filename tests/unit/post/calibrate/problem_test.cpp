// The problem that a material sets to a calibration: targets, parameters, study, and the options of its runs.
#include <fmt/format.h>

#include <functional>

#include "post/calibrate/folder.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/rows.hpp"
#include "tests/unit/post/calibrate/material_folder.hpp"

namespace graincrack::calibrate {
namespace {

using Settings = std::vector<std::string>;

class CalibrationProblem : public MaterialFolder {
protected:
    /// Adds targets and parameters of the material in the folder to the text.
    void add_problem(const std::string& what) {
        const Problem of = problem();
        text_ += what + "\n";
        for (const Target& t : of.targets) {
            text_ += fmt::format("  {} {}, deviation {}, {}\n", t.name(), t.text(t.value), t.text(t.deviation),
                                 t.use == Use::fit ? "fitted" : "predicted");
        }
        add_parameters(of);
    }
    void add_parameters(const Problem& of) {
        for (const Parameter& p : of.parameters) {
            const auto value = [&](double si) { return value_text(p.key, si, " "); };
            text_ += fmt::format("  {} {} in {} to {}, at least {}, at most {}, {}\n", p.key, value(p.first), value(p.low),
                                 value(p.high), value(p.least), value(p.most), p.logarithmic ? "logarithmic" : "linear");
        }
    }
    /// Adds the options of a run of the material in the folder to the text.
    void add_run(const std::string& what, const calibrate::Test& test, const Settings& settings = {}, const Point& point = {}) {
        const RunRow row = row_of(material(), problem(settings).study, {test, 7, point, {}, "d1p01", ""});
        text_ += fmt::format("{}\n  {}\n  {}\n  {}\n", what, row.specimen, row.mesh, row.solve);
        if (!row.material.empty()) text_ += "  " + row.material + "\n";
    }
    std::string text_;
};

TEST_F(CalibrationProblem, IsReadFromRowsOrMadeOfTheLaboratory) {
    granite_and(R"([targets]
young_modulus = {value = "25.8 GPa"}
brazilian = {value = "8.8 MPa", deviation = "0.5 MPa"}
first_peak_4MPa = {value = "157 MPa", deviation = "3 %"}
residual_8MPa = {value = "150 MPa", use = "predict"}
direct_tension = {use = "predict"}
[parameters]
"contact.cohesion" = {low = "20 MPa", high = "80 MPa"}
"contact.friction_angle" = {low = "20 deg", high = "50 deg", scale = "linear", first = "30 deg"}
"contact.tensile_strength" = {low = "50 %", high = "150 %", first = "10 MPa"}
"contact.fracture_energy" = {}
"contact.shear_stiffness" = {low = "1e13", high = "1e15"}
)");
    add_problem("rows");
    const Problem rows = problem();
    EXPECT_NEAR(rows.parameters[0].value(0), 40e6, 1);  // logarithmic
    // K_IC²/Ẽ in plane strain is 82.6 J/m²: G_I stays between half of it and all of it.
    EXPECT_NEAR(rows.parameters[3].least, 41.3, 0.1);
    EXPECT_NEAR(rows.parameters[3].most, 82.6, 0.1);
    // Tests end behind the first peak, unless a target asks for what comes after: that of a prediction in the end only.
    for (const calibrate::Test& test : tests_of(rows.targets)) add_run(test.label(), test);

    std::string stone = granite();
    for (const char* key : {"friction_angle = \"53 deg\"", "cohesion = \"21 MPa\""}) stone.insert(stone.find(key), "# ");
    stone += "direct_tensile_strength = \"7 MPa\"\ncrack_initiation = \"55 MPa\"\nconfining_pressure = \"10 MPa\"\n";
    write(stone + "confined_strength = \"222 MPa\"\n");
    add_problem("laboratory, with the line from UCS = 122 MPa to 222 MPa at 10 MPa");
    test::expect_golden(text_);

    test::GoldenRefusals refused("refusals");
    write(stone + "confined_strength = \"100 MPa\"\n");
    refused.add<InputError>("a confined strength below UCS", [&] { problem(); });
    write(stone.erase(stone.find("confining_pressure")) + "confined_strength = \"222 MPa\"\n");
    refused.add<InputError>("no line", [&] { problem(); });
}

TEST_F(CalibrationProblem, RefusesWrongTables) {
    const auto read = [&](const std::string& text) {
        write(text);
        try {
            problem();
        } catch (const InputError& error) {
            const std::string message = error.what();
            throw InputError(message.substr(message.find("material.toml")));  // without the folder
        }
    };
    EXPECT_EQ(test::expect_refused<InputError>("post/calibrate/problem.toml", read), 13U);
}

TEST_F(CalibrationProblem, HasTheParametersOfTheLaw) {
    const auto add = [&](const std::string& what, const std::string& text) {
        write(text);
        text_ += what + "\n";
        add_parameters(problem());
    };
    std::string stone = granite_with("law = \"cohesive-frictional\"\n", "cohesion = \"74.57");
    add("cohesive-frictional", stone);
    // The contrast of the modal table may vary within what is published, 0.17 to 0.32: its coefficient of variation is 0.214.
    add("contrast of minerals", stone + "[phases]\nfrom = \"granite\"\n[parameters]\n\"phases.contrast\" = {}\n");
    const std::string crystals = "\n[fabric]\ntessellation = \"trigon\"\ngrain_size = \"4 mm\"\n";
    const std::string named =
        "[parameters]\n\"ratios.process_zone\" = {}\n\"pairs.within.tensile_strength\" = {}\n"
        "\"pairs.within.fracture_energy\" = {}\n\"contact.cohesion\" = {}\n\"ratios.bridging_strength\" = {}\n"
        "\"ratios.bridging_energy\" = {}\n";
    add("crystals that break", stone + crystals);
    add("their ratios", stone + crystals + named);
    // The material's own are the first guess; outside of the box there is one about them.
    add("ratios of the material",
        stone + crystals + "[ratios]\nprocess_zone = 0.1\n[pairs.within]\nfracture_energy = 20\n" + named);
    stone.insert(stone.find("cohesion = \"74.57"), "residual_friction_angle = \"10 deg\"\nwear_slip = \"0.2 mm\"\n");
    add("friction that wears", stone + crystals);
    stone = granite_with("law = \"cohesive-frictional\"\n# ", "cohesion = \"74.57");
    add("cohesion as a ratio", stone + "\n[ratios]\ncohesion = 2\n");
    add("crystals that break, cohesion as a ratio", stone + crystals + "[ratios]\ncohesion = 6\n");
    test::expect_golden(text_);
}

TEST_F(CalibrationProblem, HasAStudyWithSettings) {
    granite_and("[study]\nconfirmation_discs = 12\nmax_strain = 0.01\nmean_edge = \"3 mm\"\n");
    const Study study = problem().study;
    EXPECT_EQ(study.confirmation_discs, 12U);
    EXPECT_EQ(study.max_strain, 0.01);
    EXPECT_NEAR(study.specimens.mean_edge(), 3e-3, 1e-15);
    const Study set = problem({"points=14", "width=40mm", "predicted_pressures=3 MPa,5 MPa"}).study;
    EXPECT_EQ(set.points, 14U);
    EXPECT_EQ(set.specimens.width, 0.04);
    EXPECT_EQ(set.predicted_pressures, (std::vector<double>{3e6, 5e6}));
    EXPECT_EQ(set.max_strain, 0.01);  // of the file
    test::GoldenRefusals().add_each<UsageError>({"disks=3", "discs", "width=-1mm"}, [&](const char* wrong) { problem({wrong}); });
    write(granite());
    EXPECT_EQ(problem().study.max_strain, 0.015);  // UCS/E as of Augig granite
}

TEST_F(CalibrationProblem, HasTheSpecimenOfTheLaboratoryOrHalfDiscsWithTheGrainsOfDiscs) {
    const auto add = [&](const std::string& what, const Settings& settings) {
        const calibrate::Test last = tests_of(problem(settings).targets).back();  // so that discs keep their specimens with it
        add_run(fmt::format("{} ({})", what, fmt::join(settings, ", ")), last, settings);
    };
    for (const char* method :
         {R"(method = "half-disc", diameter = "75 mm", notch = "18 mm")", R"(method = "beam", height = "40 mm", notch = "12 mm")",
          R"(method = "short-rod", diameter = "50 mm")"}) {
        write(granite() + fmt::format("mode_i_toughness = {{value = \"1.3 MPa.m^0.5\", {}}}\n", method));
        add(method, {});
        if (std::string(method).find("half-disc") != std::string::npos) add(method, {"half_disc_diameter=150mm"});
    }
    granite_and("[targets]\ntoughness = {value = \"1.5 MPa.m^0.5\"}\nbrazilian = {value = \"8.8 MPa\"}\n");
    add("no specimen of the laboratory", {"diameter=60mm"});
    add("no specimen of the laboratory", {"diameter=60mm", "half_disc_diameter=120mm"});
    add("no specimen of the laboratory", {"mean_edge=4mm"});
    test::expect_golden(text_);
}

TEST_F(CalibrationProblem, HasSpecimensOfTheFabricOfTheMaterial) {
    const std::string fabric =
        "[fabric]\ntessellation = \"trigon\"\ngrain_size = \"6 mm\"\nsize_variation = 0.3\nelements_per_crystal = 12\n"
        "elongation = 1.5\nelongation_angle = \"30 deg\"\n";
    for (const std::string study : {"", "grains = 300", "mean_edge = \"5 mm\""}) {
        granite_and(fabric + "[study]\n" + study);
        add_run("crystals of 6 mm (" + study + ")", {"uniaxial", 0, 0.3});
    }
    granite_and(fabric);
    // The equilateral triangle of the area of that diameter has the edge d √(π/√3).
    EXPECT_NEAR(problem().study.specimens.mean_edge(), 6e-3 * std::sqrt(M_PI / std::sqrt(3.0)), 1e-9);
    granite_and("[phases]\nfrom = \"granite\"\n[pairs.within]\ntensile_strength = 2\n");
    add_run("minerals", {"brazilian", 0, 0.3}, {},
            {{"contact.cohesion", 4e7}, {"ratios.process_zone", 0.7}, {"pairs.within.tensile_strength", 1.25}});
    test::expect_golden(text_);
}

// A calibration knows its runs by their files: those of another rock are made again, those of other targets are not.
TEST_F(CalibrationProblem, NamesRunsByWhatTheRockIsMadeOf) {
    const std::map<std::string, std::function<void(Material&)>> changes{
        {"grain size", [](Material& m) { m.grains.grain_size = 5e-3; }},
        {"elements", [](Material& m) { m.grains.elements_per_crystal = 12; }},
        {"elongation", [](Material& m) { m.grains.elongation = 1.5; }},
        {"ratio", [](Material& m) { m.ratios.open_shear_strength = 4; }},
        {"contrast", [](Material& m) { m.fabric.contrast = 0.5; }}};
    // By numbers of grains too: a process zone is as long as the grain size of the fabric says.
    const auto files = [](const Material& rock, const Point& point) {
        std::vector<std::string> all;
        for (const Settings& settings : {Settings{}, {"grains=300", "disc_grains=200"}}) {
            for (const char* test : {"uniaxial", "brazilian", "bend"}) {
                all.push_back(row_of(rock, read_study(rock, {}, settings), {{test}, 7, point, {}, "d1p01", ""}).file);
            }
        }
        return all;
    };
    Material by_ratio = granite_and("[phases]\nfrom = \"granite\"\n[fabric]\ntessellation = \"trigon\"\ngrain_size = \"4 mm\"\n");
    const Material by_point = by_ratio;
    by_ratio.ratios.fracture_energy = 0.5;
    for (const auto& [rock, point] : {std::pair{by_ratio, Point{}}, {by_point, Point{{"ratios.process_zone", 0.7}}}}) {
        const std::vector<std::string> before = files(rock, point);
        for (const auto& [what, change] : changes) {
            Material other = rock;
            change(other);
            const std::vector<std::string> now = files(other, point);
            for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NE(now[i], before[i]) << what;
        }
        Material measured = rock;
        measured.laboratory["tensile_strength"] = 1;
        EXPECT_EQ(files(measured, point), before);
    }
}

}  // namespace
}  // namespace graincrack::calibrate
