// The laboratory tests as programs: platens, a membrane where there is a pressure, and the stages of both.
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

/// How the platens' speed is found: given, by the run's own measures, or in blocks with rest between them.
enum class RateKind : std::uint8_t { fixed, automatic, blocks };
constexpr std::string_view name_of(RateKind rate) {
    return std::array{"fixed", "auto", "blocks"}[static_cast<std::size_t>(rate)];
}

/// The loading of a standard test.
struct LoadingRequest {
    TestKind test = TestKind::uniaxial;
    RateKind rate = RateKind::fixed;
    double platen_speed = 5e-3;                      ///< of each platen, m/s; not of `automatic`
    std::optional<double> rate_tolerance;            ///< of `automatic`, see `AutomaticRate`; missing: that of the test
    double rest_tolerance = default_rest_tolerance;  ///< of `blocks`: unbalanced ratio that counts as rest between them
    double rate_share = 1;                           ///< of all speeds of `automatic`, see `RateControl`
    std::int64_t block_steps = 5000;
    double confining_pressure = 0;  ///< Pa
    double platen_friction = 0;     ///< rad
    double heat = 0;                ///< rise of the temperature of the free specimen before the test, K
    bool cool = false;              ///< it falls back before the test
    double max_strain = 0.015;
    std::optional<double> span;           ///< bend: distance of the lower rollers, m; missing: `usual_span`
    std::optional<double> roller_width;   ///< bend: m; missing: the mean boundary edge
    std::optional<double> mouth_gauge;    ///< bend: length of the gauge over the mouth of the notch, m; missing: none
    std::optional<double> mouth_opening;  ///< bend: elongation of that gauge that ends the test, m; missing: none
    [[nodiscard]] double automatic_tolerance() const { return rate_tolerance.value_or(description_of(test).rate_tolerance); }
    /// Of heating: that of `automatic` if it is given; all tests heat alike.
    [[nodiscard]] double heating_tolerance() const {
        return rate == RateKind::automatic ? rate_tolerance.value_or(default_rate_tolerance) : default_rate_tolerance;
    }
    /// Bound of the measures by which the platens are moved; 0 at a fixed rate.
    [[nodiscard]] double control_tolerance() const {
        if (rate == RateKind::fixed) return 0;
        return rate == RateKind::automatic ? automatic_tolerance() : rest_tolerance;
    }
};

/// Names of the stages of a heated test under pressure; all tests have the last, most have it alone.
inline constexpr const char* heat_stage = "heat";
inline constexpr const char* cool_stage = "cool";
inline constexpr const char* isotropic_stage = "isotropic";
inline constexpr const char* axial_stage = "axial";
/// Name of the probe over the mouth of a notch.
inline constexpr const char* mouth_probe = "mouth";

/// Span of a test in bending where none is asked for, m: four heights of a beam (ASTM E399), 0.6 diameters of a half-disc (ISRM
/// 2014: 0.5 to 0.8, Kuruppu et al.).
double usual_span(const Specimen& specimen);

/// Uniaxial or triaxial compression, Brazilian test, direct tension or bending on three rollers. Under a confining pressure a
/// membrane on the parts left and right and the platens first load the specimen isotropically and wait for rest, then the platens
/// move on. Before all that a specimen may be heated and cooled as fast as equilibrium allows, without platens; they are placed
/// when it is at rest. \param peak_drop fall below the peak that ends the test, share of it; 0: the test ends at the strain limit
/// alone
///
/// A roller stands at the node of the boundary next to its place: it is met whatever its width, and one no wider than an edge
/// meets that node alone, so that the span is known. A wider flat face meets the bent specimen at its inner end. The span of the
/// program is the one that comes out. \throws UsageError naming --span or --roller-width if the rollers have no room,
/// --mouth-gauge if there is no notch below or the gauge leaves the lower face
Program standard_test(const LoadingRequest& request, double peak_drop, const Specimen& specimen, const Rock& rock);

/// Tests load the shapes of their row (`all_tests`), or end faces, the boundary parts bottom and top: those of a rectangle, a
/// beam, or a polygon that has them. A rectangle passes as it is; a program loads any shape. \param file of the specimen, for the
/// message \throws InputError if the test is not made for the shape
void require_shape(TestKind test, const Specimen& specimen, const std::string& file);

}  // namespace graincrack
