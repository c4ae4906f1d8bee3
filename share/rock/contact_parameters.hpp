// The table of contact parameters. A parameter is a member of `ContactValues` and a row of `all_contact_parameters`; the options
// of the solver, the keys of materials and their template, the attributes of run files, restarts, comparisons of runs, reports
// and calibrations take it from there. The laws that read it say so (`LawDescription` in solver/law/types.hpp).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/rock/fracture_process_zone.hpp"

namespace graincrack {

struct TomlKey;

/// A value for each contact parameter, SI units, in the order of the table.
template <class Value>
struct ContactValues {
    Value tensile_strength{};           ///< tc, Pa
    Value cohesion{};                   ///< cc, Pa
    Value friction_angle{};             ///< φc, rad
    Value normal_stiffness{};           ///< kt, Pa/m
    Value shear_stiffness{};            ///< ks, Pa/m
    Value fracture_energy{};            ///< Gf, or G_I where there is a G_II, J/m²
    Value mode_ii_fracture_energy{};    ///< G_II, J/m²
    Value open_shear_strength{};        ///< while open, Pa
    Value residual_tensile_strength{};  ///< after failure, Pa
    Value residual_cohesion{};          ///< after failure, Pa
    Value residual_friction_angle{};    ///< after failure, rad
    Value bridging_strength{};          ///< σb, of what still holds an opened contact, Pa; 0: nothing does
    Value bridging_energy{};            ///< Gb, that it takes to open it fully, J/m²
    Value maximum_closure{};            ///< from which on a joint is shut, m; 0: it never is
    Value shut_stiffness{};             ///< normal stiffness beyond, Pa/m
    Value wear_slip{};                  ///< w, over which fresh faces lose the friction that worn ones lack, m; 0: at once
};
using ContactValue = double ContactValues<double>::*;

/// What a material, a part of it or options give. What is unset follows from the rock and the other values.
using GivenContact = ContactValues<std::optional<double>>;

/// All parameters of a contact: what a law needs.
struct ContactParameters : ContactValues<double> {
    double critical_opening = 0;  ///< δct, m (Eq 8)
    double critical_sliding = 0;  ///< δcs, m (Eq 11)
    double ultimate_opening = 0;  ///< δut, m (Eq 14); below δct if Gf is too small for a law with this branch
};

/// A row of the table.
struct ContactParameter {
    Quantity quantity;  ///< its name is that of the attribute in run files
    ContactValue value;
    std::optional<double> GivenContact::*given;
    const char* example;         ///< for the template of a material
    const char* usual;           ///< in words: what it is unless given; of a needed one its first guess
    bool every_law = false;      ///< every law reads it; others are read by the laws that name them
    bool follows_plane = false;  ///< unless given it depends on the plane condition
    bool may_lack = false;       ///< files from before it have none; it is 0 there
    /// Its value unless given, from the rows before it; null where a material needs to give it.
    double (*derive)(const ContactValues<double>& before, const Rock& rock, PlaneCondition plane) = nullptr;

    [[nodiscard]] std::string key() const;     ///< in [contact]: "cohesion"
    [[nodiscard]] std::string option() const;  ///< of the solver: "--contact-cohesion"
    [[nodiscard]] bool is_needed() const { return derive == nullptr; }
};

std::span<const ContactParameter> all_contact_parameters();
/// The row of a value, as &ContactParameters::cohesion.
const ContactParameter& contact_parameter(ContactValue value);

/// The keys of a table that gives contact parameters, bound to `given`, which must stay where it is.
std::vector<TomlKey> contact_keys(GivenContact& given);
/// `given`, and where it has no value that of `base`.
GivenContact overlay(GivenContact given, const GivenContact& base);

/// All parameters of a contact between grains of a rock (Eqs 3–5, 8, 11, 14). A needed value that is not given is 0. Each law
/// checks for itself whether the fracture energies suffice for its curves.
ContactParameters derived_contact(const GivenContact& given, const Rock& rock, PlaneCondition plane);
/// Bridges have a strength and an energy or neither, and hold less than the contact did before it cracked.
/// \param where names the contacts \throws InputError
void require_sound_bridges(const ContactParameters& contact, const std::string& where);

}  // namespace graincrack
