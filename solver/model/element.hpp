// The constant-strain triangle: computes Biot strain, stress and nodal forces from displacements; a rigid rotation has no strain.
#pragma once

#include <array>
#include <cmath>

#include "share/file/fabric.hpp"
#include "share/rock/fracture_process_zone.hpp"
#include "solver/arithmetic/vector2.hpp"

namespace graincrack {

/// Isotropic elasticity in the plane: σxx = c11 εxx + c12 εyy, σxy = 2μ εxy, σzz = czz (σxx + σyy).
struct PlaneElasticity {
    double c11, c12;
    double mu;
    double czz;  ///< ν in plane strain, 0 in plane stress
};
inline PlaneElasticity make_plane_elasticity(double young_modulus, double poisson_ratio, PlaneCondition plane) {
    const double mu = young_modulus / (2 * (1 + poisson_ratio));
    const double lambda = plane == PlaneCondition::strain
                              ? young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio))
                              : young_modulus * poisson_ratio / (1 - poisson_ratio * poisson_ratio);
    return {lambda + 2 * mu, lambda, mu, plane == PlaneCondition::strain ? poisson_ratio : 0.0};
}

/// The state of the elements of a phase at a temperature T. Free crystals expand by A(T) = ∫a dT along their axis, which lies in
/// the plane, and by B(T) = ∫b dT across it. The modulus factor f(T) = E(T)/E0 scales their modulus.
struct PlaneWarmth {
    double across;       ///< free strain across the axis: (1 + ν) B in plane strain, B in plane stress
    double more_along;   ///< free strain along the axis less that across it: A − B
    double across_rate;  ///< derivatives of both with respect to T, 1/K
    double more_along_rate;
    double stress_zz;       ///< f E B in plane strain, 0 in plane stress: σzz = czz (σxx + σyy) − f E B, Pa
    double energy_zz;       ///< ½ f E B² in plane strain, stored besides ½ T : (U − I − ε0), J/m³
    double energy_zz_rate;  ///< its derivative f E B b + ½ f' E B², J/(m³ K)
    double softening;       ///< modulus factor f
    double softening_rate;  ///< f'/f, the relative derivative of the energy stored in the plane, 1/K
};
inline PlaneWarmth plane_warmth(const Phase& phase, PlaneCondition plane, double temperature) {
    const bool is_held = plane == PlaneCondition::strain;
    const auto at = [temperature](const TemperatureCurve& curve, double constant) {
        return curve.empty() ? constant_value(constant, temperature) : value_at(curve, temperature);
    };
    const ValueAtTemperature a = at(phase.along, phase.thermal_expansion);
    const ValueAtTemperature b = at(phase.across, phase.thermal_expansion);
    const ValueAtTemperature f = at(phase.softening, 1);
    const double in_plane = is_held ? 1 + phase.poisson_ratio : 1;
    const double stress_zz = is_held ? f.value * phase.young_modulus * b.integral : 0;
    const double energy_zz = 0.5 * stress_zz * b.integral;
    const double softening_rate = f.slope / f.value;
    return {in_plane * b.integral,
            a.integral - b.integral,
            in_plane * b.value,
            a.value - b.value,
            stress_zz,
            energy_zz,
            stress_zz * b.value + softening_rate * energy_zz,
            f.value,
            softening_rate};
}
/// Elasticity of a phase with a modulus factor.
inline PlaneElasticity softened(const PlaneElasticity& c, double softening) {
    return {softening * c.c11, softening * c.c12, softening * c.mu, c.czz};
}

/// The axis of a crystal at an angle φ from x.
struct CrystalAxis {
    double cosine_squared = 0, cosine_sine = 0;  ///< cos² φ, cos φ sin φ
};
inline CrystalAxis make_crystal_axis(double angle) {
    const double cosine = std::cos(angle);
    return {cosine * cosine, cosine * std::sin(angle)};
}

/// The strain ε0 in the plane without stress.
struct FreeStrain {
    double xx = 0, yy = 0, xy = 0;
};
inline FreeStrain free_strain(double across, double more_along, const CrystalAxis& axis) {
    return {across + more_along * axis.cosine_squared, across + more_along * (1 - axis.cosine_squared),
            more_along * axis.cosine_sine};
}

/// Reference geometry. The rows of the inverse edge matrix are the gradients of the shape functions of nodes 1 and 2.
struct TriangleGeometry {
    Vector2 gradient1, gradient2;  ///< 1/m; that of node 0 is −(gradient1 + gradient2)
    double area = 0;               ///< m²
};
inline TriangleGeometry make_triangle_geometry(const Vector2& p0, const Vector2& p1, const Vector2& p2) {
    const Vector2 d1 = p1 - p0;
    const Vector2 d2 = p2 - p0;
    const double det = d1.x * d2.y - d2.x * d1.y;
    return {{d2.y / det, -d2.x / det}, {-d1.y / det, d1.x / det}, 0.5 * det};
}

/// Polar decomposition F = R U of a triangle and its Biot stress T = C : (U − I − ε0).
struct TriangleState {
    double cosine, sine;   ///< of the rigid rotation R
    double exx, eyy, exy;  ///< Biot strain U − I less the free strain ε0
    double txx, tyy, txy;  ///< Biot stress in the unrotated frame, Pa
};
/// Computes the state of a triangle. \param a,b displacements of nodes 1 and 2 less that of node 0, m
/// \param free strain ε0
inline TriangleState triangle_state(const TriangleGeometry& g, const PlaneElasticity& c, const Vector2& a, const Vector2& b,
                                    const FreeStrain& free = {}) {
    // H = ∇u = F − I
    const double hxx = a.x * g.gradient1.x + b.x * g.gradient2.x;
    const double hxy = a.x * g.gradient1.y + b.x * g.gradient2.y;
    const double hyx = a.y * g.gradient1.x + b.y * g.gradient2.x;
    const double hyy = a.y * g.gradient1.y + b.y * g.gradient2.y;
    // R follows from tan θ = (Fyx − Fxy)/(Fxx + Fyy), by which Rᵀ F is symmetric.
    const double p = 2 + hxx + hyy;
    const double q = hyx - hxy;
    const double inv = 1 / std::sqrt(p * p + q * q);
    const double cosine = p * inv;
    const double sine = q * inv;
    // This is cos θ − 1 without cancellation at small rotations.
    const double cosine_less_1 = p > 0 ? -sine * sine / (1 + cosine) : cosine - 1;
    TriangleState s{cosine, sine, 0, 0, 0, 0, 0, 0};
    s.exx = cosine_less_1 + cosine * hxx + sine * hyx - free.xx;
    s.eyy = cosine_less_1 + cosine * hyy - sine * hxy - free.yy;
    s.exy = 0.5 * (cosine * (hxy + hyx) + sine * (hyy - hxx)) - free.xy;
    s.txx = c.c11 * s.exx + c.c12 * s.eyy;
    s.tyy = c.c12 * s.exx + c.c11 * s.eyy;
    s.txy = 2 * c.mu * s.exy;
    return s;
}

/// Forces of the triangle on its nodes, −A P ∇N with P = R T, N per metre of thickness.
struct TriangleForces {
    Vector2 on_node1, on_node2;
    [[nodiscard]] Vector2 on_node0() const { return {-(on_node1.x + on_node2.x), -(on_node1.y + on_node2.y)}; }
};
inline TriangleForces triangle_forces(const TriangleGeometry& g, const TriangleState& s) {
    const double pxx = s.cosine * s.txx - s.sine * s.txy;
    const double pxy = s.cosine * s.txy - s.sine * s.tyy;
    const double pyx = s.sine * s.txx + s.cosine * s.txy;
    const double pyy = s.sine * s.txy + s.cosine * s.tyy;
    const Vector2 f1{-g.area * (pxx * g.gradient1.x + pxy * g.gradient1.y),
                     -g.area * (pyx * g.gradient1.x + pyy * g.gradient1.y)};
    const Vector2 f2{-g.area * (pxx * g.gradient2.x + pxy * g.gradient2.y),
                     -g.area * (pyx * g.gradient2.x + pyy * g.gradient2.y)};
    return {f1, f2};
}

/// Strain energy ½ A T : (U − I − ε0), J per metre of thickness.
inline double triangle_energy(const TriangleGeometry& g, const TriangleState& s) {
    return 0.5 * g.area * (s.txx * s.exx + s.tyy * s.eyy + 2 * s.txy * s.exy);
}

/// Stress turned into the present directions: xx yy xy zz, Pa.
inline std::array<double, 4> triangle_stress(const PlaneElasticity& c, const TriangleState& s) {
    const double cc = s.cosine * s.cosine;
    const double ss = s.sine * s.sine;
    const double cs = s.cosine * s.sine;
    return {cc * s.txx + ss * s.tyy - 2 * cs * s.txy, ss * s.txx + cc * s.tyy + 2 * cs * s.txy,
            cs * (s.txx - s.tyy) + (cc - ss) * s.txy, c.czz * (s.txx + s.tyy)};
}

}  // namespace graincrack
