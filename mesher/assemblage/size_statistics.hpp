// Sizes and shapes of grains as they came out, beside what was wanted.
#pragma once

#include <array>
#include <optional>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/region/grading.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Measured in the plane where grains are equiaxed.
struct SizeStatistics {
    double spread = 0;     ///< coefficient of variation of the edges over their graded size
    double min_angle = 0;  ///< rad; 0: not measured, of a plain region with one size
    /// Mean edge in the first and the last eighth of the way over which sizes are graded, measured and wanted, m; 0 where there
    /// are no edges, or no grading. Beyond the distance of a grading towards something lies its last eighth.
    std::array<double, 2> graded_edge{};
    std::array<double, 2> wanted_edge{};
};

/// \param region of the specimen
/// \param cells in the plane where grains are equiaxed
/// \param edge of relative size 1, m
SizeStatistics size_statistics_of(const Region& region, const PlaneCells& cells, const SizeField& size, double edge,
                                  const std::optional<Grading>& grading);

}  // namespace graincrack::mesher
