// Files of schema 1 are read by the names of today.
#include "share/former_names.hpp"

#include <gtest/gtest.h>

#include "share/run_file.hpp"
#include "tests/support/schema_1.hpp"

namespace graincrack::test {
namespace {

TEST(FormerNames, AHistoryAndAHeaderOfSchema1AreReadAsTheyWere) {
    const TemporaryFolder folder;
    const RunReader run(unpack_schema_1(folder, "uniaxial"));
    EXPECT_EQ(run.file().version(), 1);
    EXPECT_EQ(run.header().stop_reason, "strain limit");
    EXPECT_NEAR(run.header().energy_balance_error, 7.25033e-06, 1e-11);
    EXPECT_EQ(run.file().attribute<std::string>("/run", "energy_balance_error_unit"), "1");
    const History history = run.history();
    ASSERT_EQ(history.size(), 53U);
    EXPECT_NEAR(history[HistoryColumn::energy_balance_error].back(), -7.25033e-06, 1e-11);
    EXPECT_NEAR(history[HistoryColumn::non_conservative_work].back(), 8.31143e-20, 1e-25);  // round-off of a law with a potential
    EXPECT_EQ(run.file().attribute<std::string>("/run", "material"), "Augig granite");
}

TEST(FormerNames, EveryRenamedDatasetAndAttributeOfAProgramIsFound) {
    const TemporaryFolder folder;
    const H5Input run(unpack_schema_1(folder, "program"), "run");
    for (const std::string name :
         {"integrity", "residual", "debonded", "released", "candidate_pairs", "pair_forces", "pair_groups", "watched_pairs",
          "watched_groups", "watched_chunks", "pair_friction", "occupied_area", "velocity", "cluster_energies",
          "node_edge_contacts", "displacement_at_search"}) {
        EXPECT_TRUE(run.has("/state/" + name)) << name;
    }
    for (const std::string name : {"pair_friction_before", "next_list_update", "wants_rebuild", "travel_since_rebuild",
                                   "detection_interval", "energy_balance_error", "time"}) {
        EXPECT_TRUE(run.has_attribute("/state", name)) << name;
    }
    EXPECT_EQ(run.extents("/state/node_edge_contacts"), (Extents{290, 7}));
    EXPECT_EQ(run.read<double>("/state/candidate_pairs").size(), 580U);
    EXPECT_EQ(run.attribute<double>("/state", "next_list_update"), 850);
    EXPECT_EQ(run.attribute<std::vector<std::string>>("/state", "amplitudes"), std::vector<std::string>{"membrane.pressure"});
    EXPECT_EQ(run.attribute<std::vector<double>>("/state", "amplitude_values"), std::vector<double>{1e6});
    EXPECT_EQ(run.attribute<std::vector<std::string>>("/program", "start_amplitudes").size(),
              run.attribute<std::vector<double>>("/program", "start_amplitude_values").size());
    EXPECT_EQ(run.attribute<std::vector<std::string>>("/program", "ended_by"), std::vector<std::string>{"strain limit"});
}

TEST(FormerNames, AreThoseOfAFileOfSchema1Only) {
    EXPECT_EQ(stored_name(1, "/history", "non_conservative_work"), "law_mismatch");
    EXPECT_EQ(stored_name(2, "/history", "non_conservative_work"), "non_conservative_work");
    EXPECT_EQ(stored_name(1, "/frames/0000", "residual"), "residual");
    EXPECT_EQ(present_text(1, "/run", "stop_reason", "strain cap"), "strain limit");
    EXPECT_EQ(present_text(2, "/run", "stop_reason", "strain cap"), "strain cap");
    EXPECT_EQ(present_text(1, "/run", "material", "strain cap"), "strain cap");
}

}  // namespace
}  // namespace graincrack::test
