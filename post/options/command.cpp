#include "post/options/command.hpp"

#include <fmt/format.h>

#include <iostream>

#include "share/base/error.hpp"

namespace graincrack {

const std::string& Call::file() const {
    if (files.size() == 1) return files.front();
    throw UsageError(fmt::format("{}: takes one file, not {}", command, files.size()));
}

std::ostream& Call::diagnostics() const {
    static std::ostream nowhere(nullptr);
    return verbosity == Verbosity::quiet ? nowhere : std::cerr;
}

}  // namespace graincrack
