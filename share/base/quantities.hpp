// Defines every physical quantity of the programs once, with name, dimension, bounds and meaning.
//
// Options, HDF5 names, table headers and plots use these names. Values are SI; angles are radians.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string_view>

namespace graincrack {

/// Dimension of a quantity. It determines its SI unit and the units that a user may write.
enum class Dimension {
    one,              ///< pure number (unit "1")
    length,           ///< m
    area,             ///< m2
    angle,            ///< rad
    time,             ///< s
    speed,            ///< m/s
    stress,           ///< Pa
    force,            ///< N (per metre of thickness in plane models, t = 1 m)
    energy,           ///< J (per metre of thickness in plane models)
    stiffness,        ///< Pa/m, traction over displacement of a contact
    toughness,        ///< Pa.m^0.5, stress intensity
    fracture_energy,  ///< J/m2
    density,          ///< kg/m3
    acceleration,     ///< m/s2
    frequency,        ///< Hz
    temperature,      ///< K, a difference
    expansion,        ///< 1/K
    heating_rate,     ///< K/s
};

/// A unit that a user may write, with its factor to SI ("mm" → 1e-3, "deg" → π/180, "%" → 0.01 …).
struct Unit {
    std::string_view symbol = {};
    double to_si = 1;
};

/// Names and units of a dimension.
struct DimensionRow {
    std::string_view name;                  ///< name in messages
    std::string_view option_type;           ///< type of option values in help
    std::array<Unit, 5> units;              ///< units that a user may write, the SI unit first
    std::array<std::string_view, 5> shown;  ///< units in which values are shown, smallest first
};
// clang-format off
inline constexpr std::array<DimensionRow, 18> dimension_rows{{
    {"pure number", "NUMBER", {{{"1"}, {"%", 1e-2}}}, {"1"}},
    {"length", "LENGTH", {{{"m"}, {"mm", 1e-3}, {"cm", 1e-2}, {"um", 1e-6}, {"km", 1e3}}}, {"um", "mm", "m", "km"}},
    {"surface", "AREA", {{{"m2"}, {"mm2", 1e-6}, {"cm2", 1e-4}}}, {"mm2", "m2"}},
    {"plane angle", "ANGLE", {{{"rad"}, {"deg", std::numbers::pi / 180}}}, {"deg"}},
    {"time", "TIME", {{{"s"}, {"ms", 1e-3}, {"us", 1e-6}, {"min", 60}, {"h", 3600}}}, {"us", "ms", "s", "min", "h"}},
    {"speed", "SPEED", {{{"m/s"}, {"mm/s", 1e-3}, {"um/s", 1e-6}, {"mm/min", 1e-3 / 60}}}, {"mm/s", "m/s"}},
    {"stress", "STRESS", {{{"Pa"}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}}}, {"Pa", "kPa", "MPa", "GPa"}},
    {"force", "FORCE", {{{"N"}, {"kN", 1e3}, {"MN", 1e6}}}, {"N", "kN", "MN"}},
    {"work", "ENERGY", {{{"J"}, {"mJ", 1e-3}, {"kJ", 1e3}}}, {"mJ", "J", "kJ"}},
    {"contact stiffness", "STIFFNESS", {{{"Pa/m"}, {"MPa/m", 1e6}, {"GPa/m", 1e9}, {"MPa/mm", 1e9}, {"GPa/mm", 1e12}}}, {"MPa/mm"}},
    {"fracture toughness", "TOUGHNESS", {{{"Pa.m^0.5"}, {"kPa.m^0.5", 1e3}, {"MPa.m^0.5", 1e6}}}, {"MPa.m^0.5"}},
    {"fracture energy", "ENERGY/AREA", {{{"J/m2"}, {"kJ/m2", 1e3}, {"N/m"}}}, {"J/m2"}},
    {"mass density", "DENSITY", {{{"kg/m3"}, {"g/cm3", 1e3}, {"t/m3", 1e3}}}, {"kg/m3"}},
    {"acceleration", "ACCELERATION", {{{"m/s2"}, {"mm/s2", 1e-3}}}, {"m/s2"}},
    {"frequency", "FREQUENCY", {{{"Hz"}, {"kHz", 1e3}, {"MHz", 1e6}}}, {"Hz", "kHz", "MHz"}},
    {"temperature difference", "TEMPERATURE", {{{"K"}}}, {"K"}},
    {"thermal expansion", "EXPANSION", {{{"1/K"}}}, {"1/K"}},
    {"heating rate", "RATE", {{{"K/s"}}}, {"K/s"}},
}};
// clang-format on
/// The row of a dimension; rows are in the order of `Dimension`.
constexpr const DimensionRow& row_of(Dimension dimension) { return dimension_rows[static_cast<std::size_t>(dimension)]; }
/// SI unit as spelt in files: "m", "Pa", "rad", "1", …
constexpr std::string_view si_unit(Dimension dimension) { return row_of(dimension).units.front().symbol; }
/// Name of a dimension in messages: "length", "stress", "pure number" …
constexpr std::string_view name_of(Dimension dimension) { return row_of(dimension).name; }

/// A physical quantity. A value is admissible if lower ≤ value ≤ upper (strictly above `lower` if `open_below`).
struct Quantity {
    std::string_view name;
    Dimension dimension;
    double lower;
    double upper;
    std::string_view meaning;
    bool open_below = false;
    std::string_view why_upper = {};  ///< reason for `upper`, for messages
    [[nodiscard]] constexpr bool admits(double value) const {
        return (open_below ? value > lower : value >= lower) && value <= upper;
    }
    [[nodiscard]] constexpr std::string_view unit() const { return si_unit(dimension); }
};

namespace quantity {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr double right_angle = 1.57079632679489661923;

// --- rock ------------------------------------------------------------------------------------------------------------
inline constexpr Quantity young_modulus{"young_modulus", Dimension::stress, 0, 1e13, "Young's modulus of the rock", true};
inline constexpr Quantity poisson_ratio{"poisson_ratio", Dimension::one, 0, 0.49, "Poisson's ratio of the rock"};
inline constexpr Quantity density{"density", Dimension::density, 0, 1e5, "mass density of the rock", true};
inline constexpr Quantity thermal_expansion{"thermal_expansion", Dimension::expansion, -1e-3, 1e-3,
                                            "linear thermal expansion of a phase"};
inline constexpr std::string_view why_hottest =
    "480 K above 20 deg C are 500 deg C; at 573 deg C quartz changes, and the cracks of that are not in the model";
inline constexpr Quantity temperature{
    "temperature", Dimension::temperature, -290, 480, "temperature above that of the state without stress", false, why_hottest};
inline constexpr Quantity heat{
    "heat", Dimension::temperature, -290, 480, "rise of the temperature before a test, below 0 a fall", false, why_hottest};
inline constexpr Quantity mode_i_toughness{
    "mode_i_toughness", Dimension::toughness, 0, 1e9, "fracture toughness K_IC of the rock", true};
inline constexpr Quantity mode_ii_toughness{
    "mode_ii_toughness", Dimension::toughness, 0, 1e9, "fracture toughness K_IIC of the rock", true};
inline constexpr Quantity tensile_strength{"tensile_strength", Dimension::stress, 0, 1e12, "tensile strength of the rock", true};
inline constexpr Quantity compressive_strength{
    "compressive_strength", Dimension::stress, 0, 1e12, "uniaxial compressive strength of the rock", true};
inline constexpr Quantity internal_cohesion{"cohesion", Dimension::stress, 0, 1e12, "internal cohesion of the rock"};
inline constexpr Quantity internal_friction_angle{"friction_angle", Dimension::angle, 0, right_angle,
                                                  "internal friction angle of the rock"};
inline constexpr Quantity confined_strength{
    "confined_strength", Dimension::stress, 0, 1e12, "strength of the rock under a confining pressure", true};
inline constexpr Quantity direct_tensile_strength{
    "direct_tensile_strength", Dimension::stress, 0, 1e12, "strength of the rock in direct tension", true};
inline constexpr Quantity crack_initiation{
    "crack_initiation", Dimension::stress, 0, 1e12, "uniaxial stress at which cracks begin", true};
inline constexpr Quantity crack_damage{
    "crack_damage", Dimension::stress, 0, 1e12, "uniaxial stress at which the volume begins to grow", true};

inline constexpr Quantity grain_size{"grain_size", Dimension::length, 0, 1e3, "mean grain size of the rock", true};
inline constexpr Quantity min_grain_size{"min_grain_size", Dimension::length, 0, 1e3, "smallest grains of the rock", true};
inline constexpr Quantity max_grain_size{"max_grain_size", Dimension::length, 0, 1e3, "largest grains of the rock", true};

// --- specimen --------------------------------------------------------------------------------------------------------
inline constexpr Quantity width{"width", Dimension::length, 0, 1e4, "width of the specimen (x)", true};
inline constexpr Quantity height{"height", Dimension::length, 0, 1e4, "height of the specimen (y)", true};
inline constexpr Quantity diameter{"diameter", Dimension::length, 0, 1e4, "diameter of the disc", true};
inline constexpr Quantity notch{"notch", Dimension::length, 0, 1e4, "length of a notch across the middle of a rectangle", true};
inline constexpr Quantity slit{"slit", Dimension::length, 0, 1e4, "length of a straight crack", true};
inline constexpr Quantity direction{"direction", Dimension::angle, -4 * right_angle, 4 * right_angle,
                                    "direction, counter-clockwise from x"};
inline constexpr Quantity flats{"flats", Dimension::angle, 0, 2.1, "angle under which a flat pole is seen from the centre", true};
inline constexpr Quantity joint_length{"joint_length", Dimension::length, 0, 1e4, "length or spacing of joints", true};
inline constexpr Quantity persistence{"persistence", Dimension::one, 0, 1, "share of a line that is jointed", true};
inline constexpr Quantity hole_radius{"radius", Dimension::length, 0, 1e4, "radius of a hole", true};
inline constexpr Quantity mesh_scale{"scale", Dimension::length, 1e-12, 1e6, "length of the unit of a mesh file"};
inline constexpr Quantity pixel_size{"pixel_size", Dimension::length, 0, 1e4, "side of a pixel of a picture", true};
inline constexpr Quantity element_size{"element_size", Dimension::length, 0, 1e4, "side of the elements of a grain", true};
inline constexpr Quantity elements_per_crystal{"elements_per_crystal", Dimension::one, 1, 1e6,
                                               "mean number of elements of a polygon"};
inline constexpr Quantity coordinate{"coordinate", Dimension::length, -1e4, 1e4, "coordinate"};
inline constexpr Quantity mean_edge{"edge", Dimension::length, 0, 1e3, "mean edge over all grain edges, rim included", true};
inline constexpr Quantity relative_edge{"relative_edge", Dimension::one, 0.1, 10, "relative edge of graded grains"};
inline constexpr Quantity grading_distance{
    "grading_distance", Dimension::length, 0, 1e4, "distance over which sizes are graded", true};
inline constexpr Quantity elongation{"elongation", Dimension::one, 1, 4, "ratio of the axes of elongated grains"};
inline constexpr Quantity edge_spread{"spread", Dimension::one, 0, 0.5, "coefficient of variation of the grain edges"};
inline constexpr double largest_spread_of_triangles = 0.35;
inline constexpr Quantity size_variation{"size_variation", Dimension::one, 0, 0.6, "coefficient of variation of grain sizes"};
inline constexpr Quantity phase_fraction{"fraction", Dimension::one, 0, 1, "fraction of the area that a phase has", true};
inline constexpr Quantity phase_cluster{"phase_cluster", Dimension::one, 1, 1e9,
                                        "mean number of grains in a cluster of one phase"};
// Below 1 the most probable strength would be 0.
inline constexpr Quantity strength_modulus{"strength_modulus", Dimension::one, 1, 1000,
                                           "Weibull modulus of the strength of grain boundaries"};
inline constexpr Quantity strength_correlation{
    "strength_correlation", Dimension::length, 0, 1e4, "distance at which the autocorrelation of strength is 1/e", true};
inline constexpr Quantity open_boundaries{"open_boundaries", Dimension::one, 0, 1,
                                          "share of the length of grain boundaries that is open from the start"};
inline constexpr Quantity open_length{"open_length", Dimension::one, 1, 1000, "mean number of open boundaries in a row"};

// --- test ------------------------------------------------------------------------------------------------------------
inline constexpr Quantity platen_friction{"platen_friction", Dimension::angle, 0, 1.55, "friction angle between rock and platen"};
inline constexpr Quantity confining_pressure{"confining_pressure", Dimension::stress, 0, 1e12, "pressure on the lateral edges"};
inline constexpr Quantity platen_speed{"platen_speed", Dimension::speed, 0, 1e3, "speed of each platen", true};
inline constexpr Quantity rate_tolerance{
    "rate_tolerance", Dimension::one, 0, 0.1, "what the measures of equilibrium may reach while there is damage", true};
inline constexpr Quantity rate_share{"rate_share", Dimension::one, 0, 10, "share of the speeds of the automatic rate", true};
inline constexpr Quantity peak_drop{
    "peak_drop", Dimension::one, 0, 1, "fall below the peak, as a share of it, that ends the test", true};
inline constexpr Quantity max_strain{
    "max_strain", Dimension::one, 0, 0.5, "platen approach over specimen height that ends the test", true};
inline constexpr Quantity span{"span", Dimension::length, 0, 1e4, "distance of the lower rollers of a test in bending", true};
inline constexpr Quantity roller_width{
    "roller_width", Dimension::length, 0, 1e4, "width of the rollers of a test in bending", true};
inline constexpr Quantity damping{"damping", Dimension::one, 0, 0.99, "share of the unbalanced force that damps"};
inline constexpr Quantity mass_scaling_factor{"mass_scaling_factor",
                                              Dimension::one,
                                              0,
                                              1e4,
                                              "added mass over mass, for the motion of nodes that contacts hold together",
                                              true};
inline constexpr Quantity checkpoint_interval{
    "checkpoint_interval", Dimension::time, 0, 1e7, "wall time between checkpoints", true};
inline constexpr Quantity time_step_fraction{
    "time_step_fraction", Dimension::one, 0, 1.5, "time step over the stable step", true};

}  // namespace quantity

}  // namespace graincrack
