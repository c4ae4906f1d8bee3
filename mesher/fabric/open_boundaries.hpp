// Opens boundaries between crystals from the start, as in heated or weathered granite.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Requested open boundaries.
struct OpenBoundaryRequest {
    std::optional<double> fraction;     ///< open fraction of the length of all boundaries, 0 to below 1; missing: 0
    std::optional<std::uint64_t> seed;  ///< missing: that of the specimen
    double row = 1;                     ///< mean number of boundaries in a row
};

/// Checks a request. \throws UsageError naming the option if the fraction is out of bounds, or a seed or row has no fraction
void check(const OpenBoundaryRequest& request);

/// Sets contacts to the kind `open_boundary`. Whole boundaries, which are all contacts between two crystals except those on
/// flaws, open in an order given by seed and crystals, until they have the fraction of the length to half of one boundary. A
/// larger fraction opens all boundaries of a smaller one. \param crystal_of_grain the crystal of every grain
///
/// With a row of L > 1, each boundary starts a row of n boundaries with the probability (1 − q) qⁿ⁻¹, q = 1 − 1/L. The row
/// continues at either end along the boundary that deviates least from the line between its ends. Rows meet neither themselves
/// nor others; when they fill the specimen, the boundaries between them open last, one by one.
void open_boundaries(Specimen& specimen, std::span<const int> crystal_of_grain, const OpenBoundaryRequest& request);

}  // namespace graincrack::mesher
