// What the runs of a calibration say: the fit of its responses, a target on new specimens, how many these take, and how it ends.
#pragma once

#include <cstddef>
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

/// A quantity over the design points. Targets come first, then what else the same tests measure.
struct Response {
    Target target;
    std::vector<double> values;           ///< ln of the mean over the specimens of each point of the designs; NaN: none has it
    std::optional<LocalSurface> surface;  ///< through those inside the last box, or of the kind; corrected by the rock's own runs
    std::size_t tests = 0;                ///< of the designs; of the rock itself where the surface is of the kind
    std::size_t measured = 0;             ///< of them that have it
};
/// The fitted responses that have a surface, with their targets.
std::vector<Residual> residuals_of(const std::vector<Response>& responses);

/// The last fit.
struct Fit {
    Box box;
    std::vector<DesignPoint> points;  ///< of all designs; none where the surfaces are of the kind
    std::vector<Response> responses;
    std::vector<Logistic> shares;  ///< of tests with a first peak, where not all have one
    Optimum optimum;
};

/// Values of a target in the runs that have it, SI.
std::vector<double> values_of(const Target& target, const std::vector<const Measures*>& runs);
/// Adds what the specimens of a point of a design have of a response.
void add_value(Response& response, const std::vector<const Measures*>& runs);
/// Surfaces through the points of all designs that lie in the box. \return how many these are
std::size_t fit_surfaces(Fit& fit);
/// Of how many specimens a value of the surface of a response is the mean.
std::size_t specimens_of(const Response& response, const Study& study);

/// A target on new specimens.
struct Outcome {
    Target target;
    std::optional<Sample> ours;  ///< SI; empty if no test has it
    std::size_t tests = 0;
    /// within, outside: the whole 95 % interval is within the bound, or beyond it; mean within: of a fitted target the mean is,
    /// and its standard error is no larger than the bound; undecided; of K_IC also why there is none; empty for a prediction
    /// without a measured value
    std::string verdict;
    [[nodiscard]] bool is_met() const { return verdict.ends_with("within"); }
};
Outcome outcome_of(const Target& target, const std::vector<const Measures*>& runs, const Study& study);

/// Specimens of which, by the surfaces and their scatter, half of the 95 % interval of the mean is below the deviation of every
/// target of a test, three at least; the most where a target has no surface. What a kind and earlier specimens say counts.
std::size_t specimens_for(const Test& test, const Fit& fit, const Study& study);
/// How many specimens of a test there shall be where so many do not show every target within: twice as many as long as kind and
/// specimens together expect it within, or until its verdict is decided; without a kind the most.
std::size_t more_specimens_for(const Test& test, const std::vector<const Measures*>& runs, const std::vector<Target>& targets,
                               const Fit& fit, const Study& study, bool until_decided);

/// The one of some responses or outcomes that is of a target; null: there is none.
template <class Ones>
auto* find_of(Ones& all, const Target& target) {
    const auto found = std::ranges::find_if(all, [&](const auto& one) { return one.target.name() == target.name(); });
    return found == all.end() ? nullptr : &*found;
}

/// A calibration that has ended; `decide` throws and catches it.
struct Ended {
    Ending ending = Ending::requested;
    std::string reason;  ///< one sentence: which target, by how much
    std::string next;    ///< what to do next
};
/// How a calibration ends whose outcomes are known. \param all holds the boxes of all designs
Ended ending_of(const std::vector<Outcome>& outcomes, const Fit& fit, const Box& all, const std::vector<Parameter>& parameters,
                const Study& study);

/// Adds to a list in a sentence.
inline void add(std::string& list, const std::string& item) { list += (list.empty() ? "" : "; ") + item; }

}  // namespace graincrack::calibrate
