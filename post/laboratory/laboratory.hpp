// Laboratory values and calibration of a material, by the properties that are compared with runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/target.hpp"
#include "share/file/run_header.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// The origin of the computed value of a property.
enum class PropertyOrigin {
    unknown,    ///< the material has no [fitted]
    to_fit,     ///< asked of a calibration that the material has not had
    fitted,     ///< by the calibration of the material
    predicted,  ///< by tests that the calibration did not use
};
std::string name_of(PropertyOrigin origin);

/// Where the laboratory's values are from.
enum class LaboratorySource {
    targets_first,  ///< [targets], else [laboratory]; a strength under pressure by the line σ1 = UCS + b σ3
    line            ///< [laboratory] alone; a strength under pressure by the line σ1 = 2C√b + b σ3
};

/// A property by the definition that targets of a calibration have.
struct LaboratoryProperty {
    calibrate::Target target;                         ///< its value is NaN where the laboratory has none
    bool has_own_deviation = false;                   ///< given by [targets]; else the usual one of such a measurement
    PropertyOrigin origin = PropertyOrigin::unknown;  ///< of the computed value; unknown without a measured one
    std::optional<Scatter> scatter = {};              ///< of single specimens, SI: what [fitted] tells of it
    [[nodiscard]] bool is_measured() const;           ///< by the laboratory
    [[nodiscard]] std::string name() const;           ///< "UCS", "σ1 at σ3 = 8 MPa", "crack initiation CI"
};

/// The material that a run was made with, by the name that its provenance has; empty if that is not found, or is another by now:
/// its name, the elastic constants or density of its rock differ.
std::optional<Material> material_of_run(const RunSettings& run, const std::string& name);

/// In what a run is of another material than this by the values of rock, contacts and phases, those of the run first; of
/// materials with different names these alone; "" if all values are equal, whatever the names.
std::string difference_from(const Material& material, const RunSettings& run);

/// The targets of a material, and E, ν, strengths at the given pressures, crack thresholds and K_IC, in the order of
/// `all_properties`. What [targets] lacks is filled from [laboratory]; a strength under pressure by the line σ1 = UCS + b σ3,
/// with b of the friction angle, or of cohesion and UCS. Without a material nothing has a value. \param pressures of tests, Pa
/// \throws InputError if [targets] is wrong
std::vector<LaboratoryProperty> laboratory_properties(const std::optional<Material>& material,
                                                      const std::vector<double>& pressures,
                                                      LaboratorySource source = LaboratorySource::targets_first);

/// True if the material says that its calibration used strengths under confining pressure.
bool has_fitted_confined_strength(const std::optional<Material>& material);

/// An entry of [fitted] as a calibration writes it: "122 MPa; 124.6 (117.59 to 131.62) on 6 new specimens".
struct FittedEntry {
    std::string name;  ///< of the property, as a laboratory calls it
    std::string unit;
    std::string asked, computed, low, high, specimens;  ///< without an interval both are empty
    std::string text;                                   ///< of another form, in place of these
};
/// In the order of `all_properties`.
std::vector<FittedEntry> fitted_entries(const Material& material);

}  // namespace graincrack
