// Runs by the size of their grains: means over runs of different grain sizes would hide what the size does.
#pragma once

#include <string>
#include <vector>

#include "post/measure/strength_summary.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// Runs whose specimens were meshed for one size: sorted by their mean edges, neighbours differ by less than 5 %.
struct GrainSize {
    std::string label;              ///< "edge 5 mm"
    std::vector<std::size_t> runs;  ///< indices, in their order
};
/// By rising size. \param edges mean edge of each run, m
std::vector<GrainSize> grain_sizes(const std::vector<double>& edges);
std::vector<GrainSize> grain_sizes(const std::vector<RunData>& runs);

/// Runs of one test, confining pressure and grain size.
struct SizedStrengths {
    StrengthGroup group;
    std::string size;               ///< "edge 5 mm"; empty if all runs are of one size
    std::vector<std::size_t> runs;  ///< indices of its members
};
/// In the order of `group_strengths`, and by rising size within a test. \throws InputError as `group_strengths`
std::vector<SizedStrengths> group_strengths_by_size(const std::vector<RunData>& runs,
                                                    StrengthKind kind = StrengthKind::first_peak);

}  // namespace graincrack
