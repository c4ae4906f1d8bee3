// The runs of a design as a table holds them: coded factors, the values they stand for, and responses.
#pragma once

#include <string>
#include <vector>

#include "post/ccd/design.hpp"
#include "post/ccd/model.hpp"
#include "share/base/table_file.hpp"

namespace graincrack::ccd {

/// Runs with factors x1 … xk.
struct Runs {
    std::vector<std::vector<double>> coded;  ///< runs × factors
    /// The quantity of each factor with its values at −1 and +1. A factor without one is named x1 …, from −1 to 1.
    std::vector<Factor> factors;
};

/// Reads the columns x1, x2, …; the quantity of a factor is the column that is linear in it (as `ccd design` writes them).
/// Factors in `given` have precedence: they name their columns, which are coded by them if the table has no x1.
/// \throws InputError if there is neither
Runs read_runs(const TableFile& table, const std::vector<Factor>& given);

/// Reads "NAME=LOW:HIGH". \throws UsageError
Factor parse_factor(const std::string& text);

/// How models are fitted: the full quadratic, or reduced by backward elimination.
struct ModelChoice {
    bool reduce = false;
    double alpha = 0.1;  ///< p above which a term is left out
};
/// A model of one response. \throws InputError for a missing column or too few runs
Model fit_response(const TableFile& table, const Runs& runs, const std::string& response, const ModelChoice& choice);

}  // namespace graincrack::ccd
