#include "share/file/notch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

std::optional<EdgeNotch> edge_notch(const Specimen& specimen) {
    using Position = std::array<double, 2>;
    constexpr double conformity = 1e-9;  // as that of contacts
    const double slack = conformity * (specimen.width + specimen.height);
    const auto meet = [slack](const Position& p, const Position& q) { return std::hypot(p[0] - q[0], p[1] - q[1]) <= slack; };
    std::vector<std::array<Position, 2>> rest;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (specimen.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::pre_existing_crack)) continue;
        const auto& nodes = specimen.contact_nodes[c];
        rest.push_back({specimen.node_position[static_cast<std::size_t>(nodes[0])],
                        specimen.node_position[static_cast<std::size_t>(nodes[1])]});
    }
    std::vector<Position> reached;
    for (const auto& ends : rest) {
        for (const Position& end : ends) {
            if (reached.empty() && end[1] <= -specimen.height / 2 + slack) reached.push_back(end);
        }
    }
    if (reached.empty()) return std::nullopt;
    EdgeNotch notch{reached.front(), reached.front()};
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (reached[i][1] > notch.tip[1]) notch.tip = reached[i];
        std::erase_if(rest, [&](const std::array<Position, 2>& ends) {
            const Position at = reached[i];
            if (!meet(ends[0], at) && !meet(ends[1], at)) return false;
            reached.push_back(meet(ends[0], at) ? ends[1] : ends[0]);
            return true;
        });
    }
    return notch;
}

}  // namespace graincrack
