// The labels of a picture as a table, which can be edited into a key of phases.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesher/import/phase_key.hpp"

namespace graincrack::mesher {

struct LabelImage;
struct LabelPieces;

struct LabelRow {
    int label = 0;
    std::optional<int> colour;  ///< 65536 red + 256 green + blue
    std::string phase;          ///< "" without a phase in a key
    double share_of_area = 0;
    int pieces = 0;  ///< number of pieces, each of which is a grain
};

/// The labels of pieces, by descending area. \param name of the file, for messages
/// \throws InputError if a label has one phase by its number and another by its colour
std::vector<LabelRow> label_rows(const LabelImage& image, const LabelPieces& pieces, const PhaseKey::OfLabels& phases,
                                 const std::string& name);

/// The largest labels, one line each, and the number of others.
std::vector<std::string> describe_labels(const std::vector<LabelRow>& rows);

/// A key (`PhaseKey`) with one row per label, whose phases are still to be entered unless the rows have them. Keys are colours if
/// these differ and are not all greys, otherwise numbers. \param source of the picture, for a comment
std::string key_of_labels(const std::vector<LabelRow>& rows, const std::string& source);

}  // namespace graincrack::mesher
