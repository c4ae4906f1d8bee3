// What grains and contacts of each phase are made of.
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

/// What the grains of a phase are made of.
struct Phase {
    double young_modulus = 0;  ///< Pa
    double poisson_ratio = 0;
    double density = 0;            ///< kg/m³
    double thermal_expansion = 0;  ///< 1/K; in every direction, or along the axis of its crystals at 0 K
    /// Expansion along and across the axis of its crystals in place of that, or where it changes with temperature, both or none;
    /// and a factor on the modulus, the same of all phases.
    TemperatureCurve along{}, across{}, softening{};
    [[nodiscard]] bool has_axis() const { return along != across; }
    [[nodiscard]] bool feels_temperature() const { return thermal_expansion != 0 || !along.empty() || !softening.empty(); }
    friend bool operator==(const Phase&, const Phase&) = default;
};
inline Phase phase_of(const Rock& rock) { return {rock.young_modulus, rock.poisson_ratio, rock.density}; }

/// The phases of a run without temperature: their expansion is no matter.
std::vector<Phase> without_expansion(const std::vector<Phase>& phases);

/// Angle of the axis of the crystal of each grain [g] in the plane, counter-clockwise from x, rad: uniform in (0, π), by hashes
/// of the seed of the specimen and the number of the crystal (`mixed_bits`), so that it is the same in every run of the specimen.
std::vector<double> crystal_axes(const Specimen& specimen);

/// Properties by phase and by class.
struct Fabric {
    std::vector<Phase> phases;                ///< in the order of `Specimen::phase_names`
    std::vector<ContactParameters> contacts;  ///< by `contact_class`, then by class of flaws
    /// Whether temperature does something to a phase; whether crystals of a phase have an axis.
    [[nodiscard]] bool feels_temperature() const {
        return std::any_of(phases.begin(), phases.end(), [](auto& p) { return p.feels_temperature(); });
    }
    [[nodiscard]] bool has_axes() const {
        return std::any_of(phases.begin(), phases.end(), [](auto& p) { return p.has_axis(); });
    }
};
/// \throws InputError unless a material describes the phases of a specimen and no others; without phases all grains are the rock
void require_same_phases(const Material& material, const std::vector<std::string>& phase_names);

/// Properties of the phases of a specimen and of their contacts, by the fabric of a material. A contact has the values of
/// [contact]; where a phase gives its side others, the mean or the least of both sides; then those of its pair; then its factors.
/// Stiffnesses are those of the rock, or, by `StiffnessRule::sides`, times the harmonic mean of the two moduli over the rock's
/// unless they are given. Energies never follow moduli.
/// \param phase_names of the specimen
/// \throws InputError if the material describes phases and they are not those of the specimen
Fabric fabric_of(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice,
                 const std::vector<std::string>& phase_names);

/// Parameters of a class of flaws: those of [contact], and where [flaws.NAME] has others, those.
/// \throws InputError naming the table if the material has none for the class
ContactParameters flaw_contact(const Material& material, PlaneCondition plane, const std::optional<FractureEnergyChoice>& choice,
                               const std::string& flaw_name);

/// Share of the compliance of a crystal that the contacts within it add, however many they are, unless the material says how
/// stiff they are.
inline constexpr double compliance_within_crystals = 0.01;
/// Length of the contacts within the crystals of a phase over the area of the phase, 1/m. \param class_name "within_quartz"
double length_within_crystals(const Specimen& specimen, const std::string& class_name);
/// Parameters of the contacts within the crystals of a phase: those of contacts between two crystals of the phase, or, where
/// the material has the table [flaws.within_PHASE], those of [contact]; then the factors of [pairs.within]; then the values of
/// the table. Their stiffnesses are those of `fpz::stiffness_of_added_compliance`, times the factors, unless the table gives
/// them: a crystal is as stiff as its mineral. \param class_name "within_quartz" \param length_per_area as of
/// `length_within_crystals`
ContactParameters contact_within_crystals(const Material& material, PlaneCondition plane,
                                          const std::optional<FractureEnergyChoice>& choice, const std::string& class_name,
                                          double length_per_area);

/// All phases are the rock, all contacts alike.
inline Fabric uniform_fabric(const Rock& rock, const ContactParameters& contact, std::size_t n_phases) {
    return {std::vector<Phase>(n_phases, phase_of(rock)), std::vector<ContactParameters>(n_contact_classes(n_phases), contact)};
}

}  // namespace graincrack
