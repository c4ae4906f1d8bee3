// Desirability of responses (Derringer & Suich 1980): how near each response comes to its goal, and all of them together; factors
// at which the responses meet their goals: the largest desirability within the design.
#pragma once

#include <string>
#include <vector>

#include "post/statistics/linear_model.hpp"

namespace graincrack::ccd {

/// The goal for a response.
struct Goal {
    enum class Kind { target, maximum, minimum } kind = Kind::target;
    std::string response;
    double low = 0;     ///< target, maximum: desirability 0 at or below
    double target = 0;  ///< target: the best value; maximum, minimum: desirability 1 from here on
    double high = 0;    ///< target, minimum: desirability 0 at or above
    /// 0 (useless) to 1 (goal reached), linear between.
    [[nodiscard]] double operator()(double response_value) const;
};

/// Reads "NAME=T" or "NAME=LOW:T:HIGH" (target), "NAME=LOW:GOOD" (maximum), "NAME=GOOD:HIGH" (minimum). Without limits a
/// target takes them from `set_limits`. \throws UsageError naming `option`
Goal parse_goal(const std::string& text, Goal::Kind kind, const std::string& option);

/// The limits of a target that has none: the extremes of the measured responses.
/// \throws UsageError if the target is not between them
void set_limits(Goal& goal, const std::vector<double>& measured);

/// Geometric mean. \pre values is not empty
double overall_desirability(const std::vector<double>& values);

/// The region in which a design allows predictions: each factor within the range of its runs, and no farther from the centre than
/// the farthest run.
class Region {
public:
    explicit Region(const std::vector<std::vector<double>>& coded);
    [[nodiscard]] bool holds(const std::vector<double>& coded) const;
    [[nodiscard]] double low(std::size_t factor) const { return low_[factor]; }
    [[nodiscard]] double high(std::size_t factor) const { return high_[factor]; }
    [[nodiscard]] std::size_t n_factors() const { return low_.size(); }
    /// Points of a grid over the region, `per_factor` along each factor.
    [[nodiscard]] std::vector<std::vector<double>> grid(std::size_t per_factor) const;

private:
    std::vector<double> low_;
    std::vector<double> high_;
    double radius_ = 0;
};

struct Optimum {
    std::vector<double> coded;
    double desirability = 0;
    /// Factors that the goals leave free: with fewer targets than factors all goals are met along a line or more, of which this
    /// is the place nearest to the centre.
    std::size_t free_factors = 0;
};

/// All places of the largest desirability that the search finds, the nearest to the centre first: a grid, then simplexes
/// (Nelder–Mead, GSL) from its best points. One place if the goals leave factors free. Empty if the desirability is 0 everywhere.
/// \param models one for each goal
std::vector<Optimum> solve(const std::vector<LinearModel>& models, const std::vector<Goal>& goals, const Region& region);

/// The factors for which the targets lie within the joint 95 % confidence region of the responses' means (Box & Hunter
/// 1954): δᵀ V⁻¹ δ ≤ q ν/(ν − q + 1) F(q, ν − q + 1), δ the q differences to the targets, V_ij = S_ij √(h_i h_j), S the
/// covariance of the residuals with ν degrees of freedom, h the leverages.
class ConfidenceRegion {
public:
    /// \param models of the responses that have targets, one for each; the same runs in all
    ConfidenceRegion(std::vector<LinearModel> models, std::vector<double> targets);
    /// True if the residuals have enough degrees of freedom for a region.
    [[nodiscard]] bool is_known() const { return limit_ > 0; }
    /// The statistic over its limit: up to 1 within the region.
    [[nodiscard]] double operator()(const std::vector<double>& coded) const;
    [[nodiscard]] bool holds(const std::vector<double>& coded) const { return (*this)(coded) <= 1; }

private:
    std::vector<LinearModel> models_;
    std::vector<double> targets_;
    Eigen::MatrixXd covariance_;
    double limit_ = 0;
};

}  // namespace graincrack::ccd
