// Splits texts, reads files as texts, makes foreign texts printable, finds similar words, and names the values of enumerations.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace graincrack {

/// The text without surrounding blanks, tabs and line ends.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The parts of a text between separators, one more than separators. They are views of `text`, which must outlive them.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;; text.remove_prefix(parts.back().size() + 1)) {
        parts.push_back(text.substr(0, text.find(separator)));
        if (parts.back().size() == text.size()) return parts;
    }
}

/// Both sides of the first = of a text; the second is empty without a =.
inline std::pair<std::string, std::string> sides_of_equals(std::string_view text) {
    const std::string_view key = text.substr(0, text.find('='));
    return {std::string(key), std::string(key.size() < text.size() ? text.substr(key.size() + 1) : "")};
}

/// The sides of KEY=VALUE, of which the first is not empty. \param option its name in messages, "--set" \param form "KEY=VALUE"
/// \throws UsageError "--set TEXT: KEY=VALUE is needed"
std::pair<std::string, std::string> key_and_value(std::string_view text, std::string_view option, std::string_view form);

/// Replaces characters of a foreign text that a terminal, a table or a page would interpret, as in `\x1b` or `\u202e`.
std::string printable(std::string_view text);
/// Shortens a longer text to about `limit` bytes, cut between characters: its beginning (two thirds) and its end.
std::string shortened(std::string_view text, std::size_t limit);

/// Largest size of input texts, bytes: of a table or mesh, and of a material, program or configuration.
inline constexpr std::size_t longest_text = std::size_t{1} << 29U;
inline constexpr std::size_t longest_toml = std::size_t{1} << 24U;

/// Returns the bytes of a stream. \param name in messages \param needed end of messages, "; a TOML file is needed"
/// \throws InputError if it cannot be read, or has more bytes than `limit`
std::string text_of_stream(std::istream& stream, const std::string& name, std::size_t limit = longest_text,
                           const std::string& needed = "");
/// Returns the bytes of a file, the same at each call also of a named pipe, which can be read only once. \throws InputError as
/// above
std::string text_of_file(const std::string& file, std::size_t limit = longest_text, const std::string& needed = "");
/// Returns the bytes of a TOML file. \throws InputError as above
inline std::string text_of_toml(const std::string& file) { return text_of_file(file, longest_toml, "; a TOML file is needed"); }

/// Returns " (did you mean …?)" with the nearest known word, or "". The cost grows with the product of the words' lengths.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// The name of a value of an enumeration. \param names in the order of the values
template <class Value>
const char* name_in(std::initializer_list<const char*> names, Value value) {
    return *(names.begin() + static_cast<std::ptrdiff_t>(value));
}

}  // namespace graincrack
