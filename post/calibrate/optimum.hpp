// The place where surfaces meet their targets: weighted least squares inside a box, and what the data tell of it.
#pragma once

#include <vector>

#include "post/calibrate/surface.hpp"
#include "post/statistics/logistic.hpp"

namespace graincrack::calibrate {

/// A surface and where it shall be.
struct Aim {
    const ResponseSurface* surface;
    double value = 0;      ///< ln of the target
    double deviation = 0;  ///< standard deviation of the measured value, of its ln
};

/// A share of tests that shall not be smaller. The logistic function is one of places.
struct LeastShare {
    const Logistic* share;
    double least = 0;
};

struct Optimum {
    Place place;
    Eigen::MatrixXd
        covariance;  ///< of the place, by the scatter of surfaces and measured values; 0 along directions kept or moved
    /// Directions (of length 1) along which the data tell the place no better than by half the width of the first box, one
    /// standard deviation: kept at the first guess.
    std::vector<Place> kept;
    /// Likewise, of length 1: directions along which no target changes, that were moved as far as the targets wanted.
    std::vector<Place> moved;
    std::vector<double> deviations;  ///< off the targets over their standard deviations, of each aim
    double condition = 1;            ///< number of the matrix of sensitivities
    int freedom = 0;                 ///< the least of the surfaces

    /// Half of the 95 % interval of a coordinate.
    [[nodiscard]] double half_interval(Eigen::Index coordinate) const;
    /// Share of a coordinate that lies in directions kept, 0 to 1.
    [[nodiscard]] double kept_share(Eigen::Index coordinate) const;
    /// Share of a coordinate that the data do not determine: in directions kept or moved, 0 to 1.
    [[nodiscard]] double untold_share(Eigen::Index coordinate) const;
};

/// \param first guess, inside the box or not \pre there is an aim
Optimum find_optimum(const Box& box, const Place& first, const std::vector<Aim>& aims,
                     const std::vector<LeastShare>& shares = {});

}  // namespace graincrack::calibrate
