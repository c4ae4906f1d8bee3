// The design point where response surfaces meet their targets, by weighted least squares inside a box, how well the data
// determine it, and points drawn from what they leave open.
#pragma once

#include <cstddef>
#include <vector>

#include "post/calibrate/local_surface.hpp"
#include "post/statistics/nonlinear_fit.hpp"

namespace graincrack::calibrate {

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

/// The most probable design point: targets and what is known beforehand have Gaussian scatter. What the data tell little of stays
/// near the first guess.
struct Optimum {
    DesignPoint point;
    double prior = 1;            ///< standard deviation of each coordinate about the first guess before there are data
    Eigen::MatrixXd covariance;  ///< of the point, by first guess, measured values and scatter of surfaces
    Eigen::MatrixXd gain;  ///< shift of the point by one of each residual's values, and of each coordinate of the first guess
    std::vector<double> deviations;  ///< off the targets over their standard deviations, of each residual
    double condition = 1;            ///< number of the matrix of sensitivities
    int freedom = 0;                 ///< the least of the surfaces

    /// Half of the 95 % interval of a coordinate.
    [[nodiscard]] double half_interval(Eigen::Index coordinate) const;
    /// True if the data leave more than a quarter of the variance of the usual first guess, 1, whatever this one had.
    [[nodiscard]] bool is_undetermined(Eigen::Index coordinate) const { return covariance(coordinate, coordinate) > 0.25; }
};

/// \param first guess, inside the box or not \pre there is a residual
Optimum find_optimum(const Box& box, const DesignPoint& first, const std::vector<Residual>& residuals,
                     const std::vector<ProbabilityConstraint>& constraints = {}, double prior = 1);
/// What the residuals tell of an optimum whose point stays where it is.
void update(Optimum& optimum, const std::vector<Residual>& residuals);
/// Sum of the squared deviations off the targets at a point.
double misfit(const DesignPoint& at, const std::vector<Residual>& residuals);

/// Points, and ln of the mean of each response there.
struct Draws {
    std::vector<DesignPoint> points;
    std::vector<std::vector<double>> logs;  ///< of each point
};
/// What is left open about an optimum, linearised: first guess, measured values and coefficients of surfaces scatter by what is
/// known of them. \param residuals those of the optimum \param surfaces of the responses; null: a response has none, its values
/// are NaN
Draws draw(const Box& box, const Optimum& optimum, const std::vector<Residual>& residuals,
           const std::vector<const LocalSurface*>& surfaces, std::size_t n);

}  // namespace graincrack::calibrate
