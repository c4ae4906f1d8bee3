// The search for a single number: levels of it on the same specimens, the trend through them, and the next level to test.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "post/fit/statistics.hpp"

namespace graincrack::calibrate {

/// Results at levels of a number x, each on the same specimens.
class Levels {
public:
    /// \param results of the specimens, in the same order at each level
    void add(double x, std::vector<double> results);
    [[nodiscard]] bool has(double x) const { return results_.contains(x); }
    [[nodiscard]] std::size_t size() const { return results_.size(); }
    [[nodiscard]] double mean_at(double x) const;
    [[nodiscard]] std::vector<double> levels() const;
    /// Slope of ln result against x, each specimen with a level of its own (it scatters by more than x changes it). Empty for one
    /// level.
    [[nodiscard]] std::optional<Estimate> slope() const;
    /// The x at which the mean is `wanted`: between the two nearest levels on either side of it, else from the nearest level with
    /// `slope`. \pre not empty; slope is not 0
    [[nodiscard]] double crossing(double wanted, double slope) const;
    /// The level whose mean is nearest to `wanted`, as ln of their ratio.
    [[nodiscard]] double nearest(double wanted) const;

private:
    std::map<double, std::vector<double>> results_;
};

}  // namespace graincrack::calibrate
