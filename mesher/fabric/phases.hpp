// Assigns phases (minerals) to crystals.
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
    std::string name;     ///< letters a-z, digits and _
    double fraction = 0;  ///< fraction of the area, above 0
    friend bool operator==(const PhaseFraction&, const PhaseFraction&) = default;
};

/// Requested phases. Crystals form clusters of neighbours, and every cluster has one random phase.
struct PhaseRequest {
    std::vector<PhaseFraction> fractions;  ///< empty: one phase, "rock"
    std::optional<std::uint64_t> seed;     ///< missing: that of the specimen
    double cluster = 1;                    ///< mean number of crystals in a cluster; clusters of one phase may meet
    bool yield = false;                    ///< true: phases of an imported mesh are kept instead
};

/// Reads "quartz=0.32,feldspar=0.62,mica=6%". \throws UsageError naming --phases
std::vector<PhaseFraction> parse_phases(std::string_view text);

/// Checks a request. \throws UsageError naming the option if names or fractions do not fit, a name occurs twice, there are more
/// than `max_phases`, fractions do not add up to 1 within 1e-6, or a seed or clusters have no phases
void check(const PhaseRequest& request);

/// Assigns a phase to every grain. The area of a phase differs from the requested one by at most one crystal, the largest.
///
/// For clusters, n/cluster random crystals grow to their neighbours ring by ring until they meet. Clusters lie in random order on
/// a line as long as the total area, which is divided at whole crystals where one phase ends and the next begins.
/// \param crystal_of_grain grains of a crystal have the same phase
void assign_phases(Specimen& specimen, std::span<const int> crystal_of_grain, const PhaseRequest& request);

}  // namespace graincrack::mesher
