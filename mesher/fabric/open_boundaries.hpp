// Boundaries between crystals that are open from the start, as in granite that was heated or has weathered.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Requested open boundaries.
struct OpenBoundaryRequest {
    std::optional<double> fraction;     ///< of the length of all boundaries, 0 to below 1; none: 0
    std::optional<std::uint64_t> seed;  ///< none: that of the specimen
    double row = 1;                     ///< mean number of boundaries in a row
};

/// \throws UsageError naming the option if the fraction is out of bounds, or there is a seed or a row but no fraction
void check(const OpenBoundaryRequest& request);

/// Gives contacts the kind `open_boundary`. Whole boundaries, which are all contacts between two crystals but those on flaws, are
/// drawn in an order of the seed and the crystals until they have the fraction of the length, to half of one boundary. A larger
/// fraction opens more, and all that a smaller one opens. \param crystal_of_grain the crystal of every grain
///
/// With a row of L > 1 each begins a row of n boundaries with the probability (1 − q) qⁿ⁻¹, q = 1 − 1/L, which goes on at either
/// end along the boundary that deviates least from the line between its ends. Rows meet neither themselves nor each other; what
/// lies between them once they fill the specimen opens last, one by one.
void open_boundaries(Specimen& specimen, std::span<const int> crystal_of_grain, const OpenBoundaryRequest& request);

}  // namespace graincrack::mesher
