// The specimen on which the mode I toughness of a rock is measured. Toughness depends on size, and is compared at equal size
// only.
#pragma once

#include <string>
#include <vector>

#include "share/base/toml_table.hpp"

namespace graincrack {

/// [laboratory] mode_i_toughness beside its value, or the specimen of a run. Lengths in m; 0: not known.
struct ToughnessTest {
    std::string method;  ///< "half-disc" and "beam", which graincrack-mesh makes, or another; "": not known
    double size = 0;     ///< diameter; height of a beam
    double notch = 0;
    double span = 0;  ///< of the lower rollers

    /// True if graincrack-mesh can make the same.
    [[nodiscard]] bool is_known() const;
    /// "half-disc, diameter 75 mm, notch 18.75 mm, span 45 mm"; "short-rod, of which no specimen is made here"; "of a size that
    /// the material does not name".
    [[nodiscard]] std::string text() const;
    /// Why the value of a specimen has no verdict beside that of this test: "size not known", "other specimen"; "" if it may have
    /// one: the method is the same, and each length within 5 %, by which a notch along grains may differ.
    [[nodiscard]] std::string caveat(const ToughnessTest& tested) const;
};

/// A half-disc of a diameter with a notch of half its radius and a span of 0.6 diameters, within the ranges of ISRM's suggested
/// method (Kuruppu et al. 2014).
ToughnessTest usual_half_disc(double diameter);

/// The test with what it lacks: notch and span of `usual_half_disc`, of a beam half its height and four heights (ASTM E399).
ToughnessTest completed(ToughnessTest test);

/// The keys of a material, bound to `test`, which must stay where it is.
std::vector<TomlKey> toughness_test_keys(ToughnessTest& test);

}  // namespace graincrack
