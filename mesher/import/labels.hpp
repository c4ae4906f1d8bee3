// From a picture whose pixels hold the number of their grain to triangles.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "mesher/import/imported_mesh.hpp"
#include "mesher/import/label_image.hpp"

namespace graincrack::mesher {

struct LabelOptions {
    double pixel_size = 0;  ///< side of a pixel, m
    std::optional<double>
        element_size;         ///< wanted side of triangles, m; else a third of the mean grain's diameter, at least 2 pixels
    int smallest_piece = 10;  ///< pieces of fewer pixels join the neighbour with the longest common border
    bool jagged = false;      ///< boundaries along the sides of pixels
    std::map<int, std::string> phase_by_label;
};

/// Divides the grains of a picture into triangles: each connected piece of one label is a grain. Coordinates are in m, with the
/// origin at the lower left of the picture; the sides of the picture are the lines bottom, right, top and left. Grains have the
/// numbers of their first pixels' order, row by row from the top. Notes say what was joined, opened or divided, and the smallest
/// angle. \param name of the file, for messages \throws InputError as `read_label_image` and `label_pieces`, and if the picture
/// needs too many triangles; UsageError if a size in
///         the options is no positive length
ImportedMesh import_labels(std::string_view bytes, const LabelOptions& options, const std::string& name);

}  // namespace graincrack::mesher
