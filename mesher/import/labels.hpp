// Turns a picture whose pixels are grain numbers into triangles.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/import/imported_mesh.hpp"
#include "mesher/import/label_image.hpp"
#include "mesher/import/label_table.hpp"
#include "mesher/import/phase_key.hpp"

namespace graincrack::mesher {

struct LabelOptions {
    double pixel_size = 0;  ///< side of a pixel, m
    std::optional<double>
        element_size;         ///< requested side of triangles, m; missing: a third of the mean grain diameter, ≥ 2 pixels
    int smallest_piece = 10;  ///< pieces of fewer pixels join the neighbour with the longest common border
    PhaseKey::OfLabels phases;
};

/// Returns the labels of a picture (`label_rows`) after small pieces have joined their neighbours. It needs no sizes of pixels
/// and elements. \throws InputError as `read_label_image`, `label_pieces` and `label_rows`
std::vector<LabelRow> labels_of(std::string_view bytes, const LabelOptions& options, const std::string& name);

/// Divides the grains of a picture into triangles: each connected piece of one label is a grain. Coordinates are in m, with the
/// origin at the lower left. Grains are numbered by their first pixels, row by row from the top. Notes name joined, opened and
/// divided pieces, and pixels that took a colour of the key. \param name of the file, for messages
/// \throws InputError as `read_label_image` and `label_pieces`, and if the picture needs too many triangles, or the key has
/// phases but none for one of its labels
ImportedMesh import_labels(std::string_view bytes, const LabelOptions& options, const std::string& name);

}  // namespace graincrack::mesher
