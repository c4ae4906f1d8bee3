// Writes the results of a calibration: report.md, its tables, and outcome.json for programs (share/doc/tables.md).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/decide.hpp"

namespace graincrack::calibrate {

/// The effect of a parameter on a response: the exponent d ln response / d ln parameter of its surface.
struct Sensitivity {
    std::string response;   ///< "first peak at 8 MPa"
    std::string parameter;  ///< "contact.cohesion"
    Estimate exponent;      ///< at the optimum, with its 95 % interval
};

/// The prediction of a response by rock type and runs, SI.
struct Prediction {
    Target target;
    Estimate half_of_specimens;  ///< 50 % interval of new specimens at the calibrated values
    Estimate specimen;           ///< 95 % interval of the same
    Estimate rock;               ///< 95 % interval of the mean of the rock, with the uncertainty of its values given the targets
};
std::vector<Prediction> predictions_of(const Fit& fit, const Draws& draws);

/// The contents of all reports of a calibration.
struct Findings {
    const Material& rock;  ///< the material that was given
    const Problem& problem;
    const Decision& decision;
    std::size_t n_runs = 0;                       ///< number of finished runs
    std::vector<Sensitivity> sensitivities = {};  ///< of all pairs with a surface, by response; empty until the end
    std::optional<Draws> draws = {};              ///< 400 posterior samples of values and responses; empty until the end
    std::vector<Prediction> predictions = {};     ///< from the posterior samples
};
Findings findings_of(const Material& rock, const Problem& problem, const Decision& decision, std::size_t n_runs);

/// The table identify.tsv: response, parameter, exponent, exponent_low, exponent_high.
std::string identify_table(const std::vector<Sensitivity>& sensitivities);
/// The table draws.tsv: one row per posterior sample, with values in the units of reports and the mean of each property.
/// \pre the findings have draws
std::string draws_table(const Findings& findings);
/// The text of report.md. \param at the rock with the calibrated values, if there are any
std::string report_text(const Findings& findings, const std::optional<Material>& at);
/// The text of outcome.json. \param files names of the other files, by their subjects
std::string outcome_text(const Findings& findings, const std::map<std::string, std::string>& files);

/// An estimate with its interval in a unit of this value in SI: "25.8 (25.5 to 26.1)".
std::string with_interval(const Estimate& estimate, double si);

}  // namespace graincrack::calibrate
