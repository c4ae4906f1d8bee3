// What a calibration has come to: report.md, its tables, and for programs outcome.json (share/doc/tables.md).
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

/// What kind and runs expect of a response, SI.
struct Prediction {
    Target target;
    Estimate half_of_specimens;  ///< of new specimens at the values found, 50 %
    Estimate specimen;           ///< the same, 95 %
    Estimate rock;               ///< of the mean of the rock, whose values are not known better than the targets tell, 95 %
};
std::vector<Prediction> predictions_of(const Fit& fit, const Draws& draws);

/// All that is told of a calibration.
struct Findings {
    const Material& rock;  ///< as it was given
    const Problem& problem;
    const Decision& decision;
    std::size_t n_runs = 0;                       ///< that are finished
    std::vector<Sensitivity> sensitivities = {};  ///< of all pairs that have a surface, response by response; in the end
    std::optional<Draws> draws = {};              ///< 400 of the values and of all responses that the kind knows; in the end
    std::vector<Prediction> predictions = {};     ///< by these
};
Findings findings_of(const Material& rock, const Problem& problem, const Decision& decision, std::size_t n_runs);

/// The table identify.tsv: response, parameter, exponent, exponent_low, exponent_high.
std::string identify_table(const std::vector<Sensitivity>& sensitivities);
/// The table draws.tsv: a row a draw, with values in the units of reports and the mean of each property. \pre draws
std::string draws_table(const Findings& findings);
/// \param at the rock with the values found, if there are any
std::string report_text(const Findings& findings, const std::optional<Material>& at);
/// \param files the names of the files written beside it, by what they are
std::string outcome_text(const Findings& findings, const std::map<std::string, std::string>& files);

/// "25.8 (25.5 to 26.1)"
std::string with_interval(const Estimate& estimate, double si);

}  // namespace graincrack::calibrate
