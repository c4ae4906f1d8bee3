// What a calibration decides: a pure function of a rock with its targets and of finished runs. Called again when the runs that it
// wanted are finished, it takes the same decisions and goes on; nothing is remembered but runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/run.hpp"
#include "post/calibrate/sampling.hpp"
#include "post/calibrate/specimens.hpp"
#include "post/calibrate/target.hpp"
#include "post/fit/statistics.hpp"

namespace graincrack::calibrate {

/// How a calibration is done. Bounds and numbers are set before it begins.
struct Study {
    TargetOptions targets;
    Specimens specimens;
    double max_strain = 0.015;    ///< strain limit of compression tests
    std::size_t elastic = 3;      ///< specimens for E and ν of the grains
    std::size_t scan_discs = 20;  ///< discs at each level of a parameter of σt
    std::size_t scouts = 5;       ///< pairs of single tests at most, to get near
    std::size_t centre_runs = 5;  ///< of designs
    std::size_t moves = 3;        ///< of a design whose targets lie outside, at most
    std::size_t rounds = 3;       ///< of fit and confirmation, at most
    std::size_t predicted = 5;    ///< specimens for a prediction
    SamplingRule discs{10, 80, 0.03};
    SamplingRule rectangles{10, 40, 0.03};
    double design_factor = 1.35;  ///< cc at +1 over cc at the centre
    double design_angle = 0.15;   ///< φc at +1 minus φc at the centre, a part of the rock's φ
    double narrow = 0.4;          ///< width of the second design, a part of the first
};

enum class Ending {
    wanted,         ///< runs are missing
    calibrated,     ///< the confirmation is within the bounds
    not_reached,    ///< a target is out of reach
    contradictory,  ///< each target is in reach, but not all together
    undecided       ///< specimens scatter too much for a verdict at the largest number of them
};
/// "runs are wanted", "calibrated", "not reached", "contradictory", "undecided".
std::string label_of(Ending ending);

/// A decision and the numbers that it used, for the report.
struct Step {
    std::string stage;
    std::string what;
    std::string result;
};

/// A target at the end, or at the nearest point.
struct Outcome {
    Target target;
    std::optional<Estimate> ours;  ///< SI, on new specimens; empty if not tested
    std::size_t specimens = 0;
    std::string verdict;  ///< within, outside, undecided; empty for a prediction without a laboratory value
    std::string note;     ///< two kinds of tests
};

/// A calibrated value with its 95 % interval, SI.
struct Calibrated {
    Parameter parameter;
    Estimate value;
};

struct Decision {
    Ending ending = Ending::wanted;
    std::string reason;              ///< one sentence: which target, by how much
    std::vector<WantedRun> wanted;   ///< none twice, none that is finished
    double wanted_time = 0;          ///< s of one processor for them, by finished runs of the same tests; 0 if there are none
    Point point;                     ///< calibrated; else the nearest so far
    std::vector<Calibrated> values;  ///< of what was fitted, as far as it was
    std::vector<Outcome> outcomes;
    std::vector<Step> steps;
};

/// \param rock with [laboratory] values \throws InputError naming one that is missing
Decision decide(const Material& rock, const Study& study, const std::vector<FinishedRun>& finished);

}  // namespace graincrack::calibrate
