// A run in a file: header, history in pieces, frames thinned and numbered in time order, cracks.
#include "share/file/run_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/provenance.hpp"
#include "share/file/schema.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

using test::TemporaryFolder;

Specimen specimen() { return test::one_diagonal_grid(2, 2, 0.02, 0.02); }

/// A header in which all members differ.
RunHeader header() {
    RunHeader h;
    h.test = "triaxial";
    h.material = "Augig granite";
    h.contact_law = "literal";
    h.crack_event = CrackEvent::half_damaged;
    h.fracture_energy_choice = "mixed";
    h.plane = PlaneCondition::stress;
    h.rate = "blocks";
    h.mass_scaling = "selective";
    h.stop_reason = "peak drop";
    h.steps = 5000000000;
    h.rock = {1.5, 2.5, 3.5, 4.5, 5.5, 6.5};
    double value = 6.5;
    const auto number = [&](std::initializer_list<double*> members) {
        for (double* member : members) *member = ++value;
    };
    number({&h.contact.critical_opening, &h.contact.critical_sliding, &h.contact.ultimate_opening});
    number({&h.platen_friction, &h.confining_pressure, &h.rate_tolerance, &h.platen_speed, &h.damping, &h.peak_drop,
            &h.max_strain, &h.stable_time_step, &h.time_step, &h.isotropic_end_time});
    number({&h.peak_axial_stress, &h.energy_scale, &h.energy_balance_error, &h.platen_force_difference, &h.confinement_mean,
            &h.confinement_deviation, &h.damping_share});
    for (const ContactParameter& row : all_contact_parameters()) h.contact.*row.value = ++value;
    return h;
}

/// `rows` rows in which every value is different.
History history(std::size_t rows) {
    History h;
    h.has_temperature = true;
    for (std::size_t c = 0; c < h.columns.size(); ++c) {
        for (std::size_t i = 0; i < rows; ++i) h.columns[c].push_back(static_cast<double>(c) + 100.0 * static_cast<double>(i));
    }
    return h;
}

Frame frame_at(double time) {
    const Specimen s = specimen();
    Frame f;
    f.time = time;
    f.step = static_cast<std::int64_t>(1000 * time);
    double next = time;
    const auto fill = [&next](auto& rows, std::size_t n) {
        rows.resize(n);
        for (auto& row : rows) {
            for (auto& value : row) {
                value = next;
                next += 0.001;
            }
        }
    };
    fill(f.displacement, s.n_nodes());
    fill(f.velocity, s.n_nodes());
    fill(f.element_stress, s.n_elements());
    fill(f.opening, s.n_contacts());
    fill(f.sliding, s.n_contacts());
    fill(f.traction, s.n_contacts());
    fill(f.damage, s.n_contacts());
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        f.state.push_back({static_cast<std::uint8_t>(c % 4), static_cast<std::uint8_t>((c + 1) % 4)});
    }
    return f;
}

std::vector<Crack> cracks() {
    Crack failed_in_shear{0.6, 6000000000, 2, 0, CrackMode::shear, 2.2, {-0.003, 0.004}, 0.0, 0.0025, -1e-7, 3e-6, 0.25};
    failed_in_shear.damaged_10 = {0.65, 1e-7, 1e-6};
    failed_in_shear.damaged_50 = {0.7, 2e-7, 2e-6};
    failed_in_shear.broken = {0.8, 2e-6, -4e-6};
    failed_in_shear.separated = {0.9, 3e-6, 5e-6};
    return {{0.5, 500, 3, 1, CrackMode::tensile, 0.1, {0.001, -0.002}, 1.2, 0.005, 1e-6, -2e-6, 0.75}, failed_in_shear};
}

/// Writes a run, to which `write` may add data before the file is finished.
template <class Write>
void write_run(const std::string& path, Write&& write, const RunHeader& of_run = header(),
               const std::vector<Crack>& log = cracks()) {
    RunWriter writer(H5Output(path, "run"), specimen(), of_run);
    write(writer);
    writer.finish(of_run, log, {"graincrack-solve", {"graincrack-solve", "uniaxial"}, "", "", "", {}, 12.25, 3, 1, ""});
}
void add_row(RunWriter& writer) { writer.append_history(history(1)); }

// What is read is what was written: written again it makes the same file.
TEST(RunFile, GivesBackHeaderAndCracks) {
    const TemporaryFolder folder;
    write_run(folder.file("a.h5"), add_row);
    const RunReader run(folder.file("a.h5"));
    write_run(folder.file("b.h5"), add_row, run.header(), run.cracks());
    EXPECT_EQ(RunReader(folder.file("b.h5")).file().digest(), run.file().digest());
    const RunHeader& r = run.header();
    EXPECT_EQ(r.test, "triaxial");
    EXPECT_EQ(r.plane, PlaneCondition::stress);
    EXPECT_EQ(r.crack_event, CrackEvent::half_damaged);
    EXPECT_EQ(r.steps, 5000000000);
    EXPECT_EQ(r.rock.tensile_strength, header().rock.tensile_strength);
    EXPECT_EQ(r.damping_share, header().damping_share);
    for (const ContactParameter& row : all_contact_parameters()) {
        const std::string name(row.quantity.name);
        EXPECT_EQ(r.contact.*row.value, header().contact.*row.value) << name;
        EXPECT_EQ(run.file().attribute<double>("/run", name), header().contact.*row.value) << name;
        EXPECT_EQ(run.file().attribute<std::string>("/run", name + "_unit"), row.quantity.unit()) << name;
    }
    EXPECT_EQ(run.wall_time(), 12.25);
    EXPECT_EQ(run.threads(), 3);
    EXPECT_EQ(run.specimen().contact_nodes, specimen().contact_nodes);
    const std::vector<Crack> read = run.cracks();
    ASSERT_EQ(read.size(), 2U);
    EXPECT_TRUE(std::isnan(read[0].separated.time) && std::isnan(read[0].damaged_10.time) && std::isnan(read[0].broken.time));
    EXPECT_EQ(read[1].mode, CrackMode::shear);
    EXPECT_EQ(read[1].damaged_50, cracks()[1].damaged_50);
    EXPECT_EQ(run.file().read<double>("/cracks/sliding_damaged_50")[1], 2e-6);
    EXPECT_EQ(run.file().read<double>("/cracks/opening_separated")[1], 3e-6);
}

// Imitated by giving the attribute another name or value of the same length.
TEST(RunFile, IsRefusedForAnUnknownCrackEventOrALostAttribute) {
    const TemporaryFolder folder;
    write_run(folder.file("new.h5"), add_row);
    test::GoldenRefusals refused;
    for (const std::string& word : {std::string("half-damaged"), "contact_residual_cohesion" + std::string(1, '\0')}) {
        std::string bytes = text_of_file(folder.file("new.h5"));
        ASSERT_NE(bytes.find(word), std::string::npos);
        bytes[bytes.find(word)] = 'X';
        std::ofstream(folder.file("other.h5"), std::ios::binary) << bytes;
        refused.add<InputError>(word.c_str(), [&] { RunReader(folder.file("other.h5")); });
    }
    write_run(folder.file("r.h5"), add_row);
    refused.add<InputError>("frame", [&] { static_cast<void>(RunReader(folder.file("r.h5")).frame(6)); });
}

TEST(RunFile, GivesBackAHistoryWrittenInPieces) {
    const TemporaryFolder folder;
    write_run(folder.file("r.h5"), [](RunWriter& w) {
        for (const std::size_t rows : {0U, 1U, 1U, 4U, 700U}) w.append_history(history(rows));
    });
    const History read = RunReader(folder.file("r.h5")).history();
    const History expected = history(700);
    ASSERT_EQ(read.size(), 700U);
    for (std::size_t c = 0; c < read.columns.size(); ++c) {
        EXPECT_EQ(read.columns[c], expected.columns[c]) << history_datasets[c].name;
    }
    EXPECT_EQ(read[HistoryColumn::platen_speed][1], 100.0 + static_cast<double>(HistoryColumn::platen_speed));
    History cold = expected;
    cold.has_temperature = false;
    write_run(folder.file("cold.h5"), [&](RunWriter& w) { w.append_history(cold); });
    EXPECT_FALSE(RunReader(folder.file("cold.h5")).file().has("/history/temperature"));
    EXPECT_EQ(RunReader(folder.file("cold.h5")).history()[HistoryColumn::temperature], std::vector<double>(700, 0.0));
}

TEST(RunFile, HasColumnsOfDifferentNames) {
    std::set<std::string_view> names;
    for (const HistoryDataset& d : history_datasets) {
        EXPECT_TRUE(names.insert(d.name).second) << d.name;
        EXPECT_FALSE(d.description.empty());
    }
    const auto name = [](HistoryColumn c) { return history_datasets[static_cast<std::size_t>(c)].name; };
    EXPECT_EQ(name(HistoryColumn::time), "time");
    EXPECT_EQ(name(HistoryColumn::gauge_lateral_strain), "gauge_lateral_strain");
    EXPECT_EQ(name(HistoryColumn::energy_platen), "energy_platen");
    EXPECT_EQ(name(HistoryColumn::energy_balance_error), "energy_balance_error");
    EXPECT_EQ(name(HistoryColumn::platen_speed), "platen_speed");
}

void expect_equal(const Frame& a, const Frame& b) {
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.displacement, b.displacement);
    EXPECT_EQ(a.velocity, b.velocity);
    EXPECT_EQ(a.element_stress, b.element_stress);
    EXPECT_EQ(a.opening, b.opening);
    EXPECT_EQ(a.sliding, b.sliding);
    EXPECT_EQ(a.traction, b.traction);
    EXPECT_EQ(a.damage, b.damage);
    EXPECT_EQ(a.state, b.state);
}

TEST(RunFile, ThinsFramesAndLeavesThoseKept) {
    const TemporaryFolder folder;
    write_run(folder.file("r.h5"), [](RunWriter& w) {
        w.append_history(history(1));
        for (int i = 0; i < 8; ++i) w.add_frame(frame_at(i), i == 3 ? FrameRole::kept : FrameRole::regular);
        EXPECT_EQ(w.n_frames(), 8U);
        w.thin_frames();  // removes every second of 0 1 2 4 5 6 7
        EXPECT_EQ(w.n_frames(), 5U);
        w.add_frame(frame_at(9), FrameRole::kept);
    });
    const RunReader run(folder.file("r.h5"));
    EXPECT_EQ(run.frame_times(), (std::vector<double>{0, 2, 3, 5, 7, 9}));
    ASSERT_EQ(run.n_frames(), 6U);
    expect_equal(run.frame(2), frame_at(3));
    expect_equal(run.frame(5), frame_at(9));
    EXPECT_EQ(run.file().children("/frames"), (std::vector<std::string>{"0000", "0001", "0002", "0003", "0004", "0005"}));
    EXPECT_EQ(run.file().extents("/frames/0000/traction"), (Extents{specimen().n_contacts(), 2, 2}));
}

// The frame of the peak is known only after later ones were written.
TEST(RunFile, NumbersFramesInTheOrderOfTime) {
    const TemporaryFolder folder;
    write_run(folder.file("r.h5"), [](RunWriter& w) {
        w.append_history(history(1));
        for (const double time : {0.0, 1.0, 4.0, 2.0, 3.0}) {
            w.add_frame(frame_at(time), time == 2.0 ? FrameRole::kept : FrameRole::regular);
        }
    });
    const RunReader run(folder.file("r.h5"));
    EXPECT_EQ(run.frame_times(), (std::vector<double>{0, 1, 2, 3, 4}));
    expect_equal(run.frame(2), frame_at(2));
    const H5Input& file = run.file();  // its view shows the frame that is the last in time
    EXPECT_EQ(file.attribute<std::string>("/VTKHDF", "Type"), "UnstructuredGrid");
    EXPECT_EQ(file.read<double>("/VTKHDF/PointData/displacement"), file.read<double>("/frames/0004/displacement"));
    EXPECT_EQ(file.read<double>("/VTKHDF/PointData/velocity"), file.read<double>("/frames/0004/velocity"));
    EXPECT_EQ(file.read<double>("/VTKHDF/CellData/element_stress"), file.read<double>("/frames/0004/element_stress"));
    EXPECT_EQ(file.read<std::uint8_t>("/VTKHDF/Types"), std::vector<std::uint8_t>(specimen().n_elements(), 5));
}

TEST(RunFile, ComesBackWithoutCracksAndFrames) {
    const TemporaryFolder folder;
    write_run(folder.file("r.h5"), [](RunWriter& w) { w.append_history(history(2)); }, header(), {});
    const RunReader run(folder.file("r.h5"));
    EXPECT_TRUE(run.cracks().empty());
    EXPECT_EQ(run.n_frames(), 0U);
    EXPECT_TRUE(run.frame_times().empty());
    EXPECT_EQ(run.history().size(), 2U);
}

TEST(RunFile, HasADigestWhateverTimeAndPiecesItTook) {
    const TemporaryFolder folder;
    const auto write = [&](const std::string& name, std::initializer_list<std::size_t> pieces, double wall_time) {
        RunWriter writer(H5Output(folder.file(name), "run"), specimen(), header());
        for (const std::size_t rows : pieces) writer.append_history(history(rows));
        writer.finish(header(), cracks(), {"", {}, "", "", "", {}, wall_time, 1, 1, ""});
        return RunReader(folder.file(name)).file().digest();
    };
    const std::string digest = write("a.h5", {10}, 1);
    EXPECT_EQ(digest, write("b.h5", {3, 7, 10}, 2));
    EXPECT_NE(digest, write("c.h5", {9}, 1));
}

}  // namespace
}  // namespace graincrack
