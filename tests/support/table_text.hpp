// Tables as texts, and the numbers in them.
#pragma once

#include <sstream>
#include <string>

#include "tests/support/synthetic_run.hpp"

namespace graincrack::test {

/// What `write(stream, arguments…)` writes to a stream.
template <class Write, class... Arguments>
std::string written(const Write& write, Arguments&&... arguments) {
    std::ostringstream out;
    write(out, arguments...);
    return out.str();
}

/// The number in a named column of a table's data row.
inline double number_in(const std::string& tsv, const std::string& column, std::size_t row = 0) {
    return std::stod(field(tsv, column, row));
}

}  // namespace graincrack::test
