// Strengths of a set of runs: means over those that are comparable, and their ratios.
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

/// Comparable runs, of one test at one confining pressure.
struct StrengthGroup {
    std::string test;
    std::string shape;              ///< where strengths of a test are told apart by it (`distinct_shape`), else ""
    double confining_pressure = 0;  ///< Pa
    PlaneCondition plane{};
    std::string distinction;        ///< from other groups of the test: "Gabbro, diameter 60 mm"; "" if there are none
    std::vector<std::size_t> runs;  ///< indices of its members
    Sample strength;                ///< Pa; of the runs that have one (`Strength::reported`)
    std::size_t without_peak = 0;   ///< number of runs that did not fail
    /// Mean strength over that of the discs of the same material and fabric, if these are one group: UCS/BTS, DTS/BTS.
    std::optional<double> ratio_to_brazilian;
    [[nodiscard]] bool is_brazilian() const { return test_named(test).loading == Loading::splitting && shape.empty(); }
    /// "Brazilian, ring, grain diameter 5 mm"
    [[nodiscard]] std::string name() const;
};

/// Groups in the order Brazilian, tension, then compression by rising pressure; within a test by rising size of the grains.
/// \param kind as of `Strength::reported`
std::vector<StrengthGroup> group_strengths(const std::vector<RunData>& runs, StrengthKind kind = StrengthKind::first_peak);

/// Table `strength --summary`, a row for each group. A test of a specimen that is given twice counts once.
/// \param diagnostics gets, after the table, the caveats of the strengths, with numbers of runs
void write_strength_summary(std::ostream& out, const std::vector<std::string>& runs, TableFormat format,
                            std::ostream& diagnostics, StrengthKind kind = StrengthKind::first_peak);

}  // namespace graincrack
