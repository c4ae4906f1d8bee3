// Fuzzing: what libFuzzer makes of bytes is read as a user's file or option would be. An input is read or refused with one line;
// whatever else happens (another exception, a crash, a hang, a gigabyte of memory) ends the process, and libFuzzer keeps the
// input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include <unistd.h>

#include "share/base/error.hpp"

namespace graincrack::fuzz {

/// Reads an input; what refuses it must be an error for users, in one line.
template <class Read>
int one_input(const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        const std::string message = error.what();
        if (message.empty() || message.find('\n') != std::string::npos) {
            std::fprintf(stderr, "not one line: %s\n", message.c_str());
            std::abort();
        }
    }
    return 0;
}

/// Text of an input.
inline std::string text_of(const std::uint8_t* bytes, std::size_t size) { return {reinterpret_cast<const char*>(bytes), size}; }

/// A file in memory that belongs to this process; what is read by its name only is written there.
inline std::string scratch_file(const std::string& ending) {
    return "/dev/shm/graincrack-fuzz-" + std::to_string(::getpid()) + ending;
}

/// Writes a text into a scratch file. \return its path
inline std::string written(const std::string& text, const std::string& ending) {
    const std::string path = scratch_file(ending);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

}  // namespace graincrack::fuzz
