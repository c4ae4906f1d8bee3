#include "share/rock/contact_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "share/base/error.hpp"
#include "share/base/toml_table.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

using Values = ContactValues<double>;
using Given = GivenContact;

/// The same for every rock and plane condition: zero.
double nothing(const Values& /*before*/, const Rock& /*rock*/, PlaneCondition /*plane*/) { return 0; }
double open_shear_strength(const Values& p, const Rock& /*rock*/, PlaneCondition /*plane*/) {
    return p.tensile_strength * std::sqrt(p.shear_stiffness / p.normal_stiffness);
}
double friction_angle(const Values& p, const Rock& /*rock*/, PlaneCondition /*plane*/) { return p.friction_angle; }
/// A function of the rock and the plane condition alone.
template <double (*function)(const Rock&, PlaneCondition)>
double of_rock(const Values& /*before*/, const Rock& rock, PlaneCondition plane) {
    return function(rock, plane);
}

}  // namespace

std::span<const ContactParameter> all_contact_parameters() {
    using enum Dimension;
    // clang-format off
    static const std::array<ContactParameter, 16> rows{{
        // quantity: name, dimension, bounds, meaning, open below; members
        //     example, usual, every law, follows the plane, files may lack it, derivation
        {{"contact_tensile_strength", stress, 0, 1e12, "tensile strength t_c of a contact", true}, &Values::tensile_strength, &Given::tensile_strength,
            "24.15 MPa", "2 K_IC/sqrt(pi dp), dp the mean edge (`graincrack-post fpz`)", true, false, false, nullptr},
        {{"contact_cohesion", stress, 0, 1e12, "cohesion c_c of a contact", true}, &Values::cohesion, &Given::cohesion,
            "74.57 MPa", "half the UCS", true, false, false, nullptr},
        {{"contact_friction_angle", angle, 0, 1.55, "friction angle phi_c of a contact"}, &Values::friction_angle, &Given::friction_angle,
            "48.76 deg", "0.7 times that of the rock; with the full angle grains interlock", true, false, false, nullptr},
        {{"contact_normal_stiffness", stiffness, 0, 1e19, "initial normal stiffness k_t of a contact", true}, &Values::normal_stiffness, &Given::normal_stiffness,
            "6.87e5 MPa/mm", "E / w_I (Eqs 3-5)", true, true, false, of_rock<fpz::normal_stiffness>},
        {{"contact_shear_stiffness", stiffness, 0, 1e19, "initial shear stiffness k_s of a contact", true}, &Values::shear_stiffness, &Given::shear_stiffness,
            "6.98e4 MPa/mm", "G / w_II (Eqs 3-5)", true, true, false, of_rock<fpz::shear_stiffness>},
        {{"fracture_energy", fracture_energy, 0, 1e9, "energy to open a unit of contact area fully", true}, &Values::fracture_energy, &Given::fracture_energy,
            "82.6 J/m2", "K_IC^2/E~ (mode-i)", false, true, false, of_rock<fpz::mode_i_fracture_energy>},
        {{"mode_ii_fracture_energy", fracture_energy, 0, 1e9, "energy to slide a unit of contact area apart", true}, &Values::mode_ii_fracture_energy, &Given::mode_ii_fracture_energy,
            "330 J/m2", "K_IIC^2/E~", false, true, false, of_rock<fpz::mode_ii_fracture_energy>},
        {{"contact_open_shear_strength", stress, 0, 1e12, "shear strength of a contact while it is open", true}, &Values::open_shear_strength, &Given::open_shear_strength,
            "7.7 MPa", "tc sqrt(ks/kt)", false, false, false, open_shear_strength},
        {{"contact_residual_tensile_strength", stress, 0, 1e12, "tensile strength of a failed contact"}, &Values::residual_tensile_strength, &Given::residual_tensile_strength,
            "0 MPa", "0", false, false, false, nothing},
        {{"contact_residual_cohesion", stress, 0, 1e12, "cohesion of a failed contact"}, &Values::residual_cohesion, &Given::residual_cohesion,
            "0 MPa", "0", false, false, false, nothing},
        {{"contact_residual_friction_angle", angle, 0, 1.55, "friction angle of a failed contact"}, &Values::residual_friction_angle, &Given::residual_friction_angle,
            "48.76 deg", "friction_angle", false, false, false, friction_angle},
        {{"contact_bridging_strength", stress, 0, 1e12, "stress that bridges hold in a contact that has cracked open"}, &Values::bridging_strength, &Given::bridging_strength,
            "5 MPa", "0, no bridges", false, false, true, nothing},
        {{"contact_bridging_energy", fracture_energy, 0, 1e9, "energy to pull the bridges of a unit of contact area apart"}, &Values::bridging_energy, &Given::bridging_energy,
            "80 J/m2", "0, no bridges", false, true, true, nothing},
        {{"contact_maximum_closure", length, 0, 1, "closure from which on a joint is shut"}, &Values::maximum_closure, &Given::maximum_closure,
            "50 um", "0, never shut", false, false, true, nothing},
        {{"contact_shut_stiffness", stiffness, 0, 1e19, "normal stiffness of a joint beyond its maximum closure", true}, &Values::shut_stiffness, &Given::shut_stiffness,
            "6.87e5 MPa/mm", "E / w_I (Eqs 3-5)", false, true, true, of_rock<fpz::normal_stiffness>},
        {{"contact_wear_slip", length, 0, 1, "slip over which the friction of a contact without cohesion falls to that of worn faces"}, &Values::wear_slip, &Given::wear_slip,
            "0.2 mm", "0, worn at once", false, false, true, nothing},
    }};
    // clang-format on
    return rows;
}

std::string ContactParameter::key() const {
    constexpr std::string_view prefix = "contact_";
    return std::string(quantity.name.starts_with(prefix) ? quantity.name.substr(prefix.size()) : quantity.name);
}

std::string ContactParameter::option() const {
    std::string option = "--" + std::string(quantity.name);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

const ContactParameter& contact_parameter(ContactValue value) {
    const auto rows = all_contact_parameters();
    return *std::find_if(rows.begin(), rows.end(), [&](const ContactParameter& row) { return row.value == value; });
}

std::vector<TomlKey> contact_keys(GivenContact& given) {
    std::vector<TomlKey> keys;
    for (const ContactParameter& row : all_contact_parameters()) {
        keys.push_back({row.key(), row.quantity, to(given.*row.given), row.is_needed()});
    }
    return keys;
}

GivenContact overlay(GivenContact given, const GivenContact& base) {
    for (const ContactParameter& row : all_contact_parameters()) {
        if (!(given.*row.given)) given.*row.given = base.*row.given;
    }
    return given;
}

ContactParameters derived_contact(const GivenContact& given, const Rock& rock, PlaneCondition plane) {
    ContactParameters p;
    for (const ContactParameter& row : all_contact_parameters()) {
        const std::optional<double>& value = given.*row.given;
        p.*row.value = value ? *value : row.derive != nullptr ? row.derive(p, rock, plane) : 0;
    }
    p.critical_opening = fpz::critical_displacement(p.tensile_strength, p.normal_stiffness);
    p.critical_sliding = fpz::critical_displacement(p.cohesion, p.shear_stiffness);
    p.ultimate_opening = fpz::ultimate_displacement(p.fracture_energy, p.tensile_strength, p.critical_opening);
    return p;
}

void require_sound_bridges(const ContactParameters& contact, const std::string& where) {
    const auto text = [](double value, ContactValue key) {
        const Quantity& quantity = contact_parameter(key).quantity;
        return fmt::format("{} is {}", contact_parameter(key).key(), format_quantity(value, quantity.dimension));
    };
    const std::string strength = text(contact.bridging_strength, &ContactParameters::bridging_strength);
    if ((contact.bridging_strength > 0) != (contact.bridging_energy > 0)) {
        throw InputError(fmt::format("{}: {} and {}; bridges need both, a contact without bridges has neither", where, strength,
                                     text(contact.bridging_energy, &ContactParameters::bridging_energy)));
    }
    if (contact.bridging_strength > 0 && contact.bridging_strength >= contact.tensile_strength) {
        throw InputError(fmt::format("{}: {} and {}; bridges hold less than the contact did before it cracked", where, strength,
                                     text(contact.tensile_strength, &ContactParameters::tensile_strength)));
    }
}

}  // namespace graincrack
