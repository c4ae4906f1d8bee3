#include "share/rock/incomplete_material.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

constexpr double zhang = 6.88;                     // 1/√m: σt = 6.88 K_IC over many rocks (Zhang 2002)
constexpr double mode_ii_over_mode_i = 3.0 / 1.5;  // of Augig granite

const char* const rock_keys = R"toml(
# Values are texts with units ("25.8 GPa"); a bare number is SI. Strengths are positive. Take the # from a line to set its key.

[rock]                                    # grains; all six are needed
# young_modulus = "25.8 GPa"              # E
# poisson_ratio = 0.23
# density = "2650 kg/m3"                  # hardly enters quasi-static results: 2650 kg/m3 fits most granites
# mode_i_toughness = "1.5 MPa.m^0.5"      # K_IC. Not measured: tensile strength / 6.88, an empirical mean over many rocks
                                          # (Zhang 2002), MPa to MPa.m^0.5; say in a comment that it is not a measurement
# mode_ii_toughness = "3.0 MPa.m^0.5"     # K_IIC. Not measured: Zhang (2002) has no relation for it; Augig granite has 2 K_IC.
                                          # Take that, and see by a second value how much your results depend on it
# tensile_strength = "8.8 MPa"            # Brazilian

[contact]                                 # between grains; the first three are needed, `make -C share/studies calibrate` finds them
)toml";

const char* const other_keys = R"toml(
[ratios]                                  # contact values that follow from others where [contact] does not give them
# tensile_strength = 0.9                  # tc over the tensile strength of the rock
# cohesion = 6.6                          # cc over tc
# process_zone = 0.7                      # E G_I/tc2 over the grain size of [fabric]
# mode_ii_fracture_energy = 44            # G_II over G_I
# open_shear_strength = 4                 # over tc

[platen]
# friction_angle = "5 deg"                # default: 0; rock on steel

[fabric]                                  # grains that graincrack-mesh makes of it unless options say otherwise
# tessellation = "trigon"                 # delaunay: triangles; voronoi: polygons; trigon: polygons that break
# grain_size = "4 mm"                     # mean equal-area diameter
# size_variation = 0.3                    # coefficient of variation, of triangles at most 0.35; default: 0.1
# elements_per_crystal = 8                # of polygons, on average
# elongation = 1                          # long over short axis, 1 to 4
# elongation_angle = "0 deg"              # of the long axis from x

[laboratory]                              # measured values and targets of a calibration; [rock] has them unless it gives its own
# young_modulus = "25.8 GPa"
# poisson_ratio = 0.23
# density = "2650 kg/m3"
# tensile_strength = "8.8 MPa"            # Brazilian
# compressive_strength = "122 MPa"        # UCS
# cohesion = "21 MPa"
# friction_angle = "53 deg"
# confined_strength = "193.5 MPa"         # at the next; of use without friction_angle
# confining_pressure = "8 MPa"
# mode_i_toughness = "1.5 MPa.m^0.5"
# direct_tensile_strength = "7 MPa"
# crack_initiation = "55 MPa"             # axial stress of uniaxial tests
# crack_damage = "98 MPa"
# grain_size = "4 mm"                     # mean
# min_grain_size = "2 mm"
# max_grain_size = "6 mm"
)toml";

bool has(const std::vector<std::string>& keys, const std::string& key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Sets a value of [rock] that is missing. \return whether it was
bool set_missing(IncompleteMaterial& read, const char* key, double& to, double value) {
    if (std::erase(read.missing, std::string("rock.") + key) == 0) return false;
    to = read.values[std::string("rock.") + key] = value;
    return true;
}

/// What [laboratory] has of [rock]. \param notes gets a sentence for each value
void take_measured_rock(IncompleteMaterial& read, std::vector<std::string>& notes) {
    Rock& rock = read.material.rock;
    const std::pair<const char*, double*> values[] = {{"young_modulus", &rock.young_modulus},
                                                      {"poisson_ratio", &rock.poisson_ratio},
                                                      {"density", &rock.density},
                                                      {"tensile_strength", &rock.tensile_strength},
                                                      {"mode_i_toughness", &rock.mode_i_toughness}};
    for (const auto& [key, to] : values) {
        const auto found = read.material.laboratory.find(key);
        if (found == read.material.laboratory.end() || !set_missing(read, key, *to, found->second)) continue;
        notes.push_back(fmt::format("{} of the rock is that of [laboratory]", key));
    }
}

/// \param notes gets a sentence for each value
void assume_toughness(IncompleteMaterial& read, std::vector<std::string>& notes) {
    Rock& rock = read.material.rock;
    const auto assume = [&](const char* key, double& to, double value, const char* source) {
        if (!set_missing(read, key, to, value)) return;
        notes.push_back(fmt::format("{} was not measured: {} {}", key, format_quantity(value, Dimension::toughness), source));
    };
    assume("mode_i_toughness", rock.mode_i_toughness, rock.tensile_strength / zhang,
           "is tensile_strength/6.88, an empirical mean over many rocks (Zhang 2002)");
    assume("mode_ii_toughness", rock.mode_ii_toughness, mode_ii_over_mode_i * rock.mode_i_toughness,
           "is 2 K_IC, the ratio of Augig granite");
}

}  // namespace

void take_laboratory(IncompleteMaterial& read) {
    Material& material = read.material;
    const bool is_of_laboratory = has(read.missing, "rock.tensile_strength") && material.laboratory.contains("tensile_strength");
    std::vector<std::string> taken;
    take_measured_rock(read, taken);
    std::vector<std::string> assumed;
    if (is_of_laboratory) assume_toughness(read, assumed);
    for (const std::string& note : assumed) material.notes.push_back(fmt::format("note: {}: {}", material.file.string(), note));
    const auto size = material.laboratory.find("grain_size");
    if (material.grains.tessellation.empty() || material.grains.grain_size || size == material.laboratory.end()) return;
    material.grains.grain_size = read.values["fabric.grain_size"] = size->second;
    std::erase(read.missing, "fabric.grain_size");
}

Rock rock_of_laboratory(const IncompleteMaterial& incomplete, std::vector<std::string>& notes) {
    IncompleteMaterial read = incomplete;
    take_measured_rock(read, notes);
    for (const char* key : {"young_modulus", "poisson_ratio", "tensile_strength"}) {
        if (!has(read.missing, std::string("rock.") + key)) continue;
        throw InputError(fmt::format("{}: neither rock.{} nor laboratory.{} is there; one of them is needed",
                                     read.material.file.string(), key, key));
    }
    assume_toughness(read, notes);
    return read.material.rock;
}

std::string material_template(const std::string& name) {
    std::string text = fmt::format("name = \"{}\"\n{}", name, rock_keys);
    for (const ContactParameter& row : all_contact_parameters()) {
        text += fmt::format("# {:<39} # {}: {}{}\n", fmt::format("{} = \"{}\"", row.key(), row.example),
                            row.is_needed() ? "first guess" : "default", row.usual, row.every_law ? "" : "; some laws only");
    }
    text += fmt::format("# {:<39} # contact law; default: that of graincrack-solve\n", "law = \"consistent\"");
    return text + other_keys;
}

}  // namespace graincrack
