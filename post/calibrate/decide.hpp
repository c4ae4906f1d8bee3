// The decisions of a calibration: a pure function of targets, parameters and finished runs. Called again when the runs that it
// requested are finished, it takes the same decisions and goes on; nothing is remembered but runs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/kind_prior.hpp"
#include "post/calibrate/verdict.hpp"

namespace graincrack::calibrate {

/// A decision and the numbers that it used, for the report.
struct Step {
    std::string stage;
    std::string what;
    std::string result;
};

struct Decision : Ended {
    std::vector<RequestedRun> requested;  ///< none twice, none that is finished
    Point point;                          ///< calibrated, else the nearest so far
    std::optional<Fit> fit;
    std::vector<Outcome> outcomes;
    std::vector<Step> steps;
};

/// The input of a calibration.
struct Problem {
    std::vector<Target> targets;
    std::vector<Parameter> parameters;
    Study study;
    double young_modulus = 0;  ///< of the rock, Pa: first guess of that of the grains
    double poisson_ratio = 0;
    std::shared_ptr<const KindSurface> kind = {};  ///< of the rock; null: designs of its own are needed
    Material rock = {};                            ///< whose contacts the parameters change
};

Decision decide(const Problem& problem, const FindRun& find);

}  // namespace graincrack::calibrate
