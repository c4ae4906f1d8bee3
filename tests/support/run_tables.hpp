// Runs in a folder, and tables of them as texts.
#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/support/synthetic_run.hpp"

namespace graincrack::test {

/// Tests with runs in a folder of their own.
class RunFolder : public testing::Test {
protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.file(name); }
    /// Writes a run. \return its file
    std::string run(const std::string& name, const Recipe& recipe = {}) const {
        write_run(path(name), recipe);
        return path(name);
    }
    TemporaryFolder folder_;
};

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
