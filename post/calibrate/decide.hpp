// Takes the decisions of a calibration as a pure function of targets, parameters and finished runs. When the requested runs are
// finished, the next call repeats the same decisions and continues; no state is stored besides the runs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/kind_prior.hpp"
#include "post/calibrate/verdict.hpp"

namespace graincrack::calibrate {

/// A decision with the numbers that it used, for the report.
struct Step {
    std::string stage;
    std::string what;
    std::string result;
};

struct Decision : Ended {
    std::vector<RequestedRun> requested;  ///< runs that are missing, each once
    Point point;                          ///< the calibrated point, else the nearest so far
    std::optional<Fit> fit;
    std::vector<Outcome> outcomes;
    std::vector<Step> steps;
};

/// The input of a calibration.
struct Problem {
    std::vector<Target> targets;
    std::vector<Parameter> parameters;
    Study study;
    double young_modulus = 0;  ///< of the rock, Pa; the first guess for the grains
    double poisson_ratio = 0;  ///< of the rock; the first guess for the grains
    std::shared_ptr<const KindSurface> kind =
        {};              ///< response surface of the rock type; null if the rock needs designs of its own
    Material rock = {};  ///< the parameters change its contacts
};

/// Decides which runs are needed next or how the calibration ends. \param find finished runs
Decision decide(const Problem& problem, const FindRun& find);

}  // namespace graincrack::calibrate
