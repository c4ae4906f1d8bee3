#include "post/measure/grain_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "post/run/test_label.hpp"

namespace graincrack {

namespace {

bool belongs(const RunData& run, const StrengthGroup& group) {
    return run.header.test == group.test && run.header.confining_pressure == group.confining_pressure &&
           distinct_shape(run) == group.shape;
}

std::vector<RunData> chosen(const std::vector<RunData>& runs, const std::vector<std::size_t>& indices) {
    std::vector<RunData> some;
    for (const std::size_t i : indices) some.push_back(runs[i]);
    return some;
}

}  // namespace

std::vector<GrainSize> grain_sizes(const std::vector<double>& edges) {
    constexpr double near = 1.05;
    std::vector<std::size_t> order(edges.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return edges[a] < edges[b]; });
    std::vector<GrainSize> sizes;
    for (const std::size_t i : order) {
        if (sizes.empty() || !(edges[i] < near * edges[sizes.back().runs.back()])) sizes.emplace_back();
        sizes.back().runs.push_back(i);
    }
    for (GrainSize& size : sizes) {
        double sum = 0;
        for (const std::size_t i : size.runs) sum += edges[i];
        size.label = fmt::format("edge {:.2g} mm", 1e3 * sum / static_cast<double>(size.runs.size()));
        std::sort(size.runs.begin(), size.runs.end());
    }
    return sizes;
}

std::vector<GrainSize> grain_sizes(const std::vector<RunData>& runs) {
    std::vector<double> edges;
    for (const RunData& run : runs) edges.push_back(run.specimen.mean_edge);
    return grain_sizes(edges);
}

std::vector<SizedStrengths> group_strengths_by_size(const std::vector<RunData>& runs, StrengthKind kind) {
    const std::vector<GrainSize> sizes = grain_sizes(runs);
    std::vector<SizedStrengths> rows;
    for (const StrengthGroup& test : group_strengths(runs, kind)) {
        for (const GrainSize& size : sizes) {
            for (const StrengthGroup& group : group_strengths(chosen(runs, size.runs), kind)) {
                if (!group.is_as(test)) continue;
                SizedStrengths row{group, sizes.size() > 1 ? size.label : "", {}};
                for (const std::size_t i : size.runs) {
                    if (belongs(runs[i], group)) row.runs.push_back(i);
                }
                rows.push_back(std::move(row));
            }
        }
    }
    return rows;
}

}  // namespace graincrack
