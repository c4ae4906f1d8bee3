#include "post/calibrate/local_surface.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace graincrack::calibrate {

std::optional<LocalSurface> LocalSurface::fit(const Box& box, const std::vector<DesignPoint>& points,
                                              const std::vector<double>& values) {
    LocalSurface fitted;
    fitted.locate_ = [box](const DesignPoint& point) {
        const DesignPoint local = box.local(point);
        return Located{{local.begin(), local.end()}};
    };
    std::vector<std::vector<double>> factors;
    std::vector<double> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(values[i])) continue;
        factors.push_back(fitted.locate_(points[i]).factors);
        known.push_back(values[i]);
    }
    const auto p = static_cast<std::size_t>(box.size());
    if (known.size() < p + 3) return std::nullopt;
    std::vector<SurfaceTerm> quadratic = quadratic_terms(p);
    const auto end_of_linear = quadratic.begin() + static_cast<std::ptrdiff_t>(p) + 1;
    const std::vector<SurfaceTerm> linear(quadratic.begin(), end_of_linear);
    quadratic.erase(quadratic.begin(), end_of_linear);
    auto plane = ResponseSurface::fit(linear, std::move(factors), std::move(known));
    if (!plane) return std::nullopt;  // all values at one level of a parameter
    const ResponseSurface surface = extend_forward(*std::move(plane), quadratic);
    fitted.surface_terms_ = surface.terms;
    fitted.coefficients_ = surface.coefficients;
    fitted.variance_ = surface.variance();
    fitted.covariance_ = fitted.variance_ * surface.inverse;
    fitted.freedom_ = surface.freedom();
    fitted.n_values_ = static_cast<int>(surface.response.size());
    fitted.prediction_error_ = std::sqrt(surface.press() / fitted.n_values_);
    return fitted;
}

LocalSurface::LocalSurface(Locate locate, const KindModel& model)
    : locate_(std::move(locate)),
      surface_terms_(model.terms),
      coefficients_(model.coefficients),
      covariance_(model.covariance),
      variance_(model.variance),
      prediction_error_(model.prediction_error),
      freedom_(model.freedom),
      n_values_(model.n_values),
      is_of_kind_(true) {
    covariance_(0, 0) += model.rock_variance;  // of the constant
}

Eigen::VectorXd LocalSurface::terms(const Located& at) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(surface_terms_.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i) values(i) = surface_terms_[static_cast<std::size_t>(i)](at.factors);
    return values;
}

// Factors are smooth functions of the coordinates, of order one: central differences are right to ten digits.
Eigen::MatrixXd LocalSurface::slopes(const DesignPoint& point) const {
    constexpr double h = 1e-5;
    const auto n = static_cast<Eigen::Index>(surface_terms_.size());
    Eigen::MatrixXd slopes(n + 1, point.size());
    DesignPoint near = point;
    for (Eigen::Index k = 0; k < point.size(); ++k) {
        near(k) = point(k) + h;
        const Located above = locate_(near);
        near(k) = point(k) - h;
        const Located below = locate_(near);
        near(k) = point(k);
        slopes.col(k).head(n) = (terms(above) - terms(below)) / (2 * h);
        slopes(n, k) = (above.log_unit - below.log_unit) / (2 * h);
    }
    return slopes;
}

void LocalSurface::learn(const DesignPoint& point, double value, double specimens) {
    const Located at = locate_(point);
    const Eigen::VectorXd row = terms(at);
    const Eigen::VectorXd gain = covariance_ * row / (row.dot(covariance_ * row) + specimens * variance_);
    coefficients_ += gain * (value - at.log_unit - row.dot(coefficients_));
    covariance_ -= (gain * (row.transpose() * covariance_)).eval();
    covariance_ = (0.5 * (covariance_ + covariance_.transpose())).eval();
    ++n_values_;
}

double LocalSurface::value(const DesignPoint& point) const {
    const Located at = locate_(point);
    return at.log_unit + terms(at).dot(coefficients_);
}

double LocalSurface::variance(const DesignPoint& point) const {
    const Eigen::VectorXd row = terms(point);
    return row.dot(covariance_ * row);
}

DesignPoint LocalSurface::gradient(const DesignPoint& point) const {
    const Eigen::MatrixXd by = slopes(point);
    return by.topRows(by.rows() - 1).transpose() * coefficients_ + by.bottomRows(1).transpose();
}

Eigen::MatrixXd LocalSurface::gradient_covariance(const DesignPoint& point) const {
    const Eigen::MatrixXd by = slopes(point);
    return by.topRows(by.rows() - 1).transpose() * covariance_ * by.topRows(by.rows() - 1);
}

Eigen::VectorXd LocalSurface::drawn(const Eigen::VectorXd& normal) const {
    const Eigen::LDLT<Eigen::MatrixXd> factor(covariance_);
    const Eigen::VectorXd scaled = factor.vectorD().cwiseMax(0).cwiseSqrt().cwiseProduct(normal);
    return factor.transpositionsP().transpose() * (factor.matrixL() * scaled);
}

int LocalSurface::n_quadratic() const {
    return static_cast<int>(
        std::count_if(surface_terms_.begin(), surface_terms_.end(), [](const SurfaceTerm& term) { return term.degree() > 1; }));
}

}  // namespace graincrack::calibrate
