// Evaluates the runs of a calibration: fits its responses, compares targets with new specimens, finds the number of specimens
// that this takes, and decides how the calibration ends.
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
    contradictory,  ///< each target can be reached, but not all together
    undecided       ///< the confirmation scatters too much for a verdict, or the surfaces do not fit the rock
};
/// "runs are needed", "calibrated", "not reached", "contradictory", "undecided".
std::string label_of(Ending ending);

/// A response over the design points. Responses with targets come first, then the others that the same tests measure.
struct Response {
    Target target;
    std::vector<double> values;           ///< [points] ln of the mean over the specimens of a point; NaN if none has it
    std::optional<LocalSurface> surface;  ///< fitted inside the last box, or of the rock type; updated by the rock's own runs
    std::size_t tests = 0;                ///< number of tests of the designs or, with a surface of the rock type, of the rock
    std::size_t measured = 0;             ///< number of these tests that have the response
};
/// The fitted responses that have a surface, with their targets.
std::vector<Residual> residuals_of(const std::vector<Response>& responses);

/// The last fit.
struct Fit {
    Box box;
    std::vector<DesignPoint> points;  ///< of all designs; empty with surfaces of the rock type
    std::vector<Response> responses;
    std::vector<Logistic> shares;  ///< fraction of tests with a first peak, for tests of which some have none
    Optimum optimum;
};

/// Values of a target in the runs that have it, SI.
std::vector<double> values_of(const Target& target, const std::vector<const Measures*>& runs);
/// Adds the mean of the runs of one point of a design to a response.
void add_value(Response& response, const std::vector<const Measures*>& runs);
/// Fits surfaces to the points of all designs that lie in the box. \return the number of these points
std::size_t fit_surfaces(Fit& fit);
/// The number of specimens whose mean a value of the surface of a response is.
std::size_t specimens_of(const Response& response, const Study& study);

/// The result of new specimens for a target.
struct Outcome {
    Target target;
    std::optional<Sample> ours;  ///< SI; empty if no test has it
    std::size_t tests = 0;
    /// "within" or "outside" if the whole 95 % interval lies within the bound or beyond it; "mean within" if the mean of a fitted
    /// target does and its standard error is no larger than the bound; else "undecided". For K_IC also the reason why there is no
    /// verdict; "" for a prediction without a measured value.
    std::string verdict;
    [[nodiscard]] bool is_met() const { return verdict.ends_with("within"); }
};
Outcome outcome_of(const Target& target, const std::vector<const Measures*>& runs, const Study& study);

/// The number of specimens for which surfaces and their scatter predict half of the 95 % interval of the mean below the deviation
/// of every target of a test; at least three, and the most if a target has no surface. It includes rock type and earlier
/// specimens.
std::size_t specimens_for(const Test& test, const Fit& fit, const Study& study);
/// The number of specimens of a test after runs that do not show every target within. It doubles while rock type and specimens
/// together predict the target within, or until its verdict is decided; without a rock type it is the most.
std::size_t more_specimens_for(const Test& test, const std::vector<const Measures*>& runs, const std::vector<Target>& targets,
                               const Fit& fit, const Study& study, bool until_decided);

/// The response or outcome of a target; null if there is none.
template <class Ones>
auto* find_of(Ones& all, const Target& target) {
    const auto found = std::ranges::find_if(all, [&](const auto& one) { return one.target.name() == target.name(); });
    return found == all.end() ? nullptr : &*found;
}

/// The end of a calibration; `decide` throws and catches it.
struct Ended {
    Ending ending = Ending::requested;
    std::string reason;  ///< a sentence that names the target and its difference
    std::string next;    ///< advice on what to do next
};
/// Returns how a calibration with these outcomes ends. \param all the hull of the boxes of all designs
Ended ending_of(const std::vector<Outcome>& outcomes, const Fit& fit, const Box& all, const std::vector<Parameter>& parameters,
                const Study& study);

/// Appends an item to a list within a sentence.
inline void add(std::string& list, const std::string& item) { list += (list.empty() ? "" : "; ") + item; }

}  // namespace graincrack::calibrate
