#include "solver/setup/setup.hpp"

#include "solver/setup/element_mass.hpp"
#include "solver/setup/regions.hpp"
#include "solver/setup/stable_time_step.hpp"

namespace graincrack {

Setup make_setup(const Specimen& specimen, const SimulationRequest& r, const Program& program) {
    Setup s{make_assemblage(specimen, r.material.rock, r.plane),
            {},
            {make_contact_law(r.contact, r.law, r.coupling), 0, r.damping, r.damping_form},
            0,
            0};
    s.assemblage.vector_target = r.vector_target.value_or(widest_vector_target());
    s.boundary = make_program_boundary(s.assemblage, specimen, program, r.contact, r.loading.platen_friction);
    const ContactLaw& law = s.parameters.law;
    if (r.mass_scaling) {
        s.added_mass = scale_mass_of_stiffest_elements(s.assemblage, r.material.rock.density, max_added_mass);
        s.mass_scaling_factor =
            r.mass_scaling_factor ? *r.mass_scaling_factor : sufficient_mass_scaling(s.assemblage, s.boundary, law);
    }
    s.stable_time_step = stable_time_step(s.assemblage, s.boundary, law, s.mass_scaling_factor);
    s.parameters.mass_scaling = make_mass_scaling(s.assemblage, s.mass_scaling_factor);
    s.parameters.time_step = r.time_step_fraction * s.stable_time_step;
    return s;
}

}  // namespace graincrack
