// The table [study] of a material, and the names and options of runs.
#pragma once

#include <string>
#include <vector>

#include "post/calibrate/run.hpp"
#include "share/base/toml_file.hpp"

namespace graincrack::calibrate {

/// Reads [study]; without one, the defaults. \param settings values of keys instead of those of the file
/// \throws InputError naming file, line and key for one that is unknown or out of bounds, UsageError for a setting
Study read_study(const Material& rock, const TomlFile& file, const std::vector<std::string>& settings = {});

/// A run as a row of wanted.tsv: the options of graincrack-mesh, of `graincrack-post material with` and of graincrack-solve as
/// they would be typed.
struct RunRow {
    std::string file;
    std::string specimen;
    std::string mesh;
    std::string material;
    std::string solve;
};
/// The file has test, specimen and label of the run, and eight digits that change with its options and with what the rock is made
/// of, so that a run is known by its name.
RunRow row_of(const Material& rock, const Study& study, const WantedRun& run);

}  // namespace graincrack::calibrate
