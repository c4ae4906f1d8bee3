#include "post/summary/statistic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "post/fit/mohr_coulomb.hpp"
#include "post/statistics/rank.hpp"
#include "post/statistics/regression.hpp"
#include "post/statistics/statistics.hpp"

namespace graincrack::summary {

namespace {

using Values = std::vector<double>;

/// A statistic of one argument, from the entries that there are; empty without any.
template <class Function>
Statistic of_one(Function function) {
    return {1, [function](const std::vector<std::vector<Number>>& arguments) -> Number {
                Values values;
                for (const Number& entry : arguments[0]) {
                    if (entry) values.push_back(*entry);
                }
                if (values.empty()) return std::nullopt;
                return function(values);
            }};
}

/// A statistic of pairs with at least two different x.
template <class Function>
Statistic of_pairs(Function function) {
    return {2, [function](const std::vector<std::vector<Number>>& arguments) -> Number {
                Values x;
                Values y;
                for (std::size_t row = 0; row < arguments[0].size(); ++row) {
                    if (!arguments[0][row]) continue;
                    if (!arguments[1][row]) return std::nullopt;
                    x.push_back(*arguments[0][row]);
                    y.push_back(*arguments[1][row]);
                }
                if (std::set<double>(x.begin(), x.end()).size() < 2) return std::nullopt;
                return function(x, y);
            }};
}

Number half_interval(const Values& values) {
    const Estimate mean = sample(values).mean;
    return mean.high ? Number(*mean.high - mean.value) : std::nullopt;
}

std::optional<Estimate> intercept(const Values& x, const Values& y) {
    const Line line = *fit_line(x, y);
    return estimate(line.intercept, line.intercept_variance, line.freedom);
}

std::optional<Estimate> slope(const Values& x, const Values& y) {
    const Line line = *fit_line(x, y);
    return estimate(line.slope, line.slope_variance, line.freedom);
}

std::optional<Estimate> exponent(const Values& x, const Values& y) {
    const auto positive = [](double value) { return value > 0; };
    if (!std::all_of(x.begin(), x.end(), positive) || !std::all_of(y.begin(), y.end(), positive)) return std::nullopt;
    Values log_x;
    Values log_y;
    for (const double value : x) log_x.push_back(std::log(value));
    for (const double value : y) log_y.push_back(std::log(value));
    return slope(log_x, log_y);
}

Number lack_of_fit_p(const Values& x, const Values& y) {
    const Line line = *fit_line(x, y);
    std::vector<Values> points;
    for (const double value : x) points.push_back({value});
    const auto test = lack_of_fit(points, y, line.residual_sum, line.freedom);
    return test ? Number(test->p) : std::nullopt;
}

using Fit = std::optional<Estimate> (*)(const Values& x, const Values& y);

/// A fitted value under a name, and the ends of its 95 % interval as NAME_low and NAME_high.
void add_fit(std::map<std::string, Statistic>& all, const std::string& name, Fit fit) {
    const auto part = [fit](auto of) {
        return of_pairs([fit, of](const Values& x, const Values& y) -> Number {
            const std::optional<Estimate> fitted = fit(x, y);
            return fitted ? of(*fitted) : std::nullopt;
        });
    };
    all[name] = part([](const Estimate& e) { return Number(e.value); });
    all[name + "_low"] = part([](const Estimate& e) { return e.low; });
    all[name + "_high"] = part([](const Estimate& e) { return e.high; });
}

}  // namespace

const std::map<std::string, Statistic>& statistics() {
    static const std::map<std::string, Statistic> all = [] {
        std::map<std::string, Statistic> named{
            {"mean", of_one([](const Values& v) { return Number(sample(v).mean.value); })},
            {"median", of_one([](const Values& v) { return Number(median(v)); })},
            {"deviation", of_one([](const Values& v) { return sample(v).deviation; })},
            {"low", of_one([](const Values& v) { return sample(v).mean.low; })},
            {"high", of_one([](const Values& v) { return sample(v).mean.high; })},
            {"half_interval", of_one(half_interval)},
            {"lack_of_fit", of_pairs(lack_of_fit_p)},
            {"rank_correlation", of_pairs([](const Values& x, const Values& y) { return Number(rank_correlation(x, y)); })},
            {"cohesion", of_pairs([](const Values& x, const Values& y) { return Number(fit_mohr_coulomb(x, y).cohesion); })},
            {"friction_angle", of_pairs([](const Values& x, const Values& y) {
                 return Number(fit_mohr_coulomb(x, y).friction_angle * 180 / std::numbers::pi);
             })}};
        add_fit(named, "intercept", &intercept);
        add_fit(named, "slope", &slope);
        add_fit(named, "exponent", &exponent);
        return named;
    }();
    return all;
}

}  // namespace graincrack::summary
