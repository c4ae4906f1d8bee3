// A TOML file as a flat list of keys, and texts as TOML writes them. The only file that uses the TOML library.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace graincrack {

/// A value of a TOML file: text, number or boolean.
struct TomlValue {
    enum class Kind { text, number, boolean };
    Kind kind = Kind::text;
    std::string text;  ///< as an option would be given: text as it stands, numbers in their shortest form, "true", "false"
};

/// A place in a TOML file: lines and columns from 1, columns in characters.
struct TomlPlace {
    int line = 0, column = 0;
};

/// A key with its value or array of values.
struct TomlEntry {
    std::vector<std::string> section;  ///< {"rock"} for [rock]; empty at the top
    std::string key;
    std::vector<TomlValue> values;  ///< one, or the elements of an array
    bool is_array = false;
    int line = 0;
    TomlPlace key_begin, begin, end;  ///< of the last part of the key, and of the value
};

/// A table, which may be empty.
struct TomlSection {
    std::vector<std::string> name;
    int line = 0;
    bool is_inline = false;  ///< {…}
    TomlPlace begin, end;    ///< of {…} or [NAME]; of the first [NAME.…] or key with dots where a table has neither
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

/// What a file says, in one line: neither comments nor the form of tables count.
std::string toml_content(const TomlFile& file);

/// A text in quotes, "…", with what may not stand there as an escape.
std::string toml_string(std::string_view text);
/// A text as a value: bare where it is a number that reads back unchanged, else in quotes.
std::string toml_value(const std::string& text);
/// A name as a key: bare where TOML allows it, else in quotes.
std::string toml_key(const std::string& name);

}  // namespace graincrack
