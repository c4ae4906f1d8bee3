#include "share/rock/fracture_process_zone.hpp"

#include <cmath>
#include <numbers>

namespace graincrack::fpz {
namespace {

using std::numbers::e;
using std::numbers::pi;

constexpr double square(double x) { return x * x; }

}  // namespace

double shear_modulus(const Rock& rock) { return rock.young_modulus / (2 * (1 + rock.poisson_ratio)); }

double effective_modulus(const Rock& rock, PlaneCondition plane) {
    return plane == PlaneCondition::stress ? rock.young_modulus : rock.young_modulus / (1 - square(rock.poisson_ratio));
}

double plane_poisson_ratio(const Rock& rock, PlaneCondition plane) {
    return plane == PlaneCondition::stress ? rock.poisson_ratio : rock.poisson_ratio / (1 - rock.poisson_ratio);
}

double mode_i_zone_thickness(const Rock& rock, PlaneCondition plane) {
    return 4 * square(rock.mode_i_toughness) / (effective_modulus(rock, plane) * rock.tensile_strength);
}

double mode_ii_zone_thickness(const Rock& rock, PlaneCondition plane) {
    return 4 * square(rock.mode_ii_toughness) / (effective_modulus(rock, plane) * rock.tensile_strength);
}

double normal_stiffness(const Rock& rock, PlaneCondition plane) {
    return rock.young_modulus / mode_i_zone_thickness(rock, plane);
}

double shear_stiffness(const Rock& rock, PlaneCondition plane) {
    return shear_modulus(rock) / mode_ii_zone_thickness(rock, plane);
}

double mixed_mode_fracture_energy(const Rock& rock, PlaneCondition plane) {
    return (square(rock.mode_i_toughness) + square(rock.mode_ii_toughness)) / effective_modulus(rock, plane);
}

double mode_i_fracture_energy(const Rock& rock, PlaneCondition plane) {
    return square(rock.mode_i_toughness) / effective_modulus(rock, plane);
}

double mode_ii_fracture_energy(const Rock& rock, PlaneCondition plane) {
    return square(rock.mode_ii_toughness) / effective_modulus(rock, plane);
}

double critical_displacement(double strength, double stiffness) { return e * strength / stiffness; }

double ultimate_displacement(double fracture_energy, double tensile_strength, double critical_displacement) {
    return 2 * fracture_energy / tensile_strength - (2 * e - 5) * critical_displacement;
}

double fracture_energy(double tensile_strength, double critical_displacement, double ultimate_displacement) {
    return tensile_strength * (ultimate_displacement + (2 * e - 5) * critical_displacement) / 2;
}

double zone_length(const Rock& rock) { return 9 * pi / 32 * square(rock.mode_i_toughness / rock.tensile_strength); }

double min_grain_size(const Rock& rock) {
    return 40 * square(rock.mode_i_toughness) / (rock.young_modulus * rock.tensile_strength);
}

double min_grain_size_shear(const Rock& rock) {
    return 40 * square(rock.mode_ii_toughness) / (rock.young_modulus * rock.tensile_strength);
}

double max_grain_size(const Rock& rock) { return zone_length(rock) / 3; }

double contact_zone_length(const Rock& rock, PlaneCondition plane, double fracture_energy, double contact_tensile_strength) {
    return 9 * pi / 32 * effective_modulus(rock, plane) * fracture_energy / square(contact_tensile_strength);
}

double lennard_jones_b(int m, int n) {
    const double ratio = (n + 1.0) / (m + 1.0);
    return (n + 1.0) / (static_cast<double>(n) * m) * std::pow(ratio, (m + 1.0) / (n - m));
}

double zone_thickness(double fracture_energy, double b, double tensile_strength) {
    return fracture_energy / (b * tensile_strength);
}

double lennard_jones_potential(double z_over_zeta, int m, int n) {
    // n^n/m^m overflows for large exponents: take its root by logarithms
    const double a = std::exp((n * std::log(n) - m * std::log(m)) / (n - m)) / (n - m);
    return a * (std::pow(z_over_zeta, -n) - std::pow(z_over_zeta, -m));
}

double contact_tensile_strength_from_toughness(double mode_i_toughness, double edge) {
    return 2 * mode_i_toughness / std::sqrt(pi * edge);
}

double tensile_strength_from_toughness(double mode_i_toughness) { return 6.88 * mode_i_toughness; }

AssemblageModuli assemblage_moduli(const Rock& rock, PlaneCondition plane, double normal_stiffness, double shear_stiffness,
                                   double contact_length_per_area) {
    const double E = effective_modulus(rock, plane);
    const double nu = plane_poisson_ratio(rock, plane);
    const double Sv = contact_length_per_area;
    const double plane_E = 1 / (1 / E + Sv * (3 / (8 * normal_stiffness) + 1 / (8 * shear_stiffness)));
    const double plane_nu = (nu / E - Sv / 8 * (1 / normal_stiffness - 1 / shear_stiffness)) * plane_E;
    if (plane == PlaneCondition::stress) return {plane_E, plane_nu, plane_E, plane_nu};
    return {material_young_modulus(plane_E, plane_nu), material_poisson_ratio(plane_nu), plane_E, plane_nu};
}

ContactStiffness stiffness_of_added_compliance(const Rock& rock, PlaneCondition plane, double share,
                                               double contact_length_per_area) {
    const double stiffness = effective_modulus(rock, plane) * contact_length_per_area / (2 * share);
    const double nu = plane_poisson_ratio(rock, plane);
    return {stiffness / (1 - nu), stiffness / (1 + 3 * nu)};
}

double material_young_modulus(double plane_strain_modulus, double plane_strain_ratio) {
    return plane_strain_modulus * (1 - square(material_poisson_ratio(plane_strain_ratio)));
}

double material_poisson_ratio(double plane_strain_ratio) { return plane_strain_ratio / (1 + plane_strain_ratio); }

}  // namespace graincrack::fpz
