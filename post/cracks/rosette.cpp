#include "post/cracks/rosette.hpp"

#include <cmath>
#include <numbers>
#include <numeric>

namespace graincrack {

std::size_t rosette_bin(double orientation) {
    const double turns = orientation / std::numbers::pi;
    // Angles on a bin's edge come from lattices; a shift far below a degree keeps round-off from splitting them.
    const double share = turns - std::floor(turns) + 1e-9;
    return static_cast<std::size_t>(share * Rosette::n_bins) % Rosette::n_bins;
}

Rosette crack_rosette(const std::vector<Crack>& cracks, const Specimen& specimen, const std::vector<bool>& contacts) {
    Rosette rosette;
    const auto counts = [&](std::size_t contact) { return contacts.empty() || contacts[contact]; };
    for (const Crack& crack : cracks) {
        if (!counts(static_cast<std::size_t>(crack.contact))) continue;
        (crack.mode == CrackMode::tensile ? rosette.tensile : rosette.shear)[rosette_bin(crack.orientation)] += crack.length;
    }
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (!counts(c)) continue;
        const auto& nodes = specimen.contact_nodes[c];
        const auto& from = specimen.node_position[static_cast<std::size_t>(nodes[0])];
        const auto& to = specimen.node_position[static_cast<std::size_t>(nodes[1])];
        const double dx = to[0] - from[0];
        const double dy = to[1] - from[1];
        rosette.facet[rosette_bin(std::atan2(dy, dx))] += std::hypot(dx, dy);
    }
    return rosette;
}

std::optional<double> share_along_load(const std::array<double, Rosette::n_bins>& length) {
    constexpr std::size_t middle = Rosette::n_bins / 2;
    constexpr std::size_t reach = Rosette::n_bins / 6;
    const double total = std::accumulate(length.begin(), length.end(), 0.0);
    if (total <= 0) return std::nullopt;
    return std::accumulate(length.begin() + middle - reach, length.begin() + middle + reach, 0.0) / total;
}

void write_rosette(std::ostream& out, const Rosette& rosette, TableFormat format) {
    TableWriter table(out,
                      {"orientation_low_deg", "orientation_high_deg", "tensile_length_m", "tensile_share", "shear_length_m",
                       "shear_share", "facet_length_m", "facet_share"},
                      format);
    constexpr std::int64_t width = 180 / static_cast<std::int64_t>(Rosette::n_bins);
    for (std::size_t i = 0; i < Rosette::n_bins; ++i) {
        const auto low = width * static_cast<std::int64_t>(i);
        std::vector<Cell> row{low, low + width};
        for (const auto* lengths : {&rosette.tensile, &rosette.shear, &rosette.facet}) {
            const double total = std::accumulate(lengths->begin(), lengths->end(), 0.0);
            row.emplace_back((*lengths)[i]);
            row.push_back(total > 0 ? Cell((*lengths)[i] / total) : Cell());
        }
        table.row(row);
    }
}

}  // namespace graincrack
