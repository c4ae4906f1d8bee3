// Properties of the grains and contacts of each phase.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"
#include "share/rock/temperature_curve.hpp"

namespace graincrack {

/// Properties of the grains of a phase.
struct Phase {
    double young_modulus = 0;  ///< Pa
    double poisson_ratio = 0;
    double density = 0;            ///< kg/m³
    double thermal_expansion = 0;  ///< 1/K; isotropic, or along the axis of its crystals at 0 K
    /// Expansion (1/K) by temperature along and across the axis of its crystals, both or none, which replaces
    /// `thermal_expansion`; and the modulus_factor E(T)/E0, the same for all phases.
    TemperatureCurve along{}, across{}, softening{};
    [[nodiscard]] bool has_axis() const { return along != across; }
    [[nodiscard]] bool feels_temperature() const { return thermal_expansion != 0 || !along.empty() || !softening.empty(); }
    friend bool operator==(const Phase&, const Phase&) = default;
};
inline Phase phase_of(const Rock& rock) { return {rock.young_modulus, rock.poisson_ratio, rock.density}; }

/// The phases of a run without temperature, which does not use their expansion.
std::vector<Phase> without_expansion(const std::vector<Phase>& phases);

/// Angle of the crystal axis of each grain [g] in the plane, counter-clockwise from x, rad. Angles are uniform in (0, π) and
/// hashes of the specimen's seed and the crystal's number (`mixed_bits`), so that all runs of a specimen have the same.
std::vector<double> crystal_axes(const Specimen& specimen);

/// Properties by phase and by class.
struct Fabric {
    std::vector<Phase> phases;                ///< in the order of `Specimen::phase_names`
    std::vector<ContactParameters> contacts;  ///< by `contact_class`, then by class of flaws
    /// True if temperature affects a phase; true if crystals of a phase have an axis.
    [[nodiscard]] bool feels_temperature() const {
        return std::any_of(phases.begin(), phases.end(), [](auto& p) { return p.feels_temperature(); });
    }
    [[nodiscard]] bool has_axes() const {
        return std::any_of(phases.begin(), phases.end(), [](auto& p) { return p.has_axis(); });
    }
};
/// Checks the phases of a material, without which all grains are the rock. \throws InputError unless they are the specimen's
void require_same_phases(const Material& material, const std::vector<std::string>& phase_names);

/// Properties of the phases of a specimen and of their contacts, by the fabric of a material. A contact has the values of
/// [contact]; if a phase overrides some for its side, the mean or the smaller of both sides; then those of its pair; then its
/// factors. Stiffnesses are those of the rock or, with `StiffnessRule::sides`, times the harmonic mean of the two moduli over the
/// rock's, unless they are given. Energies do not depend on moduli.
/// \param phase_names of the specimen
/// \throws InputError if the material describes phases and they are not those of the specimen
Fabric fabric_of(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice,
                 const std::vector<std::string>& phase_names);

/// Parameters of a class of flaws: those of [contact], overridden by [flaws.NAME].
/// \throws InputError naming the table if the material has none for the class
ContactParameters flaw_contact(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice,
                               const std::string& flaw_name);

/// Fraction of the compliance of a crystal that all contacts within it add, unless the material gives their stiffness. Chosen,
/// not fitted.
inline constexpr double compliance_within_crystals = 0.01;
/// Length of the contacts within the crystals of a phase over the area of the phase, 1/m. \param class_name "within_quartz"
double length_within_crystals(const Specimen& specimen, const std::string& class_name);
/// Parameters of the contacts within the crystals of a phase. They are those of contacts between two crystals of the phase or, if
/// the material has the table [flaws.within_PHASE], those of [contact]; then come the factors of [pairs.within] and the values of
/// the table. Stiffnesses are those of `fpz::stiffness_of_added_compliance` times the factors unless the table gives them, so
/// that a crystal is nearly as stiff as its mineral. \param class_name "within_quartz" \param length_per_area see
/// `length_within_crystals`
ContactParameters contact_within_crystals(const Material& material, PlaneCondition plane,
                                          const std::optional<FractureEnergyChoice>& choice, const std::string& class_name,
                                          double length_per_area);

/// A fabric in which all phases are the rock and all contacts are alike.
inline Fabric uniform_fabric(const Rock& rock, const ContactParameters& contact, std::size_t n_phases) {
    return {std::vector<Phase>(n_phases, phase_of(rock)), std::vector<ContactParameters>(n_contact_classes(n_phases), contact)};
}

}  // namespace graincrack
