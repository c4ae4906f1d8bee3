#include "share/file/notch.hpp"

#include <algorithm>
#include <limits>

namespace graincrack {

std::optional<std::array<double, 2>> notch_ends(const Specimen& specimen) {
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (specimen.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::pre_existing_crack)) continue;
        for (const std::int32_t node : specimen.contact_nodes[c]) {
            const double x = specimen.node_position[static_cast<std::size_t>(node)][0];
            left = std::min(left, x);
            right = std::max(right, x);
        }
    }
    if (!(left < right)) return std::nullopt;
    return std::array{left, right};
}

}  // namespace graincrack
