// Selective mass scaling: a longer step that stays stable while contacts fail, the same balance at rest, momentum to
// round-off, a closed energy balance.
#include "solver/model/vertex_clusters.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/linear_statics.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_contact;
using test::augig_law;
using test::expect_close;
using test::SmallRun;
using test::verify;
using test::verify_between;

Boundary platens_of(const SmallRun& run) {
    LoadingRequest request;
    request.platen_friction = 5 * test::degree;
    return test::boundary_of_test(run.assemblage, run.specimen, request, augig_contact());
}

/// A run with mass scaling, by default of the factor that suffices.
SmallRun scaled_run(const Specimen& specimen, const ContactLaw& law, bool platens, double fraction, double factor = 0) {
    SmallRun run(specimen, law);
    const Boundary boundary = platens ? platens_of(run) : run.boundary;
    run.parameters.mass_scaling = make_mass_scaling(
        run.assemblage, factor > 0 ? factor : sufficient_mass_scaling(run.assemblage, boundary, run.parameters.laws));
    run.set_boundary(boundary, fraction);
    return run;
}

// --- the stable step -------------------------------------------------------------------------------------------------------

/// The lowest of the nodes that contacts link with each node.
std::vector<std::int32_t> lowest_linked(const Assemblage& a) {
    std::vector<std::int32_t> lowest(a.position.size());
    std::iota(lowest.begin(), lowest.end(), 0);
    for (bool changes = true; changes;) {
        changes = false;
        for (const ContactGeometry& contact : a.contacts) {
            for (std::size_t p = 0; p < 2; ++p) {
                std::int32_t& i = lowest[static_cast<std::size_t>(contact.nodes[p])];
                std::int32_t& j = lowest[static_cast<std::size_t>(contact.nodes[2 + p])];
                changes = changes || i != j;
                i = j = std::min(i, j);
            }
        }
    }
    return lowest;
}

/// M' of a specimen whose clusters are those its contacts make, the supported ones constrained by a platen.
Eigen::MatrixXd scaled_mass(const Assemblage& a, const Boundary& boundary, double beta) {
    const auto n = static_cast<Eigen::Index>(a.position.size());
    std::vector<bool> on_platen(a.position.size(), false);
    for (const PlatenPoint& point : boundary.platen_points) on_platen[static_cast<std::size_t>(point.node)] = point.on_boundary;
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    std::map<std::int32_t, std::vector<Eigen::Index>> clusters;
    const std::vector<std::int32_t> lowest = lowest_linked(a);
    for (Eigen::Index i = 0; i < n; ++i) clusters[lowest[static_cast<std::size_t>(i)]].push_back(i);
    for (const auto& [first, nodes] : clusters) {
        double total = 0;
        bool supported = false;
        for (const Eigen::Index node : nodes) {
            total += a.mass[static_cast<std::size_t>(node)];
            supported = supported || on_platen[static_cast<std::size_t>(node)];
        }
        for (const Eigen::Index k : nodes) {
            for (const Eigen::Index l : nodes) {
                const double mk = a.mass[static_cast<std::size_t>(k)];
                const double ml = a.mass[static_cast<std::size_t>(l)];
                const double m = (k == l ? (1 + beta) * mk : 0) - (supported ? 0 : beta * mk * ml / total);
                mass(2 * k, 2 * l) = mass(2 * k + 1, 2 * l + 1) = m;
            }
        }
    }
    return mass;
}

/// The assemblage with every `every`-th contact gone, counted from `first`: clusters fall apart.
Assemblage broken(Assemblage a, std::size_t every, std::size_t first) {
    std::vector<ContactGeometry> left;
    for (std::size_t c = 0; c < a.contacts.size(); ++c) {
        if (c % every != first % every) left.push_back(a.contacts[c]);
    }
    a.contacts = left;
    a.contact_chunks = {{{0, static_cast<std::int32_t>(left.size())}, 0}};
    return a;
}

/// 2/ω of the stiffest mode with M', by a dense eigenvalue solver: of the forces that the solver exerts where platens touch and
/// every `every`-th contact is gone, counted from `first`.
double exact_step(SmallRun run, double beta, std::size_t every, std::size_t first = 0) {
    constexpr double touching = 1e-9;  // m, far short of what moves a contact off its initial stiffness
    constexpr double moved = 1e-14;    // m, small against that
    run.state.loading.platen_displacement = {touching, -touching};
    for (std::size_t c = first % every; c < run.assemblage.contacts.size(); c += every) run.state.contact_pairs.released[c] = 1;
    const Eigen::MatrixXd stiffness = tangent_stiffness(run, moved);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(
        stiffness, scaled_mass(broken(run.assemblage, every, first), run.boundary, beta), Eigen::EigenvaluesOnly);
    return 2 / std::sqrt(modes.eigenvalues().maxCoeff());
}

TEST(MassScaling, StableStepHoldsHoweverManyContactsAreLeft) {
    const Specimen s = test::jittered_grid(5, 6, 0.02, 0.03, 0.25);
    for (const LawVariant variant : {LawVariant::literal, LawVariant::consistent}) {
        const ContactLaw law = augig_law(variant);
        SmallRun run(s, law);
        run.set_boundary(platens_of(run), 1);
        const double enough = sufficient_mass_scaling(run.assemblage, run.boundary, law);
        for (const double beta : {3.0, 30.0, enough, 10 * enough}) {
            const double step = stable_time_step(run.assemblage, run.boundary, law, beta);
            double least =
                exact_step(run, beta, run.assemblage.contacts.size() + 1, run.assemblage.contacts.size());  // none gone
            for (const std::size_t every : {1U, 2U, 3U, 5U, 9U}) {
                for (std::size_t first = 0; first < std::min<std::size_t>(every, 3); ++first) {
                    least = std::min(least, exact_step(run, beta, every, first));
                }
            }
            verify_between("dynamics: stable step with mass scaling over the least of states with contacts gone", step / least,
                           0.8, 1, "dense eigenvalues");
        }
    }
}

TEST(MassScaling, StepGrowsUntilTheGrainsLimitIt) {
    const Specimen s = test::jittered_grid(5, 6, 0.02, 0.03, 0.25);
    const SmallRun run(s, augig_law());
    const Boundary platens = platens_of(run);
    const auto step = [&](double beta) { return stable_time_step(run.assemblage, platens, run.parameters.laws, beta); };
    const double none = step(0);
    // The contacts alone would give √(1 + β); 3.3 at 10 is what the grains leave of it.
    verify_between("dynamics: step with mass scaling over that without, factor 10", step(10) / none, 3, 3.3, "sqrt(1 + factor)");
    const double enough = sufficient_mass_scaling(run.assemblage, platens, run.parameters.laws);
    ContactLaw slack = run.parameters.laws[0];  // free faces are taken as supported in a step without scaling
    slack.kt = slack.stiffest_normal = slack.ks = slack.stiffest_shear = 1;
    const double most = stable_time_step(broken(run.assemblage, 1, 0), run.boundary, slack);
    expect_close(step(enough) / most, 1 / std::sqrt(1.1), 0.005, 1);  // to the residual of the eigenvalues
    EXPECT_GT(step(enough) / none, 5);
    EXPECT_LT(step(100 * enough), most);
    EXPECT_LT(step(100 * enough), 1.06 * step(enough));
}

// --- motion ----------------------------------------------------------------------------------------------------------------

TEST(MassScaling, MomentumAndEnergyWhileItFallsApart) {
    for (const ContactLaw& law : test::all_laws(augig_contact())) {
        SCOPED_TRACE(name_of(law.variant));
        SmallRun run = scaled_run(test::jittered_grid(4, 6, 0.02, 0.03, 0.2), law, false, 0.5);
        // Drift, a little spin, a pull along y and a shear: cracks of both modes.
        run.set_velocity([](const Vector2& p) { return Vector2{3 + 400 * p.y, -1 + 100 * p.x + 1500 * p.y}; });
        run.begin();
        const test::Momenta before = test::momenta_of(run);
        const Energies start = run.measured().energies;
        double drift = 0;
        for (int i = 0; i < 100; ++i) {
            run.steps(50);
            const Energies e = run.measured().energies;
            const test::Momenta now = test::momenta_of(run);
            verify("dynamics: momentum with mass scaling while it falls apart, drift over sum |p|",
                   length(now.linear - before.linear), 0, 1e-12, "conserved", before.linear_scale);
            drift = std::max(drift, std::abs(now.angular - before.angular) / before.angular_scale);
            EXPECT_EQ(e.damping + e.numerical, 0);  // no damping and no platens here
            // Undamped, laws lose up to 1.6 % of it to the step where they jump at zero opening; `consistent`, which has no
            // jump of stiffness, 0.11 % until grains knock together at 20 m/s.
            const double tolerance = law.variant == LawVariant::consistent ? 1e-2 : 0.05;
            expect_close(e.balance_error(), start.balance_error(), tolerance, start.kinetic);
        }
        EXPECT_GT(run.failed_points(), 10U);
        // Not conserved: the test reports it and sees that it is no more than the relative motion carries.
        verify_between("dynamics: angular momentum with mass scaling, drift over sum |x||p|", drift, 0, 0.2, "reported");
    }
}

/// Two grains on one contact, the upper one flying off.
SmallRun two_scaled_grains(double factor) {
    const Specimen s =
        test::specimen_of_grains({{-0.01, -0.01}, {0.01, -0.01}, {0.01, 0}, {-0.01, 0}, {0.01, 0.01}, {-0.01, 0.01}},
                                 {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}}, {0, 0, 1, 1});
    return scaled_run(s, augig_law(), false, 0.5, factor);
}
// A free grain falls back onto another: no energy is created.
TEST(MassScaling, ReturningGrainsMakeNoEnergy) {
    struct Fall {
        double gap, speed;
    };
    for (const Fall& fall : {Fall{2e-4, 0.1}, Fall{2e-4, 10}, Fall{1e-6, 1}}) {
        SmallRun run = two_scaled_grains(100);
        run.parameters.time_step *= 0.2;  // a contact that closes within a step makes or takes energy, in proportion to the step
        run.begin();
        for (const std::size_t point : {0, 1}) store_point(broken_contact(), false, point, run.state);
        for (std::int32_t i = 4; i < 8; ++i) {
            run.state.displacement[static_cast<std::size_t>(i)] = {0, fall.gap};
            run.state.velocity[static_cast<std::size_t>(i)] = {0, -fall.speed};
        }
        run.begin();
        const double kinetic = run.measured().energies.kinetic;
        double closest = 1;
        const auto steps = static_cast<int>(2 * fall.gap / fall.speed / run.parameters.time_step) + 400;
        for (int i = 0; i < steps; ++i) {
            run.steps(1);
            const Energies e = run.measured().energies;
            closest = std::min({closest, run.state.opening[0], run.state.opening[1]});
            EXPECT_LT(e.kinetic + e.stored(), 1.01 * kinetic) << fall.speed;
            expect_close(e.balance_error(), -kinetic, 0.02, kinetic);  // what it began with is nobody's work
        }
        EXPECT_LT(closest, 0);
    }
}

// --- a test ----------------------------------------------------------------------------------------------------------------

/// A specimen between platens whose speed grows from interval to interval, up to 0.1 m/s.
struct Compression {
    SmallRun run;
    Boundary boundary;
    IntervalLoading loading;
    Measurement now;
    Compression(const ContactLaw& law, double factor) : run(test::jittered_grid(6, 8, 0.02, 0.03, 0.25), law) {
        boundary = platens_of(run);
        run.parameters.damping = 0.8;
        scale_masses(factor);
        run.set_boundary(boundary, 0.5);
        run.begin();
    }
    void scale_masses(double factor) { run.parameters.mass_scaling = make_mass_scaling(run.assemblage, factor); }
    [[nodiscard]] double strain() const { return 2 * run.state.loading.platen_displacement[bottom_platen] / run.specimen.height; }
    /// A microsecond to a platen speed, with a start that takes 50 of them.
    void advance_to(double speed) {
        loading.velocity_begin = loading.velocity_end;
        const double next = std::min(speed, loading.velocity_end[bottom_platen] + 2e-3);
        loading.velocity_end = {next, -next};
        run.steps(std::max<std::int64_t>(1, static_cast<std::int64_t>(1e-6 / run.parameters.time_step)), loading);
        now = run.measured();
    }
};

// Platens that speed up carry a specimen along: they push its mass as it is, not what they hold of the added one.
TEST(MassScaling, PlatensThatSpeedUpCarryTheMassAsItIs) {
    const Specimen specimen = test::jittered_grid(6, 8, 0.02, 0.03, 0.25);
    SmallRun run(specimen, augig_law());
    LoadingRequest request;
    request.test = TestKind::tension;  // bonded platens
    run.parameters.mass_scaling = make_mass_scaling(run.assemblage, 100);
    run.set_boundary(test::boundary_of_test(run.assemblage, run.specimen, request, augig_contact()), 0.5);
    run.begin();
    const double mass = std::accumulate(run.assemblage.mass.begin(), run.assemblage.mass.end(), 0.0);
    const double acceleration = 1e4;  // m/s²; a stress of ½ ρ a h = 0.4 MPa
    const double sample = 20 * run.parameters.time_step;
    const int samples = 1000;
    double impulse = 0;
    double worst = 0;
    IntervalLoading loading;
    for (int i = 0; i < samples; ++i) {
        loading.velocity_begin = loading.velocity_end;
        loading.velocity_end[bottom_platen] = loading.velocity_end[top_platen] = (i + 1) * sample * acceleration;
        run.steps(20, loading);
        const Measurement now = run.measured();
        impulse += sample * (now.force_top + now.force_bottom);
        worst = std::max(worst, std::abs(now.energies.balance_error()) / now.energies.external);
    }
    EXPECT_EQ(run.failed_points(), 0U);
    // It rings undamped, some 40 periods of it: their share of the mean is a few thousandths.
    verify("dynamics: impulse of platens that speed up, with mass scaling, over that of the mass as it is",
           impulse / (mass * samples * sample * acceleration), 1, 0.01, "Newton", 1);
    verify("dynamics: residual of the energy balance of platens that speed up, with mass scaling", worst, 0, 1e-4,
           "each term by itself", 1);
}

// A state at rest without mass scaling is at rest with it.
TEST(MassScaling, BalanceAtRestIsTheSame) {
    Compression test(augig_law(), 0);
    SmallRun& run = test.run;
    while (test.strain() < 5e-4) test.advance_to(0.1);
    for (int i = 0; i < 3000; ++i) test.advance_to(0);
    EXPECT_EQ(run.failed_points(), 0U);
    const Measurement rest = test.now;
    EXPECT_LT(rest.unbalanced_ratio, 1e-9);
    const std::vector<Vector2> displacement = run.state.displacement;
    test.scale_masses(100);
    run.parameters.time_step =
        0.5 * stable_time_step(run.assemblage, run.boundary, run.parameters.laws, run.parameters.mass_scaling.factor);
    run.begin();
    run.steps(5000);
    EXPECT_LT(run.measured().unbalanced_ratio, 1e-9);
    expect_close(run.measured().force_top, rest.force_top, 1e-9, rest.force_top);
    for (std::size_t i = 0; i < displacement.size(); ++i) {
        expect_close(length(run.state.displacement[i] - displacement[i]), 0, 1e-9, 0.03 * 5e-4);
    }
}

TEST(MassScaling, EnergyBalanceClosesThroughFailure) {
    for (const ContactLaw& law : test::all_laws(augig_contact())) {
        SCOPED_TRACE(name_of(law.variant));
        Compression test(law, 100);
        double peak = 0;
        double scale = 0;
        double worst = 0;
        while (test.strain() < 0.012 && (test.run.failed_points() == 0 || -test.now.force_top > 0.6 * peak)) {
            test.advance_to(0.1);
            scale = std::max(scale, test.now.energies.stored());
            worst = std::max(worst, std::abs(test.now.energies.balance_error()));
            peak = std::max(peak, -test.now.force_top);
        }
        EXPECT_GT(test.run.failed_points(), 20U);
        EXPECT_GT(peak, 1e6);
        verify("specimens: residual of the energy balance through failure with mass scaling", worst / scale, 0, 5e-3,
               "each term by itself", 1);
    }
}

}  // namespace
}  // namespace graincrack
