// Which crystal is of which phase (mineral).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack::mesher {

struct PhaseFraction {
    std::string name;     ///< of a-z, 0-9 and _
    double fraction = 0;  ///< of the area, above 0
    friend bool operator==(const PhaseFraction&, const PhaseFraction&) = default;
};

/// Requested phases. Crystals are in clusters of neighbours, and every cluster is of one phase, drawn at random.
struct PhaseRequest {
    std::vector<PhaseFraction> fractions;  ///< empty: one phase, "rock"
    std::optional<std::uint64_t> seed;     ///< none: that of the specimen
    double cluster = 1;                    ///< mean number of crystals in a cluster; clusters of one phase may meet
    bool yield = false;                    ///< whether phases that an imported mesh has are kept instead
};

/// Reads "quartz=0.32,feldspar=0.62,mica=6%". \throws UsageError naming --phases
std::vector<PhaseFraction> parse_phases(std::string_view text);

/// \throws UsageError naming the option if names or fractions do not fit, a name stands twice, there are more than `max_phases`,
///         fractions do not add up to 1 within 1e-6, or there are a seed or clusters but no phases
void check(const PhaseRequest& request);

/// Gives every grain a phase. The area of each phase differs from that requested by one crystal at most, the largest.
///
/// Clusters: n/cluster crystals drawn at random grow to their neighbours ring by ring until they meet. Clusters are put in random
/// order, one after the other on a line as long as the area, and the line is cut where one phase ends and the next begins, to
/// whole crystals.
/// \param crystal_of_grain grains of a crystal have the same phase
void assign_phases(Specimen& specimen, std::span<const int> crystal_of_grain, const PhaseRequest& request);

}  // namespace graincrack::mesher
