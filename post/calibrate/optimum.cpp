#include "post/calibrate/optimum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "post/statistics/statistics.hpp"

namespace graincrack::calibrate {

namespace {

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

std::vector<double> local_factors(const Box& box, const DesignPoint& point) {
    const DesignPoint local = box.local(point);
    return {local.begin(), local.end()};
}

}  // namespace

double Logistic::probability(const Eigen::VectorXd& factors) const { return logistic(logit(factors)); }

Logistic fit_logistic(const Eigen::MatrixXd& factors, const Eigen::VectorXd& happened) {
    Eigen::MatrixXd x(factors.rows(), factors.cols() + 1);
    x << Eigen::VectorXd::Ones(factors.rows()), factors;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(x.cols());
    for (int i = 0; i < 100; ++i) {
        const Eigen::VectorXd p = (x * b).unaryExpr(&logistic);
        const Eigen::VectorXd w = (p.array() * (1 - p.array())).max(1e-12);
        const Eigen::MatrixXd information = x.transpose() * w.asDiagonal() * x;
        const Eigen::LDLT<Eigen::MatrixXd> solver(information);
        // h_i, the leverages, of the weighted regression
        const Eigen::VectorXd h = w.array() * (x.array() * solver.solve(x.transpose()).transpose().array()).rowwise().sum();
        Eigen::VectorXd step = solver.solve(x.transpose() * (happened - p + (h.array() * (0.5 - p.array())).matrix()));
        const double longest = step.lpNorm<Eigen::Infinity>();
        if (longest > 2) step *= 2 / longest;
        b += step;
        if (longest < 1e-10) break;
    }
    return {b};
}

std::optional<LocalSurface> LocalSurface::fit(const Box& box, const std::vector<DesignPoint>& points,
                                              const std::vector<double>& values) {
    std::vector<std::vector<double>> factors;
    std::vector<double> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isnan(values[i])) continue;
        factors.push_back(local_factors(box, points[i]));
        known.push_back(values[i]);
    }
    const auto p = static_cast<std::size_t>(box.size());
    if (known.size() < p + 3) return std::nullopt;
    std::vector<SurfaceTerm> quadratic = quadratic_terms(p);
    const auto end_of_linear = quadratic.begin() + static_cast<std::ptrdiff_t>(p) + 1;
    const std::vector<SurfaceTerm> linear(quadratic.begin(), end_of_linear);
    quadratic.erase(quadratic.begin(), end_of_linear);
    auto surface = ResponseSurface::fit(linear, std::move(factors), std::move(known));
    if (!surface) return std::nullopt;  // all values at one level of a parameter
    return LocalSurface(box, extend_forward(*std::move(surface), quadratic));
}

std::vector<double> LocalSurface::local(const DesignPoint& point) const { return local_factors(box_, point); }

namespace {

/// Standard deviation along a direction, in half widths of the first box, beyond which the data do not determine it.
constexpr double identified = 0.5;
/// Increase of the sum of squares at which an unidentified direction still stays at the first guess: half a standard deviation of
/// one target, beside a fifth of the sum: a slope that is little more than scatter can reduce a large misfit a little.
constexpr double small_increase = 0.25;
/// A probability below its bound counts as much as a target off by one standard deviation where its logit is off by this.
constexpr double logit_deviation = 0.25;

/// Residuals of a least-squares problem with their derivatives.
class LeastSquares {
public:
    LeastSquares(const DesignPoint& first, const std::vector<Residual>& residuals,
                 const std::vector<ProbabilityConstraint>& constraints)
        : first_(first), residuals_(residuals), constraints_(constraints) {}
    std::vector<DesignPoint> unidentified;  ///< directions held at the first guess

    void evaluate(const DesignPoint& point, Eigen::VectorXd& values, Eigen::MatrixXd& slopes) const {
        const auto n = static_cast<Eigen::Index>(residuals_.size() + constraints_.size() + unidentified.size());
        values.setZero(n);
        slopes.setZero(n, point.size());
        Eigen::Index i = 0;
        for (const Residual& residual : residuals_) {
            values(i) = (residual.surface->value(point) - residual.value) / residual.deviation;
            slopes.row(i++) = residual.surface->gradient(point).transpose() / residual.deviation;
        }
        for (const ProbabilityConstraint& constraint : constraints_) {
            const double lacking = std::log(constraint.least / (1 - constraint.least)) - constraint.probability->logit(point);
            if (lacking > 0) {
                values(i) = lacking / logit_deviation;
                slopes.row(i) = -constraint.probability->coefficients.tail(point.size()).transpose() / logit_deviation;
            }
            ++i;
        }
        constexpr double firmly = 1e3;
        for (const DesignPoint& direction : unidentified) {
            values(i) = firmly * direction.dot(point - first_);
            slopes.row(i++) = firmly * direction.transpose();
        }
    }
    [[nodiscard]] double sum(const DesignPoint& point) const {
        Eigen::VectorXd values;
        Eigen::MatrixXd slopes;
        evaluate(point, values, slopes);
        return values.squaredNorm();
    }

private:
    const DesignPoint& first_;
    const std::vector<Residual>& residuals_;
    const std::vector<ProbabilityConstraint>& constraints_;
};

/// Levenberg and Marquardt's method; coordinates at an edge that would leave the box stay there.
DesignPoint minimise(const LeastSquares& problem, const Box& box, DesignPoint point) {
    Eigen::VectorXd r;
    Eigen::MatrixXd slopes;
    double damping = 1e-3;
    double sum = problem.sum(point);
    for (int i = 0; i < 200 && damping < 1e12; ++i) {
        problem.evaluate(point, r, slopes);
        const DesignPoint downhill = -(slopes.transpose() * r);
        Eigen::MatrixXd matrix = slopes.transpose() * slopes;
        const double scale = matrix.diagonal().maxCoeff() + 1e-300;
        DesignPoint right = downhill;
        for (Eigen::Index k = 0; k < point.size(); ++k) {
            const double local = (point(k) - box.centre(k)) / box.half(k);
            matrix(k, k) += damping * scale;
            if (std::abs(local) < 1 - 1e-12 || local * downhill(k) < 0) continue;
            matrix.row(k).setZero();
            matrix.col(k).setZero();
            matrix(k, k) = 1;
            right(k) = 0;
        }
        const DesignPoint next = box.nearest(point + matrix.ldlt().solve(right));
        const double now = problem.sum(next);
        if (now < sum) {
            const bool settled = sum - now < 1e-12 * (1 + sum);
            point = next;
            sum = now;
            damping *= 0.2;
            if (settled) break;
        } else {
            damping *= 5;
        }
    }
    return point;
}

DesignPoint minimise_everywhere(const LeastSquares& problem, const Box& box, const DesignPoint& first) {
    std::vector<DesignPoint> starts = sobol_points(box, 0, 64);
    std::partial_sort(starts.begin(), starts.begin() + 3, starts.end(),
                      [&](const DesignPoint& a, const DesignPoint& b) { return problem.sum(a) < problem.sum(b); });
    starts.resize(3);
    starts.insert(starts.begin(), box.nearest(first));
    DesignPoint best;
    double least = std::numeric_limits<double>::infinity();
    for (const DesignPoint& start : starts) {
        const DesignPoint found = minimise(problem, box, start);
        const double sum = problem.sum(found);
        if (sum < least * (1 - 1e-9)) {
            least = sum;
            best = found;
        }
    }
    return best;
}

double fraction_in(const std::vector<DesignPoint>& directions, Eigen::Index coordinate) {
    double fraction = 0;
    for (const DesignPoint& direction : directions) fraction += direction(coordinate) * direction(coordinate);
    return fraction;
}

}  // namespace

double Optimum::half_interval(Eigen::Index coordinate) const {
    return student_t_95(freedom) * std::sqrt(covariance(coordinate, coordinate));
}

double Optimum::unidentified_fraction(Eigen::Index coordinate) const { return fraction_in(unidentified, coordinate); }

double Optimum::undetermined_fraction(Eigen::Index coordinate) const {
    return fraction_in(unidentified, coordinate) + fraction_in(moved, coordinate);
}

namespace {

/// Directions that are neither unidentified nor moved, a column each.
Eigen::MatrixXd identified_directions(const Eigen::MatrixXd& all, const Optimum& optimum) {
    Eigen::MatrixXd directions(all.rows(), 0);
    for (Eigen::Index k = 0; k < all.cols(); ++k) {
        const auto has = [&](const std::vector<DesignPoint>& some) {
            return std::any_of(some.begin(), some.end(), [&](const DesignPoint& d) { return d == all.col(k); });
        };
        if (has(optimum.unidentified) || has(optimum.moved)) continue;
        directions.conservativeResize(Eigen::NoChange, directions.cols() + 1);
        directions.rightCols(1) = all.col(k);
    }
    return directions;
}

/// The covariance of a point that follows from measured values and surfaces along some directions; both scatter. \param slopes
/// of the surfaces, a row each \param total variance of each \param weights of the measured values
Eigen::MatrixXd covariance_along(const Eigen::MatrixXd& directions, const Eigen::MatrixXd& slopes, const Eigen::VectorXd& total,
                                 const Eigen::VectorXd& weights) {
    if (directions.cols() == 0) return Eigen::MatrixXd::Zero(directions.rows(), directions.rows());
    const Eigen::MatrixXd along = slopes * directions;
    const Eigen::MatrixXd weighted = along.transpose() * weights.asDiagonal();
    const Eigen::MatrixXd gain = directions * (weighted * along).ldlt().solve(weighted);
    return gain * total.asDiagonal() * gain.transpose();
}

}  // namespace

Optimum find_optimum(const Box& box, const DesignPoint& first, const std::vector<Residual>& residuals,
                     const std::vector<ProbabilityConstraint>& constraints) {
    LeastSquares problem(first, residuals, constraints);
    Optimum optimum;
    const auto n = static_cast<Eigen::Index>(residuals.size());
    Eigen::MatrixXd slopes(n, box.size());
    Eigen::VectorXd total(n);  // variance of measured value and surface
    Eigen::VectorXd weights(n);
    const auto go_to = [&](const DesignPoint& point) {
        optimum.point = point;
        for (Eigen::Index i = 0; i < n; ++i) {
            const Residual& residual = residuals[static_cast<std::size_t>(i)];
            slopes.row(i) = residual.surface->gradient(point).transpose();
            total(i) = residual.deviation * residual.deviation + residual.surface->variance(point);
            weights(i) = 1 / std::pow(residual.deviation, 2);
        }
    };
    go_to(minimise_everywhere(problem, box, first));
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(total.cwiseSqrt().cwiseInverse().asDiagonal() * slopes, Eigen::ComputeFullV);
    const Eigen::VectorXd& values = svd.singularValues();
    optimum.condition = values.size() == box.size() ? values(0) / values(values.size() - 1) : INFINITY;
    double sum = problem.sum(optimum.point);
    for (Eigen::Index k = box.size() - 1; k >= 0 && (k >= values.size() || values(k) * identified < 1); --k) {
        problem.unidentified.emplace_back(svd.matrixV().col(k));
        const DesignPoint point = minimise_everywhere(problem, box, first);
        const double with_it = problem.sum(point);
        if (with_it <= 1.2 * sum + small_increase) {
            go_to(point);
            sum = with_it;
        } else {
            problem.unidentified.pop_back();
            if (k >= values.size() || values(k) < 1e-9 * values(0)) optimum.moved.emplace_back(svd.matrixV().col(k));
        }
    }
    optimum.unidentified = problem.unidentified;
    optimum.covariance = covariance_along(identified_directions(svd.matrixV(), optimum), slopes, total, weights);
    optimum.freedom = std::numeric_limits<int>::max();
    for (const Residual& residual : residuals) {
        optimum.deviations.push_back((residual.surface->value(optimum.point) - residual.value) / residual.deviation);
        optimum.freedom = std::min(optimum.freedom, residual.surface->freedom());
    }
    return optimum;
}

}  // namespace graincrack::calibrate
