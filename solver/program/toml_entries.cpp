#include "solver/program/toml_entries.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "share/base/toml_file.hpp"

namespace graincrack {
namespace {

template <class Item, class Text>
std::string list(const std::vector<Item>& items, const Text& text_of) {
    std::vector<std::string> texts;
    for (const Item& item : items) texts.push_back(text_of(item));
    return fmt::format("[{}]", fmt::join(texts, ", "));
}

}  // namespace

std::string toml_number(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

void TomlEntries::given(const std::string& key, const std::string& value) {
    if (!value.empty()) add(key, toml_string(value));
}

void TomlEntries::given(const std::string& key, const std::vector<std::string>& value) {
    if (!value.empty()) add(key, list(value, toml_string));
}

void TomlEntries::given(const std::string& key, const Quantity& of, const std::optional<double>& value, const char* none) {
    if (value && *value == 0 && none != nullptr) {
        add(key, toml_string(none));
    } else if (value) {
        given(key, of, *value);
    }
}

void TomlEntries::given(const std::string& key, const Quantity& /*of*/, const std::vector<double>& value) {
    if (value.empty()) return;
    add(key, list(value, toml_number));
}

std::string TomlEntries::lines(const std::string& before) const {
    std::string lines;
    for (const auto& [key, value] : entries_) lines += fmt::format("{}{} = {}\n", before, key, value);
    return lines;
}

std::string TomlEntries::inline_table() const {
    std::vector<std::string> items;
    for (const auto& [key, value] : entries_) items.push_back(fmt::format("{} = {}", key, value));
    return fmt::format("{{ {} }}", fmt::join(items, ", "));
}

}  // namespace graincrack
