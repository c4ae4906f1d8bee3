// What tables of a TOML file hold: keys bound to where their values go.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "share/base/quantities.hpp"

namespace graincrack {

/// A key of a table: the quantity it holds, where its value is stored, and whether it is required; or, in place of a quantity, a
/// word.
struct TomlKey {
    std::string name;
    Quantity quantity;
    std::function<void(double)> set;
    bool needed = false;
    std::vector<std::string> words = {};                         ///< that a key of a word may have; none: any
    std::function<void(const std::string&)> set_word = nullptr;  ///< of a key of a word

    [[nodiscard]] bool is_word() const { return set_word != nullptr; }
    /// \throws InputError unless a key of a word may have it
    void require_word(const std::string& word, const std::string& where) const;
};

/// A table, called by its path: "contact", "pairs.quartz-mica".
struct TomlKeys {
    std::string path;
    std::vector<TomlKey> keys;
};

}  // namespace graincrack
