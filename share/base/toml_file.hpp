// Reads a TOML file into a flat list of keys, and writes texts in TOML. Only this unit uses the TOML library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace graincrack {

/// A value of a TOML file: text, number or boolean.
struct TomlValue {
    enum class Kind { text, number, boolean };
    Kind kind = Kind::text;
    std::string text;  ///< spelt as for an option: text as it is, numbers in their shortest form, "true", "false"
};

/// A place in a TOML file: lines and columns from 1, columns in characters.
struct TomlPlace {
    int line = 0, column = 0;
};

/// A key with its value or array of values.
struct TomlEntry {
    std::vector<std::string> section;  ///< {"rock"} for [rock]; empty at the top
    std::string key;
    std::vector<TomlValue> values;  ///< one value, or the elements of an array
    bool is_array = false;
    int line = 0;
    TomlPlace key_begin, begin, end;  ///< places of the last part of the key, and of the value
};

/// A table, which may be empty.
struct TomlSection {
    std::vector<std::string> name;
    int line = 0;
    bool is_inline = false;  ///< {…}
    TomlPlace begin, end;    ///< place of {…} or [NAME]; without either, of the first [NAME.…] or dotted key
};

struct TomlFile {
    std::string file;
    std::vector<TomlEntry> entries;  ///< sorted by line
    std::vector<TomlSection> sections;
};

/// Reads a TOML file. \throws InputError, naming file and line, if it cannot be read, is not TOML, or has dates, arrays of arrays
/// or arrays of tables, which the programs do not use.
TomlFile read_toml(const std::string& file);

/// Does the same with a text; `name` replaces the file in messages.
TomlFile parse_toml(const std::string& text, const std::string& name);

/// The content of a file in one line, which does not depend on comments or the form of tables.
std::string toml_content(const TomlFile& file);

/// A text in quotes "…", with escapes for special characters.
std::string toml_string(std::string_view text);
/// A text as a value: bare if it is a number that reads back unchanged, otherwise in quotes.
std::string toml_value(const std::string& text);
/// A name as a key: bare if TOML allows it, otherwise in quotes.
std::string toml_key(const std::string& name);

}  // namespace graincrack
