// Contacts, cracks and pictures by class of contacts.
#include "post/run/contact_classes.hpp"

#include <gtest/gtest.h>

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/export.hpp"
#include "post/plot/plots.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

/// Columns of quartz, feldspar and mica, from left to right.
Specimen three_minerals() {
    Specimen s = test::grid_specimen(6, 12, 0.06, 0.12);
    s.phase_names = {"quartz", "feldspar", "mica"};
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = static_cast<std::uint8_t>(g / 2 % 6 / 2);
    return s;
}

class Classes : public test::RunFolder {
protected:
    Classes() {
        recipe_.specimen = three_minerals();
        run("run.h5", recipe_);
    }
    test::Recipe recipe_;
};

TEST_F(Classes, HaveNamesIfTheyHaveContacts) {
    // Columns touch their neighbours alone, so that no quartz lies on mica.
    const ContactClasses classes = classes_of(recipe_.specimen);
    EXPECT_EQ(classes.names,
              (std::vector<std::string>{"quartz-quartz", "quartz-feldspar", "feldspar-feldspar", "feldspar-mica", "mica-mica"}));
}

TEST_F(Classes, AddUpToTheCountsOfTheRun) {
    const RunReader run(path("run.h5"));
    const std::vector<Crack> log = test::synthetic_cracks(recipe_.specimen);
    const RunClasses classes = read_classes(run, {});
    ASSERT_EQ(classes.classes.size(), 5U);
    ModeCounts peak, end;
    std::size_t contacts = 0;
    for (const ClassCounts& each : classes.classes) {
        ASSERT_TRUE(each.at_peak);
        peak += *each.at_peak;
        end += each.at_end;
        contacts += each.contacts;
        if (each.name == "feldspar-mica") {
            EXPECT_EQ(each.contacts, 12U);
            EXPECT_NEAR(each.length, 0.12, 1e-12);
        }
    }
    const ModeCounts at_peak = count_modes(log, {}, 1);
    const ModeCounts at_end = count_modes(log, {}, 2);
    EXPECT_DOUBLE_EQ(peak.tensile, at_peak.tensile);
    EXPECT_DOUBLE_EQ(peak.shear, at_peak.shear);
    EXPECT_DOUBLE_EQ(end.tensile, at_end.tensile);
    EXPECT_DOUBLE_EQ(end.shear, at_end.shear);
    EXPECT_LT(peak.tensile, end.tensile);
    EXPECT_GT(end.shear, 0);
    EXPECT_EQ(contacts, recipe_.specimen.n_contacts());
}

TEST_F(Classes, CountTheirOwnCracksAlone) {
    std::vector<Crack> log = test::synthetic_cracks(recipe_.specimen);
    const ContactClasses classes = classes_of(recipe_.specimen);
    std::erase_if(log, [&](const Crack& crack) { return classes.name_of(crack) != "quartz-quartz"; });
    ASSERT_FALSE(log.empty());
    for (const ClassCounts& each : count_by_class(recipe_.specimen, log, std::nullopt)) {
        EXPECT_FALSE(each.at_peak);
        const double wanted = each.name == "quartz-quartz" ? 0.5 * static_cast<double>(log.size()) : 0;
        EXPECT_DOUBLE_EQ(each.at_end.tensile + each.at_end.shear, wanted) << each.name;
    }
}

TEST_F(Classes, HaveATableWithARowEachAndForPeopleTheirSum) {
    const std::vector<RunClasses> runs{read_classes(RunReader(path("run.h5")), {})};
    test::expect_golden(test::written(write_class_counts, runs, TableFormat::tsv), "scripts");
    test::expect_golden(test::written(write_class_counts, runs, TableFormat::aligned), "people");
}

TEST_F(Classes, AreNamedInTheCrackLogWhereThereAreSeveralPhases) {
    const std::vector<Crack> log = test::synthetic_cracks(recipe_.specimen);
    const auto table_of = [&](const Specimen& s) { return test::written(write_crack_table, log, s, TableFormat::tsv); };
    const ContactClasses classes = classes_of(recipe_.specimen);
    const std::string table = table_of(recipe_.specimen);
    for (std::size_t i = 0; i < log.size(); ++i) EXPECT_EQ(test::field(table, "class", i), classes.name_of(log[i]));
    EXPECT_EQ(test::field(table_of(test::grid_specimen(6, 12, 0.06, 0.12)), "class", 0), "");
}

TEST_F(Classes, AreNamedBesideADrawnSpecimen) { test::expect_golden(draw_specimen(recipe_.specimen).words()); }

}  // namespace
}  // namespace graincrack
