// Selective mass scaling: a longer step that stays stable while contacts fail, the same balance at rest, momentum to
// round-off, a closed energy balance; node–edge contacts that are no stiffer than the long step allows.
#include "solver/model/vertex_clusters.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "mesher/mesh.hpp"
#include "solver/detection/pair_geometry.hpp"
#include "solver/detection/pair_list.hpp"
#include "solver/detection/stable_area.hpp"
#include "solver/setup/element_mass.hpp"
#include "tests/support/check.hpp"
#include "tests/support/contact_walk.hpp"
#include "tests/support/linear_statics.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

Boundary platens_of(const SmallRun& run) {
    return boundary_of_test(run.assemblage, run.specimen, {.platen_friction = 5 * degree}, augig_contact());
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
                std::int32_t& i = lowest[contact.nodes[p]];
                std::int32_t& j = lowest[contact.nodes[2 + p]];
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
    for (const PlatenPoint& point : boundary.platen_points) on_platen[point.node] = point.on_boundary;
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    std::map<std::int32_t, std::vector<Eigen::Index>> clusters;
    const std::vector<std::int32_t> lowest = lowest_linked(a);
    for (Eigen::Index i = 0; i < n; ++i) clusters[lowest[i]].push_back(i);
    for (const auto& [first, nodes] : clusters) {
        double total = 0;
        bool supported = false;
        for (const Eigen::Index node : nodes) {
            total += a.mass[node];
            supported = supported || on_platen[node];
        }
        for (const Eigen::Index k : nodes) {
            for (const Eigen::Index l : nodes) {
                const double mk = a.mass[k];
                const double ml = a.mass[l];
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

// The step against 2/ω of M' by dense eigenvalues, the least of states with contacts gone: not above it, and within a fifth.
TEST(MassScaling, HasAStableStepHoweverManyContactsAreLeft) {
    const Specimen s = jittered_grid(5, 6, 0.02, 0.03, 0.25);
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

// The contacts alone would give √(1 + β), of which the grains leave 3.3 at 10; the sufficient factor is within √1.1 of that of
// grains without contacts, to the residual of the eigenvalues.
TEST(MassScaling, LengthensTheStepUntilTheGrainsLimitIt) {
    const Specimen s = jittered_grid(5, 6, 0.02, 0.03, 0.25);
    const SmallRun run(s, augig_law());
    const Boundary platens = platens_of(run);
    const auto step = [&](double beta) { return stable_time_step(run.assemblage, platens, run.parameters.laws, beta); };
    const double none = step(0);
    verify_between("dynamics: step with mass scaling over that without, factor 10", step(10) / none, 3, 3.3, "sqrt(1 + factor)");
    const double enough = sufficient_mass_scaling(run.assemblage, platens, run.parameters.laws);
    // Free faces are taken as supported in a step without scaling.
    const double most = stable_time_step(broken(run.assemblage, 1, 0), run.boundary, with_stiffnesses(augig_law(), 1, 1));
    expect_close(step(enough) / most, 1 / std::sqrt(1.1), 0.005, 1);
    EXPECT_GT(step(enough) / none, 5);
    EXPECT_LT(step(100 * enough), most);
    EXPECT_LT(step(100 * enough), 1.06 * step(enough));
}

// --- motion ----------------------------------------------------------------------------------------------------------------

// Linear momentum to round-off; the energy, undamped, to what laws lose to the step where they jump at zero opening, up to 1.6 %,
// and `consistent` 0.11 % until grains knock together at 20 m/s. Angular momentum is not conserved, and reported.
TEST(MassScaling, KeepsMomentumAndEnergyWhileASpecimenFallsApart) {
    for (const ContactLaw& law : all_laws(augig_contact())) {
        SCOPED_TRACE(name_of(law.variant));
        SmallRun run(jittered_grid(4, 6, 0.02, 0.03, 0.2), law);
        run.scale_masses(run.boundary, 0.5);
        // Drift, a little spin, a pull along y and a shear: cracks of both modes.
        run.set_velocity([](const Vector2& p) { return Vector2{3 + 400 * p.y, -1 + 100 * p.x + 1500 * p.y}; });
        run.begin();
        const Momenta before = momenta_of(run);
        const Energies start = run.measured().energies;
        double drift = 0;
        for (int i = 0; i < 100; ++i) {
            run.steps(50);
            const Energies e = run.measured().energies;
            const Momenta now = momenta_of(run);
            verify("dynamics: momentum with mass scaling while it falls apart, drift over sum |p|",
                   length(now.linear - before.linear), 0, 1e-12, "conserved", before.linear_scale);
            drift = std::max(drift, std::abs(now.angular - before.angular) / before.angular_scale);
            EXPECT_EQ(e.damping + e.numerical, 0);  // no damping and no platens here
            const double tolerance = law.variant == LawVariant::consistent ? 1e-2 : 0.05;
            expect_close(e.balance_error(), start.balance_error(), tolerance, start.kinetic);
        }
        EXPECT_GT(run.failed_points(), 10U);
        verify_between("dynamics: angular momentum with mass scaling, drift over sum |x||p|", drift, 0, 0.2, "reported");
    }
}

// A free grain falls back onto another: no energy is created beyond 1 %, as a contact that closes within a step makes or takes
// some in proportion to it.
TEST(MassScaling, MakesNoEnergyOfGrainsThatReturn) {
    for (const auto& [gap, speed] : {std::pair(2e-4, 0.1), std::pair(2e-4, 10.0), std::pair(1e-6, 1.0)}) {
        SmallRun run(one_diagonal_column(2, 0.02, 0.02), augig_law());
        run.scale_masses(run.boundary, 0.5, 100);
        run.parameters.time_step *= 0.2;
        run.begin();
        for (const std::size_t point : {0, 1}) store_point(broken_contact(), false, point, run.state);
        for (std::int32_t i = 4; i < 8; ++i) {
            run.state.displacement[i] = {0, gap};
            run.state.velocity[i] = {0, -speed};
        }
        run.begin();
        const double kinetic = run.measured().energies.kinetic;
        double closest = 1;
        const auto steps = static_cast<int>(2 * gap / speed / run.parameters.time_step) + 400;
        for (int i = 0; i < steps; ++i) {
            run.steps(1);
            const Energies e = run.measured().energies;
            closest = std::min({closest, run.state.opening[0], run.state.opening[1]});
            EXPECT_LT(e.kinetic + e.stored(), 1.01 * kinetic) << speed;
            expect_close(e.balance_error(), -kinetic, 0.02, kinetic);  // what it began with is nobody's work
        }
        EXPECT_LT(closest, 0);
    }
}

// --- a test ----------------------------------------------------------------------------------------------------------------

// Platens that speed up carry a specimen along: they push its mass as it is, not what they hold of the added one.
TEST(MassScaling, LetsPlatensCarryTheMassAsItIs) {
    SmallRun run(jittered_grid(6, 8, 0.02, 0.03, 0.25), augig_law());
    run.parameters.mass_scaling = make_mass_scaling(run.assemblage, 100);
    run.load_by({.test = TestKind::tension}, 0.5);  // bonded platens
    run.begin();
    const double acceleration = 1e4;  // m/s²; a stress of ½ ρ a h = 0.4 MPa
    const double sample = 20 * run.parameters.time_step;
    const int samples = 1000;
    double impulse = 0, worst = 0;
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
           impulse / (run.mass() * samples * sample * acceleration), 1, 0.01, "Newton", 1);
    verify("dynamics: residual of the energy balance of platens that speed up, with mass scaling", worst, 0, 1e-4,
           "each term by itself", 1);
}

// A state at rest without mass scaling, after a strain of 5e-4, is at rest with it: forces and displacements to 1e-9.
TEST(MassScaling, KeepsTheBalanceAtRest) {
    SmallRun run(jittered_grid(6, 8, 0.02, 0.03, 0.25), augig_law());
    run.set_boundary(platens_of(run), 0.5);
    run.parameters.damping = 0.8;
    run.begin();
    const auto microsecond = static_cast<std::int64_t>(1e-6 / run.parameters.time_step);
    double speed = 0;
    for (int i = 0; i < 3100; ++i) {
        const bool presses = 2 * run.state.loading.platen_displacement[bottom_platen] < 5e-4 * run.specimen.height;
        const double before = speed;
        speed = presses ? std::min(0.1, before + 2e-3) : 0;
        run.steps(microsecond, {{before, -before}, {speed, -speed}, nullptr});
    }
    EXPECT_EQ(run.failed_points(), 0U);
    const Measurement rest = run.measured();
    EXPECT_LT(rest.unbalanced_ratio, 1e-9);
    const std::vector<Vector2> displacement = run.state.displacement;
    run.parameters.mass_scaling = make_mass_scaling(run.assemblage, 100);
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

// --- areas of node–edge contacts ------------------------------------------------------------------------------------------

/// A specimen crushed with mass scaling until grains have slid past each other.
SmallRun crushed_disc() {
    SmallRun run(jittered_grid(4, 6, 0.02, 0.03, 0.25), augig_law(LawVariant::consistent));
    const LoadingRequest request{.platen_friction = 5 * degree, .max_strain = 0.1};
    run.scale_masses(boundary_of_test(run.assemblage, run.specimen, request, augig_contact()), 0.7);
    run.parameters.damping = 0.8;
    run.begin();
    constexpr double speed = 0.4;  // m/s
    const double duration = 0.5 * 0.2 * 0.03 / speed;
    run.steps(static_cast<std::int64_t>(duration / run.parameters.time_step), {{speed, -speed}, {speed, -speed}, nullptr});
    return run;
}

/// Largest ω² Δt² of the node–edge contacts alone, moved by the mean motions of vertex clusters with their masses.
double stiffness_of_contacts(const SmallRun& run) {
    const MassScaling& scaling = run.parameters.mass_scaling;
    const ContactPairList& list = run.state.contact_pairs;
    const auto n = static_cast<Eigen::Index>(scaling.cluster_mass.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n);  // over √(M M)
    for (std::size_t i = 0; i < list.pairs.size(); ++i) {
        if (!list.contacts[i].active) continue;
        const double s = pair_geometry(run.assemblage, run.state, list.pairs[i]).place;
        const auto [first, second] = run.assemblage.surface.edges[list.pairs[i].edge].nodes;
        Eigen::VectorXd motion = Eigen::VectorXd::Zero(n);
        const auto add = [&](std::int32_t node, double share) { motion(run.assemblage.cluster_of_node[node]) += share; };
        add(list.pairs[i].node, 1);
        add(first, -(1 - s));
        add(second, -s);
        for (Eigen::Index k = 0; k < n; ++k) motion(k) /= std::sqrt(scaling.cluster_mass[k]);
        stiffness += run.parameters.laws[0].kt * list.contacts[i].area * motion * motion.transpose();
    }
    const double largest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness, Eigen::EigenvaluesOnly).eigenvalues()(n - 1);
    return largest * run.parameters.time_step * run.parameters.time_step;
}

double energy_of(const SmallRun& run) {
    double energy = 0;
    for (const NodeEdgeContact& contact : run.state.contact_pairs.contacts) {
        energy += contact.active ? node_edge_energy(friction_law(run.parameters.laws[0]), contact) : 0;
    }
    return energy;
}

// ω² Δt² of the contacts alone, on the masses of vertex clusters, by dense eigenvalues: at most 0.5 by the Cauchy–Schwarz
// inequality.
TEST(StableArea, LeavesContactsNoStifferThanTheLongStepAllows) {
    SmallRun run = crushed_disc();
    limit_contact_areas(run.assemblage, run.parameters, run.state);
    EXPECT_LE(stiffness_of_contacts(run), 0.5);
    EXPECT_GT(stiffness_of_contacts(run), 0.02);  // and not needlessly soft
}

// Overlap grows by 1/√c where the area falls to c A: the energy and the depth of the node stay, to round-off.
TEST(StableArea, KeepsTheEnergyOfReducedContacts) {
    SmallRun run = crushed_disc();
    ContactPairList& list = run.state.contact_pairs;
    const double before = energy_of(run);
    EXPECT_GT(before, 0);
    const std::vector<NodeEdgeContact> contacts = list.contacts;
    run.parameters.time_step *= 2;  // a longer step allows less
    limit_contact_areas(run.assemblage, run.parameters, run.state);
    EXPECT_LE(stiffness_of_contacts(run), 0.5);
    expect_close(energy_of(run), before, 1e-12, before);
    int reduced = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const double share = list.contacts[i].area / contacts[i].area;
        reduced += contacts[i].active && contacts[i].overlap > 0 && share < 1 ? 1 : 0;
        if (contacts[i].active) {
            EXPECT_LE(share, 1);
            // The depth of the node is that of before.
            expect_close(list.contacts[i].overlap + list.contacts[i].initial_overlap,
                         contacts[i].overlap + contacts[i].initial_overlap, 1e-12, 1e-4);
        }
    }
    EXPECT_GT(reduced, 3);
}

// However long the step.
TEST(StableArea, IsTheWholeAreaWithoutMassScaling) {
    SmallRun run = crushed_disc();
    run.parameters.mass_scaling = {};
    const std::vector<NodeEdgeContact> contacts = run.state.contact_pairs.contacts;
    run.parameters.time_step *= 100;
    limit_contact_areas(run.assemblage, run.parameters, run.state);
    for (std::size_t i = 0; i < contacts.size(); ++i) EXPECT_EQ(run.state.contact_pairs.contacts[i].area, contacts[i].area);
}

// --- mass for the stiffest elements: as much as was asked for, where it is needed, and a longer step for it ---------------

struct AddedMassCase {
    Assemblage assemblage;
    Boundary boundary;
    double added = 0;
};
AddedMassCase make_case(const Specimen& specimen, double share) {
    AddedMassCase c{make_assemblage(specimen, augig_granite().rock, PlaneCondition::strain), {}};
    c.boundary = boundary_of_test(c.assemblage, specimen, {}, augig_contact());
    c.added = scale_mass_of_stiffest_elements(c.assemblage, share);
    return c;
}
Specimen rectangle(int elements_per_edge = 1) {
    const mesher::Fabric fabric{.edge = 0.004, .elements_per_edge = elements_per_edge};
    return mesher::mesh({.region = mesher::rectangle(0.02, 0.04), .fabric = fabric});
}
double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// The mass over that of the rock is what was asked for, never more and at least 0.999 of it; no node becomes lighter.
TEST(AddedMass, IsWhatWasAskedForAndNoMore) {
    const Specimen specimen = rectangle();
    for (const double share : {0.0, 0.005, 0.02, 0.1}) {
        const AddedMassCase c = make_case(specimen, share);
        EXPECT_LE(c.added, share * (1 + 1e-6));
        EXPECT_GE(c.added, 0.999 * share);
        EXPECT_NEAR(sum(c.assemblage.mass) / sum(c.assemblage.rock_mass) - 1, c.added, 1e-12);
        for (std::size_t i = 0; i < c.assemblage.mass.size(); ++i) {
            EXPECT_GE(c.assemblage.mass[i], c.assemblage.rock_mass[i]);
            EXPECT_DOUBLE_EQ(c.assemblage.inverse_mass[i] * c.assemblage.mass[i], 1);
        }
    }
}

// Less than half of the nodes are heavier. Grains of one triangle have three nodes of one mass each, before and after: their
// centres of mass stay, to round-off.
TEST(AddedMass, GoesToFewNodesAndKeepsCentresOfMass) {
    const AddedMassCase c = make_case(rectangle(), max_added_mass);
    std::size_t heavier = 0;
    for (std::size_t i = 0; i < c.assemblage.mass.size(); ++i) {
        heavier += c.assemblage.mass[i] > c.assemblage.rock_mass[i] ? 1U : 0U;
    }
    EXPECT_GT(heavier, 0U);
    EXPECT_LT(heavier, c.assemblage.mass.size() / 2);
    for (const auto& [i, j, k] : c.assemblage.element_nodes) {
        EXPECT_DOUBLE_EQ(c.assemblage.mass[i], c.assemblage.mass[j]);
        EXPECT_DOUBLE_EQ(c.assemblage.mass[i], c.assemblage.mass[k]);
    }
}

// By 5 % at least, with one or two elements along an edge.
TEST(AddedMass, MakesTheStepWithMassScalingLonger) {
    for (const int elements_per_edge : {1, 2}) {
        const Specimen specimen = rectangle(elements_per_edge);
        const AddedMassCase before = make_case(specimen, 0);
        const AddedMassCase after = make_case(specimen, max_added_mass);
        const double gain = stable_time_step(after.assemblage, after.boundary, augig_law(), 100) /
                            stable_time_step(before.assemblage, before.boundary, augig_law(), 100);
        EXPECT_GT(gain, 1.05) << elements_per_edge << " elements an edge";
    }
}

// Equal grains would all have to be heavier: the mass is spread, and the step grows as its root.
TEST(AddedMass, IsSpreadOverEqualGrains) {
    Assemblage a = make_assemblage(union_jack_grid(4, 4, 0.02, 0.02), augig_granite().rock, PlaneCondition::strain);
    const std::vector<double> before = a.mass;
    const double added = scale_mass_of_stiffest_elements(a, 0.1);
    EXPECT_NEAR(added, 0.1, 1e-6);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(a.mass[i], 1.1 * before[i], 1e-6 * before[i]);
}

}  // namespace
}  // namespace graincrack::test
