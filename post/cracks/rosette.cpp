#include "post/cracks/rosette.hpp"
#include "post/table/column.hpp"

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

Rosette crack_rosette(const std::vector<Crack>& cracks, const Specimen& specimen) {
    Rosette rosette;
    for (const Crack& crack : cracks) {
        (crack.mode == CrackMode::tensile ? rosette.tensile : rosette.shear)[rosette_bin(crack.orientation)] += crack.length;
    }
    for (const auto& nodes : specimen.contact_nodes) {
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
    using namespace unit;
    constexpr std::size_t width = 180 / Rosette::n_bins;  // deg
    Columns<std::size_t> columns{{"orientation_low_deg", none, [](std::size_t bin) { return width * bin; }},
                                 {"orientation_high_deg", none, [](std::size_t bin) { return width * (bin + 1); }}};
    const auto add = [&](const std::string& name, const std::array<double, Rosette::n_bins>& lengths) {
        const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
        columns.push_back({name + "_length", metre, [&lengths](std::size_t bin) { return lengths[bin]; }});
        columns.push_back({name + "_share", none, [&lengths, total](std::size_t bin) { return Cell(lengths[bin] / total); }});
    };
    add("tensile", rosette.tensile);
    add("shear", rosette.shear);
    add("facet", rosette.facet);
    std::vector<std::size_t> bins(Rosette::n_bins);
    std::iota(bins.begin(), bins.end(), 0);
    write_table(out, columns, bins, format);
}

}  // namespace graincrack
