#include "post/calibrate/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/kind/kind_surface.hpp"
#include "share/base/text.hpp"

namespace graincrack::calibrate {

std::string label_of(Ending ending) {
    return name_in({"runs are needed", "calibrated", "not reached", "contradictory", "undecided"}, ending);
}

std::vector<Residual> residuals_of(const std::vector<Response>& responses) {
    std::vector<Residual> residuals;
    for (const Response& r : responses) {
        if (r.target.use != Use::fit || r.target.is_elastic() || !r.surface) continue;
        residuals.push_back({&*r.surface, r.target.logarithm(r.target.value), r.target.log_deviation()});
    }
    return residuals;
}

std::vector<double> values_of(const Target& target, const std::vector<const Measures*>& runs) {
    std::vector<double> values;
    for (const Measures* run : runs) {
        const double value = target.read(*run);
        if (std::isfinite(value)) values.push_back(value);
    }
    return values;
}

void add_value(Response& response, const std::vector<const Measures*>& runs) {
    const std::vector<double> values = values_of(response.target, runs);
    response.values.push_back(values.empty() ? NAN : response.target.logarithm(sample(values).mean.value));
    response.tests += runs.size();
    response.measured += values.size();
}

std::size_t fit_surfaces(Fit& fit) {
    std::vector<DesignPoint> inner_points;
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < fit.points.size(); ++i) {
        if (!fit.box.contains(fit.points[i])) continue;
        inner_points.push_back(fit.points[i]);
        inside.push_back(i);
    }
    fit.shares.clear();
    for (Response& response : fit.responses) {
        std::vector<double> values;
        for (const std::size_t i : inside) values.push_back(response.values[i]);
        response.surface = LocalSurface::fit(fit.box, inner_points, values);
        const Target& t = response.target;
        if (t.use != Use::fit || !t.property.needs_first_peak || response.measured == response.tests) continue;
        Eigen::MatrixXd factors(static_cast<Eigen::Index>(inside.size()), fit.box.size());
        Eigen::VectorXd happened(factors.rows());
        for (Eigen::Index i = 0; i < factors.rows(); ++i) {
            factors.row(i) = inner_points[static_cast<std::size_t>(i)].transpose();
            happened(i) = std::isnan(values[static_cast<std::size_t>(i)]) ? 0 : 1;
        }
        fit.shares.push_back(fit_logistic(factors, happened));
    }
    return inside.size();
}

std::size_t specimens_of(const Response& response, const Study& study) {
    return response.surface->is_of_kind() ? 1 : study.specimens_at_point({response.target.test()});
}

namespace {

std::string verdict_on(const Target& target, const Sample& ours) {
    const double off = std::abs(ours.mean.value - target.value);
    const double error = ours.deviation ? *ours.deviation / std::sqrt(static_cast<double>(ours.n)) : 0;
    const Agreement agreement = agreement_of(target, ours.mean);
    const bool is_met = target.use == Use::fit && off <= target.deviation && error <= target.deviation;
    return agreement != Agreement::within && is_met ? "mean within" : name_of(agreement);
}

}  // namespace

Outcome outcome_of(const Target& target, const std::vector<const Measures*>& runs, const Study& study) {
    const std::vector<double> values = values_of(target, runs);
    Outcome outcome{target, {}, runs.size(), ""};
    if (!values.empty()) outcome.ours = positive_sample(values);
    const auto fraction = static_cast<double>(values.size()) / static_cast<double>(runs.size());
    if (std::isfinite(target.value)) {
        const bool lacking = target.property.needs_first_peak && fraction < study.first_peak_fraction;
        // A fitted one is asked of the specimen that it is tested on.
        const std::string caveat = target.use == Use::fit ? "" : target.caveat(study.specimens.bend());
        outcome.verdict = !caveat.empty() ? caveat : !outcome.ours || lacking ? "outside" : verdict_on(target, *outcome.ours);
    }
    return outcome;
}

std::size_t specimens_for(const Test& test, const Fit& fit, const Study& study) {
    const std::size_t most = study.most_specimens(test);
    std::size_t n = std::min<std::size_t>(3, most);
    for (const Response& response : fit.responses) {
        const Target& t = response.target;
        if (t.use != Use::fit || !test.has(t) || t.is_elastic()) continue;
        if (!response.surface) return most;
        const double scatter = response.surface->model().variance * static_cast<double>(specimens_of(response, study));
        const bool is_of_kind = response.surface->is_of_kind();
        const double known = is_of_kind ? response.surface->variance(fit.optimum.point) : INFINITY;
        const auto half = [&] {
            const double factor = is_of_kind ? deviations_of_95_percent : student_t_95(static_cast<int>(n) - 1);
            return factor / std::sqrt(1 / known + static_cast<double>(n) / scatter);
        };
        while (n < most && !(n > 1 && half() <= t.log_deviation())) ++n;
    }
    return n;
}

std::size_t more_specimens_for(const Test& test, const std::vector<const Measures*>& runs, const std::vector<Target>& targets,
                               const Fit& fit, const Study& study, bool until_decided) {
    std::size_t n = runs.size();
    for (const Target& t : targets) {
        if (t.use != Use::fit || !test.has(t) || outcome_of(t, runs, study).is_met()) continue;
        const Response* const response = find_of(fit.responses, t);
        if (!fit.points.empty()) return study.most_specimens(test);
        if (until_decided) n = 2 * runs.size();
        if (until_decided || t.is_elastic()) continue;  // grains are scaled
        LocalSurface expected = *response->surface;
        for (const double value : values_of(t, runs)) expected.learn(fit.optimum.point, t.logarithm(value), 1);
        const double off = expected.value(fit.optimum.point) - t.logarithm(t.value);
        if (std::abs(off) <= t.log_deviation()) n = 2 * runs.size();
    }
    return std::min(n, study.most_specimens(test));
}

namespace {

/// "UCS +12 % off (± 3 %)": SI values as parts of the target
std::string off_text(const Outcome& o) {
    const Target& t = o.target;
    if (!o.ours) return fmt::format("{}: none of {} tests has a value", t.symbol(), o.tests);
    const double scale = t.property.absolute ? 1 : 100 / t.value;
    const char* unit = t.property.absolute ? "" : " %";
    const double half = o.ours->mean.high ? *o.ours->mean.high - o.ours->mean.value : NAN;
    std::string text = fmt::format("{} differs by {:+.3g}{} (± {:.2g}{}, bound {:.2g}{})", t.symbol(),
                                   (o.ours->mean.value - t.value) * scale, unit, half * scale, unit, t.deviation * scale, unit);
    if (o.ours->n < o.tests) text += fmt::format(", {} of {} tests have a value", o.ours->n, o.tests);
    return text;
}

/// The prediction of the surfaces for a target that was not met.
struct Misfit {
    bool expected = false;      ///< it is off at the optimum of the surfaces too
    bool out_of_reach = false;  ///< no design point of the boxes has it
    std::string remedy;         ///< which parameter would have to go where
};

Misfit misfit_of(const Outcome& outcome, const Fit& fit, const Box& all, const std::vector<Parameter>& parameters) {
    const Target& t = outcome.target;
    const Response* const response = find_of(fit.responses, t);
    if (response == nullptr || t.is_elastic()) return {};
    if (!response->surface) {
        return {true, true,
                fmt::format("{} of {} tests of the designs have a value of {}", response->measured, response->tests, t.symbol())};
    }
    const DesignPoint& point = fit.optimum.point;
    const double requested = t.logarithm(t.value);
    const double here = response->surface->value(point);
    const double allowed = t.log_deviation() + 2 * std::sqrt(response->surface->variance(point));
    const bool lacking = outcome.ours && outcome.ours->n < outcome.tests && outcome.verdict == "outside";
    if (std::abs(here - requested) <= allowed && !lacking) return {};
    // This target alone may be in reach or not, by a surface through the points of all designs.
    const LocalSurface wide =
        response->surface->is_of_kind() ? *response->surface : *LocalSurface::fit(all, fit.points, response->values);
    double lowest = here;
    double highest = here;
    for (const DesignPoint& at : sobol_points(all, 0, 1024)) {
        const double spread = 2 * std::sqrt(wide.variance(at));
        lowest = std::min(lowest, wide.value(at) - spread);
        highest = std::max(highest, wide.value(at) + spread);
    }
    // The parameter that moves it most, and where it would have to go alone.
    const DesignPoint gradient = response->surface->gradient(point);
    Eigen::Index k = 0;
    gradient.cwiseAbs().maxCoeff(&k);
    const Parameter& p = parameters[static_cast<std::size_t>(k)];
    const double to = point(k) + (requested - here) / gradient(k);
    return {true, requested < lowest || requested > highest,
            fmt::format("{} alone would need {} to change from {} to {} (first box {} to {})", t.symbol(), p.key,
                        value_text(p.key, p.value(point(k)), " "),
                        std::abs(to) < 10 ? value_text(p.key, p.value(to), " ") : "far outside", value_text(p.key, p.low, " "),
                        value_text(p.key, p.high, " "))};
}

}  // namespace

Ended ending_of(const std::vector<Outcome>& outcomes, const Fit& fit, const Box& all, const std::vector<Parameter>& parameters,
                const Study& study) {
    std::string missed;
    std::string remedies;
    std::string wanted;
    bool expected = false;
    bool out_of_reach = false;
    bool outside = false;
    for (const Outcome& o : outcomes) {
        if (o.target.use == Use::predict || o.is_met()) continue;
        add(missed, off_text(o) + ": " + o.verdict);
        const Misfit misfit = misfit_of(o, fit, all, parameters);
        if (misfit.expected) add(remedies, misfit.remedy);
        expected = expected || misfit.expected;
        out_of_reach = out_of_reach || misfit.out_of_reach;
        outside = outside || o.verdict == "outside";
        if (o.ours && o.ours->deviation) {
            const double n =
                std::max(std::pow(2 * *o.ours->deviation / o.target.deviation, 2), 2.0 * static_cast<double>(o.tests));
            add(wanted, fmt::format("{:.0f} for {}", std::ceil(n), o.target.symbol()));
        }
    }
    if (missed.empty()) {
        return {Ending::calibrated, "means of new specimens are within the bounds of every target",
                "use calibrated.toml like any other material; predicted values were not fitted"};
    }
    remedies += "; free another parameter ([parameters]), or give a target a larger deviation";
    if (expected && out_of_reach) return {Ending::not_reached, missed, remedies};
    remedies = "each target can be reached, but not all of them together: " + remedies;
    if (expected) return {Ending::contradictory, missed, remedies};
    const std::string another =
        fit.points.empty()
            ? fmt::format("let them correct the surfaces once more (setting corrections={})", study.corrections + 1)
            : fmt::format("ask for one more design (setting zooms={})", study.zooms + 1);
    const std::string met = "the response surfaces predict that every target is met here: ";
    if (outside) return {Ending::undecided, missed, met + another};
    return {Ending::undecided, missed,
            fmt::format("confirm on more specimens, about {} (settings confirmation_discs=N, confirmation_rectangles=N), or "
                        "{}; settings are given by --set, or by SET= of make",
                        wanted, another)};
}

}  // namespace graincrack::calibrate
