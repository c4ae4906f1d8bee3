// The laboratory tests as programs: platens, a membrane if there is a confining pressure, and their stages.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"
#include "share/rock/test_kind.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Control of the platen speed: fixed, automatic from the measures of the run, or in blocks with rest between them.
enum class RateKind : std::uint8_t { fixed, automatic, blocks };
constexpr std::string_view name_of(RateKind rate) {
    return std::array{"fixed", "auto", "blocks"}[static_cast<std::size_t>(rate)];
}

/// The loading of a standard test.
struct LoadingRequest {
    TestKind test = TestKind::uniaxial;
    RateKind rate = RateKind::fixed;
    double platen_speed = 5e-3;                      ///< speed of each platen, m/s; unused with `automatic`
    std::optional<double> rate_tolerance;            ///< for `automatic`, see `AutomaticRate`; missing: that of the test
    double rest_tolerance = default_rest_tolerance;  ///< for `blocks`: unbalanced ratio that counts as rest
    double rate_share = 1;                           ///< factor on all speeds with `automatic`, see `RateControl`
    std::int64_t block_steps = 5000;
    double confining_pressure = 0;  ///< Pa
    double platen_friction = 0;     ///< rad
    double heat = 0;                ///< temperature rise of the free specimen before the test, K
    bool cool = false;              ///< true: the temperature returns before the test
    double max_strain = 0.015;
    std::optional<double> span;           ///< bend: distance of the lower rollers, m; missing: `usual_span`
    std::optional<double> roller_width;   ///< bend: m; missing: the mean boundary edge
    std::optional<double> mouth_gauge;    ///< bend: length of the gauge over the mouth of the notch, m; missing: none
    std::optional<double> mouth_opening;  ///< bend: elongation of that gauge that ends the test, m; missing: none
    [[nodiscard]] double automatic_tolerance() const { return rate_tolerance.value_or(description_of(test).rate_tolerance); }
    /// Tolerance of heating: `rate_tolerance` with `automatic` if it is given, otherwise the default of all tests.
    [[nodiscard]] double heating_tolerance() const {
        return rate == RateKind::automatic ? rate_tolerance.value_or(default_rate_tolerance) : default_rate_tolerance;
    }
    /// Bound of the measures that control the platens; 0 at a fixed rate.
    [[nodiscard]] double control_tolerance() const {
        if (rate == RateKind::fixed) return 0;
        return rate == RateKind::automatic ? automatic_tolerance() : rest_tolerance;
    }
};

/// Names of the stages of a heated test under pressure. All tests have the last, most have only that.
inline constexpr const char* heat_stage = "heat";
inline constexpr const char* cool_stage = "cool";
inline constexpr const char* isotropic_stage = "isotropic";
inline constexpr const char* axial_stage = "axial";
/// Name of the probe over the mouth of a notch.
inline constexpr const char* mouth_probe = "mouth";

/// Default span of a test in bending, m: four heights of a beam (ASTM E399), 0.6 diameters of a half-disc (Kuruppu et al., ISRM
/// 2014: 0.5 to 0.8).
double usual_span(const Specimen& specimen);

/// Makes uniaxial or triaxial compression, a Brazilian test, direct tension or bending on three rollers. Under a confining
/// pressure, a membrane on the left and right parts and the platens load the specimen isotropically until it is at rest; then the
/// platens move on. Before that, a specimen without platens may be heated and cooled as fast as equilibrium allows; platens are
/// placed when it is at rest. \param peak_drop fall that ends the test, as a fraction of the peak; 0: only the strain limit ends
/// it
///
/// A roller stands at the boundary node nearest to its place, and a roller not wider than an edge meets that node alone, so that
/// the span is known: the program has this span. A wider flat face meets the bent specimen at its inner end.
/// \throws UsageError naming --span or --roller-width if the rollers have no room, --mouth-gauge if there is no notch below or
/// the gauge leaves the lower face
Program standard_test(const LoadingRequest& request, double peak_drop, const Specimen& specimen, const Rock& rock);

/// Checks that a test is made for the shape of a specimen. Tests load the shapes of their row (`all_tests`) or end faces, the
/// boundary parts bottom and top of a rectangle, a beam, or a polygon with these parts. Programs load any shape. \param file of
/// the specimen in messages \throws InputError if the test is not made for the shape
void require_shape(TestKind test, const Specimen& specimen, const std::string& file);

}  // namespace graincrack
