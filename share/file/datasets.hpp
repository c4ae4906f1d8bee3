// Lists the datasets of files for other programs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "share/file/schema.hpp"

namespace graincrack {

/// Path of a dataset, or name of a column of a table, with unit and meaning.
struct NamedValue {
    std::string name, unit, meaning;
};

/// The datasets of a file of kind "specimen" or "run"; those of each frame are in /frames/NNNN.
std::vector<NamedValue> datasets_of(const std::string& kind);

/// Visits the datasets of a specimen, of the crack log, or of one frame.
using VisitDataset = std::function<void(const schema::Dataset&)>;
void visit_specimen_datasets(const VisitDataset& visit);
void visit_crack_datasets(const VisitDataset& visit);
void visit_frame_datasets(const VisitDataset& visit);

}  // namespace graincrack
