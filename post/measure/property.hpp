// Properties of a rock that tests measure, one row per property. They can be targets of a calibration, and reports and the table
// `properties` compare them with the laboratory.
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
    std::optional<double> mode_i_toughness;   ///< of half-discs and beams with a slit that have a peak, Pa √m
    ToughnessTest bend;                       ///< test of this toughness
    ModeCounts by_sign_at_peak;               ///< by the event of the run and the sign of the opening then

    /// One stress of the thresholds, Pa. \param stress member or function of `AllThresholds` \return empty without thresholds
    template <class Stress>
    [[nodiscard]] std::optional<double> threshold(const Stress& stress) const {
        return thresholds ? std::invoke(stress, *thresholds) : std::nullopt;
    }
};

/// The tests that have a property: unconfined, confined or both. The confining pressure ends its name: "first_peak_8MPa".
enum class PressureOf { none, name, either };

struct Property {
    std::string name;        ///< name in [targets], without a pressure
    std::string symbol;      ///< symbol in reports of calibrations
    std::string laboratory;  ///< name that laboratories use
    std::string key;         ///< key in [laboratory] and [fitted]
    Loading loading;         ///< loading of the tests that measure it
    PressureOf pressure = PressureOf::none;
    Quantity quantity;
    std::string unit;  ///< unit in reports
    double si = 1;     ///< this unit in SI
    /// Usual deviation of a measured value: relative, or in SI if `absolute`.
    double deviation = 0.05;
    bool absolute = false;
    /// Relative fall below the peak to which the test must continue; at 1 it continues to the strain limit.
    double peak_drop = 1;
    bool needs_first_peak = false;
    bool is_usual = false;  ///< true if reports of all materials have it; others need a target of the material
    std::string column;     ///< column of the table `strength`, `moduli` or `toughness`
    double column_si = 1;   ///< unit of the column in SI
    std::string other;      ///< if not "", the value is the fraction of `column` in the sum with this column
    /// The value in a run, SI; empty if the run does not have it.
    std::optional<double> (*value)(const MeasuredRun& run) = nullptr;

    /// Its row in the table `properties`, "tensile_strength_MPa".
    [[nodiscard]] std::string row() const { return key + (unit.empty() ? "" : "_" + unit); }
};

/// All properties, in the order of reports.
const std::vector<Property>& all_properties();
/// The property of this name. \pre there is one
const Property& property_named(const std::string& name);

/// The index of a property in `all_properties`.
std::size_t order_of(const Property& property);

/// The strength of a run that all tables of a report show, Pa.
std::optional<double> strength_of(const MeasuredRun& run);

}  // namespace graincrack
