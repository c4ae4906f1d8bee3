// Patch test with interfaces: under uniform traction on the boundary a point-symmetric mesh of triangular grains carries a
// uniform stress, however stiff its contacts are.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/linear_statics.hpp"
#include "tests/support/verify.hpp"

namespace graincrack {
namespace {

using test::augig_law;
using test::SmallRun;
using test::Tensor;
using test::verify;

/// Largest difference of an element's stress from `stress`, over its magnitude.
double worst_error(const SmallRun& run, const Eigen::VectorXd& u, const Tensor& stress) {
    double worst = 0;
    for (const Tensor& s : element_stresses(run, u)) {
        worst = std::max({worst, std::abs(s.xx - stress.xx), std::abs(s.yy - stress.yy), std::abs(s.xy - stress.xy)});
    }
    return worst / std::hypot(stress.xx, stress.yy, stress.xy);
}

/// Mean elongation along y over that of the grains alone: above 1 by what the contacts give way.
double compliance(const SmallRun& run, const Eigen::VectorXd& u, const Tensor& stress) {
    const PlaneElasticity c = run.assemblage.elasticity[0];
    return mean_strain(run, u).yy * (c.c11 * c.c11 - c.c12 * c.c12) / (c.c11 * stress.yy - c.c12 * stress.xx);
}

ContactLaw stiffened(double normal, double shear) {
    ContactLaw law = augig_law();
    law.stiffest_normal = law.kt *= normal;
    law.ks *= shear;
    law.stiffest_shear = law.ks;
    return law;
}

constexpr Tensor pulls[] = {{0, 1e6, 0}, {1e6, 0, 0}, {0, 0, 1e6}, {-3e6, 1e6, 2e6}};
// as published; soft; shear stiffer than normal; stiff
constexpr double stiffnesses[][2] = {{1, 1}, {0.01, 0.01}, {0.1, 30}, {10, 1}};

// The condition number times round-off, refined: 4e-11; 1e-10 is the promise.
TEST(Patch, UniformOnPointSymmetricMeshes) {
    const std::pair<const char*, Specimen> meshes[] = {{"union jack", test::union_jack_grid(4, 4, 0.02, 0.024)},
                                                       {"one diagonal", test::one_diagonal_grid(3, 4, 0.015, 0.024)},
                                                       {"equilateral lattice", test::equilateral_lattice(4, 4, 0.005)}};
    for (const auto& [name, specimen] : meshes) {
        for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
            for (const auto& [normal, shear] : stiffnesses) {
                const SmallRun run(specimen, stiffened(normal, shear), plane);
                const Eigen::SparseMatrix<double> stiffness = tangent_stiffness(run);
                for (const Tensor& stress : pulls) {
                    const Eigen::VectorXd u = equilibrium(run, stiffness, boundary_load(run, stress));
                    verify(std::string("elements: patch with interfaces, worst stress over traction, ") + name,
                           worst_error(run, u, stress), 0, 1e-10, "uniform whatever the stiffness", 1);
                }
                // The contacts really gave way, and the more the softer they are.
                const Eigen::VectorXd u = equilibrium(run, stiffness, boundary_load(run, pulls[0]));
                EXPECT_GT(compliance(run, u, pulls[0]), normal < 0.05 ? 1.3 : 1.0001) << name;
            }
        }
    }
}

// On a mesh without that symmetry the stress is genuinely not uniform: the test above sees it.
TEST(Patch, NotUniformOnAnIrregularMesh) {
    const SmallRun run(test::jittered_grid(4, 4, 0.02, 0.024, 0.25), augig_law());
    const Eigen::VectorXd u = equilibrium(run, tangent_stiffness(run), boundary_load(run, pulls[0]));
    EXPECT_GT(worst_error(run, u, pulls[0]), 1e-3);
}

}  // namespace
}  // namespace graincrack
