// Derives the constants of a run from specimen and request.
#pragma once

#include "share/file/run_header.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/step_parameters.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// Returns the requested program, or that of the standard test.
Program program_of(const SimulationRequest& request, const Specimen& specimen);

/// Returns law, rock, contacts, phases and classes in use. \throws InputError if the material does not fit the specimen
MaterialSettings material_settings(const SimulationRequest& request, const Specimen& specimen);

struct Setup {
    MaterialSettings material;
    Assemblage assemblage;
    Boundary boundary;
    StepParameters parameters;
    double mass_scaling_factor = 0;  ///< β; 0: no mass scaling
    double added_mass = 0;           ///< mass added to the stiffest elements, over the mass of the specimen
    double stable_time_step = 0;     ///< s
};
/// \param program the program to run
Setup make_setup(const Specimen& specimen, const SimulationRequest& request, const Program& program);

}  // namespace graincrack
