#include "post/fit/size_effect.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "post/fit/paper_rock.hpp"
#include "post/run/comparability.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"

namespace graincrack {

namespace {

constexpr double millimetre = 1e-3;

std::vector<double> logarithms(const std::vector<double>& values, double unit) {
    std::vector<double> out;
    for (const double value : values) out.push_back(std::log(value / unit));
    return out;
}

/// A fit to a series.
struct FitRow {
    const SizeSeries& series;
    std::optional<PowerLaw> law;
    [[nodiscard]] double small() const { return *std::ranges::min_element(series.edge); }
    [[nodiscard]] double large() const { return *std::ranges::max_element(series.edge); }
    [[nodiscard]] bool is_tensile() const { return series.test == "brazilian" || series.test == "tension"; }
};

const Columns<FitRow>& fit_columns() {
    using namespace unit;
    using R = FitRow;
    static const Columns<R> all{
        {"test", none, [](const R& r) { return r.series.test; }},
        {"confining_pressure", megapascal, [](const R& r) { return r.series.confining_pressure; }},
        {"runs", none, [](const R& r) { return r.series.edge.size(); }},
        {"runs_at_strain_limit", none, [](const R& r) { return r.series.at_strain_limit; }},
        {"smallest_edge", unit::millimetre, [](const R& r) { return r.small(); }},
        {"largest_edge", unit::millimetre, [](const R& r) { return r.large(); }},
        {"exponent", none, [](const R& r) { return r.law ? Cell(r.law->exponent.value) : Cell(); }},
        {"exponent_low", none, [](const R& r) { return r.law ? Cell(r.law->exponent.low) : Cell(); }},
        {"exponent_high", none, [](const R& r) { return r.law ? Cell(r.law->exponent.high) : Cell(); }},
        {"coefficient", none, [](const R& r) { return r.law ? Cell(r.law->coefficient * 1e-6) : Cell(); }},
        {"theory_exponent", none, [](const R& r) { return r.is_tensile() ? Cell(theory_exponent) : Cell(); }},
        {"paper_exponent", none, [](const R& r) { return r.series.exponent_of_paper(); }},
        {"zone_over_smallest_edge", none, [](const R& r) { return r.series.contact_zone_length / r.small(); }},
        {"zone_over_largest_edge", none, [](const R& r) { return r.series.contact_zone_length / r.large(); }}};
    return all;
}

void require_sizes(const SizeSeries& s) {
    if (s.edge.empty()) throw InputError(fmt::format("{}; a size effect needs strengths", s.left_out.front()));
    const auto [small, large] = std::ranges::minmax_element(s.edge);
    if (*large >= min_edge_ratio * *small) return;
    throw InputError(
        fmt::format("size-effect: {} {} of the {} test at one mean edge ({:.4g} mm); two or more edges are needed, a "
                    "factor of {} apart at least",
                    s.edge.size(), s.edge.size() == 1 ? "run" : "runs", s.test, *large / millimetre, min_edge_ratio));
}

}  // namespace

std::optional<PowerLaw> fit_power_law(const std::vector<double>& edge, const std::vector<double>& strength) {
    const std::optional<Line> line = fit_line(logarithms(edge, millimetre), logarithms(strength, 1));
    if (!line) return std::nullopt;
    return PowerLaw{line->slope_estimate(), std::exp(line->intercept), *line};
}

Estimate PowerLaw::strength_at(double edge) const {
    const double x = std::log(edge / millimetre);
    const Line& line = logarithms;
    const double variance = line.intercept_variance + x * (2 * line.covariance + x * line.slope_variance);
    const Estimate mean = estimate(line.intercept + line.slope * x, variance, line.freedom);
    const auto exponential = [](const std::optional<double>& value) { return value ? std::optional(std::exp(*value)) : value; };
    return {std::exp(mean.value), exponential(mean.low), exponential(mean.high)};
}

namespace {

/// Settings that may differ: the grain size, and the size of the specimen if both have the same ratio.
SettingGroups of_sizes(const std::vector<RunData>& runs) {
    constexpr double slack = 0.1;  // relative difference of equal ratios; chosen, not fitted
    const auto scale = [](const RunData& run) { return run.specimen.width / run.specimen.mean_edge; };
    for (const RunData& run : runs) {
        const auto other = std::ranges::find_if(runs, [&](const RunData& r) { return r.header.test == run.header.test; });
        if (!(std::abs(scale(run) / scale(*other) - 1) < slack)) return {SettingGroup::grain_size};
    }
    return {SettingGroup::grain_size, SettingGroup::size};
}

}  // namespace

std::vector<SizeSeries> collect_sizes(const std::vector<RunData>& runs, const EnvelopeOptions& options) {
    std::map<std::pair<std::string, double>, SizeSeries> series;
    require_comparable(runs, "a size effect", of_sizes(runs));
    for (const RunData& run : runs) {
        const auto same_test = std::ranges::find_if(runs, [&](const RunData& r) { return r.header.test == run.header.test; });
        if (distinct_shape(*same_test) != distinct_shape(run)) {
            throw InputError(
                fmt::format("{}: a {} has another strength than the {} of {}; a size effect needs specimens of one shape",
                            run.name, run.specimen.shape, same_test->specimen.shape, same_test->name));
        }
        if (!(run.specimen.mean_edge > 0)) throw InputError(run.name + ": the specimen has no mean edge; a size effect needs it");
        const Strength strength = measure_strength(run);
        const RunHeader& h = run.header;
        SizeSeries& s = series[{h.test, h.confining_pressure}];
        s.test = h.test;
        s.confining_pressure = h.confining_pressure;
        s.of_paper = is_rock_of_paper(h.material);
        s.contact_zone_length = fpz::contact_zone_length(h.rock, h.plane, h.contact.fracture_energy, h.contact.tensile_strength);
        const auto stress = strength_for_fit(run, strength, options, "a size effect", s.left_out, s.at_strain_limit);
        if (!stress) continue;
        s.edge.push_back(run.specimen.mean_edge);
        s.strength.push_back(*stress);
    }
    std::vector<SizeSeries> out;
    for (auto& [key, s] : series) {
        require_sizes(s);
        out.push_back(std::move(s));
    }
    return out;
}

void write_size_effect_table(std::ostream& out, const std::vector<RunData>& runs, TableFormat format,
                             const EnvelopeOptions& options, std::ostream& diagnostics) {
    const std::vector<SizeSeries> all = collect_sizes(runs, options);
    std::size_t at_strain_limit = 0;
    for (const SizeSeries& s : all) {
        at_strain_limit += s.at_strain_limit;
        print_left_out(diagnostics, "size-effect", s.left_out);
    }
    if (at_strain_limit > 0) {
        say(diagnostics,
            fmt::format(
                "graincrack-post: size-effect: {} of {} runs were stopped at the strain limit; their largest stress is taken "
                "as a strength, so that the exponent depends on that limit",
                at_strain_limit, runs.size()));
    }
    std::vector<FitRow> rows;
    for (const SizeSeries& s : all) rows.push_back({s, fit_power_law(s.edge, s.strength)});
    write_table(out, fit_columns(), rows, format);
}

}  // namespace graincrack
