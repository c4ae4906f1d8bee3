#include "post/calibrate/elasticity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "share/error.hpp"

namespace graincrack::calibrate {

namespace {

/// Plane strain, as the tests of rectangles.
fpz::AssemblageModuli assemblage(const Material& material, double contact_length_per_area) {
    const ContactParameters contact = contact_parameters(material, PlaneCondition::strain, std::nullopt);
    return fpz::assemblage_moduli(material.rock, PlaneCondition::strain, contact.normal_stiffness, contact.shear_stiffness,
                                  contact_length_per_area);
}

/// Sv of 1/E' = 1/E + Sv (3/(8 kt) + 1/(8 ks)), in plane values.
double contact_length_per_area(const Material& material, const Elasticity& predicted) {
    const double of_grains = assemblage(material, 0).plane_young_modulus;
    const double of_one = assemblage(material, 1).plane_young_modulus;
    const double plane = predicted.young_modulus / (1 - predicted.poisson_ratio * predicted.poisson_ratio);
    const double length = (1 / plane - 1 / of_grains) / (1 / of_one - 1 / of_grains);
    if (length > 0) return length;
    throw InputError(
        fmt::format("elasticity: predicted E {:.4g} GPa of the assemblage is not below E {:.4g} GPa of its grains; the "
                    "moduli do not belong to this material",
                    predicted.young_modulus * 1e-9, material.rock.young_modulus * 1e-9));
}

}  // namespace

Elasticity grains_for(const Material& grains, const Elasticity& measured, const Elasticity& predicted, const Elasticity& wanted) {
    const double length = contact_length_per_area(grains, predicted);
    Material material = grains;
    double& e = material.rock.young_modulus;
    double& nu = material.rock.poisson_ratio;
    for (int i = 0; i < 200; ++i) {
        const fpz::AssemblageModuli now = assemblage(material, length);
        e *= wanted.young_modulus / (now.young_modulus * measured.young_modulus / predicted.young_modulus);
        // Half of each correction: the full one overshoots where contacts are soft.
        nu += 0.5 * (wanted.poisson_ratio - (now.poisson_ratio + measured.poisson_ratio - predicted.poisson_ratio));
        nu = std::clamp(nu, 0.0, 0.49);
    }
    return {e, nu};
}

}  // namespace graincrack::calibrate
