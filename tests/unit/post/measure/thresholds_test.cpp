#include "post/measure/thresholds.hpp"

#include <gtest/gtest.h>

#include "post/measure/moduli.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

/// Stress rises evenly to 100 MPa over 1,001 rows, E' = 25 GPa, ν' = 0.3; from 50 MPa on the lateral strain has a share of
/// its own, `extra` per MPa² beyond 50 MPa.
LoadCurve opening_curve(double extra) {
    LoadCurve curve;
    for (int i = 0; i <= 1000; ++i) {
        const double stress = i * 0.1e6;
        const double beyond = std::max(stress * 1e-6 - 50, 0.0);
        curve.stress.push_back(stress);
        curve.gauge_axial_strain.push_back(stress / 25e9);
        curve.gauge_lateral_strain.push_back(0.3 * stress / 25e9 + extra * beyond * beyond);
    }
    curve.axial_strain = curve.gauge_axial_strain;
    curve.lateral_strain = curve.gauge_lateral_strain;
    curve.peak = 1000;
    return curve;
}

constexpr double extra = 1e-6;

TEST(Thresholds, AreThoseOfTheirDefinitionsInBothVolumes) {
    const LoadCurve curve = opening_curve(extra);
    for (const double k : {1.0, 2.0}) {  // of the lateral strain in the volume
        const Thresholds found = measure_thresholds(curve, k == 1 ? VolumeKind::plane : VolumeKind::pseudo_3d);
        // ε1 − k ε_lat turns: slope (1 − 0.3 k)/25e3 a MPa = 2 k extra (σ − 50); a row is 0.1 MPa
        const double damage = 50 + (1 - 0.3 * k) / 25e3 / (2 * k * extra);
        EXPECT_NEAR(*found.damage * 1e-6, damage, 0.11);
        // crack strain −k extra (σ − 50)² = −1e-5
        EXPECT_NEAR(*found.initiation_by_crack_strain * 1e-6, 50 + std::sqrt(crack_strain_offset / (k * extra)), 0.11);
    }
}

// The strength is of the smoothed curve, so that a row before it may have more.
TEST(Thresholds, AreNotAboveTheStrength) {
    LoadCurve curve = opening_curve(extra);
    const double damage = *measure_thresholds(curve, VolumeKind::pseudo_3d).damage;
    curve.strength.emplace().stress = damage - 2e5;
    EXPECT_EQ(*measure_thresholds(curve, VolumeKind::pseudo_3d).damage, damage - 2e5);
}

TEST(Thresholds, AreNoneOfATestThatIsElasticUpToThePeak) {
    const Thresholds none = measure_thresholds(opening_curve(0), VolumeKind::pseudo_3d);
    EXPECT_FALSE(none.damage.has_value());
    EXPECT_FALSE(none.initiation_by_crack_strain.has_value());
}

// Of plane strain ε1 + 2 ε3 of ν = 0.35 grows from the start but for the first rows.
TEST(Thresholds, HaveNoDamageWhereTheVolumeGrowsFromTheElasticPartOn) {
    LoadCurve curve = opening_curve(0);
    for (std::size_t row = 10; row < curve.stress.size(); ++row) curve.gauge_lateral_strain[row] *= 0.54 / 0.3;
    EXPECT_FALSE(measure_thresholds(curve, VolumeKind::pseudo_3d).damage.has_value());
}

// A curve whose three volumes and count set in at stresses that differ: the default is that of the pseudo-3D volume.
TEST(Thresholds, AreThoseOfStrainGaugesOnACylinderByDefault) {
    const LoadCurve curve = opening_curve(extra);
    RunData run;
    run.history = test::synthetic_history({});
    for (std::vector<double>& column : run.history.columns) column.resize(curve.stress.size());
    for (std::size_t row = 0; row < curve.stress.size(); ++row) {
        run.history[HistoryColumn::tensile_cracks][row] = row < 900 ? 0 : static_cast<double>(row);
        run.history[HistoryColumn::shear_cracks][row] = 0;
    }
    const AllThresholds all = measure_all_thresholds(run, curve, {});
    EXPECT_NEAR(*all.initiation() * 1e-6, 50 + std::sqrt(crack_strain_offset / (2 * extra)), 0.11);
    EXPECT_NEAR(*all.damage() * 1e-6, 50 + 0.4 / 25e3 / (4 * extra), 0.11);
    EXPECT_NEAR(*all.initiation_by_count * 1e-6, 90, 1e-6);
    for (const auto& other : {all.plane.initiation_by_crack_strain, all.initiation_by_count}) {
        ASSERT_TRUE(other.has_value());
        EXPECT_NE(other, all.initiation());
    }
    ASSERT_TRUE(all.plane.damage.has_value());
    EXPECT_NE(all.plane.damage, all.damage());
    EXPECT_FALSE(all.initiation_by_damage.has_value()) << "there is no log";
}

TEST(CrackStrain, IsTheVolumetricStrainBesideTheElasticLine) {
    const LoadCurve curve = opening_curve(extra);
    const std::vector<double> volume = volumetric_strain(curve, VolumeKind::pseudo_3d);
    EXPECT_NEAR(volume[400], 40e6 / 25e9 * 0.4, 1e-12);
    const std::vector<double> cracks = crack_strain(curve, volume);
    ASSERT_EQ(cracks.size(), curve.stress.size());
    EXPECT_NEAR(cracks[400], 0, 1e-12);
    EXPECT_NEAR(cracks[700], -2 * extra * 400, 1e-12);  // (70 − 50)² MPa²
}

RunData synthetic_run() { return {"", test::synthetic_header({}), test::synthetic_history({}), {}}; }

TEST(Thresholds, HaveInitiationAtOnePercentOfTheCountAtThePeak) {
    RunData run = synthetic_run();  // 25 contacts at the peak, the first tensile one at (0.5 + 1/40) of the way
    const LoadCurve curve = load_curve(run);
    EXPECT_NEAR(*initiation_by_count(run, curve) * 1e-6, 0.53 * 125, 1e-6);
    EXPECT_NEAR(*initiation_by_count(run, curve, 0.5) * 1e-6, 0.8 * 125, 1e-6);  // 12 tensile and 1 in shear of 25
    for (auto column : {HistoryColumn::tensile_cracks, HistoryColumn::shear_cracks}) {
        for (double& n : run.history[column]) n = 0;
    }
    EXPECT_FALSE(initiation_by_count(run, curve).has_value());
}

// The points of a log that are damaged as the history counts them, or later.
TEST(Thresholds, HaveInitiationByDamagedPoints) {
    const RunData run = synthetic_run();
    const LoadCurve curve = load_curve(run);
    const auto& times = run.history[HistoryColumn::time];
    std::vector<Crack> cracks;
    for (std::size_t row = 1; row < times.size(); ++row) {  // as many points as contacts fail in the row
        for (const HistoryColumn column : {HistoryColumn::tensile_cracks, HistoryColumn::shear_cracks}) {
            for (double n = run.history[column][row - 1]; n < run.history[column][row]; ++n) {
                cracks.emplace_back();
                cracks.back().damaged_10.time = times[row] - 1e-9;
            }
        }
    }
    EXPECT_EQ(initiation_by_damage(run, curve, cracks), initiation_by_count(run, curve));
    EXPECT_EQ(initiation_by_damage(run, curve, cracks, 0.5), initiation_by_count(run, curve, 0.5));
    for (Crack& crack : cracks) crack.damaged_10.time += 0.2;
    EXPECT_GT(*initiation_by_damage(run, curve, cracks), *initiation_by_count(run, curve));
    EXPECT_FALSE(initiation_by_damage(run, curve, {Crack()}).has_value());  // not damaged
}

TEST(Thresholds, CountTheCrackEventOfTheRun) {
    const test::TemporaryFolder folder;
    const auto table_of = [&](const test::Recipe& recipe, double delay = 0) {
        std::vector<Crack> cracks = test::synthetic_cracks(recipe.specimen);
        for (Crack& crack : cracks) crack.damaged_50 = {crack.time + delay, 1e-6, 1e-6};
        test::write_run(folder.file("run.h5"), recipe, cracks);
        const std::vector files{folder.file("run.h5")};
        return test::written(write_moduli_table, files, TableFormat::tsv, std::clog, ColumnChoice::all);
    };
    const std::string table = table_of({});
    EXPECT_NEAR(test::number_in(table, "crack_initiation_count_MPa"), 0.5 * 125, 1e-5);
    EXPECT_EQ(test::field(table, "crack_initiation_MPa"), test::field(table, "crack_initiation_crack_strain_pseudo_3d_MPa"));
    EXPECT_EQ(test::field(table, "crack_damage_MPa"), test::field(table, "crack_damage_pseudo_3d_MPa"));
    const std::string half_damaged = table_of({.crack_event = CrackEvent::half_damaged}, 0.2);
    EXPECT_NEAR(test::number_in(half_damaged, "crack_initiation_count_MPa"), 0.7 * 125, 1e-5);
    for (const test::Recipe& recipe :
         {test::Recipe{.test = "tension", .peak = 6e6}, test::Recipe{.drop = 0, .stop_reason = "signal"}}) {
        EXPECT_EQ(test::field(table_of(recipe), "crack_initiation_count_MPa"), "") << recipe.test;
    }
}

}  // namespace
}  // namespace graincrack
