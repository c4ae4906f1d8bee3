// Writes vectors as datasets of a file, and checks values that are read from one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/schema.hpp"

namespace graincrack {

/// Storage of an element of a vector: a number, or a row of several.
template <class T>
struct Stored {
    using Number = T;
    static constexpr std::size_t width = 1;
};
template <class T, std::size_t n>
struct Stored<std::array<T, n>> {
    using Number = T;
    static constexpr std::size_t width = n;
};
/// Shape of the dataset of a vector of T.
template <class T>
Extents extents_of(std::size_t rows) {
    return Stored<T>::width == 1 ? Extents{rows} : Extents{rows, Stored<T>::width};
}
template <class T>
void write_rows(H5Output& file, const schema::Dataset& dataset, const std::vector<T>& rows) {
    using Number = typename Stored<T>::Number;
    std::span<const Number> numbers;
    if constexpr (Stored<T>::width == 1) {
        numbers = rows;
    } else {
        numbers = flat(rows);
    }
    file.write<Number>(dataset.path, numbers, extents_of<T>(rows.size()), dataset.unit, dataset.description);
}
/// Converts the numbers of a dataset to a vector of T.
template <class T>
std::vector<T> rows_from(const std::vector<typename Stored<T>::Number>& numbers) {
    if constexpr (Stored<T>::width == 1) {
        return numbers;
    } else {
        constexpr std::size_t width = Stored<T>::width;
        std::vector<T> rows(numbers.size() / width);
        for (std::size_t i = 0; i < rows.size(); ++i) std::copy_n(numbers.data() + i * width, width, rows[i].begin());
        return rows;
    }
}

/// Checks that `holds(value)` for every value. \throws InputError naming file, dataset and index of the first other value
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

/// Number of rows of a dataset, and of all columns of its table. \throws InputError for a dataset without rows
inline std::size_t rows_of(const H5Input& file, const std::string& dataset) {
    const Extents extents = file.extents(dataset);
    if (extents.empty()) throw InputError(fmt::format("{}: dataset {} has no rows; a list is needed", file.name(), dataset));
    return extents[0];
}

}  // namespace graincrack
