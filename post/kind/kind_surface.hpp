// What strengths over the tensile strength tc of contacts the rocks of a kind have in common: with stresses over tc, lengths over
// the grain size d and energies over tc² d/E, specimens of the same fabric are one response surface. Its table is
// share/materials/kinds/surface.tsv, made by `make -C share/studies surface`.
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
    double contact_strain = 5.36e-7;     ///< tc/(kt d), with the stiffness of contacts; of the design unless a table has it
};
KindCoordinates kind_coordinates(const Material& material);

/// One row of the table: a value of a test, or the mean of several of a calibrated rock.
struct KindRow {
    std::string kind;   ///< "granite"
    std::string point;  ///< of the design, "d12", whose specimens are one for all kinds; or the name of a calibrated rock
    bool is_rock = false;
    KindCoordinates at;             ///< tensile_strength and grain_size 1
    double confining_pressure = 0;  ///< over tc
    std::string property;           ///< name of a `Property`
    double value = 0;               ///< over tc; of K_IC over tc √d
    double specimens = 1;           ///< whose mean it is
};
/// \throws InputError that names file, row and column
std::vector<KindRow> read_kind_rows(const std::string& file);
/// The rows of kinds/surface.tsv beside the materials; none if it is not there.
std::vector<KindRow> kind_rows();

/// A quantity of a kind: ln(value over its unit), with the scatter of single specimens.
struct KindModel : LinearModel {
    /// Of what a rock differs from the surface in all of its specimens: the mean over the rows of calibrated rocks, which are not
    /// in the fit, less what scatter and fit have of it. It is .03² at least, a floor that was set beforehand: four rocks cannot
    /// show less.
    double rock_variance = 0;
    int rocks = 0;  ///< that it is of
    /// Degrees of freedom of the mean of a rock: those of the fit, and of the rocks that there are (Welch & Satterthwaite).
    [[nodiscard]] int freedom_of_mean(const std::vector<double>& at) const;
};

/// Half of specimens, and 95 %, lie within so many standard deviations.
inline constexpr double deviations_of_50_percent = 0.674490, deviations_of_95_percent = 1.959964;

/// What a new specimen has by the surface; intervals of ln are normal.
struct KindPrediction {
    double value = 0;               ///< SI
    double mean_deviation = 0;      ///< standard deviation of ln of the mean of this rock
    double specimen_deviation = 0;  ///< of ln of a single new specimen
    /// The value so many standard deviations of a new specimen off, as `deviations_of_95_percent`.
    [[nodiscard]] double specimen_at(double deviations) const;
};

/// A confining pressure has the unit of the tensile strength of the coordinates beside it: Pa, or over tc where that is 1.
class KindSurface {
public:
    /// The surface of the kind whose law, fabric, factors within crystals and other ratios a material has; empty if there is
    /// none; only the kind that the material names, if it does. \param why if not null, gets in words what the material has
    /// otherwise \throws InputError for a broken table
    static std::optional<KindSurface> of(const Material& material, std::string* why = nullptr);
    /// \throws InputError if a quantity has fewer rows than its terms need
    KindSurface(std::vector<KindRow> rows, std::string kind);

    [[nodiscard]] const std::string& kind() const { return kind_; }
    /// The models by the names of their properties, in the order of `all_properties`.
    [[nodiscard]] const std::vector<std::pair<std::string, KindModel>>& models() const { return models_; }
    /// A term in words, "ln(cohesion/5) ln(process_zone/1.16)".
    [[nodiscard]] std::string name_of(const SurfaceTerm& term) const;
    /// The model of a property; null if it has none, as of one at a pressure that is no first peak, or of one that no row of this
    /// kind has.
    [[nodiscard]] const KindModel* model(const Property& property, double confining_pressure) const;
    /// The factors of all models at a material of this kind; a term of no pressure has the power 0 of it.
    [[nodiscard]] std::vector<double> factors(const KindCoordinates& at, double confining_pressure) const;
    /// ln of the unit in SI of a property: tc, of K_IC tc √d; of crack initiation, which an absolute crack strain of 1e-5
    /// defines, tc (tc/(kt d))^−.24 over that of the design.
    [[nodiscard]] static double log_unit(const Property& property, const KindCoordinates& at);
    /// What the specimens of a property are, where tests are often of others: "300 crystals, plane stress".
    [[nodiscard]] static std::string specimen_of(const Property& property);
    /// True if all coordinates, and the pressure over tc, lie within those of the design.
    [[nodiscard]] bool holds(const KindCoordinates& at, double confining_pressure = 0) const {
        return beyond(at, confining_pressure).empty();
    }
    /// Which of them does not, in words: "its cohesion over tc is 18, those of the design 1.5 to 16"; "" if the surface holds.
    [[nodiscard]] std::string beyond(const KindCoordinates& at, double confining_pressure = 0) const;
    /// The least and the most of each coordinate in the design; tensile_strength and grain_size are not bounded.
    [[nodiscard]] const KindCoordinates& least() const { return least_; }
    [[nodiscard]] const KindCoordinates& most() const { return most_; }
    /// Empty if there is no model, or it does not hold there.
    [[nodiscard]] std::optional<KindPrediction> predict(const Material& material, const Property& property,
                                                        double confining_pressure) const {
        return predict(kind_coordinates(material), property, confining_pressure);
    }
    [[nodiscard]] std::optional<KindPrediction> predict(const KindCoordinates& at, const Property& property,
                                                        double confining_pressure) const;

private:
    std::string kind_;
    std::vector<std::string> kinds_;                         ///< others than granite, of which the design has rows: a factor each
    std::vector<std::pair<std::string, KindModel>> models_;  ///< by the name of the property
    KindCoordinates least_;
    KindCoordinates most_;
    double least_pressure_ = 0;  ///< over tc
    double most_pressure_ = 0;
};

/// A row of each term of each property: property, term, coefficient, standard_error of ln, then of the property scatter,
/// rock_deviation, prediction_error, specimens.
void write_kind_terms(std::ostream& out, const KindSurface& surface, TableFormat format);

/// A row of each value of a calibrated rock, which is not in the fit: rock, property, confining_pressure, measured, predicted
/// (over tc), specimens, off_percent of the prediction from the value, and low_percent, high_percent, its 95 % interval by the
/// scatter of specimens and the fit alone. Beyond the design nothing is predicted.
void write_kind_rocks(std::ostream& out, const KindSurface& surface, const std::vector<KindRow>& rows, TableFormat format);

}  // namespace graincrack
