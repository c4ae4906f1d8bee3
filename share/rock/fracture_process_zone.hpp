// Contact parameters from the fracture process zone: Kazerani & Zhao (2014), Eqs 3–6, 8, 11, 14–17, 30–44.
//
// Pure functions; SI units; strengths positive. E, ν: rock; K_IC, K_IIC: toughnesses; σt: tensile strength of the rock.
#pragma once

#include <cmath>
#include <numbers>
#include <string_view>

namespace graincrack {

enum class PlaneCondition { strain, stress };
constexpr std::string_view name_of(PlaneCondition plane) { return plane == PlaneCondition::strain ? "strain" : "stress"; }

/// The rock's macroscopic properties ([rock] of a material file).
struct Rock {
    double young_modulus = 0;      ///< E, Pa
    double poisson_ratio = 0;      ///< ν
    double density = 0;            ///< ρ, kg/m³
    double mode_i_toughness = 0;   ///< K_IC, Pa√m
    double mode_ii_toughness = 0;  ///< K_IIC, Pa√m
    double tensile_strength = 0;   ///< σt (BTS), Pa
};

namespace fpz {

constexpr double square(double x) { return x * x; }

/// G = E / (2 (1 + ν)), Pa.
inline double shear_modulus(const Rock& rock) { return rock.young_modulus / (2 * (1 + rock.poisson_ratio)); }
/// Ẽ = E (plane stress) or E/(1 − ν²) (plane strain), Pa. The paper prints E (1 − ν²) under Eq 32; its numbers use this.
inline double effective_modulus(const Rock& rock, PlaneCondition plane) {
    return plane == PlaneCondition::stress ? rock.young_modulus : rock.young_modulus / (1 - square(rock.poisson_ratio));
}
/// ν (plane stress) or ν/(1 − ν) (plane strain).
inline double plane_poisson_ratio(const Rock& rock, PlaneCondition plane) {
    return plane == PlaneCondition::stress ? rock.poisson_ratio : rock.poisson_ratio / (1 - rock.poisson_ratio);
}
/// w_I = 4 K_IC² / (Ẽ σt), Eq 33, m.
inline double mode_i_zone_thickness(const Rock& rock, PlaneCondition plane) {
    return 4 * square(rock.mode_i_toughness) / (effective_modulus(rock, plane) * rock.tensile_strength);
}
/// w_II = 4 K_IIC² / (Ẽ σt), Eq 34, m.
inline double mode_ii_zone_thickness(const Rock& rock, PlaneCondition plane) {
    return 4 * square(rock.mode_ii_toughness) / (effective_modulus(rock, plane) * rock.tensile_strength);
}
/// k_t = E / w_I, Eqs 3–5, Pa/m.
inline double normal_stiffness(const Rock& rock, PlaneCondition plane) {
    return rock.young_modulus / mode_i_zone_thickness(rock, plane);
}
/// k_s = G / w_II, Eqs 3–5, Pa/m.
inline double shear_stiffness(const Rock& rock, PlaneCondition plane) {
    return shear_modulus(rock) / mode_ii_zone_thickness(rock, plane);
}
/// G_f = (K_IC² + K_IIC²) / Ẽ, Eq 32, J/m².
inline double mixed_mode_fracture_energy(const Rock& rock, PlaneCondition plane) {
    return (square(rock.mode_i_toughness) + square(rock.mode_ii_toughness)) / effective_modulus(rock, plane);
}
/// G_I = K_IC² / Ẽ, J/m².
inline double mode_i_fracture_energy(const Rock& rock, PlaneCondition plane) {
    return square(rock.mode_i_toughness) / effective_modulus(rock, plane);
}
/// G_II = K_IIC² / Ẽ, J/m².
inline double mode_ii_fracture_energy(const Rock& rock, PlaneCondition plane) {
    return square(rock.mode_ii_toughness) / effective_modulus(rock, plane);
}
/// δct = e tc / kt, Eq 8, or δcs = e cc / ks, Eq 11, m.
inline double critical_displacement(double strength, double stiffness) { return std::numbers::e * strength / stiffness; }
/// δut = 2 Gf/tc − (2e − 5) δct, from Eq 14, m. May fall below δct: then Gf is too small for the elastic branch.
inline double ultimate_displacement(double fracture_energy, double tensile_strength, double critical_displacement) {
    return 2 * fracture_energy / tensile_strength - (2 * std::numbers::e - 5) * critical_displacement;
}
/// l = (9π/32) (K_IC/σt)², Eq 16 (Rice 1980), m.
inline double zone_length(const Rock& rock) {
    return 9 * std::numbers::pi / 32 * square(rock.mode_i_toughness / rock.tensile_strength);
}
/// Lower bound 10 w of the grain size, Eqs 15, 17, as printed: 40 K_IC²/(E σt), m.
inline double min_grain_size(const Rock& rock) {
    return 40 * square(rock.mode_i_toughness) / (rock.young_modulus * rock.tensile_strength);
}
/// The same with w_II, which the paper leaves out: 40 K_IIC²/(E σt), m.
inline double min_grain_size_shear(const Rock& rock) {
    return 40 * square(rock.mode_ii_toughness) / (rock.young_modulus * rock.tensile_strength);
}
/// Upper bound l/3 of the grain size, Eqs 15, 17, m.
inline double max_grain_size(const Rock& rock) { return zone_length(rock) / 3; }
/// Zone of contacts that soften from tc: (9π/32) Ẽ Gf / tc², m.
inline double contact_zone_length(const Rock& rock, PlaneCondition plane, double fracture_energy,
                                  double contact_tensile_strength) {
    return 9 * std::numbers::pi / 32 * effective_modulus(rock, plane) * fracture_energy / square(contact_tensile_strength);
}
/// b(m, n) of Eq 31, integers 0 < m < n.
inline double lennard_jones_b(int m, int n) {
    const double ratio = (n + 1.0) / (m + 1.0);
    return (n + 1.0) / (static_cast<double>(n) * m) * std::pow(ratio, (m + 1.0) / (n - m));
}
/// w = Gf / (b σt), Eq 30, m.
inline double zone_thickness(double fracture_energy, double b, double tensile_strength) {
    return fracture_energy / (b * tensile_strength);
}
/// P(z)/X = a [(ζ/z)^n − (ζ/z)^m], Eqs 20–22, as a function of z/ζ.
inline double lennard_jones_potential(double z_over_zeta, int m, int n) {
    // n^n/m^m overflows for large exponents: take its root by logarithms
    const double a = std::exp((n * std::log(n) - m * std::log(m)) / (n - m)) / (n - m);
    return a * (std::pow(z_over_zeta, -n) - std::pow(z_over_zeta, -m));
}
/// tc = 2 K_IC / √(π dp), Eq 40, Pa.
inline double contact_tensile_strength_from_toughness(double mode_i_toughness, double edge) {
    return 2 * mode_i_toughness / std::sqrt(std::numbers::pi * edge);
}
/// σt = 6.88 K_IC (MPa, MPa√m; Zhang 2002), Eq 43, Pa.
inline double tensile_strength_from_toughness(double mode_i_toughness) { return 6.88 * mode_i_toughness; }

/// Material values from plane-strain values: ν = ν'/(1+ν'), E = E'(1−ν²).
inline double material_poisson_ratio(double plane_strain_ratio) { return plane_strain_ratio / (1 + plane_strain_ratio); }
inline double material_young_modulus(double plane_strain_modulus, double plane_strain_ratio) {
    return plane_strain_modulus * (1 - square(material_poisson_ratio(plane_strain_ratio)));
}

/// Elastic moduli of an isotropic assemblage of triangles with contacts of stiffness kn, ks on all edges:
/// 1/E' = 1/E + Sv (3/(8 kn) + 1/(8 ks)), ν' = [ν/E − (Sv/8)(1/kn − 1/ks)] E', with Sv the contact length per area
/// (2√3/a for equilateral triangles of edge a). In plane stress E, ν are the rock's; in plane strain the plane values
/// E/(1−ν²), ν/(1−ν) enter and the result is converted back to material values.
struct AssemblageModuli {
    double young_modulus;  ///< material value, Pa
    double poisson_ratio;  ///< material value
    double plane_young_modulus;
    double plane_poisson_ratio;
};
inline AssemblageModuli assemblage_moduli(const Rock& rock, PlaneCondition plane, double normal_stiffness, double shear_stiffness,
                                          double contact_length_per_area) {
    const double E = effective_modulus(rock, plane);
    const double nu = plane_poisson_ratio(rock, plane);
    const double Sv = contact_length_per_area;
    const double plane_E = 1 / (1 / E + Sv * (3 / (8 * normal_stiffness) + 1 / (8 * shear_stiffness)));
    const double plane_nu = (nu / E - Sv / 8 * (1 / normal_stiffness - 1 / shear_stiffness)) * plane_E;
    if (plane == PlaneCondition::stress) return {plane_E, plane_nu, plane_E, plane_nu};
    return {material_young_modulus(plane_E, plane_nu), material_poisson_ratio(plane_nu), plane_E, plane_nu};
}

/// Stiffnesses of contacts, Pa/m.
struct ContactStiffness {
    double normal;
    double shear;
};
/// Those at which contacts in all directions, of a length Sv per area, add a share s to the compliance of a body and leave its ν:
/// kn = E/(1 − ν) · Sv/(2 s), ks = E/(1 + 3 ν) · Sv/(2 s), with E and ν in the plane. It is `assemblage_moduli` solved for
/// 1/E' = (1 + s)/E and ν' = ν.
inline ContactStiffness stiffness_of_added_compliance(const Rock& rock, PlaneCondition plane, double share,
                                                      double contact_length_per_area) {
    const double stiffness = effective_modulus(rock, plane) * contact_length_per_area / (2 * share);
    const double nu = plane_poisson_ratio(rock, plane);
    return {stiffness / (1 - nu), stiffness / (1 + 3 * nu)};
}

}  // namespace fpz
}  // namespace graincrack
