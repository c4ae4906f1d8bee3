// Contact parameters from the fracture process zone: Kazerani & Zhao (2014), Eqs 3–6, 8, 11, 14–17, 30–44.
//
// Pure functions; SI units; strengths positive. E, ν: rock; K_IC, K_IIC: toughnesses; σt: tensile strength of the rock.
#pragma once

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

/// G = E / (2 (1 + ν)), Pa.
double shear_modulus(const Rock& rock);
/// Ẽ = E (plane stress) or E/(1 − ν²) (plane strain), Pa. The paper prints E (1 − ν²) under Eq 32; its numbers use this.
double effective_modulus(const Rock& rock, PlaneCondition plane);
/// ν (plane stress) or ν/(1 − ν) (plane strain).
double plane_poisson_ratio(const Rock& rock, PlaneCondition plane);
/// w_I = 4 K_IC² / (Ẽ σt), Eq 33, m.
double mode_i_zone_thickness(const Rock& rock, PlaneCondition plane);
/// w_II = 4 K_IIC² / (Ẽ σt), Eq 34, m.
double mode_ii_zone_thickness(const Rock& rock, PlaneCondition plane);
/// k_t = E / w_I, Eqs 3–5, Pa/m.
double normal_stiffness(const Rock& rock, PlaneCondition plane);
/// k_s = G / w_II, Eqs 3–5, Pa/m.
double shear_stiffness(const Rock& rock, PlaneCondition plane);
/// G_f = (K_IC² + K_IIC²) / Ẽ, Eq 32, J/m².
double mixed_mode_fracture_energy(const Rock& rock, PlaneCondition plane);
/// G_I = K_IC² / Ẽ, J/m².
double mode_i_fracture_energy(const Rock& rock, PlaneCondition plane);
/// G_II = K_IIC² / Ẽ, J/m².
double mode_ii_fracture_energy(const Rock& rock, PlaneCondition plane);
/// δct = e tc / kt, Eq 8, or δcs = e cc / ks, Eq 11, m.
double critical_displacement(double strength, double stiffness);
/// δut = 2 Gf/tc − (2e − 5) δct, from Eq 14, m. May fall below δct: then Gf is too small for the elastic branch.
double ultimate_displacement(double fracture_energy, double tensile_strength, double critical_displacement);
/// Gf = tc (δut + (2e − 5) δct) / 2, Eq 14, J/m².
double fracture_energy(double tensile_strength, double critical_displacement, double ultimate_displacement);
/// l = (9π/32) (K_IC/σt)², Eq 16 (Rice 1980), m.
double zone_length(const Rock& rock);
/// Lower bound 10 w of the grain size, Eqs 15, 17, as printed: 40 K_IC²/(E σt), m.
double min_grain_size(const Rock& rock);
/// The same with w_II, which the paper leaves out: 40 K_IIC²/(E σt), m.
double min_grain_size_shear(const Rock& rock);
/// Upper bound l/3 of the grain size, Eqs 15, 17, m.
double max_grain_size(const Rock& rock);
/// Zone of contacts that soften from tc: (9π/32) Ẽ Gf / tc², m.
double contact_zone_length(const Rock& rock, PlaneCondition plane, double fracture_energy, double contact_tensile_strength);
/// b(m, n) of Eq 31, integers 0 < m < n.
double lennard_jones_b(int m, int n);
/// w = Gf / (b σt), Eq 30, m.
double zone_thickness(double fracture_energy, double b, double tensile_strength);
/// P(z)/X = a [(ζ/z)^n − (ζ/z)^m], Eqs 20–22, as a function of z/ζ.
double lennard_jones_potential(double z_over_zeta, int m, int n);
/// tc = 2 K_IC / √(π dp), Eq 40, Pa.
double contact_tensile_strength_from_toughness(double mode_i_toughness, double edge);
/// σt = 6.88 K_IC (MPa, MPa√m; Zhang 2002), Eq 43, Pa.
double tensile_strength_from_toughness(double mode_i_toughness);

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
AssemblageModuli assemblage_moduli(const Rock& rock, PlaneCondition plane, double normal_stiffness, double shear_stiffness,
                                   double contact_length_per_area);

/// Stiffnesses of contacts, Pa/m.
struct ContactStiffness {
    double normal;
    double shear;
};
/// Those at which contacts in all directions, of a length Sv per area, add a share s to the compliance of a body and leave its ν:
/// kn = E/(1 − ν) · Sv/(2 s), ks = E/(1 + 3 ν) · Sv/(2 s), with E and ν in the plane. It is `assemblage_moduli` solved for
/// 1/E' = (1 + s)/E and ν' = ν.
ContactStiffness stiffness_of_added_compliance(const Rock& rock, PlaneCondition plane, double share,
                                               double contact_length_per_area);

/// Material values from plane-strain values: ν = ν'/(1+ν'), E = E'(1−ν²).
double material_young_modulus(double plane_strain_modulus, double plane_strain_ratio);
double material_poisson_ratio(double plane_strain_ratio);

}  // namespace fpz
}  // namespace graincrack
