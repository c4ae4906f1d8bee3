// Does a result depend on what should not matter? The test again, each time with one thing changed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "share/file/sensitivity.hpp"
#include "share/file/specimen.hpp"
#include "solver/run/outcome.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// The same grains of smaller elements: divides every element into four by the middles of its sides, every contact and boundary
/// edge into two. Grains, outline and statistics stay; nodes of the old specimen keep their numbers.
Specimen refined(const Specimen& specimen);

/// The changes, one row each, beside the test as it is.
struct SensitivityCase {
    std::string changed;
    SimulationRequest request;
    bool refine = false;  ///< twice the elements along an edge
};
/// The program at half its speed (of the automatic rate limits and floors included) unless it is dynamic, half the step, half the
/// damping (0.4 for 0.8), a quarter of the mass scaling where there is some, twice the elements along an edge.
/// \param mass_scaling_factor that the test has, 0 for none
std::vector<SensitivityCase> sensitivity_cases(const SimulationRequest& test, const Program& program, double mass_scaling_factor);

/// The row of a test.
SensitivityRow sensitivity_row(const std::string& changed, const RunHeader& header, const History& history);

/// Runs a test and writes nothing. The label is what its progress says.
using RunTest = std::function<TestOutcome(const Specimen& specimen, const SimulationRequest& request, const std::string& label)>;

/// Runs the cases by `run`. One that becomes unstable or does not settle gives a row of NaN.
/// \param as_it_is header and history of the test itself \throws Interrupted
std::vector<SensitivityRow> find_sensitivity(const Specimen& specimen, const SimulationRequest& request,
                                             const TestOutcome& as_it_is, const RunTest& run);

}  // namespace graincrack
