// Logistic regression of outcomes that happen or not.
#pragma once

#include <Eigen/Core>

namespace graincrack {

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
