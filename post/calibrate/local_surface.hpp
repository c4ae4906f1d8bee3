// Response surfaces over the free parameters: linear models of the logarithms of responses. They are fitted to the points of
// designs, or come from a rock type and are updated by the rock's own runs.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "post/calibrate/parameter.hpp"
#include "post/statistics/linear_model.hpp"

namespace graincrack::calibrate {

/// The factors of a model at a design point, and the logarithm of the unit of the response there.
struct Located {
    std::vector<double> factors;
    double log_unit = 0;
};

/// The logarithm of a response as a function of the design point.
class LocalSurface {
public:
    using Locate = std::function<Located(const DesignPoint&)>;
    LocalSurface(Locate locate, LinearModel model, bool is_of_kind)
        : locate_(std::move(locate)), model_(std::move(model)), is_of_kind_(is_of_kind) {}
    /// Fits a surface by least squares in the local coordinates of a box: all linear terms, and those quadratic terms that
    /// improve predictions, by forward selection. \param values [points] ln of the response; points with NaN are left out \return
    /// empty if there are not two values more than linear terms, or if they do not determine the terms
    static std::optional<LocalSurface> fit(const Box& box, const std::vector<DesignPoint>& points,
                                           const std::vector<double>& values);

    /// Updates the surface by a single specimen. \param value ln of its response \param specimens number of specimens whose mean
    /// a value of the surface is
    void learn(const DesignPoint& point, double value, double specimens);

    [[nodiscard]] double value(const DesignPoint& point) const;
    /// Variance of `value`, without the scatter of specimens.
    [[nodiscard]] double variance(const DesignPoint& point) const;
    /// Derivatives with respect to the coordinates of a point, and their covariance.
    [[nodiscard]] DesignPoint gradient(const DesignPoint& point) const;
    [[nodiscard]] Eigen::MatrixXd gradient_covariance(const DesignPoint& point) const;
    /// The terms at a point: `value` is the sum of their products with the coefficients, plus the logarithm of the unit.
    [[nodiscard]] Eigen::VectorXd terms(const DesignPoint& point) const { return model_.row(locate_(point).factors); }

    [[nodiscard]] const LinearModel& model() const { return model_; }
    [[nodiscard]] bool is_of_kind() const { return is_of_kind_; }

private:
    /// Derivatives with respect to the coordinates: one row per term, and the last row for the logarithm of the unit.
    [[nodiscard]] Eigen::MatrixXd slopes(const DesignPoint& point) const;

    Locate locate_;
    LinearModel model_;
    bool is_of_kind_;
};

}  // namespace graincrack::calibrate
