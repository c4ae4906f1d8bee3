#include "post/calibrate/parameter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace graincrack::calibrate {

namespace {

constexpr double GPa = 1e9;
constexpr double MPa = 1e6;
constexpr double degree = std::numbers::pi / 180;

double laboratory(const Material& rock, const std::string& key) { return rock.laboratory.at(key); }

/// tc √(ks/kt), the law's own shear strength of open contacts: the plane condition changes kt and ks alike.
double usual_open_shear_strength(const Material& rock, const Point& point) {
    Material material = material_at(rock, point);
    material.contact.open_shear_strength.reset();
    return contact_parameters(material, PlaneCondition::strain, std::nullopt).open_shear_strength;
}

}  // namespace

const std::array<ParameterRow, n_parameters>& parameters() {
    using P = Parameter;
    static const std::array<ParameterRow, n_parameters> table{{
        {P::young_modulus, "rock.young_modulus", "grain_young_modulus_GPa", "E", "E of the grains", "GPa", GPa, "young_modulus",
         "E of the rock", "half to twice the first guess"},
        {P::poisson_ratio, "rock.poisson_ratio", "grain_poisson_ratio", "nu", "ν of the grains", "", 1, "poisson_ratio",
         "ν of the rock", "0.01 to 0.45"},
        {P::tensile_strength, "contact.tensile_strength", "contact_tensile_strength_MPa", "tc", "tc", "MPa", MPa,
         "tensile_strength", "2 K_IC/√(π dp), Eq 40", "0.3 to 3 times the first guess",
         &contact_parameter(&ContactParameters::tensile_strength)},
        {P::cohesion, "contact.cohesion", "contact_cohesion_MPa", "cc", "cc", "MPa", MPa,
         "compressive_strength, confined_strength", "UCS/2", "0.05 to 3 UCS", &contact_parameter(&ContactParameters::cohesion)},
        {P::friction_angle, "contact.friction_angle", "contact_friction_angle_deg", "phic", "φc", "°", degree,
         "confined_strength", "0.7 φ: specimens are rougher than their contacts", "5° to 75°",
         &contact_parameter(&ContactParameters::friction_angle)},
        {P::fracture_energy, "contact.fracture_energy", "contact_fracture_energy_J/m2", "gf", "Gf", "J/m²", 1, "tensile_strength",
         "K_IC²/Ẽ, plane stress", "a tenth of the first guess to Eq 32, plane stress",
         &contact_parameter(&ContactParameters::fracture_energy)},
        {P::open_shear_strength, "contact.open_shear_strength", "contact_open_shear_strength_MPa", "os",
         "shear strength of open contacts", "MPa", MPa, "tensile_strength", "tc √(ks/kt)", "a fifth of the first guess to cc",
         &contact_parameter(&ContactParameters::open_shear_strength)},
    }};
    return table;
}

const ParameterRow& row_of(Parameter parameter) { return parameters()[static_cast<std::size_t>(parameter)]; }

std::string unit_in_files(const ParameterRow& row) {
    const std::string column = row.column;
    return row.unit[0] == '\0' ? "" : column.substr(column.rfind('_') + 1);
}

Point Point::with(Parameter parameter, double value) const {
    Point changed = *this;
    changed[parameter] = rounded(parameter, value);
    return changed;
}

double rounded(Parameter parameter, double value) {
    const double si = row_of(parameter).si;
    return std::strtod(fmt::format("{:.6g}", value / si).c_str(), nullptr) * si;
}

Material material_at(const Material& rock, const Point& point) {
    Material material = rock;
    if (point[Parameter::young_modulus]) material.rock.young_modulus = *point[Parameter::young_modulus];
    if (point[Parameter::poisson_ratio]) material.rock.poisson_ratio = *point[Parameter::poisson_ratio];
    for (const ParameterRow& row : parameters()) {
        if (row.contact != nullptr && point[row.parameter]) material.contact.*row.contact->given = point[row.parameter];
    }
    return material;
}

std::array<double, n_parameters> effective_values(const Material& rock, const Point& point, PlaneCondition plane) {
    Material bare;  // without names and laboratory values, whose copies take most of the time of a decision
    bare.rock = rock.rock;
    bare.contact = rock.contact;
    const Material material = material_at(bare, point);
    const ContactParameters contact = contact_parameters(material, plane, std::nullopt);
    std::array<double, n_parameters> values{material.rock.young_modulus, material.rock.poisson_ratio};
    for (const ParameterRow& row : parameters()) {
        if (row.contact != nullptr) values[static_cast<std::size_t>(row.parameter)] = contact.*row.contact->value;
    }
    return values;
}

double first_guess(Parameter parameter, const Material& rock, const Point& point, double edge) {
    switch (parameter) {
        case Parameter::young_modulus: return laboratory(rock, "young_modulus");
        case Parameter::poisson_ratio: return laboratory(rock, "poisson_ratio");
        case Parameter::tensile_strength: return fpz::contact_tensile_strength_from_toughness(rock.rock.mode_i_toughness, edge);
        case Parameter::cohesion: return 0.5 * laboratory(rock, "compressive_strength");
        case Parameter::friction_angle: return 0.7 * laboratory(rock, "friction_angle");
        case Parameter::fracture_energy: {
            Material own = material_at(rock, point);
            own.contact.fracture_energy.reset();
            return contact_parameters(own, PlaneCondition::stress, std::nullopt).fracture_energy;
        }
        case Parameter::open_shear_strength: return usual_open_shear_strength(rock, point);
    }
    return 0;
}

Range range_of(Parameter parameter, const Material& rock, const Point& point, double edge) {
    const double guess = first_guess(parameter, rock, point, edge);
    switch (parameter) {
        case Parameter::young_modulus: return {0.5 * guess, 2 * guess};
        case Parameter::poisson_ratio: return {0.01, 0.45};
        case Parameter::tensile_strength: return {0.3 * guess, 3 * guess};
        case Parameter::cohesion: return {0.1 * guess, 6 * guess};
        case Parameter::friction_angle: return {5 * degree, 75 * degree};
        case Parameter::fracture_energy: {
            const Rock grains = material_at(rock, point).rock;
            return {0.1 * guess, fpz::mixed_mode_fracture_energy(grains, PlaneCondition::stress)};
        }
        case Parameter::open_shear_strength:
            return {0.2 * guess, point[Parameter::cohesion].value_or(rock.contact.cohesion.value_or(0))};
    }
    return {};
}

std::string label_of(Parameter parameter, double value) {
    const ParameterRow& row = row_of(parameter);
    return fmt::format("{:.4g}{}{}", value / row.si, row.unit[0] == '\0' ? "" : " ", row.unit);
}

std::string label_of(const Point& point) {
    std::string text;
    for (const ParameterRow& row : parameters()) {
        if (!point[row.parameter]) continue;
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", row.symbol, label_of(row.parameter, *point[row.parameter]));
    }
    return text;
}

}  // namespace graincrack::calibrate
