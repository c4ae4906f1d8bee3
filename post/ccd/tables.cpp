#include "post/ccd/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/options/option_set.hpp"

namespace graincrack::ccd {

namespace {

std::vector<Factor> parse_factors(const std::vector<std::string>& texts) {
    std::vector<Factor> factors;
    for (const std::string& text : texts) factors.push_back(parse_factor(text));
    return factors;
}

void write_terms(TableWriter& table, const std::string& response, const LinearModel& model) {
    for (std::size_t i = 0; i < model.terms.size(); ++i) {
        const double error = model.standard_error(i);
        const Estimate value = estimate(model.coefficients[static_cast<Eigen::Index>(i)], error * error, model.freedom);
        const bool known = model.freedom > 0;
        table.row({response, model.terms[i].name(), value.value, known ? Cell(error) : Cell(),
                   known ? Cell(value.value / error) : Cell(), model.p_value(i), value.low, value.high});
    }
}

/// Sums of squares; that of a term is what leaving it out alone would add to the residual (partial, type III).
void write_anova(TableWriter& table, const std::string& response, const LinearModel& model) {
    const double variance = model.variance;
    const auto row = [&](const std::string& source, double sum, int freedom, std::optional<double> f, std::optional<double> p) {
        table.row({response, source, sum, static_cast<std::int64_t>(freedom), freedom > 0 ? Cell(sum / freedom) : Cell(), f, p});
    };
    const auto tested = model.significance();
    row("model", model.total_sum() - model.residual_sum(), static_cast<int>(model.terms.size()) - 1,
        tested ? std::optional(tested->f) : std::nullopt, tested ? std::optional(tested->p) : std::nullopt);
    for (std::size_t i = 1; i < model.terms.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double sum = model.coefficients(k) * model.coefficients(k) / model.inverse(k, k);
        row(model.terms[i].name(), sum, 1, variance > 0 ? std::optional(sum / variance) : std::nullopt, model.p_value(i));
    }
    row("residual", model.residual_sum(), model.freedom, std::nullopt, std::nullopt);
    if (const auto lack = model.lack_of_fit()) {
        row("lack of fit", lack->sum, lack->freedom, lack->f, lack->p);
        row("pure error", lack->pure_error_sum, lack->pure_error_freedom, std::nullopt, std::nullopt);
    }
    row("total", model.total_sum(), static_cast<int>(model.response.size()) - 1, std::nullopt, std::nullopt);
}

void write_summary(TableWriter& table, const std::string& response, const LinearModel& model) {
    const auto tested = model.significance();
    const auto lack = model.lack_of_fit();
    std::string names;
    for (const SurfaceTerm& term : model.terms) names += (names.empty() ? "" : ", ") + term.name();
    table.row({response, names, static_cast<std::int64_t>(model.response.size()), model.r_squared(), model.adjusted_r_squared(),
               model.predicted_r_squared(), model.press(), model.freedom > 0 ? Cell(std::sqrt(model.variance)) : Cell(),
               tested ? Cell(tested->f) : Cell(), tested ? Cell(tested->p) : Cell(), lack ? Cell(lack->f) : Cell(),
               lack ? Cell(lack->p) : Cell()});
}

struct FitTableForm {
    std::vector<std::string> columns;
    void (*write)(TableWriter&, const std::string&, const LinearModel&);
};

FitTableForm form_of(FitTable kind) {
    switch (kind) {
        case FitTable::anova: return {{"response", "source", "sum_of_squares", "freedom", "mean_square", "F", "p"}, write_anova};
        case FitTable::summary:
            return {{"response", "terms", "runs", "r_squared", "adjusted_r_squared", "predicted_r_squared", "press",
                     "residual_deviation", "F", "p", "lack_of_fit_F", "lack_of_fit_p"},
                    write_summary};
        case FitTable::terms: break;
    }
    return {{"response", "term", "coefficient", "standard_error", "t", "p", "low", "high"}, write_terms};
}

/// Bounds of the joint region along each factor, by a grid over the design.
struct RegionExtent {
    std::vector<double> low;
    std::vector<double> high;
    double share = 0;           ///< of the design that lies in the region
    bool reaches_edge = false;  ///< the region extends beyond the design
};

std::optional<RegionExtent> extent_of(const Problem& problem) {
    if (!problem.confidence.is_known()) return std::nullopt;
    const Region design(problem.runs.coded);
    const std::size_t n = design.n_factors();
    const std::size_t fine = n == 1 ? 2001 : n == 2 ? 201 : n == 3 ? 41 : 11;
    const auto places = design.grid(fine);
    RegionExtent extent{std::vector<double>(n, HUGE_VAL), std::vector<double>(n, -HUGE_VAL), 0, false};
    const auto beyond = [&](std::vector<double> place) {
        for (double& x : place) x *= 1 + 2.0 / static_cast<double>(fine);
        return !design.holds(place);
    };
    std::size_t inside = 0;
    for (const auto& place : places) {
        if (!problem.confidence.holds(place)) continue;
        ++inside;
        extent.reaches_edge = extent.reaches_edge || beyond(place);
        for (std::size_t k = 0; k < n; ++k) {
            extent.low[k] = std::min(extent.low[k], place[k]);
            extent.high[k] = std::max(extent.high[k], place[k]);
        }
    }
    if (inside == 0) return std::nullopt;
    extent.share = static_cast<double>(inside) / static_cast<double>(places.size());
    return extent;
}

std::vector<Goal> parse_goals(const GoalOptions& options) {
    std::vector<Goal> goals;
    for (const auto& text : options.targets) goals.push_back(parse_goal(text, Goal::Kind::target, "--target"));
    for (const auto& text : options.maxima) goals.push_back(parse_goal(text, Goal::Kind::maximum, "--maximise"));
    for (const auto& text : options.minima) goals.push_back(parse_goal(text, Goal::Kind::minimum, "--minimise"));
    if (goals.empty()) throw UsageError("ccd solve: no goal; give --target NAME=VALUE, --maximise or --minimise");
    return goals;
}

}  // namespace

void add_model(OptionSet set, ModelOptions& options) {
    add_texts(set, "--factor", options.factors, "NAME=LOW:HIGH", "factor with its values at -1 and +1, if the table has no x1");
    add_choice<bool>(set, "--model", options.choice.reduce, {{"full", false}, {"backward", true}},
                     "full: all quadratic terms; backward: reduced by backward elimination that keeps the hierarchy");
    static constexpr Quantity significance{"alpha", Dimension::one, 0, 1, "level of significance", true};
    add_quantity(set, "--alpha", options.choice.alpha, significance, "p value above which elimination removes a term", "0.1");
}

void add_goals(OptionSet set, GoalOptions& options) {
    add_texts(set, "--target", options.targets, "NAME=[LOW:]TARGET[:HIGH]",
              "wanted value of a response; limits default to the measured extremes");
    add_texts(set, "--maximise", options.maxima, "NAME=LOW:GOOD",
              "response to be as large as possible: desirability 0 at LOW, 1 at GOOD");
    add_texts(set, "--minimise", options.minima, "NAME=GOOD:HIGH",
              "response to be as small as possible: desirability 1 at GOOD, 0 at HIGH");
}

void write_design(std::ostream& out, const DesignOptions& options, TableFormat format) {
    const std::vector<Factor> factors = parse_factors(options.factors);
    constexpr std::size_t most = 10;
    if (factors.empty() || factors.size() > most) {
        throw UsageError(fmt::format("--factor: {} given; 1 to {} factors NAME=LOW:HIGH are needed", factors.size(), most));
    }
    std::vector<std::string> columns{"run"};
    for (std::size_t k = 0; k < factors.size(); ++k) columns.push_back(fmt::format("x{}", k + 1));
    for (const Factor& factor : factors) columns.push_back(factor.name);
    TableWriter table(out, columns, format);
    std::int64_t number = 0;
    for (const auto& coded : coded_runs(factors.size(), options.star, options.centre_runs)) {
        std::vector<Cell> row{++number};
        for (const double x : coded) row.emplace_back(x);
        for (std::size_t k = 0; k < factors.size(); ++k) row.emplace_back(factors[k].value(coded[k]));
        table.row(row);
    }
}

void write_fit(std::ostream& out, const std::string& file, const FitOptions& options, TableFormat format) {
    if (options.responses.empty()) throw UsageError("ccd fit: no response; give --response NAME, a column of the table");
    const TableFile input(file);
    const Runs runs = read_runs(input, parse_factors(options.model.factors));
    std::vector<LinearModel> models;
    for (const auto& response : options.responses) models.push_back(fit_response(input, runs, response, options.model.choice));
    const FitTableForm form = form_of(options.table);
    TableWriter table(out, form.columns, format);
    for (std::size_t i = 0; i < models.size(); ++i) form.write(table, options.responses[i], models[i]);
}

Problem solve_problem(const std::string& file, const SolveOptions& options) {
    std::vector<Goal> goals = parse_goals(options.goals);
    const TableFile input(file);
    Runs runs = read_runs(input, parse_factors(options.model.factors));
    std::vector<LinearModel> models;
    std::vector<LinearModel> with_target;
    std::vector<double> targets;
    for (Goal& goal : goals) {
        set_limits(goal, input.numbers(goal.response));
        models.push_back(fit_response(input, runs, goal.response, options.model.choice));
        if (goal.kind != Goal::Kind::target) continue;
        with_target.push_back(models.back());
        targets.push_back(goal.target);
    }
    std::vector<Optimum> optima = solve(models, goals, Region(runs.coded));
    if (optima.empty()) {
        throw InputError(input.name() + ": the desirability is 0 everywhere within the design; widen the limits of the goals");
    }
    return {
        std::move(runs), std::move(goals), std::move(models), std::move(optima), {std::move(with_target), std::move(targets)}};
}

void write_solution(std::ostream& out, const std::string& file, const SolveOptions& options, TableFormat format) {
    const Problem problem = solve_problem(file, options);
    const std::optional<RegionExtent> extent = extent_of(problem);
    Columns<Optimum> columns;
    const auto add = [&columns](const std::string& name, const std::function<Cell(const Optimum&)>& value) {
        columns.push_back({name, unit::none, value});
    };
    add("optimum", [&](const Optimum& o) { return 1 + (&o - problem.optima.data()); });
    for (std::size_t k = 0; k < problem.runs.factors.size(); ++k) {
        add(fmt::format("x{}", k + 1), [k](const Optimum& o) { return o.coded[k]; });
    }
    for (std::size_t k = 0; k < problem.runs.factors.size(); ++k) {
        const Factor& factor = problem.runs.factors[k];
        const bool is_coded = factor.name == fmt::format("x{}", k + 1);  // which stands there
        if (!is_coded) add(factor.name, [&factor, k](const Optimum& o) { return factor.value(o.coded[k]); });
        for (const auto& [end, bounds] : {std::pair{"_region_low", &RegionExtent::low}, {"_region_high", &RegionExtent::high}}) {
            Cell bound = extent ? Cell(factor.value(((*extent).*bounds)[k])) : Cell();
            add(factor.name + end, [bound](const Optimum&) { return bound; });
        }
    }
    add("desirability", [](const Optimum& o) { return o.desirability; });
    add("region_share_of_design", [&](const Optimum&) { return extent ? Cell(extent->share) : Cell(); });
    add("region_reaches_edge", [&](const Optimum&) { return extent ? Cell(extent->reaches_edge ? "yes" : "no") : Cell(); });
    add("free_factors", [](const Optimum& o) { return o.free_factors; });
    for (std::size_t i = 0; i < problem.goals.size(); ++i) {
        const std::string& name = problem.goals[i].response;
        const LinearModel& model = problem.models[i];
        add(name, [&model](const Optimum& o) { return model.value(o.coded); });
        add(name + "_confidence_low", [&model](const Optimum& o) { return model.confidence(o.coded).low; });
        add(name + "_confidence_high", [&model](const Optimum& o) { return model.confidence(o.coded).high; });
        add(name + "_prediction_low", [&model](const Optimum& o) { return model.prediction(o.coded).low; });
        add(name + "_prediction_high", [&model](const Optimum& o) { return model.prediction(o.coded).high; });
    }
    write_table(out, columns, problem.optima, format);
}

}  // namespace graincrack::ccd
