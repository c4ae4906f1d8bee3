// What grains and contacts of each phase are made of.
#pragma once

#include <cstddef>
#include <vector>

#include "share/material.hpp"
#include "share/specimen.hpp"

namespace graincrack {

/// What the grains of a phase are made of.
struct Phase {
    double young_modulus = 0;  ///< Pa
    double poisson_ratio = 0;
    double density = 0;  ///< kg/m³
    friend bool operator==(const Phase&, const Phase&) = default;
};
inline Phase phase_of(const Rock& rock) { return {rock.young_modulus, rock.poisson_ratio, rock.density}; }

/// Properties by phase and by class.
struct Fabric {
    std::vector<Phase> phases;                ///< in the order of `Specimen::phase_names`
    std::vector<ContactParameters> contacts;  ///< by `contact_class`
};
/// All phases are the rock, all contacts alike.
inline Fabric uniform_fabric(const Rock& rock, const ContactParameters& contact, std::size_t n_phases) {
    return {std::vector<Phase>(n_phases, phase_of(rock)), std::vector<ContactParameters>(n_contact_classes(n_phases), contact)};
}

}  // namespace graincrack
