// Augig granite (Kazerani & Zhao 2014, Tables 2 and 3) as the solver's tests use it, without reading a file.
#pragma once

#include <numbers>

#include "share/rock/material.hpp"

namespace graincrack::test {

inline constexpr double MPa = 1e6;
inline constexpr double mm = 1e-3;
inline constexpr double degree = std::numbers::pi / 180;

inline Material augig_granite() {
    Material m;
    m.name = "Augig granite";
    m.rock = {25.8e9, 0.23, 2650, 1.5e6, 3.0e6, 8.8e6};
    m.contact.tensile_strength = 24.15 * MPa;
    m.contact.cohesion = 74.57 * MPa;
    m.contact.friction_angle = 48.76 * degree;
    m.platen_friction_angle = 5 * degree;
    return m;
}
inline ContactParameters augig_contact(PlaneCondition plane = PlaneCondition::strain,
                                       FractureEnergyChoice::Kind energy = FractureEnergyChoice::Kind::mixed) {
    return contact_parameters(augig_granite(), plane, FractureEnergyChoice{energy, 0});
}
/// Contacts of 14 MPa, as weak as a strength that depends on pressure lets them be: their cohesion softens under compression.
inline ContactParameters weak_contact(double mode_ii_fracture_energy = 330) {
    Material material = augig_granite();
    material.contact.cohesion = 14 * MPa;
    material.contact.mode_ii_fracture_energy = mode_ii_fracture_energy;
    return contact_parameters(material, PlaneCondition::strain, FractureEnergyChoice{FractureEnergyChoice::Kind::mode_i, 0});
}

/// All strengths times `factor`, all fracture energies times its square: similar curves.
inline ContactParameters scaled_contact(ContactParameters c, double factor) {
    for (double* value : {&c.tensile_strength, &c.cohesion, &c.open_shear_strength, &c.residual_tensile_strength,
                          &c.residual_cohesion, &c.critical_opening, &c.critical_sliding, &c.ultimate_opening}) {
        *value *= factor;
    }
    c.fracture_energy *= factor * factor;
    c.mode_ii_fracture_energy *= factor * factor;
    return c;
}

}  // namespace graincrack::test
