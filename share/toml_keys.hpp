// Tables of a TOML file whose keys hold quantities, each bound to where its value goes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "share/quantities.hpp"
#include "share/toml_file.hpp"

namespace graincrack {

/// A key of a table: the quantity it holds, where its value is stored, and whether it is required.
struct TomlKey {
    std::string name;
    Quantity quantity;
    std::function<void(double)> set;
    bool needed = false;
    bool found = false;
};

/// A table, called by its path: "contact", "pairs.quartz-mica".
struct TomlKeys {
    std::string path;
    std::vector<TomlKey> keys;

    [[nodiscard]] std::vector<std::string> names() const;
    /// Sets the value of an entry of the table. \return the value, SI
    /// \throws InputError with file, line, path and key: unknown key, no quantity, value out of bounds
    double read(const std::string& file, const TomlEntry& entry);
};

/// " (did you mean …?)" with the nearest of the known words, or nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace graincrack
