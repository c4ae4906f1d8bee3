#include "post/calibrate/surface.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace graincrack::calibrate {

namespace {

/// Least squares to which columns are added one by one.
class Columns {
public:
    explicit Columns(Eigen::VectorXd y) : residual_(std::move(y)), leverage_(Eigen::VectorXd::Zero(residual_.size())) {}
    /// What a column has beside those that are there, of length 1; 0 if it depends on them.
    [[nodiscard]] Eigen::VectorXd own_part(const Eigen::VectorXd& column) const {
        Eigen::VectorXd part = column;
        for (int twice = 0; twice < 2; ++twice) {  // the second time for what rounding left
            for (const Eigen::VectorXd& q : orthonormal_) part -= q * q.dot(part);
        }
        const double length = part.norm();
        return length > 1e-8 * (column.norm() + 1e-300) ? Eigen::VectorXd(part / length) : Eigen::VectorXd::Zero(part.size());
    }
    /// Σ (residual/(1 − leverage))² with one more column.
    [[nodiscard]] double press_with(const Eigen::VectorXd& part) const {
        const Eigen::VectorXd residual = residual_ - part * part.dot(residual_);
        return (residual.array() / (1 - (leverage_ + part.cwiseAbs2()).array()).max(1e-9)).square().sum();
    }
    [[nodiscard]] double press() const { return press_with(Eigen::VectorXd::Zero(residual_.size())); }
    void add(const Eigen::VectorXd& part) {
        residual_ -= part * part.dot(residual_);
        leverage_ += part.cwiseAbs2();
        orthonormal_.push_back(part);
    }
    [[nodiscard]] double residual_sum() const { return residual_.squaredNorm(); }

private:
    std::vector<Eigen::VectorXd> orthonormal_;
    Eigen::VectorXd residual_;
    Eigen::VectorXd leverage_;
};

}  // namespace

std::optional<ResponseSurface> ResponseSurface::fit(const Box& box, const std::vector<Place>& places,
                                                    const std::vector<double>& values) {
    std::vector<Place> local;
    std::vector<double> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(values[i])) continue;
        local.push_back(box.local(places[i]));
        known.push_back(values[i]);
    }
    const Eigen::Index p = box.size();
    const auto n = static_cast<Eigen::Index>(known.size());
    if (n < p + 3) return std::nullopt;
    const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(known.data(), n);
    const auto column_of = [&](const Term& term) {
        Eigen::VectorXd column = Eigen::VectorXd::Ones(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            for (const Eigen::Index k : term) column(i) *= local[static_cast<std::size_t>(i)](k);
        }
        return column;
    };
    ResponseSurface surface;
    surface.box_ = box;
    surface.n_values_ = static_cast<int>(n);
    Columns columns(y);
    std::vector<Term> quadratic;
    surface.terms_.emplace_back();
    for (Eigen::Index k = 0; k < p; ++k) {
        surface.terms_.push_back({k});
        for (Eigen::Index l = k; l < p; ++l) quadratic.push_back({k, l});
    }
    for (const Term& term : surface.terms_) {
        const Eigen::VectorXd part = columns.own_part(column_of(term));
        if (part.isZero(0)) return std::nullopt;  // all values at one level of a parameter
        columns.add(part);
    }
    while (surface.freedom() > n / 2) {
        const Term* best = nullptr;
        Eigen::VectorXd part;
        double least = columns.press();
        for (const Term& term : quadratic) {
            const Eigen::VectorXd own = columns.own_part(column_of(term));
            const double press = own.isZero(0) ? least : columns.press_with(own);
            if (!(press < least)) continue;
            least = press;
            best = &term;
            part = own;
        }
        if (best == nullptr) break;
        columns.add(part);
        surface.terms_.push_back(*best);
    }
    Eigen::MatrixXd x(n, static_cast<Eigen::Index>(surface.terms_.size()));
    for (Eigen::Index i = 0; i < x.cols(); ++i) x.col(i) = column_of(surface.terms_[static_cast<std::size_t>(i)]);
    surface.inverse_ = (x.transpose() * x).ldlt().solve(Eigen::MatrixXd::Identity(x.cols(), x.cols()));
    surface.coefficients_ = surface.inverse_ * (x.transpose() * y);
    surface.press_ = columns.press();
    surface.scatter_ = std::sqrt(columns.residual_sum() / surface.freedom());
    return surface;
}

Eigen::VectorXd ResponseSurface::basis(const Place& place) const {
    const Place local = box_.local(place);
    Eigen::VectorXd basis = Eigen::VectorXd::Ones(coefficients_.size());
    for (Eigen::Index i = 0; i < basis.size(); ++i) {
        for (const Eigen::Index k : terms_[static_cast<std::size_t>(i)]) basis(i) *= local(k);
    }
    return basis;
}

Eigen::MatrixXd ResponseSurface::slopes(const Place& place) const {
    const Place local = box_.local(place);
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(coefficients_.size(), box_.size());
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
        const Term& term = terms_[static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < term.size(); ++k) {
            slopes(i, term[k]) += (term.size() == 2 ? local(term[1 - k]) : 1) / box_.half(term[k]);
        }
    }
    return slopes;
}

double ResponseSurface::variance(const Place& place) const {
    const Eigen::VectorXd at = basis(place);
    return scatter_ * scatter_ * at.dot(inverse_ * at);
}

Eigen::MatrixXd ResponseSurface::gradient_covariance(const Place& place) const {
    const Eigen::MatrixXd at = slopes(place);
    return scatter_ * scatter_ * at.transpose() * inverse_ * at;
}

double ResponseSurface::prediction_error() const { return std::sqrt(press_ / n_values_); }

}  // namespace graincrack::calibrate
