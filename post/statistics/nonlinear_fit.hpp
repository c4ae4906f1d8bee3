// Fits by non-linear least squares with GSL (Levenberg–Marquardt in a trust region, central differences) and by logistic
// regression of binary outcomes.
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
    /// A parameter with its linearised 95 % interval.
    [[nodiscard]] Estimate estimate(std::size_t parameter) const;
};

/// Computes the residuals of given parameters.
using Residuals = std::function<void(std::span<const double> parameters, std::span<double> residuals)>;

/// Fits parameters from a start. Parameters and residuals should be of order one. Empty if the fit does not converge.
/// \pre there are at least as many residuals as parameters
std::optional<NonlinearFit> fit_nonlinear(const Residuals& residuals, std::vector<double> start, std::size_t n_residuals);

/// Probability of an outcome as a function of several factors: logistic regression, penalised so that coefficients are finite
/// also for equal outcomes, or outcomes that a plane separates.
struct Logistic {
    Eigen::VectorXd coefficients;  ///< of the constant and the factors

    /// ln(p/(1 − p)) at some factors.
    [[nodiscard]] double logit(const Eigen::VectorXd& factors) const {
        return coefficients(0) + coefficients.tail(coefficients.size() - 1).dot(factors);
    }
};

/// Fits the maximum of the likelihood times Jeffreys' prior (Firth 1993, Biometrika 80, 27–38).
/// \param factors one row per case \param happened 0 or 1 for each case \pre there are cases
Logistic fit_logistic(const Eigen::MatrixXd& factors, const Eigen::VectorXd& happened);

}  // namespace graincrack
