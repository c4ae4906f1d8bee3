// Mass for the stiffest elements: as much as was asked for, where it is needed, and a longer step for it.
#include "solver/setup/element_mass.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "mesher/mesh.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/setup/stable_time_step.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack {
namespace {

const Rock& rock_of_cases() {
    static const Rock granite = test::augig_granite().rock;
    return granite;
}

struct AddedMassCase {
    Assemblage assemblage;
    Boundary boundary;
    double added = 0;
};
AddedMassCase make_case(const Specimen& specimen, double share) {
    AddedMassCase c{make_assemblage(specimen, rock_of_cases(), PlaneCondition::strain), {}};
    LoadingRequest loading;
    c.boundary = test::boundary_of_test(c.assemblage, specimen, loading, test::augig_contact());
    c.added = scale_mass_of_stiffest_elements(c.assemblage, share);
    return c;
}
Specimen rectangle(int elements_per_edge = 1) {
    mesher::Request request;
    request.region = mesher::rectangle(0.02, 0.04);
    request.fabric.edge = 0.004;
    request.fabric.elements_per_edge = elements_per_edge;
    return mesher::mesh(request);
}
double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(AddedMass, IsWhatWasAskedForAndNoMore) {
    const Specimen specimen = rectangle();
    for (const double share : {0.005, 0.02, 0.1}) {
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

TEST(AddedMass, NoneChangesNothing) {
    const AddedMassCase c = make_case(rectangle(), 0);
    EXPECT_EQ(c.added, 0);
    EXPECT_EQ(c.assemblage.mass, c.assemblage.rock_mass);
}

TEST(AddedMass, GoesToFew) {
    const AddedMassCase c = make_case(rectangle(), max_added_mass);
    std::size_t heavier = 0;
    for (std::size_t i = 0; i < c.assemblage.mass.size(); ++i) {
        heavier += c.assemblage.mass[i] > c.assemblage.rock_mass[i] ? 1U : 0U;
    }
    EXPECT_GT(heavier, 0U);
    EXPECT_LT(heavier, c.assemblage.mass.size() / 2);
}

// Grains of one triangle have three nodes of one mass each, before and after: so their centres of mass stay.
TEST(AddedMass, KeepsCentresOfMass) {
    const AddedMassCase c = make_case(rectangle(), max_added_mass);
    for (const auto& nodes : c.assemblage.element_nodes) {
        EXPECT_DOUBLE_EQ(c.assemblage.mass[nodes[0]], c.assemblage.mass[nodes[1]]);
        EXPECT_DOUBLE_EQ(c.assemblage.mass[nodes[0]], c.assemblage.mass[nodes[2]]);
    }
}

TEST(AddedMass, MakesTheStepWithMassScalingLonger) {
    for (const int elements_per_edge : {1, 2}) {
        const Specimen specimen = rectangle(elements_per_edge);
        const AddedMassCase before = make_case(specimen, 0);
        const AddedMassCase after = make_case(specimen, max_added_mass);
        const double gain = stable_time_step(after.assemblage, after.boundary, test::augig_law(), 100) /
                            stable_time_step(before.assemblage, before.boundary, test::augig_law(), 100);
        EXPECT_GT(gain, 1.05) << elements_per_edge << " elements an edge";
    }
}

// Equal grains would all have to be heavier: the mass is spread, and the step grows as its root.
TEST(AddedMass, OfEqualGrainsIsSpread) {
    Assemblage a = make_assemblage(test::union_jack_grid(4, 4, 0.02, 0.02), rock_of_cases(), PlaneCondition::strain);
    const std::vector<double> before = a.mass;
    const double added = scale_mass_of_stiffest_elements(a, 0.1);
    EXPECT_NEAR(added, 0.1, 1e-6);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(a.mass[i], 1.1 * before[i], 1e-6 * before[i]);
}

}  // namespace
}  // namespace graincrack
