#include "solver/run/sensitivity.hpp"

#include <limits>

#include "share/base/error.hpp"
#include "solver/run/refinement.hpp"
#include "solver/setup/setup.hpp"

namespace graincrack {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<SensitivityCase> sensitivity_cases(const SimulationRequest& request, const Program& program,
                                               double mass_scaling_factor) {
    std::vector<SensitivityCase> cases;
    if (program.why_dynamic().empty()) {
        cases.push_back({"half the rate", request});
        cases.back().request.program = at_half_the_rate(program);
    }
    cases.push_back({"half the step", request});
    cases.back().request.time_step_fraction /= 2;
    if (request.damping > 0) {
        cases.push_back({"half the damping", request});
        cases.back().request.damping /= 2;
    }
    if (mass_scaling_factor > 0) {
        cases.push_back({"a quarter of the mass scaling", request});
        cases.back().request.mass_scaling_factor = mass_scaling_factor / 4;
    }
    cases.push_back({"twice the elements along an edge", request, true});
    return cases;
}

SensitivityRow sensitivity_row(const std::string& changed, const RunHeader& header, const History& history) {
    const std::vector<double>& stress = history[HistoryColumn::axial_stress];
    const std::vector<double>& strain = history[HistoryColumn::axial_strain];
    const std::size_t peak = peak_row(header, history);
    const double sign = sign_of_strength(header, history);
    SensitivityRow row{changed,
                       header.peak_axial_stress,
                       sign * strain[peak],
                       nan,
                       history[HistoryColumn::tensile_cracks][peak],
                       history[HistoryColumn::shear_cracks][peak]};
    if (header.stop_reason == "peak drop") row.post_peak_slope = (stress.back() - stress[peak]) / (strain.back() - strain[peak]);
    return row;
}

std::vector<SensitivityRow> find_sensitivity(const Specimen& specimen, const SimulationRequest& request,
                                             const TestOutcome& as_it_is, Verbosity verbosity) {
    std::vector<SensitivityRow> rows{sensitivity_row("as it is", as_it_is.header, as_it_is.history)};
    for (const SensitivityCase& each :
         sensitivity_cases(request, program_of(request, specimen), as_it_is.header.mass_scaling_factor)) {
        try {
            const TestOutcome outcome =
                run_test(each.refine ? refined(specimen) : specimen, each.request, each.changed, verbosity);
            SensitivityRow row = sensitivity_row(each.changed, outcome.header, outcome.history);
            if (each.refine) {  // contacts are half as long
                row.tensile_cracks /= 2;
                row.shear_cracks /= 2;
            }
            rows.push_back(row);
        } catch (const NumericalError&) {
            rows.push_back({each.changed, nan, nan, nan, nan, nan});
        }
    }
    return rows;
}

}  // namespace graincrack
