#include "solver/loading/stage_ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "share/file/peak.hpp"

namespace graincrack {
namespace {

/// Distance of a condition from being reached, with its side.
double offset(const Condition& c, const Rows& rows) {
    return (c.probe.empty() ? rows.history.columns[c.column].back() : rows.probe(c.probe, c.column)) - c.value;
}

/// A column of the history or of a probe reaches a value, from the side on which it was at the begin of the stage.
StageEnd value_reached(const Condition& condition, std::size_t number, const Rows* begin) {
    return {condition.name, fmt::format("offset{}", number), begin != nullptr ? offset(condition, *begin) : 0,
            [&condition](const StageRow& row, double& at_begin) {
                const double now = offset(condition, row.rows);
                return now == 0 || (now > 0) != (at_begin > 0);
            }};
}

/// True if the load is below an axial stress (absolute, Pa). Without damping waves do not die out: what one of them takes from
/// the load, less than its time to and fro, is no fall.
bool has_fallen_below(double stress, const StageRow& row) {
    constexpr double wave_transits = 2;  // to the other platen and back
    const History& history = row.rows.history;
    const std::vector<double>& time = history[HistoryColumn::time];
    const bool is_damped = history[HistoryColumn::energy_damping].back() > 0;
    const double since = time.back() - (is_damped ? 0 : wave_transits * row.transit_time);
    std::size_t i = history.size() - 1;
    while (i > 0 && time[i] > since && std::abs(history[HistoryColumn::axial_stress][i]) < stress) --i;
    return std::abs(history[HistoryColumn::axial_stress][i]) < stress;
}

/// Axial stress and strain of the rows of a stage.
struct StageCurve {
    std::span<const double> stress, strain;
};
StageCurve curve_of(const StageRow& row) {
    const History& history = row.rows.history;
    const std::vector<double>& time = history[HistoryColumn::time];
    const auto begin = static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), row.begin) - time.begin());
    return {std::span(history[HistoryColumn::axial_stress]).subspan(begin),
            std::span(history[HistoryColumn::axial_strain]).subspan(begin)};
}

/// True if the platens go further, in the sense of the largest load of the stage, than in all its rows before: what the stress
/// loses where they retreat is no fall.
bool is_loading(const StageCurve& curve) {
    const auto [lowest, highest] = std::minmax_element(curve.stress.begin(), curve.stress.end());
    const double sense = -*lowest > *highest ? -1 : 1;
    const double last = curve.strain.back();
    return std::all_of(curve.strain.begin(), curve.strain.end() - 1,
                       [&](double before) { return sense * before < sense * last; });
}

/// True of a specimen that heat has cracked until it has gone far enough beyond its highest stress.
bool may_settle(const StageCurve& curve) {
    const auto highest =
        std::max_element(curve.stress.begin(), curve.stress.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    const double strain = curve.strain[static_cast<std::size_t>(highest - curve.stress.begin())];
    return std::abs(curve.strain.back()) < heated_strain * std::abs(strain);
}

/// The axial stress falls, under loading, below its highest of the stage since contacts have failed.
StageEnd peak_drop(double share) {
    return {ended_by_peak_drop, "highest", 0, [share](const StageRow& row, double& highest) {
                const StageCurve curve = curve_of(row);
                if (!is_loading(curve)) return false;
                const double stress = std::abs(row.feedback.axial_compression);
                const bool fails = cracks_in(row.rows.history) > row.cracks_before && stress >= row.least_load;
                if (highest > 0 || fails) highest = std::max(highest, stress);
                return has_fallen_below((1 - share) * highest, row) && !(row.is_heated && may_settle(curve));
            }};
}

/// All functions have ended, and the unbalanced ratio and the error of a servo are small.
StageEnd rest(double tolerance) {
    constexpr double rest_rows = 5;  // in succession: one may be at rest by chance
    return {ended_by_rest, "rows_at_rest", 0, [tolerance](const StageRow& row, double& rows) {
                const bool rests = row.feedback.time >= row.functions_end && row.unbalanced_ratio < tolerance &&
                                   std::abs(row.pressure_error) < tolerance;
                rows = rests ? rows + 1 : 0;
                return rows >= rest_rows;
            }};
}

StageEnd time_limit(double longest) {
    constexpr double round_off = 1e-9;  // half a step of it must not cost an interval
    return {ended_by_time, "", 0, [longest](const StageRow& row, double& /*memory*/) {
                return row.feedback.time - row.begin >= (1 - round_off) * longest;
            }};
}

}  // namespace

double overshoot(const Stage& stage, const std::string& ended_by, const Rows& rows) {
    const auto condition =
        std::find_if(stage.until.begin(), stage.until.end(), [&](const Condition& c) { return c.name == ended_by; });
    return condition == stage.until.end() || condition->value == 0 ? 0 : std::abs(offset(*condition, rows) / condition->value);
}

double cracks_in(const History& history) {
    return history[HistoryColumn::tensile_cracks].back() + history[HistoryColumn::shear_cracks].back();
}

std::vector<StageEnd> ends_of(const Stage& stage, const Rows* begin) {
    std::vector<StageEnd> ends;
    for (const Condition& condition : stage.until) ends.push_back(value_reached(condition, ends.size(), begin));
    if (stage.peak_drop) ends.push_back(peak_drop(*stage.peak_drop));
    if (stage.rest) ends.push_back(rest(*stage.rest));
    ends.push_back(time_limit(stage.longest_time));
    return ends;
}

}  // namespace graincrack
