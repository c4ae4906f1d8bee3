// Tables of a TOML file whose keys hold quantities, each bound to where its value goes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/base/toml_file.hpp"

namespace graincrack {

/// A key of a table: the quantity it holds, where its value is stored, and whether it is required; or, in place of a quantity, a
/// word.
struct TomlKey {
    std::string name;
    Quantity quantity;
    std::function<void(double)> set;
    bool needed = false;
    bool found = false;
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

    [[nodiscard]] std::vector<std::string> names() const;
    /// The key of a name, or null.
    [[nodiscard]] TomlKey* find(const std::string& name);
    /// Sets the value of an entry of the table. \return the value, SI; nothing for a word
    /// \throws InputError with file, line, path and key: unknown key, no quantity, value out of bounds
    std::optional<double> read(const std::string& file, const TomlEntry& entry);
};

}  // namespace graincrack
