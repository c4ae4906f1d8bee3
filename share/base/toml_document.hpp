// A TOML file as text in which single values are set. Every other byte stays: tables, comments and their order.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "share/base/toml_file.hpp"

namespace graincrack {

class TomlDocument {
public:
    /// A key with its tables, {"contact", "cohesion"}, or a table, {"contact"}.
    using Path = std::vector<std::string>;

    /// \param name of the file, for messages \throws InputError as `parse_toml`
    TomlDocument(std::string text, const std::string& name);
    [[nodiscard]] const std::string& text() const { return text_; }

    /// A value as spelt in the file, `"70 MPa"`, or a table in braces; empty if the key has neither.
    [[nodiscard]] std::optional<std::string> value(const Path& key) const;
    [[nodiscard]] bool has_table(const Path& table) const;

    /// Sets a value. A new key replaces its example, a line `# KEY = …` of its table, whose comment stays; without an example it
    /// follows the keys of its table, and a new table is added at the end. \param value as spelt in TOML \param is_remarked adds
    /// a comment with the former value, before an existing comment, or
    ///        "added", for keys with a line of their own
    /// \throws InputError if a table has this name, or the present content leaves no place for the key
    void set(const Path& key, const std::string& value, bool is_remarked = false);
    /// Adds an empty table at the end. \param comment behind its name; "" for none
    void add_table(const Path& table, const std::string& comment = "");
    /// Removes a key with the lines of its value. \throws InputError if these lines have other keys too
    void remove(const Path& key);

private:
    [[nodiscard]] const TomlEntry* entry(const Path& key) const;
    /// The innermost table in braces that is or contains this table; null if there is none.
    [[nodiscard]] const TomlSection* row(const Path& table) const;
    [[nodiscard]] const TomlSection* header(const Path& table) const;  ///< header [NAME]; null if there is none
    [[nodiscard]] std::size_t byte(TomlPlace place) const;
    /// The place of the example of a key.
    [[nodiscard]] std::optional<std::size_t> example(const Path& key) const;
    void put(const Path& key, const std::string& line);
    void insert_line(std::size_t behind, const std::string& line);
    void remark(const Path& key, const std::string& words);
    void replace(std::size_t begin, std::size_t end, const std::string& by);

    std::string text_;
    TomlFile toml_;
};

}  // namespace graincrack
