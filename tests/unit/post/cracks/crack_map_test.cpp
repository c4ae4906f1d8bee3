#include "post/cracks/export.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <cmath>
#include <set>

#include "post/run/run_state.hpp"
#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

vtkSmartPointer<vtkPolyData> read_lines(const std::string& path) {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
}

/// An entry of a cell.
double data_of(vtkPolyData* lines, const char* name, std::size_t cell) {
    return lines->GetCellData()->GetArray(name)->GetComponent(static_cast<vtkIdType>(cell), 0);
}

class CrackMap : public test::RunFolder {
protected:
    void SetUp() override {
        run("run.h5", recipe_);
        export_run("run.h5", "map");
    }
    std::string map(const std::string& name) const { return folder_.file("map/" + name); }
    void export_run(const std::string& run, const std::string& folder, const CrackExportOptions& options = {}) const {
        export_cracks(RunReader(folder_.file(run)), folder_.file(folder), options, Verbosity::quiet);
    }
    test::Recipe recipe_;
};

TEST_F(CrackMap, NamesEveryFrameOfASeriesWithItsTime) {
    for (const std::string series : {"grains.pvd", "cracks.pvd"}) test::expect_golden(test::read_text(map(series)), series);
    for (const std::string name : {"grains_0001.vtu", "cracks_0001.vtp"}) EXPECT_TRUE(std::filesystem::exists(map(name)));
    for (const auto& entry : std::filesystem::directory_iterator(folder_.file("map"))) {
        EXPECT_NE(entry.path().extension(), ".part");
    }
}

TEST_F(CrackMap, HasGrainsWithStressAndDisplacement) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(map("grains_0001.vtu").c_str());
    reader->Update();
    vtkUnstructuredGrid* grid = reader->GetOutput();
    const Specimen& specimen = recipe_.specimen;
    ASSERT_EQ(grid->GetNumberOfCells(), static_cast<vtkIdType>(specimen.n_elements()));
    ASSERT_EQ(grid->GetNumberOfPoints(), static_cast<vtkIdType>(specimen.n_nodes()));
    EXPECT_DOUBLE_EQ(grid->GetPoint(5)[1], specimen.node_position[5][1]);
    const Frame frame = test::synthetic_frame(specimen, 1, 0.005, 0);
    vtkDataArray* displacement = grid->GetPointData()->GetArray("displacement");
    ASSERT_NE(displacement, nullptr);
    ASSERT_EQ(displacement->GetNumberOfComponents(), 3);
    EXPECT_DOUBLE_EQ(displacement->GetComponent(5, 1), frame.displacement[5][1]);
    EXPECT_NE(frame.displacement[5][1], 0);
    EXPECT_EQ(displacement->GetComponent(5, 2), 0);
    ASSERT_NE(grid->GetPointData()->GetArray("velocity"), nullptr);
    const auto of_cell = [&](const char* name, int component = 0) {
        vtkDataArray* const array = grid->GetCellData()->GetArray(name);
        return array == nullptr ? NAN : array->GetComponent(3, component);
    };
    const std::array<double, 4> stress{1e6, -100e6, -20e6, 5e6};  // XX, YY, ZZ, XY
    for (int i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(of_cell("stress", i), stress[static_cast<std::size_t>(i)]);
    const double radius = std::hypot(101e6 / 2, 5e6);
    // Floats: 6e-8 of 1e8 Pa
    EXPECT_NEAR(of_cell("principal_stress_1"), -99e6 / 2 + radius, 6);
    EXPECT_NEAR(of_cell("principal_stress_2"), -99e6 / 2 - radius, 6);
    EXPECT_EQ(of_cell("grain"), 3);
    EXPECT_EQ(of_cell("phase"), 0);
    EXPECT_EQ(of_cell("fragment"), 0);  // nothing has separated
}

TEST_F(CrackMap, HasCracksUpToTheirFrame) {
    const std::vector<Crack> all = test::synthetic_cracks(recipe_.specimen);
    for (const auto& [file, time] : {std::pair{"cracks_0000.vtp", 0.0}, {"cracks_0001.vtp", 1.0}, {"cracks_0002.vtp", 1.25}}) {
        const auto lines = read_lines(map(file));
        const std::vector<Crack> present = cracks_until(all, time);
        ASSERT_EQ(lines->GetNumberOfLines(), static_cast<vtkIdType>(present.size())) << file;
        for (std::size_t i = 0; i < present.size(); ++i) {
            double a[3], b[3];
            lines->GetPoint(static_cast<vtkIdType>(2 * i), a);
            lines->GetPoint(static_cast<vtkIdType>(2 * i + 1), b);
            EXPECT_NEAR((a[0] + b[0]) / 2, present[i].position[0], 1e-12);
            EXPECT_NEAR(std::hypot(b[0] - a[0], b[1] - a[1]), present[i].length, 1e-12);
            EXPECT_EQ(data_of(lines, "mode", i), static_cast<double>(present[i].mode));
            EXPECT_EQ(data_of(lines, "time_of_failure", i), present[i].time);
            EXPECT_EQ(data_of(lines, "opening_at_failure", i), present[i].opening);
            EXPECT_EQ(data_of(lines, "fracture_energy_at_end", i), present[i].energy_released);
            EXPECT_EQ(data_of(lines, "mode_angle", i), present[i].mode_angle);
            EXPECT_EQ(data_of(lines, "separated", i), present[i].separated.time <= time ? 1 : 0);
            EXPECT_EQ(data_of(lines, "contact", i), present[i].contact);
            EXPECT_EQ(data_of(lines, "damage", i), 0);
            EXPECT_EQ(data_of(lines, "phase_a", i), 0);
        }
    }
    ASSERT_TRUE(cracks_until(all, 0).empty());
    ASSERT_LT(cracks_until(all, 1).size(), all.size());
}

TEST_F(CrackMap, GivesCracksTheClassAndStrengthFactorOfTheirContact) {
    Specimen& s = recipe_.specimen;
    s.phase_names = {"quartz", "mica"};
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = g % 3 == 0 ? 1 : 0;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) s.contact_strength_factor.push_back(1 + 0.001 * static_cast<double>(c));
    test::write_run(folder_.file("minerals.h5"), recipe_);
    export_run("minerals.h5", "minerals");
    const auto lines = read_lines(folder_.file("minerals/cracks_0002.vtp"));
    const std::vector<std::uint8_t> classes = contact_classes(s);
    const std::vector<Crack> all = test::synthetic_cracks(s);
    ASSERT_EQ(lines->GetNumberOfLines(), static_cast<vtkIdType>(all.size()));
    std::set<double> seen;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto c = static_cast<std::size_t>(all[i].contact);
        EXPECT_EQ(data_of(lines, "class", i), classes[c]);
        EXPECT_EQ(data_of(lines, "strength_factor", i), s.contact_strength_factor[c]);
        seen.insert(data_of(lines, "class", i));
    }
    EXPECT_EQ(seen.size(), 2U);  // no two grains of mica touch here
    auto* const names = vtkStringArray::SafeDownCast(lines->GetFieldData()->GetAbstractArray("class_names"));
    ASSERT_NE(names, nullptr);
    EXPECT_EQ(names->GetValue(1), "quartz-mica");
    EXPECT_EQ(test::field(test::read_text(folder_.file("minerals/classes.tsv")), "class", 1), "quartz-mica");
}

// The crack log has the motion at failure; each frame has its own.
TEST_F(CrackMap, HasThePresentMotionAndTractionOfEachFrame) {
    std::vector<Crack> cracks = test::synthetic_cracks(recipe_.specimen);
    for (Crack& crack : cracks) crack.time = 0.4;
    RunWriter writer(H5Output(folder_.file("moving.h5"), "run"), recipe_.specimen, test::synthetic_header(recipe_));
    writer.append_history(test::synthetic_history(recipe_));
    for (const double time : {0.5, 1.25}) {
        Frame frame = test::synthetic_frame(recipe_.specimen, time, 0, 0);
        frame.opening.assign(recipe_.specimen.n_contacts(), {4e-6 * time, -1e-6 * time});
        frame.sliding.assign(recipe_.specimen.n_contacts(), {3e-6 * time, 5e-6 * time});
        frame.traction.assign(recipe_.specimen.n_contacts(), {2e6 * time, 1e6 * time, -8e6 * time, 6e6 * time});
        writer.add_frame(frame, FrameRole::kept);
    }
    writer.finish(test::synthetic_header(recipe_), cracks, Provenance{});
    export_run("moving.h5", "moving");
    const ContactParameters contact = test::synthetic_header(recipe_).contact;
    for (const auto& [file, time] : {std::pair{"moving/cracks_0000.vtp", 0.5}, {"moving/cracks_0001.vtp", 1.25}}) {
        const auto lines = read_lines(folder_.file(file));
        ASSERT_EQ(lines->GetNumberOfLines(), static_cast<vtkIdType>(cracks.size()));
        for (std::size_t i = 0; i < cracks.size(); ++i) {
            const bool first = cracks[i].point == 0;
            EXPECT_DOUBLE_EQ(data_of(lines, "opening", i), (first ? 4e-6 : -1e-6) * time);
            EXPECT_DOUBLE_EQ(data_of(lines, "sliding", i), (first ? 3e-6 : 5e-6) * time);
            EXPECT_DOUBLE_EQ(data_of(lines, "normal_traction", i), (first ? 2e6 : -8e6) * time);
            EXPECT_DOUBLE_EQ(data_of(lines, "shear_traction", i), (first ? 1e6 : 6e6) * time);
            // Open: half of traction times motion; closed: of the squares of the tractions over the stiffnesses.
            const double open = 0.5 * (2e6 * 4e-6 + 1e6 * 3e-6);
            const double closed = 0.5 * (8e6 * 8e6 / contact.normal_stiffness + 6e6 * 6e6 / contact.shear_stiffness);
            EXPECT_NEAR(data_of(lines, "stored_energy", i), (first ? open : closed) * time * time * cracks[i].length, 1e-12);
            EXPECT_EQ(data_of(lines, "opening_at_failure", i), 2e-6);
            EXPECT_EQ(data_of(lines, "sliding_at_failure", i), 1e-6);
        }
    }
}

TEST_F(CrackMap, HasUnitsNamesOfModesAndWhereTheTestStands) {
    const auto lines = read_lines(map("cracks_0001.vtp"));
    for (const auto& [name, unit] : {std::pair{"opening", "m"}, {"shear_traction", "Pa"}, {"time_of_failure", "s"}}) {
        vtkDataArray* array = lines->GetCellData()->GetArray(name);
        ASSERT_NE(array, nullptr) << name;
        ASSERT_TRUE(array->HasInformation()) << name;
        EXPECT_STREQ(array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()), unit) << name;
    }
    const auto* modes = vtkStringArray::SafeDownCast(lines->GetFieldData()->GetAbstractArray("mode_names"));
    ASSERT_NE(modes, nullptr);
    EXPECT_EQ(const_cast<vtkStringArray*>(modes)->GetValue(1), "shear");
    const History history = test::synthetic_history(recipe_);
    const auto peak = static_cast<std::size_t>(recipe_.rows - 1);  // the frame at 1 s
    const auto field = [](vtkDataObject* data, const char* name) {
        return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
    };
    EXPECT_DOUBLE_EQ(field(lines, "time"), 1);
    EXPECT_DOUBLE_EQ(field(lines, "axial_stress"), history[HistoryColumn::axial_stress][peak]);
    EXPECT_DOUBLE_EQ(field(lines, "axial_strain"), history[HistoryColumn::axial_strain][peak]);
    const auto platens = read_lines(map("platens_0001.vtp"));
    ASSERT_EQ(platens->GetNumberOfPolys(), 2);
    // The lower platen lies on the specimen, and has moved up by half of the approach.
    EXPECT_DOUBLE_EQ(platens->GetPoint(0)[1], -recipe_.specimen.height / 2);
    EXPECT_DOUBLE_EQ(platens->GetPointData()->GetArray("displacement")->GetComponent(0, 1),
                     -recipe_.specimen.height / 2 * history[HistoryColumn::axial_strain][peak]);
}

TEST_F(CrackMap, WarpsCracksWithTheirFacets) {
    const auto lines = read_lines(map("cracks_0002.vtp"));
    const Frame frame = test::synthetic_frame(recipe_.specimen, 1.25, 0.006, 0.001);
    const std::vector<Crack> cracks = test::synthetic_cracks(recipe_.specimen);
    for (std::size_t i = 0; i < cracks.size(); ++i) {
        // Middle of the half facet, mean of both sides, displaced: by hand from the four nodes.
        const auto& nodes = recipe_.specimen.contact_nodes[static_cast<std::size_t>(cracks[i].contact)];
        const auto place = [&](std::size_t k) {
            const auto node = static_cast<std::size_t>(nodes[k]);
            return recipe_.specimen.node_position[node][0] + frame.displacement[node][0];
        };
        const double first = (place(0) + place(2)) / 2;
        const double second = (place(1) + place(3)) / 2;
        const double expected = cracks[i].point == 0 ? 0.75 * first + 0.25 * second : 0.25 * first + 0.75 * second;
        const auto id = static_cast<vtkIdType>(2 * i);
        const double warped = (lines->GetPoint(id)[0] + lines->GetPoint(id + 1)[0]) / 2 +
                              lines->GetPointData()->GetArray("displacement")->GetComponent(id, 0);
        EXPECT_NEAR(warped, expected, 1e-12);
    }
}

TEST_F(CrackMap, HasTablesOfCracksAndRosette) {
    const std::vector<Crack> cracks = test::synthetic_cracks(recipe_.specimen);
    const auto rows_of = [this](const char* name) { return test::parse_tsv(test::read_text(map(name))).size(); };
    EXPECT_EQ(rows_of("cracks.tsv"), cracks.size() + 1);
    EXPECT_EQ(rows_of("rosette.tsv"), 19U);
    EXPECT_EQ(rows_of("fragments.tsv"), 2U);
    EXPECT_GT(rows_of("events.tsv"), 2U);
    const std::string crack_log = test::read_text(map("cracks.tsv"));
    EXPECT_EQ(test::field(crack_log, "mode", 0), cracks[0].mode == CrackMode::tensile ? "tensile" : "shear");
    EXPECT_EQ(test::field(crack_log, "time_separated_s", 1), "");  // not separated
    EXPECT_EQ(test::field(crack_log, "mode_by_sign", 0), "tensile");
    EXPECT_EQ(test::field(crack_log, "mode_broken_by_sign", 0), "");
    test::expect_golden(test::read_text(map("summary.tsv")));
}

TEST_F(CrackMap, HasATimeOnceInASeries) {
    RunWriter writer(H5Output(folder_.file("twice.h5"), "run"), recipe_.specimen, test::synthetic_header(recipe_));
    writer.append_history(test::synthetic_history(recipe_));
    for (const double time : {0.0, 1.25, 1.25}) {
        writer.add_frame(test::synthetic_frame(recipe_.specimen, time, 0, 0), FrameRole::kept);
    }
    writer.finish(test::synthetic_header(recipe_), {}, Provenance{});
    export_run("twice.h5", "twice");
    test::expect_golden(test::read_text(folder_.file("twice/grains.pvd")));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("twice/grains_0002.vtu")));
}

TEST_F(CrackMap, HasTablesOfJsonLinesIfAsked) {
    CrackExportOptions options;
    options.format = TableFormat::jsonl;
    export_run("run.h5", "json", options);
    EXPECT_TRUE(test::read_text(folder_.file("json/summary.jsonl")).starts_with("{\"file\": "));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("json/summary.tsv")));
    EXPECT_TRUE(std::filesystem::exists(folder_.file("json/cracks.jsonl")));
}

TEST_F(CrackMap, NeedsContactsThatAreThereAndAFolder) {
    std::vector<Crack> cracks = test::synthetic_cracks(recipe_.specimen);
    cracks[3].contact = static_cast<std::int32_t>(recipe_.specimen.n_contacts());
    test::write_run(folder_.file("bad.h5"), recipe_, cracks);
    test::GoldenRefusals refused;
    refused.add<InputError>("a contact that is not there", [&] { export_run("bad.h5", "bad"); });
    refused.add<OutputError>("a file in place of the folder", [&] { export_run("run.h5", "run.h5"); });
}

}  // namespace
}  // namespace graincrack
