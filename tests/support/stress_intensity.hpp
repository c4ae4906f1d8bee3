// Stress intensity factors of a straight crack with free faces, from small displacements, by the interaction integral (Yau, Wang
// & Corten 1980, Journal of Applied Mechanics 47): that of Rice's J between the field and the singular fields of a crack.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/linear_statics.hpp"

namespace graincrack::test {

/// K_I and K_II, Pa √m.
struct StressIntensity {
    double mode_i = 0, mode_ii = 0;
};

/// Singular field of a crack of K = 1 at a place (r, θ) from its tip, in axes ahead of and left of the crack.
struct SingularField {
    Tensor stress;
    double u_x_x = 0, u_y_x = 0;  ///< derivatives of the displacement along the crack
};
inline SingularField singular_field(int mode, const Vector2& p, const Rock& rock, PlaneCondition plane) {
    const double nu = rock.poisson_ratio;
    const double shear_modulus = rock.young_modulus / (2 * (1 + nu));
    const double kappa = plane == PlaneCondition::strain ? 3 - 4 * nu : (3 - nu) / (1 + nu);
    const auto displacement = [&](const Vector2& at) {
        const double theta = std::atan2(at.y, at.x);
        const double c = std::cos(theta / 2);
        const double s = std::sin(theta / 2);
        const double f = std::sqrt(length(at) / (2 * std::numbers::pi)) / (2 * shear_modulus);
        return mode == 1 ? Vector2{f * c * (kappa - 1 + 2 * s * s), f * s * (kappa + 1 - 2 * c * c)}
                         : Vector2{f * s * (kappa + 1 + 2 * c * c), -f * c * (kappa - 1 - 2 * s * s)};
    };
    const double step = 1e-5 * length(p);
    const Vector2 slope = (0.5 / step) * (displacement(p + Vector2{step, 0}) - displacement(p - Vector2{step, 0}));
    const double theta = std::atan2(p.y, p.x);
    const double c = std::cos(theta / 2);
    const double s = std::sin(theta / 2);
    const double c3 = std::cos(1.5 * theta);
    const double s3 = std::sin(1.5 * theta);
    const double f = 1 / std::sqrt(2 * std::numbers::pi * length(p));
    const Tensor stress = mode == 1 ? Tensor{f * c * (1 - s * s3), f * c * (1 + s * s3), f * c * s * c3}
                                    : Tensor{-f * s * (2 + c * c3), f * s * c * c3, f * c * (1 - s * s3)};
    return {stress, slope.x, slope.y};
}

/// \param tip of the crack; \param ahead unit vector out of the crack; the integral is taken between two radii about the tip
inline StressIntensity stress_intensity(const SmallRun& run, const Eigen::VectorXd& u, PlaneCondition plane, const Rock& rock,
                                        const Vector2& tip, const Vector2& ahead, double inner, double outer) {
    const Assemblage& a = run.assemblage;
    const Vector2 left{-ahead.y, ahead.x};
    const auto local = [&](const Vector2& v) { return Vector2{dot(v, ahead), dot(v, left)}; };
    const auto weight = [&](std::int32_t node) {
        const double r = length(a.position[static_cast<std::size_t>(node)] - tip);
        return std::clamp((outer - r) / (outer - inner), 0.0, 1.0);
    };
    const std::vector<Tensor> stresses = element_stresses(run, u);
    const double nu = rock.poisson_ratio;
    const double modulus = plane == PlaneCondition::strain ? rock.young_modulus / (1 - nu * nu) : rock.young_modulus;
    std::array<double, 2> interaction{};
    for (std::size_t e = 0; e < a.element_nodes.size(); ++e) {
        const auto [n0, n1, n2] = a.element_nodes[e];
        const std::array<double, 3> q{weight(n0), weight(n1), weight(n2)};
        if (q[0] == q[1] && q[1] == q[2]) continue;
        const TriangleGeometry& g = a.element_geometry[e];
        const Vector2 slope_of_q = local((q[1] - q[0]) * g.gradient1 + (q[2] - q[0]) * g.gradient2);
        const Vector2 d1 = local(displacement_of(u, n1) - displacement_of(u, n0));
        const Vector2 d2 = local(displacement_of(u, n2) - displacement_of(u, n0));
        const Vector2 g1 = local(g.gradient1);
        const Vector2 g2 = local(g.gradient2);
        const double u_x_x = d1.x * g1.x + d2.x * g2.x;
        const double u_y_x = d1.y * g1.x + d2.y * g2.x;
        const double exy = 0.5 * (u_y_x + d1.x * g1.y + d2.x * g2.y);
        const double eyy = d1.y * g1.y + d2.y * g2.y;
        const Tensor& s = stresses[e];
        const Tensor sigma{ahead.x * ahead.x * s.xx + 2 * ahead.x * ahead.y * s.xy + ahead.y * ahead.y * s.yy,
                           left.x * left.x * s.xx + 2 * left.x * left.y * s.xy + left.y * left.y * s.yy,
                           ahead.x * left.x * s.xx + (ahead.x * left.y + ahead.y * left.x) * s.xy + ahead.y * left.y * s.yy};
        const std::array<Vector2, 3> corners{local(a.position[static_cast<std::size_t>(n0)] - tip),
                                             local(a.position[static_cast<std::size_t>(n1)] - tip),
                                             local(a.position[static_cast<std::size_t>(n2)] - tip)};
        for (std::size_t k = 0; k < 3; ++k) {  // inner points, none on a face of the crack: exact up to the second degree
            const Vector2 p = (2.0 / 3) * corners[k] + (1.0 / 6) * (corners[(k + 1) % 3] + corners[(k + 2) % 3]);
            for (const int mode : {1, 2}) {
                const SingularField f = singular_field(mode, p, rock, plane);
                const double energy = f.stress.xx * u_x_x + f.stress.yy * eyy + 2 * f.stress.xy * exy;
                const double along = sigma.xx * f.u_x_x + sigma.xy * f.u_y_x + f.stress.xx * u_x_x + f.stress.xy * u_y_x - energy;
                const double across = sigma.xy * f.u_x_x + sigma.yy * f.u_y_x + f.stress.xy * u_x_x + f.stress.yy * u_y_x;
                interaction[static_cast<std::size_t>(mode - 1)] += g.area / 3 * (along * slope_of_q.x + across * slope_of_q.y);
            }
        }
    }
    return {0.5 * modulus * interaction[0], 0.5 * modulus * interaction[1]};
}

}  // namespace graincrack::test
