// The report of a calibration, in Markdown, and the sensitivities of responses to parameters.
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
    [[nodiscard]] bool is_significant() const { return *exponent.low > 0 || *exponent.high < 0; }
};

/// The sensitivities of all pairs that have a surface, response by response.
std::vector<Sensitivity> sensitivities(const std::vector<Parameter>& parameters, const Fit& fit);

/// The table identify.tsv: response, parameter, exponent, exponent_low, exponent_high.
std::string identify_table(const std::vector<Sensitivity>& sensitivities);

/// A value of a material that a calibration found, SI.
struct FoundValue {
    std::string key;
    Estimate value;                        ///< without an interval where it was scaled, or the data do not determine it
    const Parameter* parameter = nullptr;  ///< null of E and ν of the grains
};
std::vector<FoundValue> found_values(const Problem& problem, const Decision& decision);

/// What kind and runs expect of a response, SI.
struct Prediction {
    Target target;
    Estimate half_of_specimens;  ///< of new specimens at the values found, 50 %
    Estimate specimen;           ///< the same, 95 %
    Estimate rock;               ///< of the mean of the rock, whose values are not known better than the targets tell, 95 %
};
std::vector<Prediction> predictions_of(const Fit& fit, const Draws& draws);

/// 400 draws of the values and of all responses that the kind knows; empty of a rock without a kind, or without a fit.
std::optional<Draws> draws_of(const Problem& problem, const Decision& decision);
/// The table draws.tsv: a row a draw, with values in the units of reports and the mean of each property.
std::string draws_table(const Problem& problem, const Fit& fit, const Draws& draws);

/// \param rock as it was given \param at the same with the values found, if there are any \param n_runs that are finished
std::string report_text(const Material& rock, const std::optional<Material>& at, const Problem& problem, const Decision& decision,
                        const std::optional<Draws>& draws, std::size_t n_runs);

/// "25.8 (25.5 to 26.1)"
std::string with_interval(const Estimate& estimate, double si);

}  // namespace graincrack::calibrate
