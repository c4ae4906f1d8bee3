// The response surface that the rocks of a type have in common. With stresses over the tensile strength tc of contacts, lengths
// over the grain size d and energies over tc² d/E, one surface describes all specimens of the same fabric. Its table is
// share/materials/kinds/surface.tsv; `make -C share/studies surface` makes it.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "post/measure/property.hpp"
#include "post/statistics/linear_model.hpp"
#include "post/table/table.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// The similarity variables of the contacts of a material, in plane strain.
struct KindCoordinates {
    double tensile_strength = 0;         ///< tc, Pa: the unit of stresses
    double grain_size = 0;               ///< d, m: the unit of lengths
    double cohesion = 0;                 ///< cc/tc
    double friction_angle = 0;           ///< rad
    double residual_friction_angle = 0;  ///< rad
    double process_zone = 0;             ///< E G_I/(tc² d)
    double mode_ii_fracture_energy = 0;  ///< G_II/G_I
    double bridging_strength = 0;        ///< over tc
    double bridging_energy = 0;          ///< E G_b/(tc² d); 0 without bridges
    double contact_strain = 5.36e-7;     ///< tc/(kt d) with the stiffness kt of contacts; by default that of the design
};
KindCoordinates kind_coordinates(const Material& material);

/// One row of the table: a value of a test, or the mean of several tests of a calibrated rock.
struct KindRow {
    std::string kind;   ///< rock type, "granite"
    std::string point;  ///< point of the design, "d12", with the same specimens for all rock types; or name of a calibrated rock
    bool is_rock = false;
    KindCoordinates at;             ///< with tensile_strength and grain_size 1
    double confining_pressure = 0;  ///< over tc
    std::string property;           ///< name of a `Property`
    double value = 0;               ///< over tc; for K_IC over tc √d
    double specimens = 1;           ///< number of specimens of the mean
};
/// Reads a table of rows. \throws InputError that names file, row and column
std::vector<KindRow> read_kind_rows(const std::string& file);
/// The rows of kinds/surface.tsv beside the materials; empty without this file.
std::vector<KindRow> kind_rows();

/// The model of ln(value over its unit) of a property, with the scatter of single specimens.
struct KindModel : LinearModel {
    /// Variance of the difference of a rock from the surface that all its specimens share: the mean over the rows of calibrated
    /// rocks, which are not in the fit, less the parts of scatter and fit. Its floor .03² was set beforehand: four rocks cannot
    /// show less.
    double rock_variance = 0;
    int rocks = 0;  ///< number of these rocks
    /// Degrees of freedom of the mean of a rock, from those of the fit and the number of rocks (Welch & Satterthwaite).
    [[nodiscard]] int freedom_of_mean(const std::vector<double>& at) const;
};

/// Half and 95 % of specimens lie within these numbers of standard deviations.
inline constexpr double deviations_of_50_percent = 0.674490, deviations_of_95_percent = 1.959964;

/// The prediction of a surface for a new specimen; ln of the value has normal scatter.
struct KindPrediction {
    double value = 0;               ///< SI
    double mean_deviation = 0;      ///< standard deviation of ln of the mean of this rock
    double specimen_deviation = 0;  ///< standard deviation of ln of a single new specimen
    /// The value at this number of standard deviations of a new specimen, as `deviations_of_95_percent`.
    [[nodiscard]] double specimen_at(double deviations) const;
};

/// The response surface of a rock type. Confining pressures are in Pa, or over tc if the tensile strength of the coordinates
/// is 1.
class KindSurface {
public:
    /// The surface of the rock type with the law, fabric, factors within crystals and other ratios of a material; empty if there
    /// is none. A material that names a rock type gets no other. \param why if not null, gets the differences of the material in
    /// words \throws InputError for a wrong table
    static std::optional<KindSurface> of(const Material& material, std::string* why = nullptr);
    /// Fits the surface of the rock type `kind`. \throws InputError if a property has fewer rows than its terms need
    KindSurface(std::vector<KindRow> rows, std::string kind);

    [[nodiscard]] const std::string& kind() const { return kind_; }
    /// The models by the names of their properties, in the order of `all_properties`.
    [[nodiscard]] const std::vector<std::pair<std::string, KindModel>>& models() const { return models_; }
    /// A term in words, "ln(cohesion/5) ln(process_zone/1.16)".
    [[nodiscard]] std::string name_of(const SurfaceTerm& term) const;
    /// The model of a property. It is null without a row of this rock type, and at a pressure but for the first peak.
    [[nodiscard]] const KindModel* model(const Property& property, double confining_pressure) const;
    /// The factors of all models at coordinates of this rock type; terms without the pressure have its power 0.
    [[nodiscard]] std::vector<double> factors(const KindCoordinates& at, double confining_pressure) const;
    /// ln of the unit of a property in SI: tc; for K_IC tc √d; for crack initiation, which an absolute crack strain of 1e-5
    /// defines, tc (tc/(kt d))^−.24 with tc/(kt d) over that of the design.
    [[nodiscard]] static double log_unit(const Property& property, const KindCoordinates& at);
    /// The specimens of a property, if they are unusual for tests: "300 crystals, plane stress".
    [[nodiscard]] static std::string specimen_of(const Property& property);
    /// True if all coordinates, and the pressure over tc, lie within those of the design.
    [[nodiscard]] bool holds(const KindCoordinates& at, double confining_pressure = 0) const {
        return beyond(at, confining_pressure).empty();
    }
    /// The coordinate beyond the design, in words: "its cohesion over tc is 18, those of the design 1.5 to 16"; "" if none.
    [[nodiscard]] std::string beyond(const KindCoordinates& at, double confining_pressure = 0) const;
    /// Smallest and largest value of each coordinate in the design; tensile_strength and grain_size have no bounds.
    [[nodiscard]] const KindCoordinates& least() const { return least_; }
    [[nodiscard]] const KindCoordinates& most() const { return most_; }
    /// Predicts a property in SI; empty if there is no model, or if the coordinates lie beyond the design.
    [[nodiscard]] std::optional<KindPrediction> predict(const Material& material, const Property& property,
                                                        double confining_pressure) const {
        return predict(kind_coordinates(material), property, confining_pressure);
    }
    [[nodiscard]] std::optional<KindPrediction> predict(const KindCoordinates& at, const Property& property,
                                                        double confining_pressure) const;

private:
    std::string kind_;
    std::vector<std::string> kinds_;                         ///< rock types of the design but granite; each has a factor
    std::vector<std::pair<std::string, KindModel>> models_;  ///< by the name of the property
    KindCoordinates least_;
    KindCoordinates most_;
    double least_pressure_ = 0;  ///< over tc
    double most_pressure_ = 0;
};

/// Writes one row per term of each property: property, term, coefficient and standard_error of ln, then for the property scatter,
/// rock_deviation, prediction_error and specimens.
void write_kind_terms(std::ostream& out, const KindSurface& surface, TableFormat format);

/// Writes one row per value of a calibrated rock; these values are not in the fit. Columns: rock, property, confining_pressure,
/// measured and predicted (over tc), specimens, off_percent of the prediction from the value, and its 95 % interval low_percent,
/// high_percent from the scatter of specimens and the fit alone. Coordinates beyond the design have no prediction.
void write_kind_rocks(std::ostream& out, const KindSurface& surface, const std::vector<KindRow>& rows, TableFormat format);

}  // namespace graincrack
