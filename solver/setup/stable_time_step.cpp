#include "solver/setup/stable_time_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "share/base/error.hpp"

namespace graincrack {
namespace {

constexpr int max_iterations = 400;
constexpr int check_every = 10;
constexpr double requested_residual = 0.001;  // over the eigenvalue; half of it in the step
constexpr double unseen = 0.002;              // margin over the eigenvalue; a step 0.4 % too long was seen without it

void add_elements(const Assemblage& a, const std::vector<Vector2>& x, std::vector<Vector2>& y) {
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        const auto [n0, n1, n2] = a.element_nodes[e];
        const TriangleGeometry& g = a.element_geometry[e];
        const Vector2 d1 = x[n1] - x[n0];
        const Vector2 d2 = x[n2] - x[n0];
        const double exx = d1.x * g.gradient1.x + d2.x * g.gradient2.x;
        const double eyy = d1.y * g.gradient1.y + d2.y * g.gradient2.y;
        const double gxy = d1.x * g.gradient1.y + d2.x * g.gradient2.y + d1.y * g.gradient1.x + d2.y * g.gradient2.x;
        const PlaneElasticity c = a.elasticity[e];
        const TriangleState unrotated{1,         0, exx, eyy, 0.5 * gxy, c.c11 * exx + c.c12 * eyy, c.c12 * exx + c.c11 * eyy,
                                      c.mu * gxy};
        const TriangleForces forces = triangle_forces(g, unrotated);
        y[n0] -= forces.on_node0();
        y[n1] -= forces.on_node1;
        y[n2] -= forces.on_node2;
    }
}

void add_contacts(const Assemblage& a, const ContactLaws& laws, const std::vector<Vector2>& x, std::vector<Vector2>& y) {
    for_each_contact(a, [&](std::int32_t c, std::int32_t contact_class) {
        const ContactGeometry& g = a.contacts[c];
        const ContactLaw& law = laws[contact_class];
        const Vector2 t = (1 / (2 * g.point_area)) * g.edge;
        const Vector2 n{t.y, -t.x};
        for (int p = 0; p < 2; ++p) {
            const std::int32_t on_a = g.nodes[p];
            const std::int32_t on_b = g.nodes[2 + p];
            const Vector2 jump = x[on_b] - x[on_a];
            const Vector2 force =
                (g.point_area * law.stiffest_normal * dot(jump, n)) * n + (g.point_area * law.stiffest_shear * dot(jump, t)) * t;
            y[on_b] += force;
            y[on_a] -= force;
        }
    });
}

/// Largest stiffnesses of the possible contacts of a phase, Pa/m.
struct ContactStiffness {
    double normal = 0, shear = 0;
};
std::vector<ContactStiffness> stiffest_by_phase(const Assemblage& a, const ContactLaws& laws) {
    std::vector<ContactStiffness> stiffest(*std::max_element(a.phase_of_node.begin(), a.phase_of_node.end()) + 1U);
    for (std::size_t high = 0; high < stiffest.size(); ++high) {
        for (std::size_t low = 0; low <= high; ++low) {
            const ContactLaw& law = laws.of_class[contact_class(high, low)];
            for (const std::size_t phase : {low, high}) {
                stiffest[phase] = {std::max(stiffest[phase].normal, law.stiffest_normal),
                                   std::max(stiffest[phase].shear, law.ks)};
            }
        }
    }
    return stiffest;
}

/// Adds the free faces: another grain may touch one and hold it as a bond would, if there is another grain.
void add_free_faces(const Assemblage& a, const Boundary& boundary, const ContactLaws& laws, const std::vector<Vector2>& x,
                    std::vector<Vector2>& y) {
    const std::vector<ContactStiffness> stiffest = stiffest_by_phase(a, laws);
    std::vector<bool> has_platen(a.position.size(), false);
    for (const PlatenPoint& point : boundary.platen_points) has_platen[point.node] = has_platen[point.node] || point.on_boundary;
    const auto& grains = a.surface.grain_of_node;
    if (std::all_of(grains.begin(), grains.end(), [&grains](std::int32_t grain) { return grain == grains.front(); })) return;
    for (const SurfaceEdge& edge : a.surface.edges) {
        if (edge.contact >= 0) continue;
        const Vector2 along = a.position[edge.nodes[1]] - a.position[edge.nodes[0]];
        const double half = 0.5 * length(along);
        const Vector2 t = (0.5 / half) * along;
        const Vector2 n{t.y, -t.x};
        for (const std::int32_t node : edge.nodes) {
            if (!has_platen[node]) {
                const ContactStiffness& k = stiffest[a.phase_of_node[node]];
                y[node] += (half * k.normal * dot(x[node], n)) * n + (half * k.shear * dot(x[node], t)) * t;
            }
        }
    }
}

void add_platens(const Boundary& boundary, const std::vector<Vector2>& x, std::vector<Vector2>& y) {
    for (const PlatenPoint& point : boundary.platen_points) {
        if (point.on_boundary) {
            const Platen& platen = boundary.platens[point.platen];
            const Vector2 tangent = across(platen.axis);
            y[point.node] += platen.shear_stiffness * point.tributary * dot(tangent, x[point.node]) * tangent;
            y[point.node] += platen.normal_stiffness * point.tributary * dot(platen.axis, x[point.node]) * platen.axis;
        }
    }
}

double dot(const Assemblage& a, const std::vector<Vector2>& x, const std::vector<Vector2>& y) {
    return sum_over_nodes(a, [&](std::int32_t i) { return graincrack::dot(x[i], y[i]); });
}

/// A start vector with a component in every mode: a fixed pseudo-random sequence.
std::vector<Vector2> start_vector(std::size_t n) {
    std::vector<Vector2> v(n);
    std::uint64_t state = 0x9e3779b97f4a7c15ULL;
    const auto next = [&state] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 11) * 0x1p-53 - 0.5;
    };
    for (Vector2& x : v) {
        x.x = next();
        x.y = next();
    }
    return v;
}

/// Largest eigenvalue of M^(−1/2) K M^(−1/2) by Lanczos' method, 1/s²; at most 1 % too large.
/// \param stiffness (x, y): y += K x
template <class Stiffness>
double largest_eigenvalue(const Assemblage& a, Stiffness&& stiffness) {
    const std::size_t n = a.position.size();
    std::vector<double> root(n);  // M^(−1/2)
    std::transform(a.inverse_mass.begin(), a.inverse_mass.end(), root.begin(), [](double m) { return std::sqrt(m); });
    std::vector<Vector2> current = start_vector(n);
    std::vector<Vector2> previous(n);
    std::vector<Vector2> scaled(n);
    std::vector<Vector2> next(n);
    std::vector<double> diagonal;
    std::vector<double> beside;
    double beta = std::sqrt(dot(a, current, current));
    for (Vector2& x : current) x = (1 / beta) * x;
    beta = 0;
    for (int k = 1; k <= max_iterations; ++k) {
        for (std::size_t i = 0; i < n; ++i) scaled[i] = root[i] * current[i];
        std::fill(next.begin(), next.end(), Vector2{});
        stiffness(scaled, next);
        for (std::size_t i = 0; i < n; ++i) next[i] = root[i] * next[i] - beta * previous[i];
        diagonal.push_back(dot(a, next, current));
        for (std::size_t i = 0; i < n; ++i) next[i] -= diagonal.back() * current[i];
        beta = std::sqrt(dot(a, next, next));
        const bool exhausted = beta <= 1e-12 * diagonal.front() || k == static_cast<int>(2 * n);
        if (k % check_every == 0 || exhausted) {
            Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
            solver.computeFromTridiagonal(Eigen::Map<Eigen::VectorXd>(diagonal.data(), k),
                                          Eigen::Map<Eigen::VectorXd>(beside.data(), k - 1));
            const double eigenvalue = solver.eigenvalues()(k - 1);
            const double residual = beta * std::abs(solver.eigenvectors()(k - 1, k - 1));
            if (residual < requested_residual * eigenvalue || exhausted) return (1 + unseen) * eigenvalue + residual;
        }
        beside.push_back(beta);
        std::swap(previous, current);
        for (std::size_t i = 0; i < n; ++i) current[i] = (1 / beta) * next[i];
    }
    throw NumericalError("the stable time step was not found: the stiffness of the specimen is not finite; check the material");
}

double stiffest_grain(const Assemblage& a) {
    return largest_eigenvalue(a, [&](const std::vector<Vector2>& x, std::vector<Vector2>& y) { add_elements(a, x, y); });
}

double stiffest_contact(const Assemblage& a, const Boundary& boundary, const ContactLaws& laws) {
    return largest_eigenvalue(a, [&](const std::vector<Vector2>& x, std::vector<Vector2>& y) {
        add_contacts(a, laws, x, y);
        add_platens(boundary, x, y);
    });
}

}  // namespace

// With mass scaling any motion is v = v̄ + w, the mean of each cluster and the rest, and vᵀM'v = v̄ᵀMv̄ + (1 + β) wᵀMw. For any ε
// > 0
//
//   vᵀK v ≤ (1 + ε) v̄ᵀK_g v̄ + (1 + 1/ε) wᵀK_g w + wᵀK_c w ≤ (1 + ε) ω_g² v̄ᵀMv̄ + [(1 + 1/ε) ω_g² + ω_c²] wᵀMw
//
// with the stiffness K_g of grains and K_c of contacts and platens. Thus ω² ≤ max((1 + ε) ω_g², [(1 + 1/ε) ω_g² + ω_c²]/(1 + β)),
// which is smallest where the two are equal. It holds for any clusters; failed contacts reduce K_c only.

double stable_time_step(const Assemblage& a, const Boundary& boundary, const ContactLaws& laws, double mass_scaling_factor) {
    if (mass_scaling_factor == 0) {
        return 2 / std::sqrt(largest_eigenvalue(a, [&](const std::vector<Vector2>& x, std::vector<Vector2>& y) {
                   add_elements(a, x, y);
                   add_contacts(a, laws, x, y);
                   add_free_faces(a, boundary, laws, x, y);
                   add_platens(boundary, x, y);
               }));
    }
    const double beta = mass_scaling_factor;
    const double grain = stiffest_grain(a);
    const double p = beta - stiffest_contact(a, boundary, laws) / grain;
    const double epsilon = (std::sqrt(p * p + 4 * (1 + beta)) - p) / (2 * (1 + beta));
    return 2 / std::sqrt((1 + epsilon) * grain);
}

double sufficient_mass_scaling(const Assemblage& a, const Boundary& boundary, const ContactLaws& laws) {
    constexpr double epsilon = 0.1;  // reduces the step of the grains to 1/√1.1, by a twentieth; chosen, not fitted
    const double ratio = stiffest_contact(a, boundary, laws) / stiffest_grain(a);
    return (1 + 1 / epsilon + ratio) / (1 + epsilon) - 1;
}

}  // namespace graincrack
