// Properties of runs beside the laboratory's and what the kind of rock predicts: the rows that the page `report` and the table
// `properties` print.
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

/// Comparable runs: of one test at one confining pressure, different in their seeds alone.
struct SeedGroup {
    std::string test;  ///< "uniaxial", "σ3 = 8 MPa"
    /// How its specimens were heated, and what tells it from other groups of the test: "diameter 60 mm"; "" if nothing does.
    std::string distinction;
    std::vector<const MeasuredRun*> runs;
    std::vector<std::size_t> indices;  ///< of these in the list that was grouped

    [[nodiscard]] const MeasuredRun& first() const { return *runs.front(); }
    /// A text with what tells the group from others of its test: "uniaxial, grain diameter 5 mm".
    [[nodiscard]] std::string with_specimen(const std::string& text) const {
        return text + (distinction.empty() ? "" : ", ") + distinction;
    }
    [[nodiscard]] std::string name() const { return with_specimen(test); }
    /// Over the runs that have the value; empty if none has.
    [[nodiscard]] std::optional<Sample> sample_of(const ValueOfTest& value) const;
};

/// In the order of `group_strengths`: Brazilian, tension, then compression by rising pressure.
std::vector<SeedGroup> seed_groups(const std::vector<const MeasuredRun*>& runs);
template <class Run>
std::vector<SeedGroup> seed_groups(const std::vector<Run>& runs) {
    std::vector<const MeasuredRun*> all;
    for (const Run& run : runs) all.push_back(&run);
    return seed_groups(all);
}

/// The envelope of the compression tests of one fabric.
struct FabricEnvelope {
    std::string fabric;  ///< "at +300 K, edge 5 mm": how it was heated, and what tells it from others
    bool is_heated = false;
    EnvelopeTests tests;
    Envelope envelope;
};

/// What the kind of rock predicts of new specimens of a material.
struct MaterialPrediction {
    std::optional<KindSurface> surface;  ///< empty if it predicts nothing
    std::string why;                     ///< it predicts nothing: "its cohesion over tc is 20, those of the design 1.5 to 16"
    KindCoordinates at;                  ///< of the material
    std::map<std::string, KindPrediction> of_calibration = {};  ///< by kind and runs, as [predicted] has them; by target

    [[nodiscard]] std::optional<KindPrediction> of(const calibrate::Target& target) const {
        const auto own = of_calibration.find(target.name());
        if (own != of_calibration.end()) return own->second;
        return surface ? surface->predict(at, target.property, target.confining_pressure) : std::nullopt;
    }
    /// What that specimen is, and whether the runs of a calibration do not tell of it: "300 crystals, by the kind alone".
    [[nodiscard]] std::string specimen_of(const calibrate::Target& target) const;
};
MaterialPrediction prediction_of(const Material& material);

/// A property of a group of runs, or of the line through several groups, and what it is compared with. SI.
struct ComparisonRow {
    LaboratoryProperty laboratory;  ///< the property; not measured where a comparison would be wrong, as for heated specimens
    std::string name = {};          ///< as a laboratory calls it, with what tells its specimens; "" of rows of the table alone
    std::string column = {};        ///< its name in the table `properties`
    Estimate ours = {};             ///< mean over specimens, or of a fit; NaN: none, or not determined
    std::optional<double> deviation = std::nullopt;  ///< over specimens; of C and φ over seeds with tests at all pressures
    std::size_t specimens = 0;                       ///< that have a value
    /// Those that did not fail: not among the specimens, unless the largest stress is taken as the strength; empty: no strength.
    std::optional<std::size_t> without_peak = std::nullopt;
    bool is_heated = false;                             ///< compared with neither laboratory nor kind
    bool is_mean = false;                               ///< of a sample of specimens; else from a fit through all of them
    std::optional<KindPrediction> kind = std::nullopt;  ///< of a new specimen, by the surface of the kind of rock
    std::string kind_specimen = {};                     ///< what that is
    std::string caveat = {};                            ///< why its agreement is unknown, as `Target::caveat`
    calibrate::Agreement agreement = calibrate::Agreement::unknown;

    [[nodiscard]] bool is_tested() const { return specimens > 0 || without_peak; }
    /// Our value with its interval; of up to three specimens also by the scatter that the material tells.
    [[nodiscard]] Estimate computed() const;
    [[nodiscard]] bool is_pooled() const { return is_mean && specimens > 0 && specimens <= 3 && laboratory.scatter; }
    /// 100 (ours/laboratory − 1)
    [[nodiscard]] std::optional<double> off_laboratory_percent() const;
    /// Half of the 95 % interval over our value.
    [[nodiscard]] std::optional<double> half_interval_percent() const;
    /// Specimens, at least three, whose mean has a 95 % half interval of 3 %, with the deviation of these.
    [[nodiscard]] std::optional<double> specimens_for_3_percent() const;
};

/// True if runs with these settings and a `distinct_shape` (bending: that of the specimen with a slit) measure a target.
bool is_measured_by(const calibrate::Target& target, const RunSettings& settings, const std::string& shape);
/// The property of a target, SI; empty if the run is of another test or does not have it. \param kind of strengths
std::optional<double> value_of(const MeasuredRun& test, const calibrate::Target& target,
                               StrengthKind kind = StrengthKind::first_peak);

/// For each property a row for each group that measures it; behind the strengths C, φ and b of each envelope, which [targets]
/// do not have; last the properties that no group measures. Heated specimens stand beside
/// neither the laboratory's values nor the kind's.
/// \param properties as `laboratory_properties` \param kind of strengths
std::vector<ComparisonRow> compare(const std::vector<SeedGroup>& groups, const std::vector<FabricEnvelope>& envelopes,
                                   const std::vector<LaboratoryProperty>& properties, const std::optional<Material>& material,
                                   const MaterialPrediction& prediction, StrengthKind kind = StrengthKind::first_peak);

/// \throws InputError if runs are not of a material by its values, as `difference_from`; of one that lacks some nothing is known
void require_material(const std::vector<RunData>& runs, IncompleteMaterial material);

/// The table `properties` of a rock: its specimens beside its laboratory (the paper's Table 8), and what its kind predicts.
///
/// E and ν (chord to half the peak) of the uniaxial tests, tensile strengths, σ1 at each pressure, and C, φ and b of the line
/// through them; then, without runs, what the surface of the kind predicts of new specimens:
/// σ1 at the pressures of the runs, of [targets] and of the laboratory, else at 8 and 20 MPa. Neither the runs nor the kind need
/// to give all. \param why the kind predicts nothing; "" if it does \throws InputError as require_comparable and
/// collect_envelope_tests, and for a broken table or [targets]
std::vector<ComparisonRow> property_rows(const std::vector<RunData>& runs, IncompleteMaterial material,
                                         const EnvelopeOptions& options, std::string& why);

/// Table property, laboratory, ours, low, high, deviation, specimens, without_peak, off_laboratory_percent,
/// half_interval_percent, specimens_for_3_percent, kind_median, kind_50_low, kind_50_high, kind_95_low, kind_95_high,
/// kind_specimen; each row in the unit of its name. Aligned it is a datasheet, by the names that laboratories have.
void write_properties(std::ostream& out, const std::vector<ComparisonRow>& rows, TableFormat format);

}  // namespace graincrack
