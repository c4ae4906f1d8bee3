// A TOML file as text in which single values are set. All else stays as it stands, byte by byte: tables, comments, their order.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "share/base/toml_file.hpp"

namespace graincrack {

class TomlDocument {
public:
    /// The tables of a key and its name, {"contact", "cohesion"}; of a table, {"contact"}.
    using Path = std::vector<std::string>;

    /// \param name of the file, for messages \throws InputError as `parse_toml`
    TomlDocument(std::string text, const std::string& name);
    [[nodiscard]] const std::string& text() const { return text_; }

    /// A value as it stands in the file, `"70 MPa"`, or a table in braces; empty if the key has neither.
    [[nodiscard]] std::optional<std::string> value(const Path& key) const;
    [[nodiscard]] bool has_table(const Path& table) const;

    /// Sets a value. A key that is not there takes the place of its example, a line `# KEY = …` of its table, whose comment
    /// stays; else it comes behind the keys of its table, and a table that is not there at the end. \param value as TOML writes
    /// it \param is_remarked a comment has the former value, before a comment that the line had, or
    ///        "added"; of keys with a line of their own
    /// \throws InputError where a table has this name, or what stands there leaves no place for the key
    void set(const Path& key, const std::string& value, bool is_remarked = false);
    /// Adds an empty table at the end. \param comment behind its name; "": none
    void add_table(const Path& table, const std::string& comment = "");
    /// Takes a key out, with the lines of its value. \throws InputError if they have other keys too
    void remove(const Path& key);

private:
    [[nodiscard]] const TomlEntry* entry(const Path& key) const;
    /// The table in braces that this one is, or the innermost one around it; null if it is in none.
    [[nodiscard]] const TomlSection* row(const Path& table) const;
    [[nodiscard]] const TomlSection* header(const Path& table) const;  ///< its [NAME]; null if it has none
    [[nodiscard]] std::size_t byte(TomlPlace place) const;
    /// Where the example of a key stands.
    [[nodiscard]] std::optional<std::size_t> example(const Path& key) const;
    void put(const Path& key, const std::string& line);
    void insert_line(std::size_t behind, const std::string& line);
    void remark(const Path& key, const std::string& words);
    void replace(std::size_t begin, std::size_t end, const std::string& by);

    std::string text_;
    TomlFile toml_;
};

}  // namespace graincrack
