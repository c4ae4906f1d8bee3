// Places of the platens' faces at the start of a run: rollers and punches, or platens as wide as the loaded faces.
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
    double side = 1;             ///< +1 for the top platen, −1 for the bottom platen
    double left = 0, right = 0;  ///< ends across the direction of the platens, m
    double position = 0;         ///< position along the direction, m
    friend bool operator==(const PlatenFace&, const PlatenFace&) = default;
};

struct PlatenFaceSet {
    double direction = std::numbers::pi / 2;  ///< direction of platen motion from x, rad
    std::vector<PlatenFace> faces;
    /// Displacement of a face when its platen has moved by `approach` (m), m.
    [[nodiscard]] std::array<double, 2> displacement(const PlatenFace& face, double approach) const;
    /// Corners of a bar outside a face when its platen has moved by `approach`, m. The first two lie on the face.
    [[nodiscard]] std::array<std::array<double, 2>, 4> bar(const PlatenFace& face, double thickness, double approach) const;
};

/// Writes /platens. \pre all ends are finite
void write_platen_faces(H5Output& file, const PlatenFaceSet& set);
/// Reads the faces of a run; without /platens they are as wide as what they load (`loaded_width`). \throws InputError
PlatenFaceSet read_platen_faces(const H5Input& file, const Specimen& specimen);

}  // namespace graincrack
