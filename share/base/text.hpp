// Parts of texts and files as texts, texts from outside as they are shown, words that are near, and names of the values of an
// enumeration.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace graincrack {

/// The text without blanks, tabs and line ends around it.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The parts of a text between separators, one more than there are separators. They are parts of `text`, which must outlive them.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;; text.remove_prefix(parts.back().size() + 1)) {
        parts.push_back(text.substr(0, text.find(separator)));
        if (parts.back().size() == text.size()) return parts;
    }
}

/// Both sides of the first = of a text; the second is empty where there is none.
inline std::pair<std::string, std::string> sides_of_equals(std::string_view text) {
    const std::string_view key = text.substr(0, text.find('='));
    return {std::string(key), std::string(key.size() < text.size() ? text.substr(key.size() + 1) : "")};
}

/// The sides of KEY=VALUE, of which the first is not empty. \param option as messages name it, "--set" \param form "KEY=VALUE"
/// \throws UsageError "--set TEXT: KEY=VALUE is needed"
std::pair<std::string, std::string> key_and_value(std::string_view text, std::string_view option, std::string_view form);

/// A text that comes from outside, with what a terminal, a table or a page would obey as `\x1b` or `\u202e`.
std::string printable(std::string_view text);
/// A text of at most about `limit` bytes: of a longer one its first two thirds of that and its end, between whole characters.
std::string shortened(std::string_view text, std::size_t limit);

/// Most bytes of a text that is read: a table or a mesh, and a material, program or configuration.
inline constexpr std::size_t longest_text = std::size_t{1} << 29U;
inline constexpr std::size_t longest_toml = std::size_t{1} << 24U;

/// The bytes of a stream. \param name of messages \param needed end of messages, "; a TOML file is needed"
/// \throws InputError if it cannot be read, or has more bytes than `limit`
std::string text_of_stream(std::istream& stream, const std::string& name, std::size_t limit = longest_text,
                           const std::string& needed = "");
/// The bytes of a file. What can be read only once, a named pipe, gives the same at each call. \throws InputError as above
std::string text_of_file(const std::string& file, std::size_t limit = longest_text, const std::string& needed = "");
/// The bytes of a TOML file. \throws InputError as above
inline std::string text_of_toml(const std::string& file) { return text_of_file(file, longest_toml, "; a TOML file is needed"); }

/// " (did you mean …?)" with the nearest of the known words, or nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

/// The name of a value of an enumeration. \param names in the order of the values
template <class Value>
const char* name_in(std::initializer_list<const char*> names, Value value) {
    return *(names.begin() + static_cast<std::ptrdiff_t>(value));
}

}  // namespace graincrack
