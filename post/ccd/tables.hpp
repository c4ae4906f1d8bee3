// Tables of ccd design, fit and solve.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/ccd/design.hpp"
#include "post/ccd/runs.hpp"
#include "post/ccd/solve.hpp"
#include "post/table/table.hpp"

namespace graincrack::ccd {

/// What a call of ccd asks for; each command uses its part.
struct Options {
    std::vector<std::string> factors;  ///< NAME=LOW:HIGH
    Star star = Star::rotatable;
    std::size_t centre_runs = 5;
    std::vector<std::string> responses;
    ModelChoice model;
    enum class FitTable { terms, anova, summary } fit_table = FitTable::terms;
    std::vector<std::string> targets;
    std::vector<std::string> maxima;
    std::vector<std::string> minima;
};

/// run, x1 …, then a column for each factor. \throws UsageError without factors, or with more than ten
void write_design(std::ostream& out, const Options& options, TableFormat format);

/// Coefficients, analysis of variance, or what the model is worth, for each response.
void write_fit(std::ostream& out, const std::string& file, const Options& options, TableFormat format);

/// A problem as it is solved: models and goals of equal length, and what else the answer needs.
struct Problem {
    Runs runs;
    std::vector<Goal> goals;
    std::vector<Model> models;
    std::vector<Optimum> optima;
    ConfidenceRegion confidence;  ///< of the responses with targets
};
/// \throws UsageError without goals, InputError if no place within the design is of any use
Problem solve_problem(const std::string& file, const Options& options);

/// A row an optimum: coded and real factors, the joint region of the factors, each response with its intervals.
void write_solution(std::ostream& out, const std::string& file, const Options& options, TableFormat format);

}  // namespace graincrack::ccd
