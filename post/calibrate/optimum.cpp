#include "post/calibrate/optimum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "post/fit/statistics.hpp"

namespace graincrack::calibrate {

namespace {

/// Standard deviation along a direction, in half widths of the first box, beyond which data do not tell it.
constexpr double untold = 0.5;
/// A share below its bound counts as much as a target off by one standard deviation where its logit is off by this.
constexpr double logit_deviation = 0.25;

/// Residuals of a least-squares problem with their derivatives.
class Problem {
public:
    Problem(const Place& first, const std::vector<Aim>& aims, const std::vector<LeastShare>& shares)
        : first_(first), aims_(aims), shares_(shares) {}
    std::vector<Place> kept;  ///< directions held at the first guess

    void evaluate(const Place& place, Eigen::VectorXd& residuals, Eigen::MatrixXd& slopes) const {
        const auto n = static_cast<Eigen::Index>(aims_.size() + shares_.size() + kept.size());
        residuals.setZero(n);
        slopes.setZero(n, place.size());
        Eigen::Index i = 0;
        for (const Aim& aim : aims_) {
            residuals(i) = (aim.surface->value(place) - aim.value) / aim.deviation;
            slopes.row(i++) = aim.surface->gradient(place).transpose() / aim.deviation;
        }
        for (const LeastShare& share : shares_) {
            const double lacking = std::log(share.least / (1 - share.least)) - share.share->logit(place);
            if (lacking > 0) {
                residuals(i) = lacking / logit_deviation;
                slopes.row(i) = -share.share->coefficients.tail(place.size()).transpose() / logit_deviation;
            }
            ++i;
        }
        constexpr double firmly = 1e3;
        for (const Place& direction : kept) {
            residuals(i) = firmly * direction.dot(place - first_);
            slopes.row(i++) = firmly * direction.transpose();
        }
    }
    [[nodiscard]] double sum(const Place& place) const {
        Eigen::VectorXd residuals;
        Eigen::MatrixXd slopes;
        evaluate(place, residuals, slopes);
        return residuals.squaredNorm();
    }

private:
    const Place& first_;
    const std::vector<Aim>& aims_;
    const std::vector<LeastShare>& shares_;
};

/// Levenberg and Marquardt's method; coordinates at an edge that would leave the box stay there.
Place minimise(const Problem& problem, const Box& box, Place place) {
    Eigen::VectorXd r;
    Eigen::MatrixXd slopes;
    double damping = 1e-3;
    double sum = problem.sum(place);
    for (int i = 0; i < 200 && damping < 1e12; ++i) {
        problem.evaluate(place, r, slopes);
        const Place downhill = -(slopes.transpose() * r);
        Eigen::MatrixXd matrix = slopes.transpose() * slopes;
        const double scale = matrix.diagonal().maxCoeff() + 1e-300;
        Place right = downhill;
        for (Eigen::Index k = 0; k < place.size(); ++k) {
            const double local = (place(k) - box.centre(k)) / box.half(k);
            matrix(k, k) += damping * scale;
            if (std::abs(local) < 1 - 1e-12 || local * downhill(k) < 0) continue;
            matrix.row(k).setZero();
            matrix.col(k).setZero();
            matrix(k, k) = 1;
            right(k) = 0;
        }
        const Place next = box.nearest(place + matrix.ldlt().solve(right));
        const double now = problem.sum(next);
        if (now < sum) {
            const bool settled = sum - now < 1e-12 * (1 + sum);
            place = next;
            sum = now;
            damping *= 0.2;
            if (settled) break;
        } else {
            damping *= 5;
        }
    }
    return place;
}

Place minimise_everywhere(const Problem& problem, const Box& box, const Place& first) {
    std::vector<Place> starts = sobol_places(box, 0, 64);
    std::partial_sort(starts.begin(), starts.begin() + 3, starts.end(),
                      [&](const Place& a, const Place& b) { return problem.sum(a) < problem.sum(b); });
    starts.resize(3);
    starts.insert(starts.begin(), box.nearest(first));
    Place best;
    double least = std::numeric_limits<double>::infinity();
    for (const Place& start : starts) {
        const Place found = minimise(problem, box, start);
        const double sum = problem.sum(found);
        if (sum < least * (1 - 1e-9)) {
            least = sum;
            best = found;
        }
    }
    return best;
}

}  // namespace

double Optimum::half_interval(Eigen::Index coordinate) const {
    return student_t_95(freedom) * std::sqrt(covariance(coordinate, coordinate));
}

double Optimum::kept_share(Eigen::Index coordinate) const {
    double share = 0;
    for (const Place& direction : kept) share += direction(coordinate) * direction(coordinate);
    return share;
}

Optimum find_optimum(const Box& box, const Place& first, const std::vector<Aim>& aims, const std::vector<LeastShare>& shares) {
    Problem problem(first, aims, shares);
    Optimum optimum;
    const auto n = static_cast<Eigen::Index>(aims.size());
    Eigen::MatrixXd slopes(n, box.size());
    Eigen::VectorXd total(n);  // variance of measured value and surface
    Eigen::MatrixXd told;
    for (std::size_t before = box.size() + 1U; before != problem.kept.size();) {
        before = problem.kept.size();
        optimum.place = minimise_everywhere(problem, box, first);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Aim& aim = aims[static_cast<std::size_t>(i)];
            slopes.row(i) = aim.surface->gradient(optimum.place).transpose();
            total(i) = aim.deviation * aim.deviation + aim.surface->variance(optimum.place);
        }
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(total.cwiseSqrt().cwiseInverse().asDiagonal() * slopes, Eigen::ComputeFullV);
        const Eigen::VectorXd& values = svd.singularValues();
        const Eigen::Index rank = (values.array() * untold >= 1).count();
        told = svd.matrixV().leftCols(rank);
        optimum.condition = values.size() == box.size() ? values(0) / values(values.size() - 1) : INFINITY;
        std::vector<Place> kept;
        for (Eigen::Index k = rank; k < box.size(); ++k) kept.emplace_back(svd.matrixV().col(k));
        if (kept.size() <= problem.kept.size()) break;  // what is kept once stays, so that this ends
        problem.kept = kept;
    }
    optimum.kept = problem.kept;
    if (!problem.kept.empty()) {  // the directions that were kept, not those at the place to which they led
        Eigen::MatrixXd directions(box.size(), static_cast<Eigen::Index>(problem.kept.size()));
        for (Eigen::Index k = 0; k < directions.cols(); ++k) directions.col(k) = problem.kept[static_cast<std::size_t>(k)];
        const Eigen::JacobiSVD<Eigen::MatrixXd> svd(directions, Eigen::ComputeFullU);
        told = svd.matrixU().rightCols(box.size() - directions.cols());
    }
    // The place follows from the measured values and the surfaces by G; both scatter.
    optimum.covariance.setZero(box.size(), box.size());
    if (told.cols() > 0) {
        Eigen::VectorXd weights(n);
        for (Eigen::Index i = 0; i < n; ++i) weights(i) = 1 / std::pow(aims[static_cast<std::size_t>(i)].deviation, 2);
        const Eigen::MatrixXd along = slopes * told;
        const Eigen::MatrixXd g =
            told * (along.transpose() * weights.asDiagonal() * along).ldlt().solve(along.transpose() * weights.asDiagonal());
        optimum.covariance = g * total.asDiagonal() * g.transpose();
    }
    optimum.freedom = std::numeric_limits<int>::max();
    for (const Aim& aim : aims) {
        optimum.deviations.push_back((aim.surface->value(optimum.place) - aim.value) / aim.deviation);
        optimum.freedom = std::min(optimum.freedom, aim.surface->freedom());
    }
    return optimum;
}

}  // namespace graincrack::calibrate
