#include "post/calibrate/local_surface.hpp"

#include <cmath>

namespace graincrack::calibrate {

std::optional<LocalSurface> LocalSurface::fit(const Box& box, const std::vector<DesignPoint>& points,
                                              const std::vector<double>& values) {
    const Locate locate = [box](const DesignPoint& point) {
        const DesignPoint local = box.local(point);
        return Located{{local.begin(), local.end()}};
    };
    std::vector<std::vector<double>> factors;
    std::vector<double> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(values[i])) continue;
        factors.push_back(locate(points[i]).factors);
        known.push_back(values[i]);
    }
    const auto p = static_cast<std::size_t>(box.size());
    if (known.size() < p + 3) return std::nullopt;
    std::vector<SurfaceTerm> quadratic = quadratic_terms(p);
    const auto end_of_linear = quadratic.begin() + static_cast<std::ptrdiff_t>(p) + 1;
    const std::vector<SurfaceTerm> linear(quadratic.begin(), end_of_linear);
    quadratic.erase(quadratic.begin(), end_of_linear);
    auto plane = LinearModel::fit(linear, std::move(factors), std::move(known));
    if (!plane) return std::nullopt;  // all values at one level of a parameter
    return LocalSurface(locate, extend_forward(*std::move(plane), quadratic), false);
}

// Factors are smooth functions of the coordinates, of order one: central differences are right to ten digits.
Eigen::MatrixXd LocalSurface::slopes(const DesignPoint& point) const {
    constexpr double h = 1e-5;
    const auto n = static_cast<Eigen::Index>(model_.terms.size());
    Eigen::MatrixXd slopes(n + 1, point.size());
    DesignPoint near = point;
    for (Eigen::Index k = 0; k < point.size(); ++k) {
        near(k) = point(k) + h;
        const Located above = locate_(near);
        near(k) = point(k) - h;
        const Located below = locate_(near);
        near(k) = point(k);
        slopes.col(k).head(n) = (model_.row(above.factors) - model_.row(below.factors)) / (2 * h);
        slopes(n, k) = (above.log_unit - below.log_unit) / (2 * h);
    }
    return slopes;
}

void LocalSurface::learn(const DesignPoint& point, double value, double specimens) {
    const Located at = locate_(point);
    const double before = model_.leverage(at.factors);
    model_.update(at.factors, value - at.log_unit, specimens);
    if (!is_of_kind_) return;
    // A variance depends on that among other rocks by its square: the less is left of it, the less it matters how few these are.
    const double of_fit = static_cast<double>(model_.design.rows()) - model_.leverages.sum();
    const double known = model_.freedom * std::pow(before / model_.leverage(at.factors), 2);
    model_.freedom = static_cast<int>(std::max<double>(model_.freedom, std::min(known, of_fit)));
}

double LocalSurface::value(const DesignPoint& point) const {
    const Located at = locate_(point);
    return at.log_unit + model_.value(at.factors);
}

double LocalSurface::variance(const DesignPoint& point) const {
    return model_.variance * model_.leverage(locate_(point).factors);
}

DesignPoint LocalSurface::gradient(const DesignPoint& point) const {
    const Eigen::MatrixXd by = slopes(point);
    return by.topRows(by.rows() - 1).transpose() * model_.coefficients + by.bottomRows(1).transpose();
}

Eigen::MatrixXd LocalSurface::gradient_covariance(const DesignPoint& point) const {
    const Eigen::MatrixXd by = slopes(point).topRows(model_.coefficients.size());
    return model_.variance * by.transpose() * model_.inverse * by;
}

}  // namespace graincrack::calibrate
