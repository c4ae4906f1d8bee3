#include "post/calibrate/optimum.hpp"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "post/statistics/statistics.hpp"

namespace graincrack::calibrate {

namespace {

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

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
                 const std::vector<ProbabilityConstraint>& constraints, double prior)
        : first_(first), residuals_(residuals), constraints_(constraints), prior_(prior) {}
    std::vector<DesignPoint> unidentified;  ///< directions held at the first guess

    void evaluate(const DesignPoint& point, Eigen::VectorXd& values, Eigen::MatrixXd& slopes) const {
        const auto others = static_cast<Eigen::Index>(residuals_.size() + constraints_.size() + unidentified.size());
        const Eigen::Index p = point.size();
        values.setZero(others + p);
        slopes.setZero(others + p, p);
        values.tail(p) = (point - first_) / prior_;
        slopes.bottomRows(p).diagonal().setConstant(1 / prior_);
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
    double prior_;
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
    return fraction_in(unidentified, coordinate) + fraction_in(moved, coordinate) +
           covariance(coordinate, coordinate) / (prior * prior);
}

namespace {

/// Directions at right angles to those that are unidentified or moved, a column each.
Eigen::MatrixXd identified_directions(const Optimum& optimum) {
    std::vector<DesignPoint> others = optimum.unidentified;
    others.insert(others.end(), optimum.moved.begin(), optimum.moved.end());
    const Eigen::Index p = optimum.point.size();
    const auto m = static_cast<Eigen::Index>(others.size());
    Eigen::MatrixXd columns(p, m);
    for (Eigen::Index k = 0; k < m; ++k) columns.col(k) = others[static_cast<std::size_t>(k)];
    const Eigen::MatrixXd all = columns.householderQr().householderQ() * Eigen::MatrixXd::Identity(p, p);
    return all.rightCols(p - m);
}

/// The sensitivities of residuals at a point.
struct Sensitivities {
    Eigen::MatrixXd slopes;   ///< of the surfaces, a row each
    Eigen::VectorXd total;    ///< variance of measured value and surface
    Eigen::VectorXd weights;  ///< of the measured values

    Sensitivities(const DesignPoint& at, const std::vector<Residual>& residuals)
        : slopes(static_cast<Eigen::Index>(residuals.size()), at.size()), total(slopes.rows()), weights(slopes.rows()) {
        for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
            const Residual& residual = residuals[static_cast<std::size_t>(i)];
            slopes.row(i) = residual.surface->gradient(at).transpose();
            total(i) = residual.deviation * residual.deviation + residual.surface->variance(at);
            weights(i) = 1 / std::pow(residual.deviation, 2);
        }
    }
    [[nodiscard]] Eigen::JacobiSVD<Eigen::MatrixXd> directions() const {
        return Eigen::JacobiSVD<Eigen::MatrixXd>(total.cwiseSqrt().cwiseInverse().asDiagonal() * slopes, Eigen::ComputeFullV);
    }
};

}  // namespace

Optimum find_optimum(const Box& box, const DesignPoint& first, const std::vector<Residual>& residuals,
                     const std::vector<ProbabilityConstraint>& constraints, double prior) {
    LeastSquares problem(first, residuals, constraints, prior);
    Optimum optimum;
    optimum.prior = prior;
    optimum.point = minimise_everywhere(problem, box, first);
    const auto svd = Sensitivities(optimum.point, residuals).directions();
    const Eigen::VectorXd& values = svd.singularValues();
    double sum = problem.sum(optimum.point);
    for (Eigen::Index k = box.size() - 1; k >= 0 && std::isinf(prior) && (k >= values.size() || values(k) * identified < 1);
         --k) {
        problem.unidentified.emplace_back(svd.matrixV().col(k));
        const DesignPoint point = minimise_everywhere(problem, box, first);
        const double with_it = problem.sum(point);
        if (with_it <= 1.2 * sum + small_increase) {
            optimum.point = point;
            sum = with_it;
        } else {
            problem.unidentified.pop_back();
            if (k >= values.size() || values(k) < 1e-9 * values(0)) optimum.moved.emplace_back(svd.matrixV().col(k));
        }
    }
    optimum.unidentified = problem.unidentified;
    update(optimum, residuals);
    return optimum;
}

void update(Optimum& optimum, const std::vector<Residual>& residuals) {
    const Sensitivities at(optimum.point, residuals);
    const Eigen::VectorXd singular = at.directions().singularValues();
    optimum.condition = singular.size() == at.slopes.cols() ? singular(0) / singular(singular.size() - 1) : INFINITY;
    const Eigen::MatrixXd directions = identified_directions(optimum);
    const Eigen::Index p = at.slopes.cols();
    Eigen::MatrixXd slopes(at.slopes.rows() + p, p);
    slopes << at.slopes, Eigen::MatrixXd::Identity(p, p);
    Eigen::VectorXd weights(slopes.rows());
    weights << at.weights, Eigen::VectorXd::Constant(p, 1 / (optimum.prior * optimum.prior));
    Eigen::VectorXd total(slopes.rows());
    total << at.total, Eigen::VectorXd::Constant(p, std::isinf(optimum.prior) ? 0 : optimum.prior * optimum.prior);
    optimum.gain.setZero(p, slopes.rows());
    if (directions.cols() > 0) {
        const Eigen::MatrixXd along = slopes * directions;
        const Eigen::MatrixXd weighted = along.transpose() * weights.asDiagonal();
        optimum.gain = directions * (weighted * along).ldlt().solve(weighted);
    }
    optimum.covariance = optimum.gain * total.asDiagonal() * optimum.gain.transpose();
    optimum.freedom = std::numeric_limits<int>::max();
    optimum.deviations.clear();
    for (const Residual& residual : residuals) {
        optimum.deviations.push_back((residual.surface->value(optimum.point) - residual.value) / residual.deviation);
        optimum.freedom = std::min(optimum.freedom, residual.surface->freedom());
    }
}

double misfit(const DesignPoint& at, const std::vector<Residual>& residuals) {
    double sum = 0;
    for (const Residual& r : residuals) sum += std::pow((r.surface->value(at) - r.value) / r.deviation, 2);
    return sum;
}

Draws draw(const Box& box, const Optimum& optimum, const std::vector<Residual>& residuals,
           const std::vector<const LocalSurface*>& surfaces, std::size_t n) {
    const std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> generator(gsl_rng_alloc(gsl_rng_mt19937), &gsl_rng_free);
    const auto normal = [&] { return gsl_ran_ugaussian(generator.get()); };
    Draws draws;
    for (std::size_t i = 0; i < n; ++i) {
        std::map<const LocalSurface*, Eigen::VectorXd> off;  // coefficients
        for (const LocalSurface* const surface : surfaces) {
            if (surface == nullptr) continue;
            off[surface] = surface->drawn(Eigen::VectorXd::NullaryExpr(surface->terms(optimum.point).size(), normal));
        }
        Eigen::VectorXd values(optimum.gain.cols());
        for (double& of_prior : values) of_prior = std::isinf(optimum.prior) ? 0 : optimum.prior * normal();
        for (std::size_t r = 0; r < residuals.size(); ++r) {
            const LocalSurface* const surface = residuals[r].surface;
            values(static_cast<Eigen::Index>(r)) =
                residuals[r].deviation * normal() - surface->terms(optimum.point).dot(off.at(surface));
        }
        DesignPoint point = optimum.point + optimum.gain * values;
        for (const auto* const directions : {&optimum.unidentified, &optimum.moved}) {
            for (const DesignPoint& direction : *directions) point += identified * normal() * direction;
        }
        draws.points.push_back(box.nearest(point));
        std::vector<double>& logs = draws.logs.emplace_back();
        for (const LocalSurface* const surface : surfaces) {
            logs.push_back(surface == nullptr
                               ? NAN
                               : surface->value(draws.points.back()) + surface->terms(draws.points.back()).dot(off[surface]));
        }
    }
    return draws;
}

}  // namespace graincrack::calibrate
