#include "post/fit/trend.hpp"

#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "post/table/table_file.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

const std::vector<std::string> trend_columns{"x",
                                             "y",
                                             "group",
                                             "fit",
                                             "n",
                                             "left_out",
                                             "levels",
                                             "x_low",
                                             "x_high",
                                             "intercept",
                                             "intercept_low",
                                             "intercept_high",
                                             "slope",
                                             "slope_low",
                                             "slope_high",
                                             "coefficient",
                                             "coefficient_low",
                                             "coefficient_high",
                                             "elasticity",
                                             "elasticity_low",
                                             "elasticity_high",
                                             "elasticity_at_x",
                                             "r_squared",
                                             "residual_deviation",
                                             "lack_of_fit_F",
                                             "lack_of_fit_p"};

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> natural_logarithms(std::span<const double> values) {
    std::vector<double> out(values.size());
    std::transform(values.begin(), values.end(), out.begin(), [](double v) { return std::log(v); });
    return out;
}

/// Variance of the line's value at x.
double variance_at(const Line& line, double x) {
    return line.intercept_variance + 2 * x * line.covariance + x * x * line.slope_variance;
}

Estimate exponential(Estimate e) {
    e.value = std::exp(e.value);
    for (auto* end : {&e.low, &e.high}) {
        if (*end) **end = std::exp(**end);
    }
    return e;
}

/// b x/y at the mean: slope and mean of y are independent, so that Fieller's interval holds the q with
/// (q y − b x)² ≤ t² (q² var y + x² var b).
Estimate elasticity_at_mean(const Line& line, double x, double y) {
    Estimate e{line.slope * x / y, std::nullopt, std::nullopt};
    if (line.freedom < 1) return e;
    const double t = student_t_95(line.freedom);
    const double square = y * y - t * t * variance_at(line, x);
    if (!(square > 0)) return e;
    const double mixed = y * line.slope * x;
    const double constant = x * x * (line.slope * line.slope - t * t * line.slope_variance);
    const double root = std::sqrt(std::max(mixed * mixed - square * constant, 0.0));
    e.low = (mixed - root) / square;
    e.high = (mixed + root) / square;
    return e;
}

/// Adds the rows of one table to the groups; returns how many rows have a peak_kind other than "drop", so no peak.
std::size_t add_rows(const TableFile& table, const TrendOptions& options, std::vector<TrendRows>& groups) {
    const std::vector<double> x = table.numbers_or_nan(options.x);
    const std::vector<double> y = table.numbers_or_nan(options.y);
    std::vector<std::vector<std::string>> keys;
    for (const std::string& column : options.groups) keys.push_back(table.texts(column));
    const std::vector<std::string> kinds = table.has("peak_kind") ? table.texts("peak_kind") : std::vector<std::string>{};
    std::size_t without_peak = 0;
    for (std::size_t row = 0; row < table.n_rows(); ++row) {
        std::string name;
        for (const auto& key : keys) name += (name.empty() ? "" : ", ") + key[row];
        auto group = std::find_if(groups.begin(), groups.end(), [&](const TrendRows& g) { return g.group == name; });
        if (group == groups.end()) group = groups.insert(group, TrendRows{name, {}, {}, 0});
        if (!std::isfinite(x[row]) || !std::isfinite(y[row])) {
            ++group->left_out;
            continue;
        }
        if (options.power && !(x[row] > 0 && y[row] > 0)) {
            throw InputError(fmt::format("{}: row {}: {} {:.4g} and {} {:.4g}; a power law needs values above zero", table.name(),
                                         row + 1, options.x, x[row], options.y, y[row]));
        }
        group->x.push_back(x[row]);
        group->y.push_back(y[row]);
        if (!kinds.empty() && kinds[row] != "drop") ++without_peak;
    }
    return without_peak;
}

void append(std::vector<Cell>& row, const Estimate& e) {
    row.emplace_back(e.value);
    row.push_back(cell(e.low));
    row.push_back(cell(e.high));
}

void append_fit(std::vector<Cell>& row, const Trend& trend) {
    if (trend.power) row.insert(row.end(), 6, Cell());
    append(row, trend.coefficient);
    append(row, trend.power ? trend.elasticity : trend.slope);
    if (!trend.power) {
        row.insert(row.end(), 3, Cell());
        append(row, trend.elasticity);
    }
    row.push_back(trend.power ? Cell() : Cell(trend.mean_x));
    row.emplace_back(trend.line.r_squared);
    row.push_back(trend.line.freedom > 0 ? Cell(std::sqrt(trend.line.residual_sum / trend.line.freedom)) : Cell());
    row.push_back(trend.lack_of_fit ? Cell(trend.lack_of_fit->f) : Cell());
    row.push_back(trend.lack_of_fit ? Cell(trend.lack_of_fit->p) : Cell());
}

std::vector<Cell> row_of(const TrendRows& rows, const TrendOptions& options) {
    std::vector<Cell> row{options.x,
                          options.y,
                          rows.group,
                          std::string(options.power ? "power" : "linear"),
                          static_cast<std::int64_t>(rows.x.size()),
                          static_cast<std::int64_t>(rows.left_out),
                          static_cast<std::int64_t>(rows.levels())};
    if (!rows.x.empty()) {
        const auto [low, high] = std::minmax_element(rows.x.begin(), rows.x.end());
        row.emplace_back(*low);
        row.emplace_back(*high);
        if (const auto trend = fit_trend(rows.x, rows.y, options.power)) append_fit(row, *trend);
    }
    row.resize(trend_columns.size());
    return row;
}

}  // namespace

std::size_t TrendRows::levels() const { return std::set<double>(x.begin(), x.end()).size(); }

std::vector<TrendRows> collect_trends(const std::vector<std::string>& tables, const TrendOptions& options,
                                      std::ostream& diagnostics) {
    std::vector<TrendRows> groups;
    std::size_t without_peak = 0;
    for (const std::string& file : tables) without_peak += add_rows(TableFile(file), options, groups);
    std::size_t left_out = 0;
    for (const TrendRows& group : groups) left_out += group.left_out;
    if (std::none_of(groups.begin(), groups.end(), [](const TrendRows& g) { return g.levels() > 1; })) {
        throw InputError(fmt::format("trend: no two different {} with a {}{}; a line needs two", options.x, options.y,
                                     options.groups.empty() ? "" : " in any group"));
    }
    if (left_out > 0) {
        fmt::print(diagnostics, "graincrack-post: trend: {} rows with an empty {} or {} are left out\n", left_out, options.x,
                   options.y);
    }
    if (without_peak > 0) {
        fmt::print(diagnostics,
                   "graincrack-post: trend: {} rows are of runs without a peak; their largest stress is not a strength\n",
                   without_peak);
    }
    return groups;
}

Estimate Trend::at(double x) const {
    const double place = power ? std::log(x) : x;
    const Estimate e = estimate(line.intercept + line.slope * place, variance_at(line, place), line.freedom);
    return power ? exponential(e) : e;
}

std::optional<Trend> fit_trend(std::span<const double> x, std::span<const double> y, bool power) {
    const std::vector<double> xs = power ? natural_logarithms(x) : std::vector<double>(x.begin(), x.end());
    const std::vector<double> ys = power ? natural_logarithms(y) : std::vector<double>(y.begin(), y.end());
    const std::optional<Line> line = fit_line(xs, ys);
    if (!line) return std::nullopt;
    Trend trend{power, *line, {}, {}, {}, mean_of(x), std::nullopt};
    const Estimate intercept = estimate(line->intercept, line->intercept_variance, line->freedom);
    trend.coefficient = power ? exponential(intercept) : intercept;
    trend.slope = estimate(line->slope, line->slope_variance, line->freedom);
    trend.elasticity = power ? trend.slope : elasticity_at_mean(*line, trend.mean_x, mean_of(y));
    std::vector<std::vector<double>> places;
    for (const double value : xs) places.push_back({value});
    trend.lack_of_fit = lack_of_fit(places, ys, line->residual_sum, line->freedom);
    return trend;
}

void write_trend_table(std::ostream& out, const std::vector<std::string>& tables, const TrendOptions& options, TableFormat format,
                       std::ostream& diagnostics) {
    const std::vector<TrendRows> groups = collect_trends(tables, options, diagnostics);
    TableWriter table(out, trend_columns, format);
    for (const TrendRows& rows : groups) table.row(row_of(rows, options));
}

}  // namespace graincrack
