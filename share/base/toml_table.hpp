// Tables of a TOML file: keys with the targets of their values, and a table whose keys are queried one by one, so that keys which
// were never queried can be refused.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/base/toml_file.hpp"

namespace graincrack {

/// A key of a table with its quantity, or word, the target of its value, and whether it is required.
struct TomlKey {
    std::string name;
    Quantity quantity;
    std::function<void(double)> set;
    bool needed = false;
    std::vector<std::string> words = {};                         ///< words that the key may have; empty: any
    std::function<void(const std::string&)> set_word = nullptr;  ///< target of a word
    std::vector<double>* values = nullptr;  ///< target of an array, which is required unless the key has `set`

    [[nodiscard]] bool is_word() const { return set_word != nullptr; }
    /// Checks that the key may have a word. \throws InputError if it may not
    void require_word(const std::string& word, const std::string& where) const;
};

/// The target of a value: a number or an optional number.
template <class Target>
std::function<void(double)> to(Target& target) {
    return [&target](double value) { target = value; };
}

/// A key for a word. \param words the allowed words; empty: any
inline TomlKey word_key(const char* name, std::vector<std::string> words, std::function<void(const std::string&)> set) {
    return {name, {}, {}, false, std::move(words), std::move(set)};
}

/// The keys of a table, identified by its path: "contact", "pairs.quartz-mica".
struct TomlKeys {
    std::string path;
    std::vector<TomlKey> keys;
};

/// A table of a file that is read.
class TomlTable {
public:
    explicit TomlTable(const TomlFile& file);

    [[nodiscard]] const std::string& path() const { return path_; }  ///< "stage.load", "" for the whole file
    [[nodiscard]] const std::vector<std::string>& section() const { return section_; }
    [[nodiscard]] std::string shown(const std::string& key) const;  ///< the text of a value or the first of several
    [[nodiscard]] bool has(const std::string& key) const;           ///< a value or a table
    [[nodiscard]] bool has_value(const std::string& key) const;
    [[nodiscard]] bool has_array(const std::string& key) const;
    /// The place of a key in messages: "file: line 12: stage.load.until".
    [[nodiscard]] std::string where(const std::string& key = "") const;

    // Functions for the rows of `program/keys.hpp`. A missing key leaves the value unchanged or, if it is needed, is refused with
    // the message `what`. Each throws InputError if the key has a value of another type.
    static constexpr bool reads = true;
    void given(const std::string& key, std::string& value);
    void given(const std::string& key, std::vector<std::string>& value);  ///< also accepts one text
    void given(const std::string& key, bool& value);
    void given(const std::string& key, const Quantity& quantity, double& value);
    void given(const std::string& key, const Quantity& quantity, std::int64_t& value);
    /// \param none word for 0, if there is one
    void given(const std::string& key, const Quantity& quantity, std::optional<double>& value, const char* none = nullptr);
    void given(const std::string& key, const Quantity& quantity, std::vector<double>& value);
    /// \param fits message for another number of values
    template <std::size_t N>
    void given(const std::string& key, const Quantity& quantity, std::optional<std::array<double, N>>& value, const char* fits) {
        std::vector<double> values;
        given(key, quantity, values);
        if (!has(key)) return;
        if (values.size() != N) refuse(key, fits);
        std::copy(values.begin(), values.end(), value.emplace().begin());
    }
    /// Reads one of two words.
    void choice(const std::string& key, bool& value, const std::string& word_of_false, const std::string& word_of_true);
    template <class Value>
    void needed(const std::string& key, Value& value, const std::string& what) {
        require(key, what);
        given(key, value);
    }
    void needed(const std::string& key, const Quantity& quantity, double& value, const std::string& what) {
        require(key, what);
        given(key, quantity, value);
    }

    /// True if the value is this word.
    bool is_word(const std::string& key, const std::string& word);
    std::optional<TomlTable> table(const std::string& key);
    TomlTable needed_table(const std::string& key, const std::string& what);
    /// The tables in this one, in the order of the file.
    std::vector<TomlTable> tables();

    [[nodiscard]] std::string name() const;  ///< last part of the path
    /// Refuses every key that was not queried. \throws InputError
    void refuse_others() const;
    [[noreturn]] void refuse(const std::string& key, const std::string& wrong_and_right) const;

private:
    /// The entry of a key, or null. \throws InputError with the message `otherwise` if it is a table or does not fit
    const TomlEntry* asked(const std::string& key, bool (*fits)(const TomlEntry&), const std::string& otherwise);
    void require(const std::string& key, const std::string& what);
    [[nodiscard]] double number(const std::string& key, const TomlValue& value, const Quantity& quantity) const;
    TomlTable(std::shared_ptr<const TomlFile> file, std::vector<std::string> section);
    [[nodiscard]] const TomlEntry* entry(const std::string& key) const;
    [[nodiscard]] bool has_table(const std::string& key) const;
    [[nodiscard]] std::vector<std::pair<int, std::string>> keys() const;  ///< line and name of values and tables
    [[nodiscard]] bool is_inside(const std::vector<std::string>& section) const;

    std::shared_ptr<const TomlFile> file_;
    std::vector<std::string> section_;
    std::string path_;
    std::set<std::string> asked_;
};

}  // namespace graincrack
