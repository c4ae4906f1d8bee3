// The decisions of a calibration: a pure function of targets, parameters and finished runs. Called again when the runs that it
// requested are finished, it takes the same decisions and goes on; nothing is remembered but runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/optimum.hpp"
#include "post/calibrate/study.hpp"
#include "post/statistics/statistics.hpp"

namespace graincrack::calibrate {

enum class Ending {
    requested,      ///< runs are missing
    calibrated,     ///< the confirmation is within the bounds
    not_reached,    ///< a target is out of reach
    contradictory,  ///< each target is in reach, but not all together
    undecided       ///< the confirmation scatters too much for a verdict, or the surfaces do not describe the rock
};
/// "runs are needed", "calibrated", "not reached", "contradictory", "undecided".
std::string label_of(Ending ending);

/// A quantity at all points of the designs. Targets come first, then what else the same tests measure.
struct Response {
    Target target;
    std::vector<double> values;           ///< logarithm of the mean over the specimens of a point; NaN: none has it
    std::optional<LocalSurface> surface;  ///< through the points inside the last box
    std::optional<double> pure_error;     ///< standard deviation of a value between equal points, by repeated tests
    int pure_freedom = 0;                 ///< its degrees of freedom
    std::size_t tests = 0;                ///< of the designs
    std::size_t measured = 0;             ///< of them that have it
};

/// The last fit.
struct Fit {
    Box box;
    std::vector<DesignPoint> points;  ///< of all designs
    std::vector<Response> responses;
    Optimum optimum;
};

/// A target on new specimens.
struct Outcome {
    Target target;
    std::optional<Sample> ours;  ///< SI; empty if no test has it
    std::size_t tests = 0;
    /// within, outside, undecided; of K_IC also why there is none; empty for a prediction without a measured value
    std::string verdict;
};

/// A decision and the numbers that it used, for the report.
struct Step {
    std::string stage;
    std::string what;
    std::string result;
};

struct Decision {
    Ending ending = Ending::requested;
    std::string reason;                   ///< one sentence: which target, by how much
    std::string next;                     ///< what to do next
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
};

Decision decide(const Problem& problem, const FindRun& find);

}  // namespace graincrack::calibrate
