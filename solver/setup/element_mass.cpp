#include "solver/setup/element_mass.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

namespace graincrack {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// What may hold each node, Pa (N/m per metre of thickness): bonds, platens where they are met, elsewhere on free faces other
/// grains.
std::vector<Eigen::Matrix2d> springs_of_nodes(const Assemblage& a, const Boundary& boundary, const ContactLaw& law) {
    std::vector<Eigen::Matrix2d> springs(a.position.size(), Eigen::Matrix2d::Zero());
    std::vector<bool> has_platen(a.position.size(), false);
    for (const PlatenPoint& point : boundary.platen_points) {
        if (point.on_boundary) {
            const Platen& platen = boundary.platens[static_cast<std::size_t>(point.platen)];
            springs[point.node].diagonal() += point.tributary * Eigen::Vector2d(platen.shear_stiffness, platen.normal_stiffness);
            has_platen[point.node] = true;
        }
    }
    for (const SurfaceEdge& edge : a.surface.edges) {
        const Vector2 along = a.position[edge.nodes[1]] - a.position[edge.nodes[0]];
        const double half = 0.5 * length(along);
        const Eigen::Vector2d t = (0.5 / half) * Eigen::Vector2d(along.x, along.y);
        const Eigen::Vector2d n(t.y(), -t.x());
        const bool is_bond = edge.contact >= 0;
        const double ends = is_bond ? 2 : 1;  // k (u − v)² ≤ 2 k u² + 2 k v²
        for (const std::int32_t node : edge.nodes) {
            if (is_bond || !has_platen[node]) {
                springs[node] += ends * half * (law.kt * n * n.transpose() + law.stiffest_shear * t * t.transpose());
            }
        }
    }
    return springs;
}

/// K = A Bᵀ C B of a triangle, Pa.
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

double largest_eigenvalue(const Matrix6& m) {
    return Eigen::SelfAdjointEigenSolver<Matrix6>(m, Eigen::EigenvaluesOnly).eigenvalues()(5);
}

/// Largest ω² of each element, 1/s².
struct Frequencies {
    std::vector<double> alone;
    std::vector<double> constrained;  ///< with its share of what may hold its nodes
};
Frequencies frequencies_of(const Assemblage& a, const Boundary& boundary, const ContactLaw& law, double density) {
    const std::vector<Eigen::Matrix2d> springs = springs_of_nodes(a, boundary, law);
    Frequencies f;
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        const TriangleGeometry g = a.element_geometry[e];
        const double mass = density * g.area / 3;
        Matrix6 stiffness = stiffness_of(g, a.elasticity);
        f.alone.push_back(largest_eigenvalue(stiffness) / mass);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t node = a.element_nodes[e][k];
            const auto row = static_cast<Eigen::Index>(2 * k);
            stiffness.block<2, 2>(row, row) += (mass / a.mass[node]) * springs[node];
        }
        f.constrained.push_back(largest_eigenvalue(stiffness) / mass);
    }
    return f;
}

/// The ω² that no element is above once `share` of all mass has been added to those that were.
double level(const Assemblage& a, const std::vector<double>& squared, double share) {
    const auto added = [&](double wanted) {
        double area = 0;
        double sum = 0;
        for (std::size_t e = 0; e < squared.size(); ++e) {
            const double own = a.element_geometry[e].area;
            area += own;
            sum += (std::max(1.0, squared[e] / wanted) - 1) * own;
        }
        return sum / area;
    };
    double high = *std::max_element(squared.begin(), squared.end());
    double low = high / (1 + share);  // which adds no more than that
    while (added(low) < share) {
        low *= 0.5;
    }
    constexpr int halvings = 30;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (added(middle) > share ? low : high) = middle;
    }
    return high;
}

}  // namespace

double scale_mass_of_stiffest_elements(Assemblage& a, const Boundary& boundary, const ContactLaw& law, double density,
                                       double share) {
    if (a.element_nodes.empty() || share <= 0) {
        return 0;
    }
    const Frequencies f = frequencies_of(a, boundary, law, density);
    const double alone = level(a, f.alone, 0.5 * share);
    const double constrained = level(a, f.constrained, 0.5 * share);
    double before = 0;
    double added = 0;
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        const double mass = density * a.element_geometry[e].area / 3;
        const double more = (std::max({1.0, f.alone[e] / alone, f.constrained[e] / constrained}) - 1) * mass;
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
