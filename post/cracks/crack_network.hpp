// Cracks as a network: half facets that meet at corners of grains and in the middle of facets.
#pragma once

#include <limits>
#include <vector>

#include "share/base/union_find.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// Corner of the grains to which each node belongs [n]: nodes at one place at the start share a corner.
std::vector<std::size_t> corners_of_nodes(const Specimen& specimen);

/// Grows crack by crack. A crack joins the corner at its end (a1 of point 0, a2 of point 1) with the middle of its facet.
class CrackNetwork {
public:
    explicit CrackNetwork(const Specimen& specimen);

    /// Adds a crack; returns the extent along y (reference positions), m, of the tensile cracks among those connected with it
    /// by cracks of either mode; 0 without any.
    double add(const Crack& crack);

private:
    struct Reach {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
        void include(const Reach& other);
    };
    [[nodiscard]] Reach reach_of(const Crack& crack) const;

    const Specimen& specimen_;
    std::vector<std::size_t> corner_;
    UnionFind sets_;            ///< nodes (by their corners), then the middle of each facet
    std::vector<Reach> reach_;  ///< by representative
};

}  // namespace graincrack
