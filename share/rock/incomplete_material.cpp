#include "share/rock/incomplete_material.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

constexpr double zhang = 6.88;                     // 1/√m: σt = 6.88 K_IC over many rocks (Zhang 2002)
constexpr double mode_ii_over_mode_i = 3.0 / 1.5;  // of Augig granite

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

}  // namespace graincrack
