#include "share/file/open_boundaries.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace graincrack {

OpenBoundaries count_open_boundaries(const Specimen& specimen) {
    const std::vector<std::int32_t> grain = grain_of_nodes(specimen);
    const auto crystal = [&](std::int32_t node) {
        const std::int32_t own = grain[static_cast<std::size_t>(node)];
        return specimen.grain_crystal.empty() ? own : specimen.grain_crystal[static_cast<std::size_t>(own)];
    };
    std::array<std::set<std::pair<std::int32_t, std::int32_t>>, 2> boundaries;  // closed, open
    std::array<double, 2> length{};
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const std::uint8_t kind = specimen.contact_kind[c];
        const bool is_open = kind == static_cast<std::uint8_t>(ContactKind::open_boundary);
        const bool has_class = !specimen.contact_flaw.empty() && specimen.contact_flaw[c] > 0;
        if (has_class || !(is_open || kind == static_cast<std::uint8_t>(ContactKind::grain_boundary))) continue;
        boundaries[is_open].insert(std::minmax({crystal(specimen.contact_nodes[c][0]), crystal(specimen.contact_nodes[c][2])}));
        length[is_open] += contact_length(specimen, c);
    }
    const auto [closed, open] = length;
    return {boundaries[1].size(), boundaries[0].size() + boundaries[1].size(), open > 0 ? open / (closed + open) : 0};
}

std::string open_boundaries_text(const Specimen& specimen) {
    const OpenBoundaries count = count_open_boundaries(specimen);
    return count.n_open == 0 ? "" : fmt::format("{} of {}, {:.4f} of their length", count.n_open, count.n, count.share);
}

}  // namespace graincrack
