// Linear least squares in several terms, on GSL: coefficients, their errors, and how well the model predicts.
#pragma once

#include <optional>
#include <vector>

namespace graincrack {

/// One row a run, one column a term.
using DesignMatrix = std::vector<std::vector<double>>;

struct Regression {
    std::vector<double> coefficients;
    std::vector<std::vector<double>> inverse;  ///< (XᵀX)⁻¹
    double residual_sum = 0;                   ///< Σ (y − ŷ)²
    double total_sum = 0;                      ///< Σ (y − ȳ)²
    double press = 0;                          ///< Σ of squared residuals, each predicted without its own run
    int freedom = 0;                           ///< runs − terms

    [[nodiscard]] double r_squared() const { return total_sum > 0 ? 1 - residual_sum / total_sum : 1; }
    /// Corrected for the number of terms; empty without degrees of freedom.
    [[nodiscard]] std::optional<double> adjusted_r_squared() const;
    [[nodiscard]] double predicted_r_squared() const { return total_sum > 0 ? 1 - press / total_sum : 1; }
    /// Residual variance; 0 without degrees of freedom.
    [[nodiscard]] double variance() const { return freedom > 0 ? residual_sum / freedom : 0; }
    [[nodiscard]] double standard_error(std::size_t term) const;
    [[nodiscard]] double predict(const std::vector<double>& terms) const;
    /// xᵀ (XᵀX)⁻¹ x: the variance of the fitted mean at x over the residual variance.
    [[nodiscard]] double leverage(const std::vector<double>& terms) const;
};

/// Empty if there are fewer runs than terms, or the terms depend on each other.
std::optional<Regression> regress(const DesignMatrix& design, const std::vector<double>& y);

/// Lack of fit against pure error from runs at one place.
struct LackOfFit {
    double sum = 0;
    int freedom = 0;
    double pure_error_sum = 0;
    int pure_error_freedom = 0;
    double f = 0;
    double p = 0;
};
/// Of a model fitted to values at places. Empty without repeated places that scatter, or without degrees of freedom beyond them.
std::optional<LackOfFit> lack_of_fit(const std::vector<std::vector<double>>& places, const std::vector<double>& values,
                                     double residual_sum, int freedom);

/// P(F > f) of Fisher's distribution.
double f_tail(double f, int numerator_freedom, int denominator_freedom);
/// The f that is exceeded with the probability `tail`.
double f_quantile(double tail, int numerator_freedom, int denominator_freedom);
/// P(|t| > …) of Student's distribution.
double t_tail(double t, int freedom);

}  // namespace graincrack
