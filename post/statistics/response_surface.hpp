// Response surfaces: a polynomial of degree two in several factors, fitted to runs by least squares, reduced or extended term by
// term, with its errors and what it predicts.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "post/statistics/statistics.hpp"

namespace graincrack {

/// A product of powers of factors: power[k] of factor k. The constant has all zero.
struct SurfaceTerm {
    std::vector<int> power;
    [[nodiscard]] double operator()(const std::vector<double>& factors) const;
    /// Derivative by a factor.
    [[nodiscard]] double slope(const std::vector<double>& factors, std::size_t factor) const;
    [[nodiscard]] int degree() const;
    /// "1", "x1", "x1 x2", "x1^2"
    [[nodiscard]] std::string name() const;
    /// True if this term divides another: x1 and x2 are parents of x1 x2.
    [[nodiscard]] bool is_parent_of(const SurfaceTerm& other) const;
    bool operator==(const SurfaceTerm&) const = default;
};

/// Constant, linear terms, products of two, squares: in this order, as in Eq 19.
std::vector<SurfaceTerm> quadratic_terms(std::size_t n_factors);

struct FTest {
    double f = 0;
    double p = 0;
};

/// Lack of fit against pure error from runs at equal factors.
struct LackOfFit : FTest {
    double sum = 0;
    int freedom = 0;
    double pure_error_sum = 0;
    int pure_error_freedom = 0;
};

struct ResponseSurface {
    std::vector<SurfaceTerm> terms;
    std::vector<std::vector<double>> factors;  ///< of each run
    std::vector<double> response;              ///< of each run
    Eigen::MatrixXd design;                    ///< terms of each run, X
    Eigen::MatrixXd inverse;                   ///< (XᵀX)⁻¹
    Eigen::VectorXd coefficients;
    Eigen::VectorXd residuals;  ///< of each run
    Eigen::VectorXd leverages;  ///< of each run

    /// Least squares. Empty if there are fewer runs than terms, or the terms depend on each other there.
    static std::optional<ResponseSurface> fit(std::vector<SurfaceTerm> terms, std::vector<std::vector<double>> factors,
                                              std::vector<double> response);

    [[nodiscard]] int freedom() const { return static_cast<int>(design.rows() - design.cols()); }
    [[nodiscard]] double residual_sum() const { return residuals.squaredNorm(); }  ///< Σ (y − ŷ)²
    [[nodiscard]] double total_sum() const;                                        ///< Σ (y − ȳ)²
    /// Σ of squared residuals, each predicted without its own run (Allen 1974).
    [[nodiscard]] double press() const;
    /// The same with one more term; infinite if it depends on the others.
    [[nodiscard]] double press_with(const SurfaceTerm& term) const;
    /// Residual variance; 0 without degrees of freedom.
    [[nodiscard]] double variance() const { return freedom() > 0 ? residual_sum() / freedom() : 0; }
    [[nodiscard]] double standard_error(std::size_t term) const;
    [[nodiscard]] double r_squared() const;
    /// Corrected for the number of terms; empty without degrees of freedom.
    [[nodiscard]] std::optional<double> adjusted_r_squared() const;
    [[nodiscard]] double predicted_r_squared() const;

    [[nodiscard]] double value(const std::vector<double>& at) const { return row(at).dot(coefficients); }
    /// Variance of the fitted mean over the residual variance, xᵀ (XᵀX)⁻¹ x.
    [[nodiscard]] double leverage(const std::vector<double>& at) const;
    /// The mean with its 95 % confidence interval.
    [[nodiscard]] Estimate confidence(const std::vector<double>& at) const { return with_interval(at, 0); }
    /// A single new run with its 95 % prediction interval.
    [[nodiscard]] Estimate prediction(const std::vector<double>& at) const { return with_interval(at, 1); }
    /// Derivative of each term by each factor: terms × factors.
    [[nodiscard]] Eigen::MatrixXd slopes(const std::vector<double>& at) const;

    /// Partial F test of a term (1 degree of freedom): p of leaving it out. Empty without degrees of freedom.
    [[nodiscard]] std::optional<double> p_value(std::size_t term) const;
    /// F test of all terms but the constant.
    [[nodiscard]] std::optional<FTest> significance() const;
    /// Empty without repeated runs that scatter, or without degrees of freedom beyond them.
    [[nodiscard]] std::optional<LackOfFit> lack_of_fit() const;

private:
    [[nodiscard]] Eigen::VectorXd row(const std::vector<double>& at) const;
    [[nodiscard]] Estimate with_interval(const std::vector<double>& at, double own_variance) const;
};

/// Leaves out, one by one, the term with the largest p above alpha; never the constant, nor a term whose product or square
/// is still there (hierarchy).
ResponseSurface eliminate_backward(ResponseSurface surface, double alpha);

/// Adds, one by one, the candidate that reduces PRESS most, until none reduces it or the degrees of freedom are as few as half of
/// the runs.
ResponseSurface extend_forward(ResponseSurface surface, const std::vector<SurfaceTerm>& candidates);

/// P(F > f) of Fisher's distribution.
double f_tail(double f, int numerator_freedom, int denominator_freedom);
/// The f that is exceeded with the probability `tail`.
double f_quantile(double tail, int numerator_freedom, int denominator_freedom);
/// P(|t| > …) of Student's distribution.
double t_tail(double t, int freedom);

}  // namespace graincrack
