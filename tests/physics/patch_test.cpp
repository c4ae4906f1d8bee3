// Patch test with interfaces: under uniform traction on the boundary a point-symmetric mesh of triangular grains carries a
// uniform stress, however stiff its contacts are. Linear statics with the stiffness the time step is found from.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack {
namespace {

using test::augig_law;
using test::expect_close;
using test::SmallRun;

struct Stress {
    double xx, yy, xy;
};

/// Displacements under the tractions σ·n of a uniform stress, three degrees of freedom held (their reactions are zero).
Eigen::VectorXd solve(const SmallRun& run, const ContactLaw& law, const Stress& stress) {
    const Assemblage& a = run.assemblage;
    const auto n = static_cast<Eigen::Index>(a.position.size());
    Eigen::MatrixXd stiffness(2 * n, 2 * n);
    std::vector<Vector2> x(a.position.size());
    std::vector<Vector2> y(a.position.size());
    for (Eigen::Index j = 0; j < 2 * n; ++j) {
        Vector2& unit = x[static_cast<std::size_t>(j / 2)];
        (j % 2 == 0 ? unit.x : unit.y) = 1;
        apply_stiffness(a, run.boundary, law, x, y);
        unit = {};
        for (Eigen::Index i = 0; i < n; ++i) {
            stiffness(2 * i, j) = y[static_cast<std::size_t>(i)].x;
            stiffness(2 * i + 1, j) = y[static_cast<std::size_t>(i)].y;
        }
    }
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * n);
    for (const auto& edge : run.specimen.boundary_edges) {
        const std::int32_t i = a.node_of_specimen[edge[0]];
        const std::int32_t j = a.node_of_specimen[edge[1]];
        const Vector2 along = a.position[j] - a.position[i];
        const Vector2 normal{along.y, -along.x};  // outward times the length
        const Vector2 half =
            0.5 * Vector2{stress.xx * normal.x + stress.xy * normal.y, stress.xy * normal.x + stress.yy * normal.y};
        for (const std::int32_t node : {i, j}) {
            load(2 * node) += half.x;
            load(2 * node + 1) += half.y;
        }
    }
    // Hold one node and the height of the farthest other one.
    Eigen::Index far = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto dx = [&](Eigen::Index k) { return std::abs(a.position[static_cast<std::size_t>(k)].x - a.position[0].x); };
        far = dx(i) > dx(far) ? i : far;
    }
    for (const Eigen::Index held : {Eigen::Index{0}, Eigen::Index{1}, 2 * far + 1}) {
        stiffness.row(held).setZero();
        stiffness.col(held).setZero();
        stiffness(held, held) = law.kt * 1e-3;
        load(held) = 0;
    }
    const Eigen::LDLT<Eigen::MatrixXd> factors(stiffness);
    Eigen::VectorXd u = factors.solve(load);
    for (int i = 0; i < 3; ++i) {
        u += factors.solve(load - stiffness * u);  // against the condition number, up to 1e8
    }
    return u;
}

/// Largest difference of an element's small-strain stress from `stress`, over its magnitude.
double worst_error(const SmallRun& run, const Eigen::VectorXd& u, const Stress& stress) {
    const PlaneElasticity& c = run.assemblage.elasticity;
    double worst = 0;
    for (std::size_t e = 0; e < run.assemblage.element_nodes.size(); ++e) {
        const auto [n0, n1, n2] = run.assemblage.element_nodes[e];
        const TriangleGeometry& g = run.assemblage.element_geometry[e];
        const auto at = [&u](std::int32_t i) { return Vector2{u(2 * i), u(2 * i + 1)}; };
        const Vector2 d1 = at(n1) - at(n0);
        const Vector2 d2 = at(n2) - at(n0);
        const double exx = d1.x * g.gradient1.x + d2.x * g.gradient2.x;
        const double eyy = d1.y * g.gradient1.y + d2.y * g.gradient2.y;
        const double gamma = d1.x * g.gradient1.y + d2.x * g.gradient2.y + d1.y * g.gradient1.x + d2.y * g.gradient2.x;
        worst = std::max({worst, std::abs(c.c11 * exx + c.c12 * eyy - stress.xx), std::abs(c.c12 * exx + c.c11 * eyy - stress.yy),
                          std::abs(c.mu * gamma - stress.xy)});
    }
    return worst / std::hypot(stress.xx, stress.yy, stress.xy);
}

/// Mean elongation along y over that of the grains alone: above 1 by what the contacts give way.
double compliance(const SmallRun& run, const Eigen::VectorXd& u, const Stress& stress) {
    const PlaneElasticity& c = run.assemblage.elasticity;
    const double eyy = (c.c11 * stress.yy - c.c12 * stress.xx) / (c.c11 * c.c11 - c.c12 * c.c12);
    double top = 0;
    double bottom = 0;
    double n_top = 0;
    double n_bottom = 0;
    for (std::size_t i = 0; i < run.assemblage.position.size(); ++i) {
        const double y = run.assemblage.position[i].y;
        const double uy = u(2 * static_cast<Eigen::Index>(i) + 1);
        if (y > 0.4999 * run.specimen.height) {
            top += uy;
            ++n_top;
        } else if (y < -0.4999 * run.specimen.height) {
            bottom += uy;
            ++n_bottom;
        }
    }
    return (top / n_top - bottom / n_bottom) / (eyy * run.specimen.height);
}

ContactLaw stiffened(double normal, double shear) {
    ContactLaw law = augig_law();
    law.kt *= normal;
    law.ks *= shear;
    law.w = law.ks / law.kt;
    return law;
}

constexpr Stress pulls[] = {{0, 1e6, 0}, {1e6, 0, 0}, {0, 0, 1e6}, {-3e6, 1e6, 2e6}};
// as published; soft; shear stiffer than normal; stiff
constexpr double stiffnesses[][2] = {{1, 1}, {0.01, 0.01}, {0.1, 30}, {10, 1}};

// The condition number times round-off, refined: below 4e-12; 1e-10 is the promise.
TEST(Patch, UniformOnPointSymmetricMeshes) {
    for (const bool union_jack : {false, true}) {
        for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
            const Specimen specimen =
                union_jack ? test::union_jack_grid(4, 4, 0.02, 0.024) : test::one_diagonal_grid(3, 4, 0.015, 0.024);
            const SmallRun run(specimen, augig_law(), plane);
            for (const auto& [normal, shear] : stiffnesses) {
                const ContactLaw law = stiffened(normal, shear);
                for (const Stress& stress : pulls) {
                    const Eigen::VectorXd u = solve(run, law, stress);
                    expect_close(worst_error(run, u, stress), 0, 1e-10, 1,
                                 (union_jack ? "union jack, kn x " : "one diagonal, kn x ") + std::to_string(normal));
                }
                // The contacts really gave way, and the more the softer they are.
                const double give = compliance(run, solve(run, law, pulls[0]), pulls[0]);
                EXPECT_GT(give, normal < 0.05 ? 1.3 : 1.0001);
            }
        }
    }
}

// On a mesh without that symmetry the stress is genuinely not uniform: the test above sees it.
TEST(Patch, NotUniformOnAnIrregularMesh) {
    const SmallRun run(test::jittered_grid(4, 4, 0.02, 0.024, 0.25), augig_law());
    EXPECT_GT(worst_error(run, solve(run, augig_law(), pulls[0]), pulls[0]), 1e-3);
}

}  // namespace
}  // namespace graincrack
