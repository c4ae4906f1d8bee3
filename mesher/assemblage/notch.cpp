#include "mesher/assemblage/notch.hpp"

#include <cmath>
#include <vector>

namespace graincrack::mesher {

namespace {

/// For each grain a number with the sign of its centroid's y, [g].
std::vector<double> grain_heights(const Specimen& s) {
    std::vector<double> height(s.n_grains(), 0.0);
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        // All elements of a grain have the same size, so that the mean of their nodes is the grain's centroid.
        for (const std::int32_t node : s.element_nodes[e]) {
            height[static_cast<std::size_t>(s.element_grain[e])] += s.node_position[static_cast<std::size_t>(node)][1];
        }
    }
    return height;
}

}  // namespace

void cut_notch(Specimen& specimen, double length) {
    const std::vector<double> height = grain_heights(specimen);
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    const auto above = [&](std::int32_t node) {
        return height[static_cast<std::size_t>(grain[static_cast<std::size_t>(node)])] > 0;
    };
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const auto& [a1, a2, b1, b2] = specimen.contact_nodes[c];
        const double middle = 0.5 * (specimen.node_position[static_cast<std::size_t>(a1)][0] +
                                     specimen.node_position[static_cast<std::size_t>(a2)][0]);
        if (above(a1) != above(b1) && std::abs(middle) <= 0.5 * length) {
            specimen.contact_kind[c] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
        }
    }
}

}  // namespace graincrack::mesher
