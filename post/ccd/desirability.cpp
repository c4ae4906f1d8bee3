#include "post/ccd/desirability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "post/ccd/assignment.hpp"
#include "share/base/error.hpp"

namespace graincrack::ccd {

double Goal::operator()(double value) const {
    double share = 0;
    if (kind != Kind::minimum && value < target) {
        share = (value - low) / (target - low);
    } else if (kind != Kind::maximum && value > target) {
        share = (high - value) / (high - target);
    } else {
        share = 1;
    }
    return std::clamp(share, 0.0, 1.0);
}

Goal parse_goal(const std::string& text, Goal::Kind kind, const std::string& option) {
    const char* const form = kind == Goal::Kind::target    ? "NAME=TARGET or NAME=LOW:TARGET:HIGH"
                             : kind == Goal::Kind::maximum ? "NAME=LOW:GOOD"
                                                           : "NAME=GOOD:HIGH";
    const Assignment given = parse_assignment(text, option, form);
    const std::vector<double>& v = given.values;
    const bool rises = std::is_sorted(v.begin(), v.end(), std::less_equal<>());
    const std::size_t wanted = kind == Goal::Kind::target && v.size() != 1 ? 3 : kind == Goal::Kind::target ? 1 : 2;
    if (v.size() != wanted || !rises) {
        throw UsageError(fmt::format("{} {}: {} with rising numbers is needed", option, text, form));
    }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (kind == Goal::Kind::maximum) return {kind, given.name, v[0], v[1], none};
    if (kind == Goal::Kind::minimum) return {kind, given.name, none, v[0], v[1]};
    if (v.size() == 3) return {kind, given.name, v[0], v[1], v[2]};
    return {kind, given.name, none, v[0], none};
}

void set_limits(Goal& goal, const std::vector<double>& measured) {
    if (goal.kind != Goal::Kind::target || !std::isnan(goal.low)) return;
    const auto [low, high] = std::minmax_element(measured.begin(), measured.end());
    goal.low = *low;
    goal.high = *high;
    if (goal.low < goal.target && goal.target < goal.high) return;
    throw UsageError(
        fmt::format("--target {}={:.6g}: not between the measured {:.6g} and {:.6g}; give limits, {}=LOW:TARGET:HIGH",
                    goal.response, goal.target, goal.low, goal.high, goal.response));
}

double overall_desirability(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        if (!(value > 0)) return 0;
        sum += std::log(value);
    }
    return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace graincrack::ccd
