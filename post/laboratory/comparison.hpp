// Compares properties of runs with laboratory and rock type, in rows for the page `report` and the table `properties`.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/kind/kind_surface.hpp"
#include "post/laboratory/laboratory.hpp"
#include "post/measure/property.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// A value of a run, SI; empty if the test does not measure it.
using ValueOfTest = std::function<std::optional<double>(const MeasuredRun&)>;

/// Comparable runs of one test at one confining pressure, which differ in their seeds only.
struct SeedGroup {
    std::string test;  ///< "uniaxial", "σ3 = 8 MPa"
    /// Heating of its specimens, and settings that distinguish it from other groups of the test: "diameter 60 mm"; "" if none.
    std::string distinction;
    std::vector<const MeasuredRun*> runs;
    std::vector<std::size_t> indices;  ///< [runs] indices in the list that was grouped

    [[nodiscard]] const MeasuredRun& first() const { return *runs.front(); }
    /// A text with the distinction: "uniaxial, grain diameter 5 mm".
    [[nodiscard]] std::string with_specimen(const std::string& text) const {
        return text + (distinction.empty() ? "" : ", ") + distinction;
    }
    [[nodiscard]] std::string name() const { return with_specimen(test); }
    /// The sample of the runs that have the value; empty if none has.
    [[nodiscard]] std::optional<Sample> sample_of(const ValueOfTest& value) const;
};

/// Groups runs in the order of `group_strengths`: Brazilian, tension, then compression by rising pressure.
std::vector<SeedGroup> seed_groups(const std::vector<const MeasuredRun*>& runs);
template <class Run>
std::vector<SeedGroup> seed_groups(const std::vector<Run>& runs) {
    std::vector<const MeasuredRun*> all;
    for (const Run& run : runs) all.push_back(&run);
    return seed_groups(all);
}

/// The envelope of the compression tests of one fabric.
struct FabricEnvelope {
    std::string fabric;  ///< heating and distinction from others: "at +300 K, edge 5 mm"
    bool is_heated = false;
    EnvelopeTests tests;
    Envelope envelope;
};

/// The predictions for new specimens of a material by its rock type.
struct MaterialPrediction {
    std::optional<KindSurface> surface;  ///< empty without predictions
    std::string why;                     ///< reason: "its cohesion over tc is 20, those of the design 1.5 to 16"
    KindCoordinates at;                  ///< coordinates of the material
    std::map<std::string, KindPrediction> of_calibration = {};  ///< from [predicted], by rock type and runs; keys are targets

    [[nodiscard]] std::optional<KindPrediction> of(const calibrate::Target& target) const {
        const auto own = of_calibration.find(target.name());
        if (own != of_calibration.end()) return own->second;
        return surface ? surface->predict(at, target.property, target.confining_pressure) : std::nullopt;
    }
    /// The specimen of the prediction, with a note if no runs of a calibration contribute: "300 crystals, by the kind alone".
    [[nodiscard]] std::string specimen_of(const calibrate::Target& target) const;
};
MaterialPrediction prediction_of(const Material& material);

/// A property of a group of runs, or of the line through several groups, with the values it is compared with. SI.
struct ComparisonRow {
    LaboratoryProperty laboratory;  ///< the property; without a value if a comparison would be wrong, as for heated specimens
    std::string name = {};          ///< the laboratory's name with the distinction of specimens; "" for rows of the table only
    std::string column = {};        ///< its name in the table `properties`
    Estimate ours = {};             ///< mean over specimens, or of a fit; NaN if there is none or it is not determined
    std::optional<double> deviation = std::nullopt;  ///< over specimens; for C and φ over seeds with tests at all pressures
    std::size_t specimens = 0;                       ///< number of specimens with a value
    /// Number of specimens that did not fail. They are in `specimens` only if the largest stress counts. Empty if it is no
    /// strength.
    std::optional<std::size_t> without_peak = std::nullopt;
    bool is_heated = false;                             ///< if true, laboratory and rock type are not compared
    bool is_mean = false;                               ///< true for the mean of specimens, false for a fit through all of them
    std::optional<KindPrediction> kind = std::nullopt;  ///< prediction for a new specimen by the surface of the rock type
    std::string kind_specimen = {};                     ///< the specimen of the prediction
    std::string caveat = {};                            ///< reason for an unknown agreement, as `Target::caveat`
    calibrate::Agreement agreement = calibrate::Agreement::unknown;

    [[nodiscard]] bool is_tested() const { return specimens > 0 || without_peak; }
    /// Our value with its interval; for up to three specimens the scatter in the material's file contributes.
    [[nodiscard]] Estimate computed() const;
    [[nodiscard]] bool is_pooled() const { return is_mean && specimens > 0 && specimens <= 3 && laboratory.scatter; }
    /// The difference 100 (ours/laboratory − 1), percent.
    [[nodiscard]] std::optional<double> off_laboratory_percent() const;
    /// Half of the 95 % interval over our value, percent.
    [[nodiscard]] std::optional<double> half_interval_percent() const;
    /// Number of specimens, at least three, for which half of the 95 % interval of the mean is 3 % at their present deviation.
    [[nodiscard]] std::optional<double> specimens_for_3_percent() const;
};

/// True if runs with these settings and a `distinct_shape` (bending: that of the specimen with a slit) measure a target.
bool is_measured_by(const calibrate::Target& target, const RunSettings& settings, const std::string& shape);
/// The property of a target in a run, SI; empty if the run is of another test or does not have it. \param kind of strengths
std::optional<double> value_of(const MeasuredRun& test, const calibrate::Target& target,
                               StrengthKind kind = StrengthKind::first_peak);

/// Returns one row per property and group that measures it; C, φ and b of each envelope, which are no targets, after the
/// strengths; and the properties that no group measures last. Heated specimens are compared neither with the laboratory nor with
/// the rock type. \param properties from `laboratory_properties` \param kind of strengths
std::vector<ComparisonRow> compare(const std::vector<SeedGroup>& groups, const std::vector<FabricEnvelope>& envelopes,
                                   const std::vector<LaboratoryProperty>& properties, const std::optional<Material>& material,
                                   const MaterialPrediction& prediction, StrengthKind kind = StrengthKind::first_peak);

/// \throws InputError if the values of a material differ from those of the runs, as `difference_from` finds. Values that the
/// material lacks are not compared.
void require_material(const std::vector<RunData>& runs, IncompleteMaterial material);

/// Returns the table `properties` of a rock: runs, laboratory (as Table 8 of Kazerani & Zhao 2014) and predictions by rock type.
///
/// The rows are E and ν (chord to half the peak) of uniaxial tests, tensile strengths, σ1 at each pressure, and C, φ and b of the
/// line through them. Without runs they are the predictions of the rock type for new specimens, with σ1 at the pressures of
/// [targets] and of the laboratory, else at 8 and 20 MPa. Values may be missing. \param why set to the reason why the rock type
/// predicts nothing, else "" \throws InputError as `require_comparable` and `collect_envelope_tests`, and for a wrong table or
/// [targets]
std::vector<ComparisonRow> property_rows(const std::vector<RunData>& runs, IncompleteMaterial material,
                                         const EnvelopeOptions& options, std::string& why);

/// Writes the columns property, laboratory, ours, low, high, deviation, specimens, without_peak, off_laboratory_percent,
/// half_interval_percent, specimens_for_3_percent, kind_median, kind_50_low, kind_50_high, kind_95_low, kind_95_high,
/// kind_specimen; each row in the unit of its name. The aligned format is a datasheet with the names that laboratories use.
void write_properties(std::ostream& out, const std::vector<ComparisonRow>& rows, TableFormat format);

}  // namespace graincrack
