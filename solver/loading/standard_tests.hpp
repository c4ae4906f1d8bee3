// The four laboratory tests as programs: platens, a membrane where there is a pressure, and the stages of both.
#pragma once

#include <string>

#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"
#include "solver/setup/program.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// Names of the stages of a test under pressure; the others have the second alone.
inline constexpr const char* isotropic_stage = "isotropic";
inline constexpr const char* axial_stage = "axial";

/// Uniaxial or triaxial compression, Brazilian test or direct tension. Under a confining pressure a membrane on the parts left
/// and right and the platens first load the specimen isotropically and wait for rest, then the platens move on. \param peak_drop
/// fall below the peak that ends the test, share of it; 0: the test ends at the strain limit alone
Program standard_test(const LoadingRequest& request, double peak_drop, const Specimen& specimen, const Rock& rock);

/// A Brazilian test loads a disc; the other standard tests measure stress over the width of their specimen, which a disc does not
/// have. Shapes of names that the mesher does not give, and all shapes of a program, pass.
/// \param file of the specimen, for the message \throws InputError if the test is not made for the shape
void require_shape(TestKind test, const Specimen& specimen, const std::string& file);

/// What a run runs: the program that is asked for, or that of the standard test.
Program program_of(const SimulationRequest& request, const Specimen& specimen);

}  // namespace graincrack
