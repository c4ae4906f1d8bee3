// Small displacements of a specimen at rest: its stiffness, found from the solver's own nodal forces, and what follows from it
// by linear algebra alone: equilibrium under tractions, mean strains, the stiffest mode.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/step/nodal_forces.hpp"
#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {

/// Components of a plane stress or strain (γ as εxy = γ/2).
struct Tensor {
    double xx = 0, yy = 0, xy = 0;
};

/// The solver's nodal forces at given displacements, with the contact histories of the run's state.
inline std::vector<Vector2> forces_at(const SmallRun& run, State state, const std::vector<Vector2>& displacement) {
    state.displacement = displacement;
    start(run.assemblage, run.parameters, state);
    ThreadTeam alone(1);
    sum_nodal_forces(run.assemblage, run.boundary, state.loading, alone, state);
    return state.force;
}

/// Nodes whose forces depend on the displacement of a node: those of its elements and contacts, itself first.
inline std::vector<std::vector<std::int32_t>> neighbours(const Assemblage& a) {
    std::vector<std::vector<std::int32_t>> result(a.position.size());
    const auto link = [&result](const auto& nodes) {
        for (const std::int32_t i : nodes) {
            auto& list = result[static_cast<std::size_t>(i)];
            for (const std::int32_t j : nodes) {
                if (std::find(list.begin(), list.end(), j) == list.end()) list.push_back(j);
            }
        }
    };
    std::for_each(a.element_nodes.begin(), a.element_nodes.end(), link);
    std::for_each(a.contacts.begin(), a.contacts.end(), [&link](const ContactGeometry& c) { link(c.nodes); });
    return result;
}

/// Groups of nodes that can be displaced in one evaluation: no node has two nodes of a group among its neighbours.
inline std::vector<std::vector<std::int32_t>> independent_groups(const std::vector<std::vector<std::int32_t>>& neighbours) {
    std::vector<std::vector<std::int32_t>> groups;
    std::vector<std::vector<bool>> taken;  // by group: nodes with a neighbour in it
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(neighbours.size()); ++i) {
        const auto& mine = neighbours[static_cast<std::size_t>(i)];
        const auto collides = [&mine](const std::vector<bool>& t) {
            return std::any_of(mine.begin(), mine.end(), [&t](std::int32_t j) { return t[static_cast<std::size_t>(j)]; });
        };
        const auto fit = static_cast<std::size_t>(std::find_if_not(taken.begin(), taken.end(), collides) - taken.begin());
        if (fit == groups.size()) {
            groups.emplace_back();
            taken.emplace_back(neighbours.size(), false);
        }
        groups[fit].push_back(i);
        for (const std::int32_t j : mine) taken[fit][static_cast<std::size_t>(j)] = true;
    }
    return groups;
}

/// K = −∂F/∂u about the run's present state, by central differences of the solver's own forces.
/// \param step of the displacements, m. In the reference state there is no cancellation, and the step is chosen very small, since
///        contacts soften by step/δct; in other states it must be small against the motions that open contacts or lift nodes off
///        the platens
inline Eigen::SparseMatrix<double> tangent_stiffness(const SmallRun& run, double step = 1e-20) {
    const auto near = neighbours(run.assemblage);
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& group : independent_groups(near)) {
        for (const int axis : {0, 1}) {
            const auto moved = [&](double by) {
                std::vector<Vector2> u = run.state.displacement;
                for (const std::int32_t j : group) u[static_cast<std::size_t>(j)] += axis == 0 ? Vector2{by, 0} : Vector2{0, by};
                return forces_at(run, run.state, u);
            };
            const std::vector<Vector2> after = moved(step);
            const std::vector<Vector2> before = moved(-step);
            for (const std::int32_t j : group) {
                for (const std::int32_t i : near[static_cast<std::size_t>(j)]) {
                    const Vector2 k = (0.5 / step) * (before[static_cast<std::size_t>(i)] - after[static_cast<std::size_t>(i)]);
                    entries.emplace_back(2 * i, 2 * j + axis, k.x);
                    entries.emplace_back(2 * i + 1, 2 * j + axis, k.y);
                }
            }
        }
    }
    const auto n = 2 * static_cast<Eigen::Index>(near.size());
    Eigen::SparseMatrix<double> stiffness(n, n);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    return stiffness;
}

/// 2/ω of the stiffest mode of that stiffness, by a dense eigenvalue solver.
inline double exact_stable_step(const SmallRun& run, double step = 1e-20) {
    Eigen::MatrixXd k = tangent_stiffness(run, step);
    for (Eigen::Index i = 0; i < k.rows(); ++i) {
        for (Eigen::Index j = 0; j < k.cols(); ++j) {
            k(i, j) *= std::sqrt(run.assemblage.inverse_mass[static_cast<std::size_t>(i / 2)] *
                                 run.assemblage.inverse_mass[static_cast<std::size_t>(j / 2)]);
        }
    }
    return 2 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff());
}

/// The same by power iteration, for specimens too large for that: it exceeds the exact value by less than 1e-4 for meshes of this
/// kind.
inline double iterated_stable_step(const SmallRun& run, double step = 1e-20) {
    const Eigen::SparseMatrix<double> k = tangent_stiffness(run, step);
    Eigen::VectorXd root(k.rows());
    for (Eigen::Index i = 0; i < root.size(); ++i) {
        root(i) = std::sqrt(run.assemblage.inverse_mass[static_cast<std::size_t>(i / 2)]);
    }
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(k.rows(), 1, 1000).array().sin();  // has a component in every mode
    double eigenvalue = 0;
    for (int i = 0; i < 3000; ++i) {
        x.normalize();
        const Eigen::VectorXd y = root.cwiseProduct(k * root.cwiseProduct(x));
        eigenvalue = x.dot(y);
        x = y;
    }
    return 2 / std::sqrt(eigenvalue);
}

/// Nodal loads of the tractions σ·n of a uniform stress on the whole boundary, N.
inline Eigen::VectorXd boundary_load(const SmallRun& run, const Tensor& stress) {
    const Assemblage& a = run.assemblage;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(a.position.size()));
    for (const auto& edge : run.specimen.boundary_edges) {
        const std::int32_t i = a.node_of_specimen[static_cast<std::size_t>(edge[0])];
        const std::int32_t j = a.node_of_specimen[static_cast<std::size_t>(edge[1])];
        const Vector2 along = a.position[static_cast<std::size_t>(j)] - a.position[static_cast<std::size_t>(i)];
        const Vector2 normal{along.y, -along.x};  // outward times the length
        for (const std::int32_t node : {i, j}) {
            load(2 * node) += 0.5 * (stress.xx * normal.x + stress.xy * normal.y);
            load(2 * node + 1) += 0.5 * (stress.xy * normal.x + stress.yy * normal.y);
        }
    }
    return load;
}

/// Displacements under loads in balance: one node is held, and the height of the one farthest beside it (reactions are zero).
inline Eigen::VectorXd equilibrium(const SmallRun& run, Eigen::SparseMatrix<double> stiffness, Eigen::VectorXd load) {
    const std::vector<Vector2>& p = run.assemblage.position;
    Eigen::Index far = 0;
    for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(p.size()); ++i) {
        const auto beside = [&p](Eigen::Index k) { return std::abs(p[static_cast<std::size_t>(k)].x - p[0].x); };
        far = beside(i) > beside(far) ? i : far;
    }
    const auto is_held = [far](Eigen::Index k) { return k == 0 || k == 1 || k == 2 * far + 1; };
    stiffness.prune([&is_held](Eigen::Index i, Eigen::Index j, double) { return i == j || (!is_held(i) && !is_held(j)); });
    load(0) = load(1) = load(2 * far + 1) = 0;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(stiffness);
    EXPECT_EQ(factors.info(), Eigen::Success);
    Eigen::VectorXd u = factors.solve(load);
    for (int i = 0; i < 3; ++i) {
        u += factors.solve(load - stiffness * u);  // iterative refinement; the condition number is up to 1e8
    }
    return u;
}

/// Gives a state a temperature, K.
inline void warm(const Assemblage& a, double temperature, State& state) {
    take_temperature(a, state);
    state.loading.temperature = temperature;
}
/// What the elements of an undisplaced specimen push with at a temperature, N.
inline Eigen::VectorXd load_of_temperature(const SmallRun& run, double temperature) {
    State state = run.state;
    warm(run.assemblage, temperature, state);
    const std::vector<Vector2> forces = forces_at(run, state, state.displacement);
    Eigen::VectorXd load(2 * static_cast<Eigen::Index>(forces.size()));
    for (Eigen::Index i = 0; i < load.size(); ++i) {
        load(i) = i % 2 == 0 ? forces[static_cast<std::size_t>(i / 2)].x : forces[static_cast<std::size_t>(i / 2)].y;
    }
    return load;
}

inline Vector2 displacement_of(const Eigen::VectorXd& u, std::int32_t node) { return {u(2 * node), u(2 * node + 1)}; }

/// Small-strain stress of each element, Pa.
inline std::vector<Tensor> element_stresses(const SmallRun& run, const Eigen::VectorXd& u) {
    std::vector<Tensor> stresses;
    for (std::size_t e = 0; e < run.assemblage.element_nodes.size(); ++e) {
        const auto [n0, n1, n2] = run.assemblage.element_nodes[e];
        const PlaneElasticity c = run.assemblage.elasticity[e];
        const TriangleGeometry& g = run.assemblage.element_geometry[e];
        const Vector2 d1 = displacement_of(u, n1) - displacement_of(u, n0);
        const Vector2 d2 = displacement_of(u, n2) - displacement_of(u, n0);
        const double exx = d1.x * g.gradient1.x + d2.x * g.gradient2.x;
        const double eyy = d1.y * g.gradient1.y + d2.y * g.gradient2.y;
        const double gamma = d1.x * g.gradient1.y + d2.x * g.gradient2.y + d1.y * g.gradient1.x + d2.y * g.gradient2.x;
        stresses.push_back({c.c11 * exx + c.c12 * eyy, c.c12 * exx + c.c11 * eyy, c.mu * gamma});
    }
    return stresses;
}

/// Mean strain of the specimen, jumps of contacts included: ∮ ½(u n + n u) ds over its outline, over its area.
inline Tensor mean_strain(const SmallRun& run, const Eigen::VectorXd& u) {
    const Assemblage& a = run.assemblage;
    Tensor sum;
    double area = 0;
    for (const auto& edge : run.specimen.boundary_edges) {
        const std::int32_t i = a.node_of_specimen[static_cast<std::size_t>(edge[0])];
        const std::int32_t j = a.node_of_specimen[static_cast<std::size_t>(edge[1])];
        const Vector2 p = a.position[static_cast<std::size_t>(i)];
        const Vector2 q = a.position[static_cast<std::size_t>(j)];
        const Vector2 normal{q.y - p.y, p.x - q.x};
        const Vector2 middle = 0.5 * (displacement_of(u, i) + displacement_of(u, j));
        sum.xx += middle.x * normal.x;
        sum.yy += middle.y * normal.y;
        sum.xy += 0.5 * (middle.x * normal.y + middle.y * normal.x);
        area += 0.5 * (p.x * q.y - p.y * q.x);
    }
    return {sum.xx / area, sum.yy / area, sum.xy / area};
}

}  // namespace graincrack::test
