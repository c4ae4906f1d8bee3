// With mass scaling, node–edge contacts are no stiffer than the long step allows, whatever they slide over, and reducing their
// areas changes no energy.
#include "solver/detection/stable_area.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "solver/detection/pair_geometry.hpp"
#include "solver/detection/pair_list.hpp"
#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack {
namespace {

using test::SmallRun;

/// A specimen crushed with mass scaling until grains have slid past each other.
SmallRun crushed_disc() {
    SmallRun run(test::jittered_grid(4, 6, 0.02, 0.03, 0.25), test::augig_law(LawVariant::consistent));
    LoadingRequest request;
    request.platen_friction = 5 * test::degree;
    request.max_strain = 0.1;
    const Boundary boundary = test::boundary_of_test(run.assemblage, run.specimen, request, test::augig_contact());
    run.parameters.mass_scaling =
        make_mass_scaling(run.assemblage, sufficient_mass_scaling(run.assemblage, boundary, run.parameters.laws));
    run.set_boundary(boundary, 0.7);
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
        const auto [first, second] = run.assemblage.surface.edges[static_cast<std::size_t>(list.pairs[i].edge)].nodes;
        Eigen::VectorXd motion = Eigen::VectorXd::Zero(n);
        const auto add = [&](std::int32_t node, double share) {
            motion(run.assemblage.cluster_of_node[static_cast<std::size_t>(node)]) += share;
        };
        add(list.pairs[i].node, 1);
        add(first, -(1 - s));
        add(second, -s);
        for (Eigen::Index k = 0; k < n; ++k) motion(k) /= std::sqrt(scaling.cluster_mass[static_cast<std::size_t>(k)]);
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

TEST(StableArea, ContactsAreNoStifferThanTheLongStepAllows) {
    SmallRun run = crushed_disc();
    limit_contact_areas(run.assemblage, run.parameters, run.state);
    EXPECT_LE(stiffness_of_contacts(run), 0.5);
    EXPECT_GT(stiffness_of_contacts(run), 0.02);  // and not needlessly soft
}

TEST(StableArea, ReducingAreasChangesNoEnergy) {
    SmallRun run = crushed_disc();
    ContactPairList& list = run.state.contact_pairs;
    const double before = energy_of(run);
    EXPECT_GT(before, 0);
    const std::vector<NodeEdgeContact> contacts = list.contacts;
    run.parameters.time_step *= 2;  // a longer step allows less
    limit_contact_areas(run.assemblage, run.parameters, run.state);
    EXPECT_LE(stiffness_of_contacts(run), 0.5);
    test::expect_close(energy_of(run), before, 1e-12, before);
    int reduced = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const double share = list.contacts[i].area / contacts[i].area;
        reduced += contacts[i].active && contacts[i].overlap > 0 && share < 1 ? 1 : 0;
        if (contacts[i].active) {
            EXPECT_LE(share, 1);
            // The depth of the node is that of before.
            test::expect_close(list.contacts[i].overlap + list.contacts[i].initial_overlap,
                               contacts[i].overlap + contacts[i].initial_overlap, 1e-12, 1e-4);
        }
    }
    EXPECT_GT(reduced, 3);
}

TEST(StableArea, NothingIsReducedWithoutMassScaling) {
    SmallRun run = crushed_disc();
    run.parameters.mass_scaling = {};
    const std::vector<NodeEdgeContact> contacts = run.state.contact_pairs.contacts;
    run.parameters.time_step *= 100;
    limit_contact_areas(run.assemblage, run.parameters, run.state);
    for (std::size_t i = 0; i < contacts.size(); ++i) EXPECT_EQ(run.state.contact_pairs.contacts[i].area, contacts[i].area);
}

}  // namespace
}  // namespace graincrack
