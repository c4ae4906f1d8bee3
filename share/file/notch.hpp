// The notch of a specimen, as it came out.
#pragma once

#include <array>
#include <optional>

#include "share/file/specimen.hpp"

namespace graincrack {

/// Ends along x, m, of the contacts that are broken from the start (kind `pre_existing_crack`); empty without any.
std::optional<std::array<double, 2>> notch_ends(const Specimen& specimen);

/// A notch that starts from the lower rim.
struct EdgeNotch {
    std::array<double, 2> mouth;  ///< m
    std::array<double, 2> tip;    ///< the highest place of those contacts that the mouth leads to, m
    [[nodiscard]] double length() const { return tip[1] - mouth[1]; }
};
/// Of the contacts that are broken from the start; empty if none of them starts from the lower rim.
std::optional<EdgeNotch> edge_notch(const Specimen& specimen);

}  // namespace graincrack
