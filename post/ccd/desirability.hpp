// Desirability of responses (Derringer & Suich 1980): how near each response comes to its goal, and all of them together.
#pragma once

#include <string>
#include <vector>

namespace graincrack::ccd {

/// The goal for a response.
struct Goal {
    enum class Kind { target, maximum, minimum } kind = Kind::target;
    std::string response;
    double low = 0;     ///< target, maximum: desirability 0 at or below
    double target = 0;  ///< target: the best value; maximum, minimum: desirability 1 from here on
    double high = 0;    ///< target, minimum: desirability 0 at or above
    /// 0 (useless) to 1 (goal reached), linear between.
    [[nodiscard]] double operator()(double response_value) const;
};

/// Reads "NAME=T" or "NAME=LOW:T:HIGH" (target), "NAME=LOW:GOOD" (maximum), "NAME=GOOD:HIGH" (minimum). Without limits a
/// target takes them from `set_limits`. \throws UsageError naming `option`
Goal parse_goal(const std::string& text, Goal::Kind kind, const std::string& option);

/// The limits of a target that has none: the extremes of the measured responses.
/// \throws UsageError if the target is not between them
void set_limits(Goal& goal, const std::vector<double>& measured);

/// Geometric mean. \pre values is not empty
double overall_desirability(const std::vector<double>& values);

}  // namespace graincrack::ccd
