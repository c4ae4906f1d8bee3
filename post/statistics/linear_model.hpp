// Linear models: a response is a sum of terms of several factors. Coefficients are fitted to observations by least squares or
// restricted likelihood, and updated by further observations; models are reduced or extended term by term.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "post/statistics/statistics.hpp"

namespace graincrack {

/// A product of powers of factors, with power[k] of factor k. All powers of the constant are zero.
struct SurfaceTerm {
    std::vector<int> power;
    [[nodiscard]] double operator()(const std::vector<double>& factors) const;
    /// Derivative with respect to a factor.
    [[nodiscard]] double slope(const std::vector<double>& factors, std::size_t factor) const;
    [[nodiscard]] int degree() const;
    /// "1", "x1", "x1 x2", "x1^2"
    [[nodiscard]] std::string name() const;
    /// True if this term divides another: x1 and x2 are parents of x1 x2.
    [[nodiscard]] bool is_parent_of(const SurfaceTerm& other) const;
    bool operator==(const SurfaceTerm&) const = default;
};

/// Constant, linear terms, products of two factors and squares, in this order, as in Eq 19 of Kazerani & Zhao 2014.
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
    Eigen::MatrixXd inverse;  ///< covariance of the coefficients over `variance`; for least squares (XᵀX)⁻¹
    double variance = 0;      ///< variance of an observation about the model; 0 without degrees of freedom
    int freedom = 0;          ///< degrees of freedom
    int n_values = 0;         ///< number of observations of fit and updates

    std::vector<std::vector<double>> factors;  ///< [observations of the fit], as the members below
    std::vector<double> response;
    Eigen::MatrixXd design;  ///< terms, X
    Eigen::VectorXd residuals;
    Eigen::VectorXd leverages;

    /// Fits by least squares. Empty if there are fewer observations than terms, or if the terms are linearly dependent there.
    static std::optional<LinearModel> fit(std::vector<SurfaceTerm> terms, std::vector<std::vector<double>> factors,
                                          std::vector<double> response);
    /// Fits by least squares with all coefficients after the first `n_free` shrunk to 0, as normal numbers about 0. Restricted
    /// likelihood determines the weight of the shrinkage (empirical Bayes); the standard deviation of a coefficient is at most
    /// about the scatter of an observation, as few observations would not bound it. Observations of one specimen have a
    /// correlation that is found likewise; `design`, `response` and their derived members then belong to independent combinations
    /// of equal variance. Empty if there are not two observations more than free terms, or if they do not determine these terms.
    /// \param specimens [observations] name of the specimen
    static std::optional<LinearModel> fit_restricted(std::vector<SurfaceTerm> terms, std::size_t n_free,
                                                     std::vector<std::vector<double>> factors, std::vector<double> response,
                                                     const std::vector<std::string>& specimens);
    /// Updates the model by one more observation (Bayes). \param scatter its variance over `variance`
    void update(const std::vector<double>& at, double value, double scatter);
    /// Correlation of the residuals of two models of the same terms at equal factors; 0 if their terms differ.
    [[nodiscard]] double residual_correlation(const LinearModel& other) const;

    [[nodiscard]] double residual_sum() const { return residuals.squaredNorm(); }  ///< Σ (y − ŷ)²
    [[nodiscard]] double total_sum() const;                                        ///< Σ (y − ȳ)²
    /// PRESS: the sum of squared residuals, each predicted without its own observation (Allen 1974).
    [[nodiscard]] double press() const;
    /// PRESS with one more term; infinite if the term depends on the others.
    [[nodiscard]] double press_with(const SurfaceTerm& term) const;
    [[nodiscard]] double scatter() const { return std::sqrt(variance); }
    [[nodiscard]] double prediction_error() const;  ///< √(PRESS/n)
    [[nodiscard]] double standard_error(std::size_t term) const;
    [[nodiscard]] double r_squared() const;
    /// R² corrected for the number of terms; empty without degrees of freedom.
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
    /// Derivatives of the mean with respect to the factors.
    [[nodiscard]] Eigen::VectorXd gradient(const std::vector<double>& at) const;

    /// p value of leaving a term out, by a partial F test (1 degree of freedom). Empty without degrees of freedom.
    [[nodiscard]] std::optional<double> p_value(std::size_t term) const;
    /// F test of all terms but the constant.
    [[nodiscard]] std::optional<FTest> significance() const;
    /// Test of the lack of fit. Empty without repeated observations that scatter, or without degrees of freedom beyond them.
    [[nodiscard]] std::optional<LackOfFit> lack_of_fit() const;

private:
    LinearModel() = default;
    LinearModel(std::vector<SurfaceTerm> of, std::vector<std::vector<double>> at, std::vector<double> values);
    /// Fits with a weight for each coefficient that shrinks it to 0; 0 for none. \return ln of the restricted likelihood
    double solve(const Eigen::VectorXd& weights);
    /// Combines the correlated observations of each specimen to independent ones (Fuller & Battese 1973).
    /// \return ln of the determinant of the combination
    double make_independent(const std::vector<std::string>& specimens, double correlation);
    [[nodiscard]] Estimate with_interval(const std::vector<double>& at, double own_variance) const;
};

/// Removes, one by one, the term with the largest p above alpha. The constant stays, and so do terms whose product or square is
/// still in the model (hierarchy).
LinearModel eliminate_backward(LinearModel model, double alpha);

/// Adds, one by one, the candidate that reduces PRESS most. Ends if none does, or if freedom falls to half of the observations.
LinearModel extend_forward(LinearModel model, const std::vector<SurfaceTerm>& candidates);

/// The symmetric square root of a matrix. \pre it is symmetric, and no eigenvalue is negative but for rounding
Eigen::MatrixXd square_root(const Eigen::MatrixXd& matrix);

/// The probability P(F > f) of Fisher's distribution.
double f_tail(double f, int numerator_freedom, int denominator_freedom);
/// The value that F exceeds with the probability `tail`.
double f_quantile(double tail, int numerator_freedom, int denominator_freedom);

}  // namespace graincrack
