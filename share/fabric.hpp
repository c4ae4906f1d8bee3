// What grains and contacts of each phase are made of.
//
// Every grain belongs to a phase of the specimen (/grains/phase), every contact to the class of its two phases. A specimen of p
// phases has p (p + 1)/2 classes, in the order 00, 01, 11, 02, 12, 22, …
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "share/material.hpp"

namespace graincrack {

/// What the grains of a phase are made of.
struct Phase {
    double young_modulus = 0;  ///< Pa
    double poisson_ratio = 0;
    double density = 0;  ///< kg/m³
    friend bool operator==(const Phase&, const Phase&) = default;
};
inline Phase phase_of(const Rock& rock) { return {rock.young_modulus, rock.poisson_ratio, rock.density}; }

/// The class of a contact between grains of two phases, in either order.
constexpr std::size_t contact_class(std::size_t phase, std::size_t other) {
    const std::size_t high = std::max(phase, other);
    return high * (high + 1) / 2 + std::min(phase, other);
}
constexpr std::size_t n_contact_classes(std::size_t n_phases) { return n_phases * (n_phases + 1) / 2; }

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
