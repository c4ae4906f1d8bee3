// Properties of a rock that tests measure, a row each: what can be a target of a calibration, and what reports and the table
// `properties` compare with the laboratory.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/thresholds.hpp"
#include "post/run/crack_label.hpp"
#include "post/run/load_curve.hpp"
#include "share/base/quantities.hpp"
#include "share/rock/toughness_test.hpp"

namespace graincrack {

/// The measurements of a run.
struct MeasuredRun {
    RunData data;
    LoadCurve curve;
    Strength strength;
    std::optional<Moduli> moduli;
    std::optional<AllThresholds> thresholds;  ///< of compression tests
    std::optional<double> mode_i_toughness;   ///< Pa √m, of half-discs and beams with a slit that have a peak
    ToughnessTest bend;                       ///< of that
    ModeCounts by_sign_at_peak;               ///< by the event of the run and the sign of the opening then

    /// \param stress what gives a stress of `AllThresholds` \return empty of a test without them
    template <class Stress>
    [[nodiscard]] std::optional<double> threshold(const Stress& stress) const {
        return thresholds ? std::invoke(stress, *thresholds) : std::nullopt;
    }
};

/// A property belongs to unconfined tests, to confined ones or to both. A confining pressure is the end of its name:
/// "first_peak_8MPa".
enum class PressureOf { none, name, either };

struct Property {
    std::string name;        ///< of [targets], without a pressure
    std::string symbol;      ///< in reports of calibrations
    std::string laboratory;  ///< as a laboratory calls it
    std::string key;         ///< in [laboratory] and [fitted]
    Loading loading;         ///< of the tests that measure it
    PressureOf pressure = PressureOf::none;
    Quantity quantity;
    std::string unit;  ///< of reports
    double si = 1;     ///< that unit in SI
    /// Usual deviation of a measured value: relative, or in SI if `absolute`.
    double deviation = 0.05;
    bool absolute = false;
    /// Relative fall below the peak to which the test must continue; 1: to the strain limit.
    double peak_drop = 1;
    bool needs_first_peak = false;
    bool is_usual = false;  ///< in reports of any material; others where the material has a target of them
    std::string column;     ///< of the tables `strength`, `moduli` and `toughness`
    double column_si = 1;   ///< its unit in SI
    std::string other;      ///< another column: the value is the fraction that the first has of both
    /// SI; empty if the run does not have it.
    std::optional<double> (*value)(const MeasuredRun& run) = nullptr;

    /// "tensile_strength_MPa": its row in the table `properties`.
    [[nodiscard]] std::string row() const { return key + (unit.empty() ? "" : "_" + unit); }
};

/// The rows, in the order of reports.
const std::vector<Property>& all_properties();
/// \pre there is a row of this name
const Property& property_named(const std::string& name);

/// The number of its row.
std::size_t order_of(const Property& property);

/// The strength of a run that all tables of a report show, Pa.
std::optional<double> strength_of(const MeasuredRun& run);

}  // namespace graincrack
