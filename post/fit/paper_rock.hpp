// The rock of Kazerani & Zhao (2014): what that paper found for it stands beside results for it, and beside no other rock's.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

namespace graincrack {

/// Augig granite, also with words behind its name. \param material its name
inline bool is_rock_of_paper(std::string_view material) { return material.starts_with("Augig granite"); }

/// Means of the paper's model at its calibrated point (Table 8), in the units of the paper.
struct PaperModel {
    /// \param key of [laboratory] \return empty where the paper has none
    [[nodiscard]] std::optional<double> value(std::string_view key) const {
        for (const auto& [name, value] : values) {
            if (name == key) return value;
        }
        return std::nullopt;
    }
    static constexpr std::pair<std::string_view, double> values[]{{"young_modulus", 25.2},          // GPa
                                                                  {"poisson_ratio", 0.24},          //
                                                                  {"tensile_strength", 8.7},        // MPa
                                                                  {"compressive_strength", 125.4},  // MPa
                                                                  {"cohesion", 20.9},               // MPa
                                                                  {"friction_angle", 53.5}};        // °
};

}  // namespace graincrack
