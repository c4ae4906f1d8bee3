// Calibration parameters: what a calibration may change, in one table, and a point of values for them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "share/material.hpp"

namespace graincrack::calibrate {

/// Rows of the table `parameters`, in its order.
enum class Parameter : std::size_t {
    young_modulus,        ///< E of the grains
    poisson_ratio,        ///< ν of the grains
    tensile_strength,     ///< tc
    cohesion,             ///< cc
    friction_angle,       ///< φc
    fracture_energy,      ///< Gf
    open_shear_strength,  ///< shear strength of open contacts
};
inline constexpr std::size_t n_parameters = 7;

struct ParameterRow {
    Parameter parameter;
    const char* key;                            ///< in a material file: "contact.cohesion"
    const char* column;                         ///< of tables: "contact_cohesion_MPa"
    const char* name;                           ///< in names of runs: "cc"
    const char* symbol;                         ///< in reports
    const char* unit;                           ///< of the column and in reports
    double si;                                  ///< that unit in SI
    const char* moves;                          ///< the targets that it moves
    const char* first_guess;                    ///< with its source
    const char* range;                          ///< bounds, with their source
    const ContactParameter* contact = nullptr;  ///< its row of the contact parameters; null for one of the grains
};
const std::array<ParameterRow, n_parameters>& parameters();
const ParameterRow& row_of(Parameter parameter);
/// The unit of a parameter in files: "MPa", "J/m2", "deg"; "" for one without.
std::string unit_in_files(const ParameterRow& row);

/// Values of the parameters, SI. What is unset follows from the others as in a material without it.
class Point {
public:
    std::optional<double>& operator[](Parameter p) { return values_[static_cast<std::size_t>(p)]; }
    const std::optional<double>& operator[](Parameter p) const { return values_[static_cast<std::size_t>(p)]; }
    /// The same with one value changed, rounded as `rounded` does.
    [[nodiscard]] Point with(Parameter parameter, double value) const;

private:
    std::array<std::optional<double>, n_parameters> values_;
};

/// The value to six significant digits of its unit in tables, so that a file holds the very number that a decision used.
double rounded(Parameter parameter, double value);

/// The rock with the values of a point.
Material material_at(const Material& rock, const Point& point);

/// All values at a point, with those that follow: what a run reports. Contact values are those of `plane`.
std::array<double, n_parameters> effective_values(const Material& rock, const Point& point, PlaneCondition plane);

struct Range {
    double low = 0;
    double high = 0;
};
/// First guess and bounds of a parameter at a point whose other values are given.
/// \param edge mean grain edge, m
double first_guess(Parameter parameter, const Material& rock, const Point& point, double edge);
Range range_of(Parameter parameter, const Material& rock, const Point& point, double edge);

/// "tc 24.15 MPa, cc 74.57 MPa, …": what is set of a point.
std::string label_of(const Point& point);
/// "24.15 MPa"
std::string label_of(Parameter parameter, double value);

}  // namespace graincrack::calibrate
