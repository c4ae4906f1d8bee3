#include "solver/contact_options.hpp"

#include <fmt/format.h>

#include <vector>

#include "share/error.hpp"
#include "share/units.hpp"

namespace graincrack {
namespace {

void add_parameters(CLI::App& command, ContactOptions& o) {
    add_quantity(command, "--contact-normal-stiffness", o.normal_stiffness, quantity::contact_normal_stiffness,
                 "normal stiffness kt of the contacts instead of the derived one");
    add_quantity(command, "--contact-shear-stiffness", o.shear_stiffness, quantity::contact_shear_stiffness,
                 "shear stiffness ks of the contacts instead of the derived one");
    add_quantity(command, "--contact-tensile-strength", o.tensile_strength, quantity::contact_tensile_strength,
                 "tensile strength tc of the contacts instead of the material's");
    add_quantity(command, "--contact-cohesion", o.cohesion, quantity::contact_cohesion,
                 "cohesion cc of the contacts instead of the material's");
    add_quantity(command, "--contact-friction-angle", o.friction_angle, quantity::contact_friction_angle,
                 "friction angle of the contacts instead of the material's");
    add_quantity(command, "--contact-open-shear-strength", o.open_shear_strength, quantity::contact_open_shear_strength,
                 "consistent, cohesive-frictional: shear strength while open; tc sqrt(ks/kt) unless given");
    add_quantity(command, "--contact-residual-tensile-strength", o.residual_tensile_strength,
                 quantity::contact_residual_tensile_strength, "coulomb-slip: tensile strength after failure; 0 unless given");
    add_quantity(command, "--contact-residual-cohesion", o.residual_cohesion, quantity::contact_residual_cohesion,
                 "coulomb-slip: cohesion after failure; 0 unless given");
    add_quantity(
        command, "--contact-residual-friction-angle", o.residual_friction_angle, quantity::contact_residual_friction_angle,
        "coulomb-slip, combined, cohesive-frictional: friction angle when cohesion is lost; that of the contacts unless given");
    add_fracture_energy(
        command, o.fracture_energy,
        "fracture energy of the contacts: mixed (Eq 32), mode-i (K_IC^2/E~) or a value; mode-i unless the material has one");
    add_quantity(command, "--mode-ii-fracture-energy", o.mode_ii_fracture_energy, quantity::mode_ii_fracture_energy,
                 "combined, cohesive-frictional: fracture energy in sliding; K_IIC^2/E~ unless given");
}

/// Refuses an option that is given and that the law has no use for.
void require_use(bool is_given, const char* option, LawVariant law, bool LawDescription::*uses) {
    if (!is_given || description_of(law).*uses) {
        return;
    }
    std::string others;
    for (const LawDescription& other : all_contact_laws()) {
        if (other.*uses) {
            others += (others.empty() ? "" : ", ") + std::string(other.name);
        }
    }
    throw UsageError(fmt::format("{}: the contact law {} does not use it; leave it out, or choose one that does: {}", option,
                                 name_of(law), others));
}

void require_energy(const char* option, double value, double least, LawVariant law) {
    if (!(value >= least)) {
        throw UsageError(fmt::format("{}: {} is less than a contact of the law {} takes to its peak; at least {} J/m2 fits",
                                     option, format_quantity(value, Dimension::fracture_energy), name_of(law),
                                     format_number(least, 4)));
    }
}

void check_use(const ContactOptions& o) {
    const auto residual = &LawDescription::residual_strength;
    require_use(o.coupling == Coupling::none, "--coupling none", o.law, &LawDescription::coupling);
    require_use(o.fracture_energy.has_value(), "--fracture-energy", o.law, &LawDescription::fracture_energy);
    require_use(o.mode_ii_fracture_energy.has_value(), "--mode-ii-fracture-energy", o.law,
                &LawDescription::mode_ii_fracture_energy);
    require_use(o.open_shear_strength.has_value(), "--contact-open-shear-strength", o.law, &LawDescription::open_shear_strength);
    require_use(o.residual_tensile_strength.has_value(), "--contact-residual-tensile-strength", o.law, residual);
    require_use(o.residual_cohesion.has_value(), "--contact-residual-cohesion", o.law, residual);
    require_use(o.residual_friction_angle.has_value(), "--contact-residual-friction-angle", o.law,
                &LawDescription::residual_friction);
    const bool mixed = o.fracture_energy && o.fracture_energy->kind == FractureEnergyChoice::Kind::mixed;
    if (mixed && description_of(o.law).mode_ii_fracture_energy) {
        throw UsageError(fmt::format("--fracture-energy: the contact law {} has an energy for each mode; mode-i or a value fits",
                                     name_of(o.law)));
    }
}

void check_energies(const ContactParameters& p, LawVariant law) {
    const FractureEnergies least = min_fracture_energies(make_contact_law(p, law, Coupling::full));
    require_energy("--fracture-energy", p.fracture_energy, least.opening, law);
    require_energy("--mode-ii-fracture-energy", p.mode_ii_fracture_energy, least.sliding, law);
}

Material material_of(const ContactOptions& o) {
    Material material = read_material(o.material);
    ContactMaterial& contact = material.contact;
    const auto replace = [](auto& value, const auto& given) {
        if (given) value = *given;
    };
    replace(contact.normal_stiffness, o.normal_stiffness);
    replace(contact.shear_stiffness, o.shear_stiffness);
    replace(contact.tensile_strength, o.tensile_strength);
    replace(contact.cohesion, o.cohesion);
    replace(contact.friction_angle, o.friction_angle);
    replace(contact.open_shear_strength, o.open_shear_strength);
    replace(contact.residual_tensile_strength, o.residual_tensile_strength);
    replace(contact.residual_cohesion, o.residual_cohesion);
    replace(contact.residual_friction_angle, o.residual_friction_angle);
    replace(contact.mode_ii_fracture_energy, o.mode_ii_fracture_energy);
    return material;
}

}  // namespace

void add_contact_options(CLI::App& command, ContactOptions& o) {
    command.add_option("--material", o.material, "material: a name of share/materials or a TOML file")
        ->required()
        ->type_name("NAME");
    std::vector<std::pair<std::string, LawVariant>> laws;
    for (const LawDescription& law : all_contact_laws()) laws.emplace_back(law.name, law.variant);
    add_choice<LawVariant>(command, "--contact-law", o.law, laws, "contact law; see share/doc/laws.md");
    add_choice<Coupling>(command, "--coupling", o.coupling, {{"full", Coupling::full}, {"none", Coupling::none}},
                         "full: failure in one mode takes the cohesion in both; none: each mode for itself");
    add_parameters(command, o);
    add_choice(command, "--plane", o.plane, {"strain", "stress"}, "plane condition");
}

void apply_contact_options(const ContactOptions& o, SimulationRequest& request) {
    check_use(o);
    request.law = o.law;
    request.coupling = o.coupling;
    const bool brazilian = request.loading.test == TestKind::brazilian;
    request.plane = o.plane.empty() ? (brazilian ? PlaneCondition::stress : PlaneCondition::strain)
                                    : (o.plane == "stress" ? PlaneCondition::stress : PlaneCondition::strain);
    request.material = material_of(o);
    request.contact = contact_parameters(request.material, request.plane, o.fracture_energy);
    check_energies(request.contact, o.law);
    request.fracture_energy_choice = description_of(o.law).fracture_energy
                                         ? name_of(effective_fracture_energy(request.material, o.fracture_energy).kind)
                                         : std::string_view("none");
}

}  // namespace graincrack
