// What a calibration decides, on a synthetic rock with known answers: planted values, targets out of reach, contradictions,
// noise.
#include "post/calibrate/decide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "share/error.hpp"
#include "synthetic_rock.hpp"
#include "tests/support/check.hpp"

namespace graincrack::calibrate {
namespace {

using test::calibrate_synthetic;
using test::Calibration;
using test::expect_one_line;
using test::SyntheticRock;

constexpr double degree = std::numbers::pi / 180;

Material augig() {
    Material rock = read_material(std::string(GRAINCRACK_SOURCE) + "/share/materials/augig-granite.toml");
    rock.laboratory.erase("cohesion");  // C follows from φ and UCS
    return rock;
}

Point point(double tc, double cc, double phic) {
    Point p;
    p[Parameter::young_modulus] = 25.8e9;
    p[Parameter::poisson_ratio] = 0.23;
    p[Parameter::tensile_strength] = tc;
    p[Parameter::cohesion] = cc;
    p[Parameter::friction_angle] = phic;
    return p;
}

/// The rock whose laboratory values are those of the assemblage at a point.
Material rock_planted_at(const SyntheticRock& synthetic, const Point& planted) {
    Material rock = augig();
    const Material grains = material_at(rock, planted);
    const auto contact = contact_parameters(grains, PlaneCondition::strain, std::nullopt);
    const auto moduli =
        fpz::assemblage_moduli(grains.rock, PlaneCondition::strain, contact.normal_stiffness, contact.shear_stiffness, 680);
    const auto disc = effective_values(rock, planted, PlaneCondition::stress);
    const auto rectangle = effective_values(rock, planted, PlaneCondition::strain);
    const double ucs = synthetic.strength("uniaxial", 0, rectangle);
    const double b = (synthetic.strength("triaxial", 8e6, rectangle) - ucs) / 8e6;
    rock.laboratory["young_modulus"] = 0.99 * moduli.young_modulus;
    rock.laboratory["poisson_ratio"] = moduli.poisson_ratio + 0.002;
    rock.laboratory["tensile_strength"] = synthetic.strength("brazilian", 0, disc);
    rock.laboratory["compressive_strength"] = ucs;
    rock.laboratory["friction_angle"] = std::asin((b - 1) / (b + 1));
    return rock;
}

bool names(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Decide, PlantedValuesLieInTheirIntervals) {
    constexpr int trials = 500;
    std::map<Parameter, int> held;
    int calibrated = 0;
    for (int i = 0; i < trials; ++i) {
        SyntheticRock synthetic;
        synthetic.variety = 1000 + static_cast<std::uint64_t>(i);
        // Spread evenly over a box by three irrational numbers.
        const auto part = [&](double irrational) { return std::fmod((i + 1) * irrational, 1.0); };
        const Point planted = point((18 + 12 * part(std::numbers::sqrt2)) * 1e6, (50 + 50 * part(std::numbers::sqrt3)) * 1e6,
                                    (34 + 12 * part(std::numbers::phi)) * degree);
        const Calibration done = calibrate_synthetic(rock_planted_at(synthetic, planted), synthetic, {});
        EXPECT_FALSE(done.asked_twice);
        calibrated += done.decision.ending == Ending::calibrated ? 1 : 0;
        for (const Calibrated& value : done.decision.values) {
            const double there = planted[value.parameter].value();
            held[value.parameter] += *value.value.low <= there && there <= *value.value.high ? 1 : 0;
        }
    }
    // Trials without an answer count as missed.
    for (const Parameter p : {Parameter::tensile_strength, Parameter::cohesion, Parameter::friction_angle})
        EXPECT_GE(held[p], 0.93 * trials) << row_of(p).symbol;
    EXPECT_GE(calibrated, 0.97 * trials);
}

TEST(Decide, ATargetThatTwoParametersTogetherReachIsReached) {
    SyntheticRock synthetic;
    synthetic.tensile_exponent = 0.3;  // below 0.5: tc alone is not identifiable
    Material rock = augig();
    rock.laboratory["tensile_strength"] =
        13e6;  // alone tc reaches 8.8 · 3^0.3 = 12.2 MPa, Gf 11.2 MPa, open shear strength 10.8 MPa
    const Calibration done = calibrate_synthetic(rock, synthetic, {});
    ASSERT_EQ(done.decision.ending, Ending::calibrated) << done.decision.reason;
    const auto values = effective_values(rock, done.decision.point, PlaneCondition::stress);
    EXPECT_NEAR(synthetic.strength("brazilian", 0, values) / 13e6, 1, 0.05);
    EXPECT_TRUE(done.decision.point[Parameter::fracture_energy].has_value());
}

TEST(Decide, ATensileStrengthOutOfReachIsNotReached) {
    Material rock = augig();
    rock.laboratory["tensile_strength"] = 60e6;
    const Calibration done = calibrate_synthetic(rock, {}, {});
    EXPECT_EQ(done.decision.ending, Ending::not_reached);
    EXPECT_TRUE(names(done.decision.reason, "σt 60 MPa is out of reach")) << done.decision.reason;
    ASSERT_EQ(done.decision.outcomes.size(), 1U);  // the nearest point, tested
    EXPECT_EQ(done.decision.outcomes[0].verdict, "outside");
    EXPECT_GE(done.decision.outcomes[0].specimens, 10U);
    EXPECT_GT(*done.decision.point[Parameter::tensile_strength], 60e6);
}

TEST(Decide, StrengthsThatFrictionCannotJoinAreContradictory) {
    SyntheticRock synthetic;
    synthetic.friction_limit = 40;  // b at most 4.6; the laboratory's φ of 53° needs 8.9
    const Calibration done = calibrate_synthetic(augig(), synthetic, {});
    EXPECT_EQ(done.decision.ending, Ending::contradictory) << done.decision.reason;
    EXPECT_TRUE(names(done.decision.reason, "the nearest point is cc")) << done.decision.reason;
}

TEST(Decide, NoisyTargetsAreUndecided) {
    SyntheticRock synthetic;
    synthetic.disc_scatter = 0.5;  // ± 11 % with 80 discs, for a bound of 5 %
    const Calibration done = calibrate_synthetic(augig(), synthetic, {});
    EXPECT_EQ(done.decision.ending, Ending::undecided) << done.decision.reason;
    EXPECT_TRUE(names(done.decision.reason, "σt is undecided")) << done.decision.reason;
}

TEST(Decide, AnIntervalThatIsTooWideIsNotFittedAgain) {
    SyntheticRock synthetic;
    synthetic.confined_scatter = 0.3;  // ± 10 % with 40 specimens, for a bound of 5 %
    synthetic.variety = 4;             // whose means are within their bounds
    const Calibration done = calibrate_synthetic(augig(), synthetic, {});
    EXPECT_EQ(done.decision.ending, Ending::undecided) << done.decision.reason;
    EXPECT_TRUE(names(done.decision.reason, "σ1 at 8 MPa is undecided")) << done.decision.reason;
    EXPECT_TRUE(names(done.decision.reason, "off with 40 specimens, for a bound of")) << done.decision.reason;
    const auto confirmations = std::count_if(done.decision.steps.begin(), done.decision.steps.end(),
                                             [](const Step& step) { return step.stage == "confirmation"; });
    EXPECT_EQ(confirmations, static_cast<std::ptrdiff_t>(done.decision.outcomes.size()));  // one round
    for (const Outcome& o : done.decision.outcomes) EXPECT_LE(std::abs(o.ours->value - o.target.value), o.target.tolerance());
}

TEST(Decide, StiffnessOutOfReachIsNotReached) {
    Material rock = augig();
    rock.laboratory["poisson_ratio"] = 0.012;  // grains with a negative ν
    const Calibration done = calibrate_synthetic(rock, {}, {});
    EXPECT_EQ(done.decision.ending, Ending::not_reached);
    EXPECT_TRUE(names(done.decision.reason, "stiffer than the process zone's")) << done.decision.reason;
}

TEST(Decide, AnyInterruptionGoesOn) {
    const Material rock = augig();
    const SyntheticRock synthetic;
    const Calibration whole = calibrate_synthetic(rock, synthetic, {});
    std::vector<FinishedRun> runs;
    Decision decision;
    const Study study;
    for (int call = 0; call < 2000; ++call) {
        decision = decide(rock, study, runs);
        if (decision.ending != Ending::wanted) break;
        // A third of the wanted runs is finished, in another order, before the next call.
        const std::size_t n = (decision.wanted.size() + 2) / 3;
        for (std::size_t i = 0; i < n; ++i)
            runs.insert(runs.begin(), synthetic.run(rock, decision.wanted[decision.wanted.size() - 1 - i], study.max_strain));
    }
    EXPECT_EQ(decision.ending, whole.decision.ending);
    EXPECT_EQ(runs.size(), whole.runs.size());
    EXPECT_EQ(label_of(decision.point), label_of(whole.decision.point));
}

TEST(Decide, EveryWantedRunHasAReasonAndEveryNumberIsInTheSteps) {
    const Calibration done = calibrate_synthetic(augig(), {}, {});
    ASSERT_EQ(done.decision.ending, Ending::calibrated) << done.decision.reason;
    const Decision first = decide(augig(), {}, {});
    ASSERT_FALSE(first.wanted.empty());
    for (const WantedRun& run : first.wanted) EXPECT_FALSE(run.reason.empty());
    const auto has = [&](const std::string& stage) {
        return std::any_of(done.decision.steps.begin(), done.decision.steps.end(),
                           [&](const Step& s) { return s.stage == stage; });
    };
    for (const char* stage : {"targets", "first guess", "elasticity", "σt", "start", "cc, φc", "confirmation"})
        EXPECT_TRUE(has(stage));
    const auto fitted = [](const Outcome& o) { return o.target.role == Role::fitted; };
    EXPECT_EQ(std::count_if(done.decision.outcomes.begin(), done.decision.outcomes.end(), fitted), 5);
    EXPECT_EQ(done.decision.values.size(), 3U);
}

TEST(Decide, PredictionsAreTestedButNotFitted) {
    Study study;
    study.targets.predicted_pressures = {12e6, 20e6};
    const Calibration done = calibrate_synthetic(augig(), {}, study);
    std::map<std::string, Outcome> predicted;
    for (const Outcome& o : done.decision.outcomes) {
        if (o.target.role == Role::predicted) predicted.emplace(o.target.symbol, o);
    }
    ASSERT_EQ(predicted.size(), 6U);
    EXPECT_EQ(predicted.at("σ1 at 20 MPa").specimens, study.predicted);
    EXPECT_FALSE(predicted.at("σ1 at 20 MPa").verdict.empty());
    EXPECT_NEAR(predicted.at("K_IC").ours->value, 1.6e6, 1);
    EXPECT_NEAR(predicted.at("direct tensile strength").ours->value, 11e6, 1);
    EXPECT_TRUE(predicted.at("direct tensile strength").verdict.empty());  // the laboratory has none
    // Thresholds are those of the specimens for UCS.
    EXPECT_GE(predicted.at("crack damage by reversal of volume").specimens, study.rectangles.least);
}

TEST(Decide, AMissingLaboratoryValueIsOneLine) {
    for (const char* key : {"young_modulus", "poisson_ratio", "tensile_strength", "compressive_strength"}) {
        Material rock = augig();
        rock.laboratory.erase(key);
        expect_one_line<InputError>([&] { decide(rock, {}, {}); }, {"[laboratory] has no", key});
    }
    Material rock = augig();
    rock.laboratory.erase("friction_angle");
    expect_one_line<InputError>([&] { decide(rock, {}, {}); }, {"neither friction_angle nor cohesion"});
}

}  // namespace
}  // namespace graincrack::calibrate
