// Central composite designs: the runs from which a full quadratic in k factors can be fitted.
#pragma once

#include <string>
#include <vector>

namespace graincrack::ccd {

/// A factor with its values at the coded levels −1 and +1, in any unit; values derived from it have the same unit.
struct Factor {
    std::string name;
    double low = 0;
    double high = 0;
    [[nodiscard]] double centre() const { return (low + high) / 2; }
    [[nodiscard]] double step() const { return (high - low) / 2; }
    [[nodiscard]] double value(double coded) const { return centre() + coded * step(); }
    [[nodiscard]] double coded(double value) const { return (value - centre()) / step(); }
};

/// Where the star points lie.
enum class Star {
    rotatable,    ///< α = (2^k)^¼: the variance of prediction depends on the distance from the centre alone; √2 for k = 2
    face_centred  ///< α = 1: all values stay within [low, high]
};
double star_distance(Star star, std::size_t n_factors);

/// Coded runs: 2^k corners (the first factor changes fastest), 2k star points (−, + for each factor), centre runs.
std::vector<std::vector<double>> coded_runs(std::size_t n_factors, Star star, std::size_t n_centre);

}  // namespace graincrack::ccd
