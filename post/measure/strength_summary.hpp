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

/// Runs of one test at one confining pressure.
struct StrengthGroup {
    std::string test;
    std::string shape;              ///< where strengths of a test are told apart by it (`distinct_shape`), else ""
    double confining_pressure = 0;  ///< Pa
    PlaneCondition plane{};
    Sample strength;               ///< Pa; as laboratories report it (`Strength::reported`), also of runs without a peak
    std::size_t without_peak = 0;  ///< number of runs
    /// Mean strength over that of the brazilian runs of the set: UCS/BTS, DTS/BTS.
    std::optional<double> ratio_to_brazilian;
    /// Whether two groups are of one test.
    [[nodiscard]] bool is_as(const StrengthGroup& other) const {
        return test == other.test && shape == other.shape && confining_pressure == other.confining_pressure;
    }
    /// Of discs.
    [[nodiscard]] bool is_brazilian() const { return test == "brazilian" && shape.empty(); }
};

/// Groups in the order brazilian, tension, then compression by rising pressure.
/// \param kind as of `Strength::reported` \throws InputError if the runs are not of one material
std::vector<StrengthGroup> group_strengths(const std::vector<RunData>& runs, StrengthKind kind = StrengthKind::first_peak);

/// Table `strength --summary`, a row for each test, pressure and grain size.
/// \param diagnostics gets, after the table, the caveats of the strengths, with numbers of runs
void write_strength_summary(std::ostream& out, const std::vector<std::string>& runs, TableFormat format,
                            std::ostream& diagnostics, StrengthKind kind = StrengthKind::first_peak);

}  // namespace graincrack
