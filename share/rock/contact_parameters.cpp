#include "share/rock/contact_parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "share/base/toml_keys.hpp"

namespace graincrack {
namespace {

using Values = ContactValues<double>;
using Given = GivenContact;

/// The same for every rock and plane condition: zero.
double nothing(const Values& /*before*/, const Rock& /*rock*/, PlaneCondition /*plane*/) { return 0; }
/// A function of the rock and the plane condition alone.
template <double (*function)(const Rock&, PlaneCondition)>
double of_rock(const Values& /*before*/, const Rock& rock, PlaneCondition plane) {
    return function(rock, plane);
}

}  // namespace

std::span<const ContactParameter> all_contact_parameters() {
    using enum Dimension;
    static const std::array rows{
        ContactParameter{.quantity = {"contact_tensile_strength", stress, 0, 1e12, "tensile strength t_c of a contact", true},
                         .value = &Values::tensile_strength,
                         .given = &Given::tensile_strength,
                         .example = "24.15 MPa",
                         .usual = "2 K_IC/sqrt(pi dp), dp the mean edge (`graincrack-post fpz`)",
                         .every_law = true},
        ContactParameter{.quantity = {"contact_cohesion", stress, 0, 1e12, "cohesion c_c of a contact", true},
                         .value = &Values::cohesion,
                         .given = &Given::cohesion,
                         .example = "74.57 MPa",
                         .usual = "half the UCS",
                         .every_law = true},
        ContactParameter{.quantity = {"contact_friction_angle", angle, 0, 1.55, "friction angle phi_c of a contact"},
                         .value = &Values::friction_angle,
                         .given = &Given::friction_angle,
                         .example = "48.76 deg",
                         .usual = "0.7 times that of the rock; with the full angle grains interlock",
                         .every_law = true},
        ContactParameter{
            .quantity = {"contact_normal_stiffness", stiffness, 0, 1e19, "initial normal stiffness k_t of a contact", true},
            .value = &Values::normal_stiffness,
            .given = &Given::normal_stiffness,
            .example = "6.87e5 MPa/mm",
            .usual = "E / w_I (Eqs 3-5)",
            .every_law = true,
            .follows_plane = true,
            .derive = of_rock<fpz::normal_stiffness>},
        ContactParameter{
            .quantity = {"contact_shear_stiffness", stiffness, 0, 1e19, "initial shear stiffness k_s of a contact", true},
            .value = &Values::shear_stiffness,
            .given = &Given::shear_stiffness,
            .example = "6.98e4 MPa/mm",
            .usual = "G / w_II (Eqs 3-5)",
            .every_law = true,
            .follows_plane = true,
            .derive = of_rock<fpz::shear_stiffness>},
        ContactParameter{
            .quantity = {"fracture_energy", fracture_energy, 0, 1e9, "energy to open a unit of contact area fully", true},
            .value = &Values::fracture_energy,
            .given = &Given::fracture_energy,
            .example = "82.6 J/m2",
            .usual = "K_IC^2/E~ (mode-i)",
            .follows_plane = true,
            .derive = of_rock<fpz::mode_i_fracture_energy>},
        ContactParameter{.quantity = {"mode_ii_fracture_energy", fracture_energy, 0, 1e9,
                                      "energy to slide a unit of contact area apart", true},
                         .value = &Values::mode_ii_fracture_energy,
                         .given = &Given::mode_ii_fracture_energy,
                         .example = "330 J/m2",
                         .usual = "K_IIC^2/E~",
                         .follows_plane = true,
                         .derive = of_rock<fpz::mode_ii_fracture_energy>},
        ContactParameter{
            .quantity = {"contact_open_shear_strength", stress, 0, 1e12, "shear strength of a contact while it is open", true},
            .value = &Values::open_shear_strength,
            .given = &Given::open_shear_strength,
            .example = "7.7 MPa",
            .usual = "tc sqrt(ks/kt)",
            .derive = [](const Values& p, const Rock&,
                         PlaneCondition) { return p.tensile_strength * std::sqrt(p.shear_stiffness / p.normal_stiffness); }},
        ContactParameter{
            .quantity = {"contact_residual_tensile_strength", stress, 0, 1e12, "tensile strength of a failed contact"},
            .value = &Values::residual_tensile_strength,
            .given = &Given::residual_tensile_strength,
            .example = "0 MPa",
            .usual = "0",
            .derive = nothing},
        ContactParameter{.quantity = {"contact_residual_cohesion", stress, 0, 1e12, "cohesion of a failed contact"},
                         .value = &Values::residual_cohesion,
                         .given = &Given::residual_cohesion,
                         .example = "0 MPa",
                         .usual = "0",
                         .derive = nothing},
        ContactParameter{.quantity = {"contact_residual_friction_angle", angle, 0, 1.55, "friction angle of a failed contact"},
                         .value = &Values::residual_friction_angle,
                         .given = &Given::residual_friction_angle,
                         .example = "48.76 deg",
                         .usual = "friction_angle",
                         .derive = [](const Values& p, const Rock&, PlaneCondition) { return p.friction_angle; }},
    };
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
        std::optional<double>& to = given.*row.given;
        keys.push_back({row.key(), row.quantity, [&to](double value) { to = value; }, row.is_needed()});
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

}  // namespace graincrack
