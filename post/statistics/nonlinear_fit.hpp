// Non-linear least squares on GSL (Levenberg–Marquardt in a trust region, central differences).
#pragma once

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

}  // namespace graincrack
