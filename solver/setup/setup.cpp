#include "solver/setup/setup.hpp"

#include <fmt/format.h>

#include "share/base/error.hpp"
#include "share/base/units.hpp"
#include "solver/setup/borne_loads.hpp"
#include "solver/setup/element_mass.hpp"
#include "solver/setup/regions.hpp"
#include "solver/setup/stable_time_step.hpp"

namespace graincrack {

namespace {

/// Refuses contact stiffnesses derived from an impossible rock, with which nothing can be computed.
void require_bounds(const ContactParameters& contact, const std::string& where) {
    for (const ContactParameter& row : all_contact_parameters()) {
        if (!(contact.*row.value > row.quantity.upper)) continue;
        throw InputError(fmt::format("{}: {} is {}, and must be {}; give it, or other values of [rock]", where, row.key(),
                                     format_quantity(contact.*row.value, row.quantity.dimension), bounds_text(row.quantity)));
    }
}

/// The fabric of a specimen. Without phases all grains and contacts have the same values, except the contacts of flaws.
Fabric fabric_of(const SimulationRequest& r, const Specimen& specimen) {
    const bool is_uniform = r.material.fabric.phases.empty();
    Fabric fabric = is_uniform ? uniform_fabric(r.material.rock, r.contact, specimen.phase_names.size())
                               : graincrack::fabric_of(r.material, r.plane, r.fracture_energy, specimen.phase_names);
    const std::size_t n_uniform = is_uniform ? fabric.contacts.size() : 0;
    for (const std::string& flaw : specimen.flaw_names) {
        fabric.contacts.push_back(
            phase_of_within_class(flaw).empty()
                ? flaw_contact(r.material, r.plane, r.fracture_energy, flaw)
                : contact_within_crystals(r.material, r.plane, r.fracture_energy, flaw, length_within_crystals(specimen, flaw)));
    }
    const std::vector<std::string> names = contact_class_names(specimen);
    const bool may_bridge = description_of(r.law).reads(&ContactParameters::bridging_strength);
    for (std::size_t k = 0; k < fabric.contacts.size(); ++k) {
        require_bounds(fabric.contacts[k], r.material.file.string() + ": contacts " + names[k]);
        if (k < n_uniform) continue;
        if (may_bridge) require_sound_bridges(fabric.contacts[k], r.material.file.string() + ": contacts " + names[k]);
        const FractureEnergies least = min_fracture_energies(make_contact_law(fabric.contacts[k], r.law));
        if (!(fabric.contacts[k].fracture_energy >= least.opening &&
              fabric.contacts[k].mode_ii_fracture_energy >= least.sliding)) {
            throw InputError(
                fmt::format("{}: the fracture energies of contacts {} are less than such a contact of the law {} absorbs up to "
                            "its peak; give at least {:.4g} J/m2 in opening and {:.4g} J/m2 in sliding",
                            r.material.file.string(), names[k], name_of(r.law), least.opening, least.sliding));
        }
    }
    return fabric;
}

}  // namespace

Program program_of(const SimulationRequest& request, const Specimen& specimen) {
    return request.program ? *request.program
                           : standard_test(request.loading, request.peak_drop, specimen, request.material.rock);
}

MaterialSettings material_settings(const SimulationRequest& r, const Specimen& specimen) {
    return {.material = r.material.name,
            .contact_law = std::string(name_of(r.law)),
            .crack_event = description_of(r.law).crack_event(),
            .fracture_energy_choice = r.fracture_energy_choice,
            .plane = r.plane,
            .rock = r.material.rock,
            .contact = r.contact,
            .fabric = fabric_of(r, specimen),
            .class_names = contact_class_names(specimen)};
}

Setup make_setup(const Specimen& specimen, const SimulationRequest& r, const Program& program) {
    Setup s;
    s.material = material_settings(r, specimen);
    const Fabric& fabric = s.material.fabric;
    s.assemblage = make_assemblage(specimen, fabric.phases, r.plane);
    if (program.has_temperature() && s.assemblage.expansion.empty()) {
        throw InputError(
            fmt::format("{}, and no phase of the material {} expands; give its [phases.NAME] a thermal_expansion, such as \"8e-6 "
                        "1/K\"",
                        r.loading.heat != 0 ? "--heat: changes the temperature" : program.file + ": prescribes a temperature",
                        r.material.file.string()));
    }
    s.parameters.laws = make_contact_laws(fabric.contacts, r.law);
    s.parameters.damping = r.damping;
    s.parameters.damping_form = r.damping_form;
    s.assemblage.vector_target = r.vector_target.value_or(widest_vector_target());
    s.boundary = make_program_boundary(s.assemblage, specimen, program, r.contact, r.loading.platen_friction);
    const bool starts_unloaded = r.restart.empty() && program.start_from.empty();
    if (r.damping > 0 && starts_unloaded) require_borne_loads(s.assemblage, s.boundary.prescribed, program);
    const ContactLaws& laws = s.parameters.laws;
    if (r.mass_scaling) {
        s.added_mass = scale_mass_of_stiffest_elements(s.assemblage, max_added_mass);
        s.mass_scaling_factor =
            r.mass_scaling_factor ? *r.mass_scaling_factor : sufficient_mass_scaling(s.assemblage, s.boundary, laws);
    }
    s.stable_time_step = stable_time_step(s.assemblage, s.boundary, laws, s.mass_scaling_factor);
    s.parameters.mass_scaling = make_mass_scaling(s.assemblage, s.mass_scaling_factor);
    s.parameters.time_step = r.time_step_fraction * s.stable_time_step;
    s.assemblage.part = make_part(s.assemblage, s.boundary.prescribed, *r.ranks);
    return s;
}

}  // namespace graincrack
