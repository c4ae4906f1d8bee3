// Linear models: a response as a sum of terms of several factors, whose coefficients are fitted to observations by least squares
// or restricted likelihood, reduced or extended term by term, and updated; with their errors and what they predict.
#pragma once

#include <Eigen/Core>
#include <cmath>
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

/// Lack of fit against pure error from observations at equal factors.
struct LackOfFit : FTest {
    double sum = 0;
    int freedom = 0;
    double pure_error_sum = 0;
    int pure_error_freedom = 0;
};

struct LinearModel {
    std::vector<SurfaceTerm> terms;
    Eigen::VectorXd coefficients;
    Eigen::MatrixXd inverse;  ///< covariance of the coefficients over `variance`; by least squares (XᵀX)⁻¹
    double variance = 0;      ///< of an observation about the model; 0 without degrees of freedom
    int freedom = 0;          ///< degrees of freedom
    int n_values = 0;         ///< observations of fit and updates

    std::vector<std::vector<double>> factors;  ///< of each observation of the fit, as all that follows
    std::vector<double> response;
    Eigen::MatrixXd design;  ///< terms, X
    Eigen::VectorXd residuals;
    Eigen::VectorXd leverages;

    /// Least squares. Empty if there are fewer observations than terms, or the terms depend on each other there.
    static std::optional<LinearModel> fit(std::vector<SurfaceTerm> terms, std::vector<std::vector<double>> factors,
                                          std::vector<double> response);
    /// Least squares in which the coefficients behind the first `n_free` are drawn to 0, as normal numbers about it, with that
    /// weight by which the observations are most likely (empirical Bayes, restricted likelihood); each is at most about the
    /// scatter of an observation, as few of these would bend without end. Those on one specimen scatter together, by a
    /// correlation that is found likewise; `design`, `response` and what follows from them are then of independent combinations
    /// with the same variance. Empty unless there are two observations more than free terms, which they determine.
    /// \param specimens of each observation
    static std::optional<LinearModel> fit_restricted(std::vector<SurfaceTerm> terms, std::size_t n_free,
                                                     std::vector<std::vector<double>> factors, std::vector<double> response,
                                                     const std::vector<std::string>& specimens);
    /// Bayesian update by one more observation. \param scatter its variance over `variance`
    void update(const std::vector<double>& at, double value, double scatter);
    /// Correlation of what observations at equal factors are off two models of the same terms; 0 if they have others.
    [[nodiscard]] double residual_correlation(const LinearModel& other) const;

    [[nodiscard]] double residual_sum() const { return residuals.squaredNorm(); }  ///< Σ (y − ŷ)²
    [[nodiscard]] double total_sum() const;                                        ///< Σ (y − ȳ)²
    /// Σ of squared residuals, each predicted without its own observation (Allen 1974).
    [[nodiscard]] double press() const;
    /// The same with one more term; infinite if it depends on the others.
    [[nodiscard]] double press_with(const SurfaceTerm& term) const;
    [[nodiscard]] double scatter() const { return std::sqrt(variance); }
    [[nodiscard]] double prediction_error() const;  ///< √(PRESS/n)
    [[nodiscard]] double standard_error(std::size_t term) const;
    [[nodiscard]] double r_squared() const;
    /// Corrected for the number of terms; empty without degrees of freedom.
    [[nodiscard]] std::optional<double> adjusted_r_squared() const;
    [[nodiscard]] double predicted_r_squared() const;

    [[nodiscard]] Eigen::VectorXd row(const std::vector<double>& at) const;  ///< the terms there
    [[nodiscard]] double value(const std::vector<double>& at) const { return row(at).dot(coefficients); }
    /// Variance of the mean over that of an observation.
    [[nodiscard]] double leverage(const std::vector<double>& at) const;
    /// The mean with its 95 % confidence interval.
    [[nodiscard]] Estimate confidence(const std::vector<double>& at) const { return with_interval(at, 0); }
    /// A single new observation with its 95 % prediction interval.
    [[nodiscard]] Estimate prediction(const std::vector<double>& at) const { return with_interval(at, 1); }
    /// Derivatives of the mean by the factors.
    [[nodiscard]] Eigen::VectorXd gradient(const std::vector<double>& at) const;

    /// Partial F test of a term (1 degree of freedom): p of leaving it out. Empty without degrees of freedom.
    [[nodiscard]] std::optional<double> p_value(std::size_t term) const;
    /// F test of all terms but the constant.
    [[nodiscard]] std::optional<FTest> significance() const;
    /// Empty without repeated observations that scatter, or without degrees of freedom beyond them.
    [[nodiscard]] std::optional<LackOfFit> lack_of_fit() const;

private:
    LinearModel() = default;
    LinearModel(std::vector<SurfaceTerm> of, std::vector<std::vector<double>> at, std::vector<double> values);
    /// Fits with a weight that draws each coefficient to 0, or none. \return the restricted likelihood, its logarithm
    double solve(const Eigen::VectorXd& weights);
    /// Combines the observations of each specimen, which have a correlation, to independent ones (Fuller & Battese 1973).
    /// \return ln of the determinant of the combination
    double make_independent(const std::vector<std::string>& specimens, double correlation);
    [[nodiscard]] Estimate with_interval(const std::vector<double>& at, double own_variance) const;
};

/// Leaves out, one by one, the term with the largest p above alpha; never the constant, nor a term whose product or square
/// is still there (hierarchy).
LinearModel eliminate_backward(LinearModel model, double alpha);

/// Adds, one by one, the candidate that reduces PRESS most, until none reduces it or the degrees of freedom are as few as half of
/// the observations.
LinearModel extend_forward(LinearModel model, const std::vector<SurfaceTerm>& candidates);

/// The symmetric matrix whose square is this one. \pre symmetric, no eigenvalue is negative but for rounding
Eigen::MatrixXd square_root(const Eigen::MatrixXd& matrix);

/// P(F > f) of Fisher's distribution.
double f_tail(double f, int numerator_freedom, int denominator_freedom);
/// The f that is exceeded with the probability `tail`.
double f_quantile(double tail, int numerator_freedom, int denominator_freedom);

}  // namespace graincrack
