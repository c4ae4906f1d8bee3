// The design point where response surfaces meet their targets, by weighted least squares inside a box, how well the data
// determine it, and points drawn from what they leave open.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "post/calibrate/local_surface.hpp"

namespace graincrack::calibrate {

/// Probability of an outcome as a function of several factors: logistic regression, penalised so that outcomes that all are
/// alike, or that a plane separates, have finite coefficients too.
struct Logistic {
    Eigen::VectorXd coefficients;  ///< of 1 and the factors

    /// ln(p/(1 − p)) at some factors.
    [[nodiscard]] double logit(const Eigen::VectorXd& factors) const {
        return coefficients(0) + coefficients.tail(coefficients.size() - 1).dot(factors);
    }
    [[nodiscard]] double probability(const Eigen::VectorXd& factors) const;
};

/// Maximum of the likelihood times Jeffreys' prior (Firth 1993, Biometrika 80, 27–38).
/// \param factors a row a case \param happened 0 or 1 of each case \pre there are cases
Logistic fit_logistic(const Eigen::MatrixXd& factors, const Eigen::VectorXd& happened);

/// A response with its target, whose difference over the deviation is a residual.
struct Residual {
    const LocalSurface* surface;
    double value = 0;      ///< ln of the target
    double deviation = 0;  ///< standard deviation of the measured value, of its ln
};

/// A probability, by a logistic function of design points, with its lower bound.
struct ProbabilityConstraint {
    const Logistic* probability;
    double least = 0;
};

struct Optimum {
    DesignPoint point;
    /// Covariance of the point, by the scatter of surfaces and measured values; 0 along directions that are unidentified or were
    /// moved.
    Eigen::MatrixXd covariance;
    /// Directions (of length 1) along which the data determine the point no better than by half the width of the first box, one
    /// standard deviation: along these it stays at the first guess.
    std::vector<DesignPoint> unidentified;
    /// Directions (of length 1) along which no target changes, that were moved as far as the targets need.
    std::vector<DesignPoint> moved;
    std::vector<double> deviations;  ///< off the targets over their standard deviations, of each residual
    /// Standard deviation of each coordinate about the first guess before there are data; infinite: nothing is known.
    double prior = INFINITY;
    /// Shift of the point by one of each residual's values, and with a prior by one of each coordinate of the first guess.
    Eigen::MatrixXd gain;
    double condition = 1;  ///< number of the matrix of sensitivities
    int freedom = 0;       ///< the least of the surfaces

    /// Half of the 95 % interval of a coordinate.
    [[nodiscard]] double half_interval(Eigen::Index coordinate) const;
    /// Fraction of a coordinate that lies in unidentified directions, 0 to 1.
    [[nodiscard]] double unidentified_fraction(Eigen::Index coordinate) const;
    /// Fraction of a coordinate that lies in directions unidentified or moved, with a prior of its variance that the data leave,
    /// 0 to 1.
    [[nodiscard]] double undetermined_fraction(Eigen::Index coordinate) const;
};

/// \param first guess, inside the box or not \param prior of the optimum: with one, what the data tell little of stays near the
/// first guess, and no direction is unidentified \pre there is a residual
Optimum find_optimum(const Box& box, const DesignPoint& first, const std::vector<Residual>& residuals,
                     const std::vector<ProbabilityConstraint>& constraints = {}, double prior = INFINITY);
/// What the residuals tell of an optimum whose point and directions stay as they are.
void update(Optimum& optimum, const std::vector<Residual>& residuals);
/// Sum of the squared deviations off the targets at a point.
double misfit(const DesignPoint& at, const std::vector<Residual>& residuals);

/// Points, and ln of the mean of each response there.
struct Draws {
    std::vector<DesignPoint> points;
    std::vector<std::vector<double>> logs;  ///< of each point
};
/// What measured values that scatter by their deviations and coefficients that scatter by their covariance leave open about an
/// optimum, linearised; along directions that nothing determines, the quarter of the width of the first box that the data had to
/// beat. \param residuals those of the optimum \param surfaces of the responses; null: a response has none, its values are NaN
Draws draw(const Box& box, const Optimum& optimum, const std::vector<Residual>& residuals,
           const std::vector<const LocalSurface*>& surfaces, std::size_t n);

}  // namespace graincrack::calibrate
