#include "post/calibrate/optimum.hpp"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "post/statistics/statistics.hpp"

namespace graincrack::calibrate {

namespace {

/// A probability below its bound counts as much as a target off by one standard deviation where its logit is off by this.
constexpr double logit_deviation = 0.25;

/// Residuals of a least-squares problem with their derivatives.
class LeastSquares {
public:
    LeastSquares(const DesignPoint& first, const std::vector<Residual>& residuals,
                 const std::vector<ProbabilityConstraint>& constraints, double prior)
        : first_(first), residuals_(residuals), constraints_(constraints), prior_(prior) {}

    void evaluate(const DesignPoint& point, Eigen::VectorXd& values, Eigen::MatrixXd& slopes) const {
        const auto others = static_cast<Eigen::Index>(residuals_.size() + constraints_.size());
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
    std::ranges::partial_sort(starts, starts.begin() + 3, {}, [&](const DesignPoint& point) { return problem.sum(point); });
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

/// Root of the correlations between surfaces by specimens that they have in common.
Eigen::MatrixXd root_between(const std::vector<const LocalSurface*>& surfaces) {
    const auto n = static_cast<Eigen::Index>(surfaces.size());
    Eigen::MatrixXd correlation = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index r = 0; r < n; ++r) {
        for (Eigen::Index s = 0; s < r; ++s) {
            const auto [one, other] = std::pair(surfaces[static_cast<std::size_t>(r)], surfaces[static_cast<std::size_t>(s)]);
            if (one == nullptr || other == nullptr) continue;
            correlation(r, s) = correlation(s, r) = one->model().residual_correlation(other->model());
        }
    }
    return square_root(correlation);
}

}  // namespace

double Optimum::half_interval(Eigen::Index coordinate) const {
    return student_t_95(freedom) * std::sqrt(covariance(coordinate, coordinate));
}

void update(Optimum& optimum, const std::vector<Residual>& residuals) {
    const Eigen::Index p = optimum.point.size();
    const auto n = static_cast<Eigen::Index>(residuals.size());
    Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(n + p, p);  // of residuals, then of the first guess
    Eigen::VectorXd known = Eigen::VectorXd::Constant(n + p, optimum.prior * optimum.prior);  // variances of measured values
    Eigen::VectorXd total = known;                                                            // and of surfaces
    slopes.bottomRows(p).setIdentity();
    optimum.freedom = std::numeric_limits<int>::max();
    optimum.deviations.clear();
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto& [surface, value, deviation] = residuals[static_cast<std::size_t>(i)];
        slopes.row(i) = surface->gradient(optimum.point).transpose();
        known(i) = deviation * deviation;
        total(i) = known(i) + surface->variance(optimum.point);
        optimum.deviations.push_back((surface->value(optimum.point) - value) / deviation);
        optimum.freedom = std::min(optimum.freedom, surface->model().freedom);
    }
    const Eigen::MatrixXd weighted = slopes.transpose() * known.cwiseInverse().asDiagonal();
    optimum.gain = (weighted * slopes).ldlt().solve(weighted);
    optimum.covariance = optimum.gain * total.asDiagonal() * optimum.gain.transpose();
    const Eigen::VectorXd singular =
        Eigen::JacobiSVD<Eigen::MatrixXd>(total.head(n).cwiseSqrt().cwiseInverse().asDiagonal() * slopes.topRows(n))
            .singularValues();
    optimum.condition = n >= p ? singular(0) / singular(p - 1) : INFINITY;
}

Optimum find_optimum(const Box& box, const DesignPoint& first, const std::vector<Residual>& residuals,
                     const std::vector<ProbabilityConstraint>& constraints, double prior) {
    Optimum optimum;
    optimum.prior = prior;
    optimum.point = minimise_everywhere(LeastSquares(first, residuals, constraints, prior), box, first);
    update(optimum, residuals);
    return optimum;
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
    const Eigen::MatrixXd together = root_between(surfaces);
    std::map<const LocalSurface*, Eigen::MatrixXd> roots;  // of the covariances of coefficients
    Eigen::Index most = 0;
    for (const LocalSurface* const surface : surfaces) {
        if (surface == nullptr) continue;
        roots[surface] = square_root(surface->model().variance * surface->model().inverse);
        most = std::max(most, roots[surface].cols());
    }
    Draws draws;
    for (std::size_t i = 0; i < n; ++i) {
        Eigen::MatrixXd numbers = Eigen::MatrixXd::NullaryExpr(most, together.cols(), normal);
        numbers *= together;
        std::map<const LocalSurface*, Eigen::VectorXd> off;  // coefficients, by Student's distribution
        for (Eigen::Index r = 0; r < numbers.cols(); ++r) {
            const LocalSurface* const surface = surfaces[static_cast<std::size_t>(r)];
            if (surface == nullptr) continue;
            const int freedom = std::max(surface->model().freedom, 1);
            const double scale = std::sqrt(freedom / gsl_ran_chisq(generator.get(), freedom));
            off[surface] = scale * (roots[surface] * numbers.col(r).head(roots[surface].cols()));
        }
        Eigen::VectorXd values(optimum.gain.cols());
        for (double& of_prior : values) of_prior = optimum.prior * normal();
        for (std::size_t r = 0; r < residuals.size(); ++r) {
            const LocalSurface* const surface = residuals[r].surface;
            values(static_cast<Eigen::Index>(r)) =
                residuals[r].deviation * normal() - surface->terms(optimum.point).dot(off.at(surface));
        }
        draws.points.push_back(box.nearest(optimum.point + optimum.gain * values));
        std::vector<double>& logs = draws.logs.emplace_back();
        for (const LocalSurface* const surface : surfaces) {
            logs.push_back(surface == nullptr
                               ? NAN
                               : surface->value(draws.points.back()) + surface->terms(draws.points.back()).dot(off.at(surface)));
        }
    }
    return draws;
}

}  // namespace graincrack::calibrate
