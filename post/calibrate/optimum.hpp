// Finds the design point at which response surfaces meet their targets, by weighted least squares inside a box, with its
// uncertainty, and draws posterior samples about it.
#pragma once

#include <cstddef>
#include <vector>

#include "post/calibrate/local_surface.hpp"
#include "post/statistics/nonlinear_fit.hpp"

namespace graincrack::calibrate {

/// A response with its target. The residual is their difference over the deviation.
struct Residual {
    const LocalSurface* surface;
    double value = 0;      ///< ln of the target
    double deviation = 0;  ///< standard deviation of ln of the measured value
};

/// A probability with its lower bound; it is a logistic function of the design point.
struct ProbabilityConstraint {
    const Logistic* probability;
    double least = 0;
};

/// The most probable design point for Gaussian scatter of targets and of the first guess. It is shrunk to the first guess in
/// directions that the data determine little.
struct Optimum {
    DesignPoint point;
    double prior = 1;            ///< prior standard deviation of each coordinate about the first guess
    Eigen::MatrixXd covariance;  ///< of the point, from first guess, measured values and scatter of surfaces
    Eigen::MatrixXd gain;  ///< derivatives of the point by the value of each residual and by each coordinate of the first guess
    std::vector<double> deviations;  ///< [residuals] response less target, over the standard deviation
    double condition = 1;            ///< condition number of the matrix of sensitivities
    int freedom = 0;                 ///< smallest number of degrees of freedom of the surfaces

    /// Half of the 95 % interval of a coordinate.
    [[nodiscard]] double half_interval(Eigen::Index coordinate) const;
    /// True if the data leave more than a quarter of the usual prior variance, which is 1, whatever `prior` is.
    [[nodiscard]] bool is_undetermined(Eigen::Index coordinate) const { return covariance(coordinate, coordinate) > 0.25; }
};

/// Finds the optimum in a box. \param first guess, inside the box or not \pre there is a residual
Optimum find_optimum(const Box& box, const DesignPoint& first, const std::vector<Residual>& residuals,
                     const std::vector<ProbabilityConstraint>& constraints = {}, double prior = 1);
/// Updates all members of an optimum but its point by the residuals.
void update(Optimum& optimum, const std::vector<Residual>& residuals);
/// Sum of the squared residuals at a point.
double misfit(const DesignPoint& at, const std::vector<Residual>& residuals);

/// Posterior samples: points, and ln of the mean of each response there.
struct Draws {
    std::vector<DesignPoint> points;
    std::vector<std::vector<double>> logs;  ///< [points][responses]
};
/// Draws n posterior samples about an optimum by linearisation: first guess and measured values have Gaussian scatter,
/// coefficients of surfaces that of Student's distribution. \param residuals those of the optimum \param surfaces of the
/// responses; a response without one (null) has NaN
Draws draw(const Box& box, const Optimum& optimum, const std::vector<Residual>& residuals,
           const std::vector<const LocalSurface*>& surfaces, std::size_t n);

}  // namespace graincrack::calibrate
