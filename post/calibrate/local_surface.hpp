// Responses over the free parameters: linear models of their logarithms, through the points of designs, or of a kind of rock,
// which the rock's own runs correct.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "post/calibrate/parameter.hpp"
#include "post/statistics/linear_model.hpp"

namespace graincrack::calibrate {

/// The factors of a model at a design point, and the logarithm of the unit of its response there.
struct Located {
    std::vector<double> factors;
    double log_unit = 0;
};

/// ln of a response over the design points.
class LocalSurface {
public:
    using Locate = std::function<Located(const DesignPoint&)>;
    LocalSurface(Locate locate, LinearModel model, bool is_of_kind)
        : locate_(std::move(locate)), model_(std::move(model)), is_of_kind_(is_of_kind) {}
    /// Least squares in the local coordinates of a box: the linear terms, extended forward by those quadratic ones by which
    /// values are predicted better. \param values ln of the response at each point; NaN: it has none there, and is left out
    /// \return empty unless there are two values more than linear terms, and these determine them
    static std::optional<LocalSurface> fit(const Box& box, const std::vector<DesignPoint>& points,
                                           const std::vector<double>& values);

    /// Update by a single specimen. \param specimens whose mean each value about the surface is
    void learn(const DesignPoint& point, double value, double specimens);

    [[nodiscard]] double value(const DesignPoint& point) const;
    /// Variance of `value`, without the scatter of specimens.
    [[nodiscard]] double variance(const DesignPoint& point) const;
    /// Derivatives by the coordinates of a point, and their covariance.
    [[nodiscard]] DesignPoint gradient(const DesignPoint& point) const;
    [[nodiscard]] Eigen::MatrixXd gradient_covariance(const DesignPoint& point) const;
    /// The terms at a point: `value` is their product with the coefficients, and the unit.
    [[nodiscard]] Eigen::VectorXd terms(const DesignPoint& point) const { return model_.row(locate_(point).factors); }

    [[nodiscard]] const LinearModel& model() const { return model_; }
    [[nodiscard]] bool is_of_kind() const { return is_of_kind_; }

private:
    /// Derivative of each term, a row a term, and of the logarithm of the unit, the last row.
    [[nodiscard]] Eigen::MatrixXd slopes(const DesignPoint& point) const;

    Locate locate_;
    LinearModel model_;
    bool is_of_kind_;
};

}  // namespace graincrack::calibrate
