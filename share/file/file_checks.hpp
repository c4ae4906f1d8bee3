// What values read from a file are held against before they are used.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"

namespace graincrack {

/// \throws InputError naming file, dataset and row unless `holds(value)` of every value
template <class T, class Holds>
void require_all(const H5Input& file, const std::string& dataset, const std::vector<T>& values, const char* wanted,
                 const Holds& holds) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!holds(values[i])) {
            throw InputError(
                fmt::format("{}: value {} of dataset {} is {}; {} is needed", file.name(), i, dataset, values[i], wanted));
        }
    }
}

/// Reads a dataset that must have this shape and finite values. \throws InputError
inline std::vector<double> read_finite(const H5Input& file, const std::string& dataset, const Extents& shape) {
    std::vector<double> values = file.read<double>(dataset, shape);
    require_all(file, dataset, values, "a finite number", [](double value) { return std::isfinite(value); });
    return values;
}

/// Rows of a dataset, of which all columns that belong to it must have as many. \throws InputError for a dataset without rows
inline std::size_t rows_of(const H5Input& file, const std::string& dataset) {
    const Extents extents = file.extents(dataset);
    if (extents.empty()) throw InputError(fmt::format("{}: dataset {} has no rows; a list is needed", file.name(), dataset));
    return extents[0];
}

}  // namespace graincrack
