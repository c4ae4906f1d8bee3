// The fabric of a material: its grains, its minerals, what the contacts between them are made of, and how their strengths
// scatter.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "share/base/toml_table.hpp"
#include "share/rock/contact_parameters.hpp"

namespace graincrack {

/// [fabric]: the grains that are made of a rock unless options say otherwise.
struct GrainFabric {
    std::string tessellation;                    ///< "delaunay", "voronoi" or "trigon"; "": not given
    std::optional<double> grain_size;            ///< mean equal-area diameter, m
    std::optional<double> size_variation;        ///< coefficient of variation: of edges of triangles, of diameters of polygons
    std::optional<double> elements_per_crystal;  ///< mean number of elements of a polygon
    std::optional<double> elongation;            ///< ratio of the long to the short axis
    std::optional<double> elongation_angle;      ///< of the long axis from x, rad
};

/// The keys of [fabric], bound to `grains`, which must stay where it is.
std::vector<TomlKey> grain_keys(GrainFabric& grains);
/// Checks what these keys mean together. \param where names the file \throws InputError
void require_sound_grains(const GrainFabric& grains, const std::string& where);

/// Values by temperature (K), and others across the axis of a crystal if there are any: columns of a table.
struct ColumnsByTemperature {
    std::vector<double> temperatures, values, across;
    [[nodiscard]] bool are_given() const { return !temperatures.empty() || !values.empty() || !across.empty(); }
};

/// [phases.NAME]: a mineral. What is unset is the rock's.
struct PhaseMaterial {
    double fraction = 0;                           ///< of the area
    std::optional<double> young_modulus;           ///< Pa
    std::optional<double> relative_young_modulus;  ///< r, over the rock's; one of the two at most
    std::optional<double> poisson_ratio;
    std::optional<double> density;                            ///< kg/m³
    std::optional<double> thermal_expansion;                  ///< 1/K; none: 0
    std::optional<double> expansion_along, expansion_across;  ///< [phases.NAME.thermal_expansion_axes], in place of it, 1/K
    ColumnsByTemperature expansion_by_temperature;            ///< where it changes, likewise
    [[nodiscard]] bool gives_expansion() const {
        return thermal_expansion || expansion_along || expansion_across || expansion_by_temperature.are_given();
    }
    GivenContact contact;  ///< [phases.NAME.contact]: of its side of a contact
};

/// A phase of a material, with what it does not give from the same phase of a file of phases.
PhaseMaterial overlay(PhaseMaterial phase, const PhaseMaterial& of_file);

/// How a value of a contact follows from those of its two sides.
enum class SideRule { mean, minimum };
/// Where the stiffnesses of contacts come from: from the rock for all alike, or from the moduli of the two grains.
enum class StiffnessRule { rock, sides };

struct MaterialFabric {
    std::string from;  ///< [phases] from: file of share/materials/phases whose phases it has, unless it gives their values itself
    std::map<std::string, PhaseMaterial> phases;
    double contrast = 1;                        ///< h: E of a grain = E of the rock × (1 + h (r − 1))
    std::map<std::string, GivenContact> pairs;  ///< [pairs.A-B]
    std::map<std::string, GivenContact> flaws;  ///< [flaws.NAME]: of a class of flaws; what is unset is [contact]'s
    GivenContact homophase;                     ///< [pairs.homophase]: factors on the contacts of a phase with itself
    GivenContact heterophase;                   ///< [pairs.heterophase]: on the others
    GivenContact within;                        ///< [pairs.within]: on the contacts within crystals that break
    SideRule rule = SideRule::mean;
    StiffnessRule stiffness = StiffnessRule::rock;
    ColumnsByTemperature young_modulus_by_temperature;  ///< [temperature]: factor on the modulus of all grains
    std::optional<double> strength_modulus;             ///< [strength]: Weibull modulus of the strengths of grain boundaries
    double strength_correlation = 0;                    ///< distance at which their autocorrelation is 1/e, m; 0: none
};

/// The keys of a table of the fabric, bound to `fabric`, which must stay where it is; nothing if it is none of its tables.
/// \param path {"phases", "quartz", "contact"} for [phases.quartz.contact]
std::optional<TomlKeys> fabric_table(MaterialFabric& fabric, const std::vector<std::string>& path);

/// Checks what the keys of a fabric mean together. \param where names the file \throws InputError
void require_sound_fabric(const MaterialFabric& fabric, const Rock& rock, const std::string& where);

/// A value of a fabric: a number in SI or a word.
struct FabricValue {
    std::string table;  ///< "phases.quartz"
    std::string key;
    std::optional<double> number;
    std::string word = {};
};
/// What a fabric has, each table in one piece. What matters with a temperature alone is left out: the tests of a calibration and
/// of a kind have none, and are the same whatever expands.
std::vector<FabricValue> fabric_values(const MaterialFabric& fabric);

/// r of a phase: its modulus over the rock's; 1 where it has none of its own.
double relative_young_modulus(const PhaseMaterial& phase, const Rock& rock);
/// E of the grains of a phase: E of the rock × (1 + h (r − 1)), Pa.
double young_modulus_of_grains(const PhaseMaterial& phase, const MaterialFabric& fabric, const Rock& rock);

}  // namespace graincrack
