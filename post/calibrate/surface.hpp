// A response as a surface over the free parameters: the logarithm, linear in all of them, with those quadratic terms by which it
// predicts better.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "post/calibrate/design.hpp"

namespace graincrack::calibrate {

class ResponseSurface {
public:
    /// Least squares. Starting from the linear terms, that square or product is added which reduces PRESS most, until none
    /// reduces it or the degrees of freedom are as few as half of the values. PRESS is the sum of the squared residuals, each
    /// predicted without its own value (Allen 1974). \param values ln of the response at each place; NaN: it has none there, and
    /// is left out \return empty unless there are two values more than linear terms
    static std::optional<ResponseSurface> fit(const Box& box, const std::vector<Place>& places,
                                              const std::vector<double>& values);

    [[nodiscard]] double value(const Place& place) const { return basis(place).dot(coefficients_); }
    /// Variance of `value`, by the scatter about the surface.
    [[nodiscard]] double variance(const Place& place) const;
    /// Derivatives by the coordinates of a place, and their covariance.
    [[nodiscard]] Place gradient(const Place& place) const { return slopes(place).transpose() * coefficients_; }
    [[nodiscard]] Eigen::MatrixXd gradient_covariance(const Place& place) const;

    [[nodiscard]] double scatter() const { return scatter_; }  ///< standard deviation about the surface
    [[nodiscard]] double prediction_error() const;             ///< √(PRESS/n)
    [[nodiscard]] int n_values() const { return n_values_; }
    [[nodiscard]] int freedom() const { return n_values_ - static_cast<int>(terms_.size()); }
    [[nodiscard]] int n_quadratic() const { return static_cast<int>(terms_.size() - 1) - static_cast<int>(box_.size()); }

private:
    /// Numbers of the coordinates that a term multiplies; none: of the constant.
    using Term = std::vector<Eigen::Index>;
    [[nodiscard]] Eigen::VectorXd basis(const Place& place) const;
    /// Derivative of each term, a row a term.
    [[nodiscard]] Eigen::MatrixXd slopes(const Place& place) const;

    Box box_;
    std::vector<Term> terms_;
    Eigen::VectorXd coefficients_;
    Eigen::MatrixXd inverse_;  ///< (XᵀX)⁻¹
    double scatter_ = 0;
    double press_ = 0;
    int n_values_ = 0;
};

}  // namespace graincrack::calibrate
