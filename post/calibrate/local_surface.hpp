// Responses over the free parameters: surfaces of their logarithms, by least squares through the points of designs, or that of a
// kind of rock, which the rock's own runs correct.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "post/calibrate/parameter.hpp"
#include "post/kind/kind_surface.hpp"
#include "post/statistics/response_surface.hpp"

namespace graincrack::calibrate {

/// The factors of a surface at a design point, and the logarithm of the unit of its response there.
struct Located {
    std::vector<double> factors;
    double log_unit = 0;
};
using Locate = std::function<Located(const DesignPoint&)>;

/// ln of a response as a linear function of terms of some factors, whose coefficients are known with a covariance.
class LocalSurface {
public:
    /// Least squares in the local coordinates of a box: the linear terms, extended forward by those quadratic ones by which
    /// values are predicted better. \param values ln of the response at each point; NaN: it has none there, and is left out
    /// \return empty unless there are two values more than linear terms, and these determine them
    static std::optional<LocalSurface> fit(const Box& box, const std::vector<DesignPoint>& points,
                                           const std::vector<double>& values);
    /// That of a kind, of which a rock differs by as much as calibrated rocks did.
    LocalSurface(Locate locate, const KindModel& model);

    /// Bayesian linear update by a single specimen. \param specimens whose mean each value about the surface is
    void learn(const DesignPoint& point, double value, double specimens);

    [[nodiscard]] double value(const DesignPoint& point) const;
    /// Variance of `value`, without the scatter of specimens.
    [[nodiscard]] double variance(const DesignPoint& point) const;
    /// Derivatives by the coordinates of a point, and their covariance.
    [[nodiscard]] DesignPoint gradient(const DesignPoint& point) const;
    [[nodiscard]] Eigen::MatrixXd gradient_covariance(const DesignPoint& point) const;
    /// The terms at a point: `value` is their product with the coefficients, and the unit.
    [[nodiscard]] Eigen::VectorXd terms(const DesignPoint& point) const { return terms(locate_(point)); }
    /// How far coefficients are off that have these standard normal numbers, one a coefficient.
    [[nodiscard]] Eigen::VectorXd drawn(const Eigen::VectorXd& normal) const;

    [[nodiscard]] double scatter() const { return std::sqrt(variance_); }        ///< standard deviation about the surface
    [[nodiscard]] double prediction_error() const { return prediction_error_; }  ///< √(PRESS/n)
    [[nodiscard]] int n_values() const { return n_values_; }
    [[nodiscard]] int freedom() const { return freedom_; }
    [[nodiscard]] int n_quadratic() const;
    [[nodiscard]] bool is_of_kind() const { return is_of_kind_; }

private:
    LocalSurface() = default;
    [[nodiscard]] Eigen::VectorXd terms(const Located& at) const;
    /// Derivative of each term, a row a term, and of the logarithm of the unit, the last row.
    [[nodiscard]] Eigen::MatrixXd slopes(const DesignPoint& point) const;

    Locate locate_;
    std::vector<SurfaceTerm> surface_terms_;
    Eigen::VectorXd coefficients_;
    Eigen::MatrixXd covariance_;
    double variance_ = 0;
    double prediction_error_ = 0;
    int freedom_ = 0;
    int n_values_ = 0;
    bool is_of_kind_ = false;
};

}  // namespace graincrack::calibrate
