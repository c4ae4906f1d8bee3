#include "solver/setup/element_mass.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

namespace graincrack {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Stiffness matrix K = A Bᵀ C B of a triangle of unit thickness, Pa.
Matrix6 stiffness_of(const TriangleGeometry& g, const PlaneElasticity& c) {
    const Vector2 gradients[] = {-1.0 * (g.gradient1 + g.gradient2), g.gradient1, g.gradient2};
    Eigen::Matrix<double, 3, 6> strains;
    for (int k = 0; k < 3; ++k) {
        strains.block<3, 2>(0, 2 * k) << gradients[k].x, 0, 0, gradients[k].y, gradients[k].y, gradients[k].x;
    }
    Eigen::Matrix3d moduli;
    moduli << c.c11, c.c12, 0, c.c12, c.c11, 0, 0, 0, c.mu;
    return g.area * strains.transpose() * moduli * strains;
}

double largest_eigenvalue_of_element(const Matrix6& m) {
    return Eigen::SelfAdjointEigenSolver<Matrix6>(m, Eigen::EigenvaluesOnly).eigenvalues()(5);
}

/// Largest ω² of each element, 1/s².
std::vector<double> squared_frequencies(const Assemblage& a) {
    std::vector<double> squared;
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        const TriangleGeometry g = a.element_geometry[e];
        squared.push_back(largest_eigenvalue_of_element(stiffness_of(g, a.elasticity[e])) / (a.element_mass[e] / 3));
    }
    return squared;
}

/// The smallest ω² to which all elements above it can be lowered by adding at most `fraction` of the total mass, by bisection.
double level(const Assemblage& a, const std::vector<double>& squared, double fraction) {
    const auto added = [&](double requested) {
        double mass = 0, sum = 0;
        for (std::size_t e = 0; e < squared.size(); ++e) {
            mass += a.element_mass[e];
            sum += (std::max(1.0, squared[e] / requested) - 1) * a.element_mass[e];
        }
        return sum / mass;
    };
    double high = *std::max_element(squared.begin(), squared.end());
    double low = high / (1 + fraction);  // this adds no more than `fraction`
    while (added(low) < fraction) low *= 0.5;
    constexpr int halvings = 30;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (added(middle) > fraction ? low : high) = middle;
    }
    return high;
}

}  // namespace

double scale_mass_of_stiffest_elements(Assemblage& a, double fraction) {
    if (a.element_nodes.empty() || fraction <= 0) return 0;
    const std::vector<double> squared = squared_frequencies(a);
    const double common = level(a, squared, fraction);
    double before = 0, added = 0;
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        const double mass = a.element_mass[e] / 3;
        const double more = (std::max(1.0, squared[e] / common) - 1) * mass;
        for (const std::int32_t node : a.element_nodes[e]) {
            a.mass[node] += more;
            a.inverse_mass[node] = 1 / a.mass[node];
        }
        before += mass;
        added += more;
    }
    return added / before;
}

}  // namespace graincrack
