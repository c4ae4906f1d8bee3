// Central composite designs: the runs from which a full quadratic in k factors can be fitted, and such runs as a table holds
// them: coded factors, the values they stand for, and responses.
#pragma once

#include <string>
#include <vector>

#include "post/statistics/linear_model.hpp"
#include "share/base/table_file.hpp"

namespace graincrack::ccd {

/// An option of the form NAME=NUMBER:NUMBER….
struct Assignment {
    std::string name;
    std::vector<double> values;
};
/// \throws UsageError naming `option` and the `form` that would be right
Assignment parse_assignment(const std::string& text, const std::string& option, const std::string& form);

/// A factor with its values at the coded levels −1 and +1, in any unit; values derived from it have the same unit.
struct Factor {
    std::string name;
    double low = 0;
    double high = 0;
    [[nodiscard]] double centre() const { return (low + high) / 2; }
    [[nodiscard]] double step() const { return (high - low) / 2; }
    [[nodiscard]] double value(double coded) const { return centre() + coded * step(); }
    [[nodiscard]] double coded(double value) const { return (value - centre()) / step(); }
};

/// The position of the star points.
enum class Star {
    rotatable,    ///< α = (2^k)^¼: the variance of prediction depends on the distance from the centre alone; √2 for k = 2
    face_centred  ///< α = 1: all values stay within [low, high]
};
double star_distance(Star star, std::size_t n_factors);

/// Coded runs: 2^k corners (the first factor changes fastest), 2k star points (−, + for each factor), centre runs.
std::vector<std::vector<double>> coded_runs(std::size_t n_factors, Star star, std::size_t n_centre);

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
/// The full quadratic through a response, with a value for each run. \throws InputError if there are too few runs for its terms
LinearModel fit_quadratic(const std::vector<std::vector<double>>& coded, const std::vector<double>& response);
/// A model of one response. \throws InputError for a missing column or too few runs
LinearModel fit_response(const TableFile& table, const Runs& runs, const std::string& response, const ModelChoice& choice);

}  // namespace graincrack::ccd
