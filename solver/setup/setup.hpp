// The constants of a run, found once from specimen and request.
#pragma once

#include "share/file/run_header.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/step_parameters.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// The program of a run: the one that is asked for, or that of the standard test.
Program program_of(const SimulationRequest& request, const Specimen& specimen);

/// The effective values of law, rock, contacts, phases and classes. \throws InputError if the material does not fit the specimen
MaterialSettings material_settings(const SimulationRequest& request, const Specimen& specimen);

struct Setup {
    MaterialSettings material;
    Assemblage assemblage;
    Boundary boundary;
    StepParameters parameters;
    double mass_scaling_factor = 0;  ///< β, 0: none
    double added_mass = 0;           ///< to the stiffest elements, of the mass of the specimen
    double stable_time_step = 0;     ///< s
};
/// \param program that is run
Setup make_setup(const Specimen& specimen, const SimulationRequest& request, const Program& program);

}  // namespace graincrack
