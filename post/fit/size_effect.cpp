#include "post/fit/size_effect.hpp"

#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "post/fit/paper_rock.hpp"
#include "post/run/comparable.hpp"
#include "post/statistics/nonlinear_fit.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

constexpr double millimetre = 1e-3;

const std::vector<std::string> columns{"test",
                                       "confining_pressure_MPa",
                                       "fit",
                                       "runs",
                                       "runs_at_strain_limit",
                                       "smallest_edge_mm",
                                       "largest_edge_mm",
                                       "exponent",
                                       "exponent_low",
                                       "exponent_high",
                                       "coefficient",
                                       "theory_exponent",
                                       "paper_exponent",
                                       "zone_over_smallest_edge",
                                       "zone_over_largest_edge"};

std::vector<double> logarithms(const std::vector<double>& values, double unit) {
    std::vector<double> out;
    for (const double value : values) out.push_back(std::log(value / unit));
    return out;
}

void write_row(TableWriter& table, const SizeSeries& s, const std::string& name, const std::optional<PowerLaw>& law) {
    const auto [small, large] = std::minmax_element(s.edge.begin(), s.edge.end());
    const bool tensile = s.test == "brazilian" || s.test == "tension";
    table.row({s.test, s.confining_pressure * 1e-6, name, static_cast<std::int64_t>(s.edge.size()),
               static_cast<std::int64_t>(s.at_strain_limit), *small / millimetre, *large / millimetre,
               law ? Cell(law->exponent.value) : Cell(), law ? cell(law->exponent.low) : Cell(),
               law ? cell(law->exponent.high) : Cell(), law ? Cell(law->coefficient * 1e-6) : Cell(),
               tensile ? Cell(theory_exponent) : Cell(), cell(s.exponent_of_paper()), s.contact_zone_length / *small,
               s.contact_zone_length / *large});
}

void require_sizes(const SizeSeries& s) {
    const auto [small, large] = std::minmax_element(s.edge.begin(), s.edge.end());
    if (*large >= min_edge_ratio * *small) return;
    throw InputError(
        fmt::format("size-effect: {} {} of the {} test at one mean edge ({:.4g} mm); two or more edges are needed, a "
                    "factor of {} apart at least",
                    s.edge.size(), s.edge.size() == 1 ? "run" : "runs", s.test, *large / millimetre, min_edge_ratio));
}

}  // namespace

std::optional<PowerLaw> fit_power_law_log(const std::vector<double>& edge, const std::vector<double>& strength) {
    const std::optional<Line> line = fit_line(logarithms(edge, millimetre), logarithms(strength, 1));
    if (!line) return std::nullopt;
    return PowerLaw{estimate(line->slope, line->slope_variance, line->freedom), std::exp(line->intercept)};
}

std::optional<PowerLaw> fit_power_law(const std::vector<double>& edge, const std::vector<double>& strength) {
    const std::optional<PowerLaw> start = fit_power_law_log(edge, strength);
    if (!start) return std::nullopt;
    // In units of the start, so that parameters and residuals are of order one.
    const double scale = *std::max_element(strength.begin(), strength.end());
    const auto residuals = [&](std::span<const double> p, std::span<double> f) {
        for (std::size_t i = 0; i < edge.size(); ++i) {
            f[i] = (p[0] * start->coefficient * std::pow(edge[i] / millimetre, p[1]) - strength[i]) / scale;
        }
    };
    const auto fit = fit_nonlinear(residuals, {1, start->exponent.value}, edge.size());
    if (!fit) return std::nullopt;
    return PowerLaw{fit->estimate(1), fit->parameters[0] * start->coefficient};
}

std::vector<SizeSeries> collect_sizes(const std::vector<RunData>& runs, StrainLimitRuns strain_limit_runs) {
    std::map<std::pair<std::string, double>, SizeSeries> series;
    require_same_settings(runs, "a size effect");
    for (const RunData& run : runs) {
        require_same_material(run, runs.front(), "a size effect");
        if (!(run.specimen.mean_edge > 0)) throw InputError(run.name + ": the specimen has no mean edge; a size effect needs it");
        const Strength strength = measure_strength(run);
        const RunHeader& h = run.header;
        SizeSeries& s = series[{h.test, h.confining_pressure}];
        s.test = h.test;
        s.confining_pressure = h.confining_pressure;
        s.of_paper = is_rock_of_paper(h.material);
        s.contact_zone_length = fpz::contact_zone_length(h.rock, h.plane, h.contact.fracture_energy, h.contact.tensile_strength);
        if (stopped_at_strain_limit(run, strength, strain_limit_runs, "a size effect")) ++s.at_strain_limit;
        s.edge.push_back(run.specimen.mean_edge);
        s.strength.push_back(strength.value());
    }
    std::vector<SizeSeries> out;
    for (auto& [key, s] : series) {
        require_sizes(s);
        out.push_back(std::move(s));
    }
    return out;
}

void write_size_effect_table(std::ostream& out, const std::vector<RunData>& runs, TableFormat format,
                             StrainLimitRuns strain_limit_runs, std::ostream& diagnostics) {
    const std::vector<SizeSeries> all = collect_sizes(runs, strain_limit_runs);
    std::size_t at_strain_limit = 0;
    for (const SizeSeries& s : all) at_strain_limit += s.at_strain_limit;
    if (at_strain_limit > 0) {
        fmt::print(diagnostics,
                   "graincrack-post: size-effect: {} of {} runs were stopped at the strain limit; their largest stress is taken "
                   "as a strength, so that the exponent depends on that limit\n",
                   at_strain_limit, runs.size());
    }
    TableWriter table(out, columns, format);
    for (const SizeSeries& s : all) {
        write_row(table, s, "log-log", fit_power_law_log(s.edge, s.strength));
        write_row(table, s, "non-linear", fit_power_law(s.edge, s.strength));
    }
}

}  // namespace graincrack
