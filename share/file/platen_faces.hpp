// Where the faces of the platens are at the start of a run: rollers and punches, or platens as wide as what they load.
#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack {

class H5Input;
class H5Output;

/// The face of a roller, punch or platen.
struct PlatenFace {
    double side = 1;             ///< +1: of the top platen, −1: of the bottom one
    double left = 0, right = 0;  ///< ends across the direction of the platens, m
    double position = 0;         ///< along that direction, m
    friend bool operator==(const PlatenFace&, const PlatenFace&) = default;
};

struct PlatenFaceSet {
    double direction = std::numbers::pi / 2;  ///< along which the platens move, from x, rad
    std::vector<PlatenFace> faces;
    /// Displacement of a face whose platen has approached the specimen, m.
    [[nodiscard]] std::array<double, 2> displacement(const PlatenFace& face, double approach) const;
    /// Corners of a bar of some thickness outside a face, whose platen has approached; m. The first two lie on the face.
    [[nodiscard]] std::array<std::array<double, 2>, 4> bar(const PlatenFace& face, double thickness, double approach) const;
};

/// Writes /platens. \pre all ends are finite
void write_platen_faces(H5Output& file, const PlatenFaceSet& set);
/// Those of a run; where it has no /platens, platens as wide as what they load (`loaded_width`). \throws InputError
PlatenFaceSet read_platen_faces(const H5Input& file, const Specimen& specimen);

}  // namespace graincrack
