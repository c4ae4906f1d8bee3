// Tables of ccd design, fit and solve.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/ccd/design.hpp"
#include "post/ccd/solve.hpp"
#include "post/options/command.hpp"
#include "post/table/table.hpp"

namespace graincrack::ccd {

struct DesignOptions {
    std::vector<std::string> factors;  ///< NAME=LOW:HIGH
    Star star = Star::rotatable;
    std::size_t centre_runs = 5;
};
/// run, x1 …, then a column for each factor. \throws UsageError without factors, or with more than ten
void write_design(std::ostream& out, const DesignOptions& options, TableFormat format);

/// How a model is fitted to the runs of a table.
struct ModelOptions {
    std::vector<std::string> factors;  ///< NAME=LOW:HIGH, for a table without coded factors
    ModelChoice choice;
};

enum class FitTable { terms, anova, summary };
struct FitOptions {
    ModelOptions model;
    std::vector<std::string> responses;
    FitTable table = FitTable::terms;
};
/// Coefficients, analysis of variance, or measures of the goodness of fit, for each response. \throws UsageError without
/// responses
void write_fit(std::ostream& out, const std::string& file, const FitOptions& options, TableFormat format);

/// Goals for the responses: NAME=[LOW:]TARGET[:HIGH], NAME=LOW:GOOD, NAME=GOOD:HIGH.
struct GoalOptions {
    std::vector<std::string> targets;
    std::vector<std::string> maxima;
    std::vector<std::string> minima;
};
struct SolveOptions {
    ModelOptions model;
    GoalOptions goals;
};

inline constexpr FileArguments design_table{"table", "table of the runs: x1, x2, … and the responses"};
/// --factor, --model, --alpha: how a model is fitted to the runs of a design.
void add_model(OptionSet set, ModelOptions& options);
/// --target, --maximise, --minimise: the goals for the responses.
void add_goals(OptionSet set, GoalOptions& options);

/// A solved problem: a model for each goal, the optima, and the confidence region of the factors.
struct Problem {
    Runs runs;
    std::vector<Goal> goals;
    std::vector<LinearModel> models;
    std::vector<Optimum> optima;
    ConfidenceRegion confidence;  ///< of the responses with targets
};
/// \throws UsageError without goals, InputError if the desirability is 0 everywhere within the design
Problem solve_problem(const std::string& file, const SolveOptions& options);

/// A row an optimum: coded and real factors, the joint region of the factors, each response with its intervals.
void write_solution(std::ostream& out, const std::string& file, const SolveOptions& options, TableFormat format);

}  // namespace graincrack::ccd
