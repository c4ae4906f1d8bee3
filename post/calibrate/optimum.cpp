#include "post/calibrate/optimum.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "post/statistics/statistics.hpp"

namespace graincrack::calibrate {

namespace {

/// Standard deviation along a direction, in half widths of the first box, beyond which the data do not determine it.
constexpr double untold = 0.5;
/// What keeping such a direction at the first guess may add to the sum of squares, half a standard deviation of one target,
/// beside a fifth of it: a slope that is little more than scatter can reduce a large misfit a little.
constexpr double costs_little = 0.25;
/// A share below its bound counts as much as a target off by one standard deviation where its logit is off by this.
constexpr double logit_deviation = 0.25;

/// Residuals of a least-squares problem with their derivatives.
class LeastSquares {
public:
    LeastSquares(const Place& first, const std::vector<Aim>& aims, const std::vector<LeastShare>& shares)
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
Place minimise(const LeastSquares& problem, const Box& box, Place place) {
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

Place minimise_everywhere(const LeastSquares& problem, const Box& box, const Place& first) {
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

double share_in(const std::vector<Place>& directions, Eigen::Index coordinate) {
    double share = 0;
    for (const Place& direction : directions) share += direction(coordinate) * direction(coordinate);
    return share;
}

}  // namespace

double Optimum::half_interval(Eigen::Index coordinate) const {
    return student_t_95(freedom) * std::sqrt(covariance(coordinate, coordinate));
}

double Optimum::kept_share(Eigen::Index coordinate) const { return share_in(kept, coordinate); }

double Optimum::untold_share(Eigen::Index coordinate) const { return share_in(kept, coordinate) + share_in(moved, coordinate); }

Optimum find_optimum(const Box& box, const Place& first, const std::vector<Aim>& aims, const std::vector<LeastShare>& shares) {
    LeastSquares problem(first, aims, shares);
    Optimum optimum;
    const auto n = static_cast<Eigen::Index>(aims.size());
    Eigen::MatrixXd slopes(n, box.size());
    Eigen::VectorXd total(n);  // variance of measured value and surface
    const auto go_to = [&](const Place& place) {
        optimum.place = place;
        for (Eigen::Index i = 0; i < n; ++i) {
            const Aim& aim = aims[static_cast<std::size_t>(i)];
            slopes.row(i) = aim.surface->gradient(place).transpose();
            total(i) = aim.deviation * aim.deviation + aim.surface->variance(place);
        }
    };
    go_to(minimise_everywhere(problem, box, first));
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(total.cwiseSqrt().cwiseInverse().asDiagonal() * slopes, Eigen::ComputeFullV);
    const Eigen::VectorXd& values = svd.singularValues();
    optimum.condition = values.size() == box.size() ? values(0) / values(values.size() - 1) : INFINITY;
    double sum = problem.sum(optimum.place);
    for (Eigen::Index k = box.size() - 1; k >= 0 && (k >= values.size() || values(k) * untold < 1); --k) {
        problem.kept.emplace_back(svd.matrixV().col(k));
        const Place place = minimise_everywhere(problem, box, first);
        const double with_it = problem.sum(place);
        if (with_it <= 1.2 * sum + costs_little) {
            go_to(place);
            sum = with_it;
        } else {
            problem.kept.pop_back();
            if (k >= values.size() || values(k) < 1e-9 * values(0)) optimum.moved.emplace_back(svd.matrixV().col(k));
        }
    }
    optimum.kept = problem.kept;
    Eigen::MatrixXd told = svd.matrixV();  // of which those are left out that are kept or moved
    for (Eigen::Index k = told.cols() - 1; k >= 0; --k) {
        const auto is_in = [&](const std::vector<Place>& directions) {
            return std::any_of(directions.begin(), directions.end(), [&](const Place& d) { return d == svd.matrixV().col(k); });
        };
        if (!is_in(optimum.kept) && !is_in(optimum.moved)) continue;
        told.middleCols(k, told.cols() - 1 - k) = told.rightCols(told.cols() - 1 - k).eval();
        told.conservativeResize(Eigen::NoChange, told.cols() - 1);
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
