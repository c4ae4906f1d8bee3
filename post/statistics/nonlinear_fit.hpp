// Non-linear least squares on GSL (Levenberg–Marquardt in a trust region, central differences), and logistic regression of
// outcomes that happen or not.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "post/statistics/statistics.hpp"

namespace graincrack {

struct NonlinearFit {
    std::vector<double> parameters;
    std::vector<std::vector<double>> inverse;  ///< (JᵀJ)⁻¹ at the optimum
    double residual_sum = 0;
    int freedom = 0;
    /// A parameter with its 95 % interval, linearised.
    [[nodiscard]] Estimate estimate(std::size_t parameter) const;
};

/// Writes the residuals of some parameters.
using Residuals = std::function<void(std::span<const double> parameters, std::span<double> residuals)>;

/// Parameters and residuals should be of order one. Empty if the fit does not converge.
/// \pre as many residuals as parameters at least
std::optional<NonlinearFit> fit_nonlinear(const Residuals& residuals, std::vector<double> start, std::size_t n_residuals);

/// Probability of an outcome as a function of several factors: logistic regression, penalised so that outcomes that all are
/// alike, or that a plane separates, have finite coefficients too.
struct Logistic {
    Eigen::VectorXd coefficients;  ///< of 1 and the factors

    /// ln(p/(1 − p)) at some factors.
    [[nodiscard]] double logit(const Eigen::VectorXd& factors) const {
        return coefficients(0) + coefficients.tail(coefficients.size() - 1).dot(factors);
    }
};

/// Maximum of the likelihood times Jeffreys' prior (Firth 1993, Biometrika 80, 27–38).
/// \param factors a row a case \param happened 0 or 1 of each case \pre there are cases
Logistic fit_logistic(const Eigen::MatrixXd& factors, const Eigen::VectorXd& happened);

}  // namespace graincrack
