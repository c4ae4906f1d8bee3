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
[platen]
# friction_angle = "5 deg"                # default: 0; rock on steel

[fabric]                                  # grains that graincrack-mesh makes of it unless options say otherwise
# tessellation = "trigon"                 # delaunay: triangles; voronoi: polygons; trigon: polygons that break
# grain_size = "4 mm"                     # mean equal-area diameter
# size_variation = 0.3                    # coefficient of variation, of triangles at most 0.35; default: 0.1
# elements_per_crystal = 8                # of polygons, on average
# elongation = 1                          # long over short axis, 1 to 4
# elongation_angle = "0 deg"              # of the long axis from x

[laboratory]                              # measured values and targets of a calibration; not read by the solver
# young_modulus = "25.8 GPa"
# poisson_ratio = 0.23
# tensile_strength = "8.8 MPa"            # Brazilian
# compressive_strength = "122 MPa"        # UCS
# cohesion = "21 MPa"
# friction_angle = "53 deg"
# grain_size = "4 mm"                     # mean
# min_grain_size = "2 mm"
# max_grain_size = "6 mm"
)toml";

}  // namespace

Rock rock_of_laboratory(const IncompleteMaterial& incomplete, std::vector<std::string>& notes) {
    const Material& material = incomplete.material;
    const auto missing = [&](const char* key) {
        return std::find(incomplete.missing.begin(), incomplete.missing.end(), std::string("rock.") + key) !=
               incomplete.missing.end();
    };
    Rock rock = material.rock;
    const auto measured = [&](const char* key, double& value) {
        if (!missing(key)) return;
        const auto found = material.laboratory.find(key);
        if (found == material.laboratory.end()) {
            throw InputError(fmt::format("{}: neither rock.{} nor laboratory.{} is there; one of them is needed",
                                         material.file.string(), key, key));
        }
        value = found->second;
        notes.push_back(fmt::format("{} of the rock is that of [laboratory]", key));
    };
    measured("young_modulus", rock.young_modulus);
    measured("poisson_ratio", rock.poisson_ratio);
    measured("tensile_strength", rock.tensile_strength);
    const auto assumed = [&](const char* key, double& value, double assumption, const char* source) {
        if (!missing(key)) return;
        value = assumption;
        notes.push_back(fmt::format("{} was not measured: {} {}", key, format_quantity(value, Dimension::toughness), source));
    };
    assumed("mode_i_toughness", rock.mode_i_toughness, rock.tensile_strength / zhang,
            "is tensile_strength/6.88, an empirical mean over many rocks (Zhang 2002)");
    assumed("mode_ii_toughness", rock.mode_ii_toughness, mode_ii_over_mode_i * rock.mode_i_toughness,
            "is 2 K_IC, the ratio of Augig granite");
    return rock;
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
