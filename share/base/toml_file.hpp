// A TOML file as a flat list of keys. The only file that uses the TOML library.
#pragma once

#include <string>
#include <vector>

namespace graincrack {

/// A value of a TOML file: text, number or boolean.
struct TomlValue {
    enum class Kind { text, number, boolean };
    Kind kind = Kind::text;
    std::string text;  ///< as an option would be given: text as it stands, numbers in their shortest form, "true", "false"
};

/// A key with its value or array of values.
struct TomlEntry {
    std::vector<std::string> section;  ///< {"rock"} for [rock]; empty at the top
    std::string key;
    std::vector<TomlValue> values;  ///< one, or the elements of an array
    bool is_array = false;
    int line = 0;
};

/// A table, which may be empty.
struct TomlSection {
    std::vector<std::string> name;
    int line = 0;
};

struct TomlFile {
    std::string file;
    std::vector<TomlEntry> entries;  ///< sorted by line
    std::vector<TomlSection> sections;
};

/// Reads a TOML file. \throws InputError, naming file and line, if it cannot be read, is not TOML, or holds dates, arrays of
/// arrays or arrays of tables, which nothing here uses.
TomlFile read_toml(const std::string& file);

/// The same from text; `name` stands for the file in messages.
TomlFile parse_toml(const std::string& text, const std::string& name);

}  // namespace graincrack
