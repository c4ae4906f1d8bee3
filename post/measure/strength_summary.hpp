// Strengths of a set of runs by test, confining pressure and grain size: means over seeds and their ratios.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "post/measure/strength.hpp"
#include "post/run/load_curve.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Runs whose specimens were meshed for one size: sorted by their mean edges, neighbours differ by less than 5 %.
struct GrainSize {
    std::string label;              ///< "edge 5 mm"
    std::vector<std::size_t> runs;  ///< indices, in their order
};
/// By rising size: means over runs of different grain sizes would hide the effect of the size. \param edges mean edge of each
/// run, m
std::vector<GrainSize> grain_sizes(const std::vector<double>& edges);
std::vector<GrainSize> grain_sizes(const std::vector<RunData>& runs);

/// Runs of one test at one confining pressure.
struct StrengthGroup {
    std::string test;
    std::string shape;              ///< where strengths of a test are told apart by it (`distinct_shape`), else ""
    double confining_pressure = 0;  ///< Pa
    PlaneCondition plane{};
    std::string size;               ///< "edge 5 mm"; empty if all runs are of one size, or sizes are pooled
    std::vector<std::size_t> runs;  ///< indices of its members
    Sample strength;                ///< Pa; of the runs that have one (`Strength::reported`)
    std::size_t without_peak = 0;   ///< number of runs that did not fail
    /// Mean strength over that of the discs of the same size: UCS/BTS, DTS/BTS.
    std::optional<double> ratio_to_brazilian;
    [[nodiscard]] bool is_brazilian() const { return test_named(test).loading == Loading::splitting && shape.empty(); }
    /// "Brazilian, ring, edge 5 mm"
    [[nodiscard]] std::string name() const;
};

/// Groups in the order Brazilian, tension, then compression by rising pressure; sizes are pooled.
/// \param kind as of `Strength::reported` \throws InputError if the runs are not of one material
std::vector<StrengthGroup> group_strengths(const std::vector<RunData>& runs, StrengthKind kind = StrengthKind::first_peak);
/// The same for each grain size, by rising size within a test.
std::vector<StrengthGroup> group_strengths_by_size(const std::vector<RunData>& runs,
                                                   StrengthKind kind = StrengthKind::first_peak);

/// Table `strength --summary`, a row for each test, pressure and grain size.
/// \param diagnostics gets, after the table, the caveats of the strengths, with numbers of runs
void write_strength_summary(std::ostream& out, const std::vector<std::string>& runs, TableFormat format,
                            std::ostream& diagnostics, StrengthKind kind = StrengthKind::first_peak);

}  // namespace graincrack
