// Pictures of the course of a test: counts of cracks, energy, acoustic emission.
#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "post/run/test_label.hpp"
#include "share/base/error.hpp"

namespace graincrack {

namespace {

/// An axis with the values of a run's history on it.
struct Course {
    Axis axis;
    std::vector<double> values;
};

/// Time in ms, or axial strain in %, positive in the sense of the test; time for a run that was not loaded along its axis.
Course course_of(const RunData& run, Abscissa abscissa) {
    const double sense = run.header.loading() == Loading::tension ? 100 : -100;
    const std::vector<double> strain = times(run.history[HistoryColumn::axial_strain], sense);
    const bool by_strain = abscissa == Abscissa::strain && largest(strain) > 0;
    std::vector<double> values = by_strain ? strain : times(run.history[HistoryColumn::time], 1e3);
    const Axis axis{by_strain ? "axial strain, %" : "time, ms", std::min(0.0, smallest(values)), 1.03 * largest(values)};
    return {axis, std::move(values)};
}

using Moment = CrackCounts::Moment;

template <class Get>
std::vector<double> column(const CrackCounts& counts, const Get& get) {
    std::vector<double> values;
    for (const Moment& m : counts.moments) values.push_back(get(m));
    return values;
}

struct CountCurve {
    std::string label;
    std::vector<double> counts;
    Stroke stroke;
};

constexpr std::size_t most_pairs = 6;  ///< beside the others: as many as there are colours

/// The pairs in the order of their cracks by the end, the most first.
std::vector<std::size_t> pairs_by_cracks(const CrackCounts& counts) {
    std::vector<std::size_t> pairs(counts.classes.size());
    std::iota(pairs.begin(), pairs.end(), 0);
    const auto cracks = [&](std::size_t pair) {
        const ModeCounts& last = counts.moments.back().by_class[pair];
        return last.tensile + last.shear;
    };
    std::stable_sort(pairs.begin(), pairs.end(), [&](std::size_t a, std::size_t b) { return cracks(a) > cracks(b); });
    return pairs;
}

/// Both modes of some pairs together.
void add_pairs(std::vector<CountCurve>& curves, const CrackCounts& counts, std::span<const std::size_t> pairs,
               const std::string& name, Colour colour) {
    const auto sum = [&](double ModeCounts::*mode) {
        return column(counts, [&](const Moment& m) {
            double all = 0;
            for (const std::size_t pair : pairs) all += m.by_class[pair].*mode;
            return all;
        });
    };
    curves.push_back({name + ", tensile", sum(&ModeCounts::tensile), {colour, 4}});
    curves.push_back({name + ", shear", sum(&ModeCounts::shear), {colour, 3, Dash::dashed}});
}

std::vector<CountCurve> count_curves(const CrackCounts& counts, bool by_class) {
    if (!by_class) {
        return {{"tensile", column(counts, [](const Moment& m) { return m.all.tensile; }), {palette::tensile, 4}},
                {"shear", column(counts, [](const Moment& m) { return m.all.shear; }), {palette::shear, 3.5, Dash::dashed}}};
    }
    std::vector<CountCurve> curves;
    const std::vector<std::size_t> pairs = pairs_by_cracks(counts);
    const std::size_t own = pairs.size() > most_pairs + 1 ? most_pairs : pairs.size();
    for (std::size_t i = 0; i < own; ++i) {
        add_pairs(curves, counts, std::span(pairs).subspan(i, 1), mineral_label(counts.classes[pairs[i]]), palette::series(i));
    }
    if (own < pairs.size()) add_pairs(curves, counts, std::span(pairs).subspan(own), "other pairs", palette::series(own));
    std::erase_if(curves, [](const CountCurve& curve) { return curve.counts.back() == 0; });
    return curves;
}

}  // namespace

Drawing draw_counts(const CrackCounts& counts, const RunData& run, const std::string& definition, const CountsOptions& options,
                    const PictureStyle& style) {
    const ModeCounts& last = counts.moments.back().all;
    if (last.tensile + last.shear == 0) {
        throw InputError(run.name + ": no micro-cracks; counts over the loading need a run with some");
    }
    const bool by_class = options.by_class && counts.classes.size() > 1;
    const std::vector<CountCurve> curves = count_curves(counts, by_class);
    const std::vector<double> stress = column(counts, [](const Moment& m) { return 1e-6 * m.stress; });
    double most = 0;
    for (const CountCurve& curve : curves) most = std::max(most, curve.counts.back());
    const Course course = course_of(run, options.abscissa);
    Chart chart(
        style,
        {test_title(run.header), {fmt::format("seed {}, {} crystals", run.specimen.seed, run.specimen.crystals)}, {definition}},
        course.axis, Axis{"micro-cracks (contacts)", 0, 1.08 * most}, {Axis{"stress, MPa", 0, 1.08 * largest(stress)}});
    const Stroke load{palette::rim, 4.5, Dash::dotted};
    chart.line(course.values, stress, load, "", Chart::Side::right);
    for (const CountCurve& curve : curves) chart.line(course.values, from_first(curve.counts), curve.stroke, curve.label);
    chart.legend(load, "stress, right");
    if (by_class) chart.add_note("pairs without cracks of a mode have no curve");
    return chart.finish();
}

namespace {

struct Term {
    HistoryColumn column;
    const char* label;
    Stroke stroke;
};

const std::vector<Term>& terms() {
    using enum HistoryColumn;
    static const std::vector<Term> all{{energy_external, "external work", {palette::ink, 5}},
                                       {energy_strain, "strain", {palette::series(0), 4}},
                                       {energy_contact, "contacts", {palette::series(4), 4, Dash::long_dashed}},
                                       {energy_fracture_tension, "fracture, tension", {palette::tensile, 4, Dash::dash_dot}},
                                       {energy_fracture_shear, "fracture, shear", {palette::tensile, 4.5, Dash::dotted}},
                                       {energy_friction, "friction", {palette::series(2), 4, Dash::dashed}},
                                       {energy_damping, "damping", {palette::series(3), 6, Dash::dotted}},
                                       {energy_platen, "platens", {palette::series(5), 3, Dash::dashed}},
                                       {energy_kinetic, "kinetic", {palette::series(6), 2.5, Dash::dash_dot}},
                                       {non_conservative_work, "non-conservative work", {palette::rim, 2}}};
    return all;
}

/// Terms smaller than this share of the largest are nothing in a picture.
constexpr double least_share = 1e-3;

double magnitude(const std::vector<double>& values) { return std::max(largest(values), -smallest(values)); }

}  // namespace

Drawing draw_energy(const RunData& run, Abscissa abscissa, const PictureStyle& style) {
    const Course course = course_of(run, abscissa);
    std::vector<double> all;
    for (const Term& term : terms()) all.insert(all.end(), run.history[term.column].begin(), run.history[term.column].end());
    const auto [low, high] = padded_range(all, 0.04);
    Chart chart(
        style,
        {test_title(run.header),
         {fmt::format("energy balance per metre of thickness; largest residual {:.2g} % of the peak stored energy; damping "
                      "took {:.2g} % of the work",
                      100 * run.header.energy_balance_error, 100 * run.header.damping_share)}},
        course.axis, Axis{"energy, J/m", low, high});
    if (const auto curve = load_curve_if_any(run)) {
        const double peak = course.values[curve->peak];
        chart.line({peak, low}, {peak, high}, {palette::rim, 2, Dash::dashed}, curve->peak_name());
    }
    std::string left_out;
    for (const Term& term : terms()) {
        const std::vector<double>& values = run.history[term.column];
        if (magnitude(values) < least_share * magnitude(all)) {
            left_out += (left_out.empty() ? "" : ", ") + std::string(term.label);
            continue;
        }
        chart.line(course.values, values, term.stroke, term.label);
    }
    if (!left_out.empty()) chart.add_note("below 0.1 % of the largest, and not shown: " + left_out);
    return chart.finish();
}

Drawing draw_emission(const std::vector<EmissionEvent>& events, const std::string& title, const std::string& run,
                      const PictureStyle& style) {
    std::vector<double> magnitudes = magnitudes_of(events);
    if (magnitudes.empty()) throw InputError(run + ": no events of acoustic emission; the run has no micro-cracks");
    std::sort(magnitudes.begin(), magnitudes.end());
    std::vector<double> number;
    for (std::size_t i = 0; i < magnitudes.size(); ++i) number.push_back(static_cast<double>(magnitudes.size() - i));
    const auto fit = fit_gutenberg_richter(magnitudes, completeness_of(magnitudes));
    std::vector<std::string> subtitle{counted(events.size(), "event")};
    const bool is_line = fit && fit->follows_line();
    subtitle[0] += !fit      ? ", too few for a slope"
                   : is_line ? fmt::format(", b = {:.2f} ± {:.2f} from magnitude {:.2f} ({} events)", fit->b, fit->error,
                                           fit->completeness, fit->events)
                             : fmt::format(
                                   ", no slope b: from magnitude {:.2f} on they do not lie on a line (farthest {:.2f}, at most "
                                   "{:.2f} by chance)",
                                   fit->completeness, fit->distance, fit->distance_by_chance());
    const auto [low, high] = padded_range(magnitudes, 0.08);
    Chart chart(style, {title, subtitle}, Axis{"magnitude, per metre of thickness", low, high},
                Axis{"events at or above", 0.8, 1.5 * number.front(), true});
    chart.points(magnitudes, number, {palette::series(0), MarkerShape::disc, 9}, "events");
    if (is_line) {
        const auto n = static_cast<double>(fit->events);
        chart.line({fit->completeness, n}, {fit->completeness + std::log10(n) / fit->b, 1}, {palette::ink, 3.5}, "slope b (Aki)");
    }
    return chart.finish();
}

}  // namespace graincrack
