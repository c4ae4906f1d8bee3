#include "solver/setup/setup.hpp"

#include "solver/setup/element_mass.hpp"
#include "solver/setup/regions.hpp"
#include "solver/setup/stable_time_step.hpp"

namespace graincrack {

Setup make_setup(const Specimen& specimen, const SimulationRequest& r, const Program& program) {
    Setup s;
    s.fabric = uniform_fabric(r.material.rock, r.contact, specimen.phase_names.size());
    s.assemblage = make_assemblage(specimen, s.fabric.phases, r.plane);
    s.parameters.laws = make_contact_laws(s.fabric.contacts, r.law, r.coupling);
    s.parameters.damping = r.damping;
    s.parameters.damping_form = r.damping_form;
    s.assemblage.vector_target = r.vector_target.value_or(widest_vector_target());
    s.boundary = make_program_boundary(s.assemblage, specimen, program, r.contact, r.loading.platen_friction);
    const ContactLaws& laws = s.parameters.laws;
    if (r.mass_scaling) {
        s.added_mass = scale_mass_of_stiffest_elements(s.assemblage, max_added_mass);
        s.mass_scaling_factor =
            r.mass_scaling_factor ? *r.mass_scaling_factor : sufficient_mass_scaling(s.assemblage, s.boundary, laws);
    }
    s.stable_time_step = stable_time_step(s.assemblage, s.boundary, laws, s.mass_scaling_factor);
    s.parameters.mass_scaling = make_mass_scaling(s.assemblage, s.mass_scaling_factor);
    s.parameters.time_step = r.time_step_fraction * s.stable_time_step;
    return s;
}

}  // namespace graincrack
