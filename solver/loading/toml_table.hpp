// A table of a TOML file that is asked for its keys one by one; what nobody asked for is refused.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/base/toml_file.hpp"

namespace graincrack {

class TomlTable {
public:
    explicit TomlTable(const TomlFile& file);

    [[nodiscard]] const std::string& path() const { return path_; }  ///< "stage.load", "" for the whole file
    [[nodiscard]] bool has(const std::string& key) const;            ///< a value or a table
    [[nodiscard]] bool has_value(const std::string& key) const;
    /// "file: line 12: stage.load.until", for messages.
    [[nodiscard]] std::string where(const std::string& key = "") const;

    // Each is empty where the key is missing, and throws InputError where it is something else.
    std::optional<std::string> text(const std::string& key);
    std::optional<std::vector<std::string>> texts(const std::string& key);  ///< one text, or an array of them
    std::optional<bool> flag(const std::string& key);
    std::optional<double> quantity(const std::string& key, const Quantity& quantity);
    /// Whether the value is this word.
    bool is_word(const std::string& key, const std::string& word);
    /// The same where a word stands for a value.
    std::optional<double> quantity_or(const std::string& key, const std::string& word, double word_value,
                                      const Quantity& quantity);
    std::optional<std::vector<double>> quantities(const std::string& key, const Quantity& quantity);  ///< an array
    std::optional<TomlTable> table(const std::string& key);
    /// The tables in this one, by their names in the order of the file.
    std::vector<TomlTable> tables();

    // The same, and an InputError that says `what` where the key is missing.
    std::string needed_text(const std::string& key, const std::string& what);
    double needed_quantity(const std::string& key, const Quantity& quantity, const std::string& what);
    TomlTable needed_table(const std::string& key, const std::string& what);

    [[nodiscard]] std::string name() const;  ///< last part of the path
    /// Refuses every key that was not asked for. \throws InputError
    void refuse_others() const;
    [[noreturn]] void refuse(const std::string& key, const std::string& wrong_and_right) const;

private:
    TomlTable(std::shared_ptr<const TomlFile> file, std::vector<std::string> section);
    [[nodiscard]] const TomlEntry* entry(const std::string& key) const;
    [[nodiscard]] bool has_table(const std::string& key) const;
    [[nodiscard]] std::vector<std::pair<int, std::string>> keys() const;  ///< line and name of values and tables
    [[nodiscard]] bool is_inside(const std::vector<std::string>& section) const;

    std::shared_ptr<const TomlFile> file_;
    std::vector<std::string> section_;
    std::string path_;
    std::vector<std::string> asked_;
};

}  // namespace graincrack
