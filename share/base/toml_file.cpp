#include "share/base/toml_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }
TomlPlace place(const toml::source_position& at) { return {static_cast<int>(at.line), static_cast<int>(at.column)}; }

TomlValue value_of(const toml::node& node, const std::string& file, std::string_view key) {
    if (const auto* text = node.as_string()) return {TomlValue::Kind::text, text->get()};
    if (const auto* number = node.as_integer()) return {TomlValue::Kind::number, fmt::format("{}", number->get())};
    if (const auto* number = node.as_floating_point()) return {TomlValue::Kind::number, format_number(number->get())};
    if (const auto* flag = node.as_boolean()) return {TomlValue::Kind::boolean, flag->get() ? "true" : "false"};
    throw InputError(fmt::format("{}: line {}: {} is a {}; a text, a number, true, false or an array of these fits", file,
                                 line_of(node), key,
                                 node.is_table()   ? "table in an array"
                                 : node.is_array() ? "nested array"
                                                   : "date or time"));
}

constexpr std::size_t max_nesting = 200;  // dots in a key; the programs' own keys have three parts

/// Refuses deeply nested keys: the parser nests tables by the dots of a key, and freeing them needs stack for each.
/// \throws InputError for a key with more than `max_nesting` dots
void require_shallow_keys(const std::string& text, const std::string& file) {
    int line = 1;
    std::size_t dots = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '\n') ++line;
        if (c == '"' || c == '\'') {  // dots in quotes do not count
            std::size_t end = at + 1;
            while (end < text.size() && text[end] != c && text[end] != '\n') end += c == '"' && text[end] == '\\' ? 2 : 1;
            at = end < text.size() && text[end] == '\n' ? end - 1 : end;
        } else if (c == '\n' || std::string_view("=,[]{}").find(c) != std::string_view::npos) {
            dots = 0;
        } else if (c == '.' && ++dots > max_nesting) {
            throw InputError(
                fmt::format("{}: line {}: a key has more than {} dots; none here has more than two", file, line, max_nesting));
        }
    }
}

void flatten(const toml::table& table, const std::vector<std::string>& section, TomlFile& out) {
    for (const auto& [key, node] : table) {
        const std::string name(key.str());
        if (section.size() > max_nesting) {
            throw InputError(fmt::format("{}: line {}: tables are nested deeper than {}; two are enough for all that is read",
                                         out.file, line_of(node), max_nesting));
        }
        if (const auto* sub = node.as_table()) {
            std::vector<std::string> below = section;
            below.push_back(name);
            out.sections.push_back(
                {below, line_of(node), sub->is_inline(), place(node.source().begin), place(node.source().end)});
            flatten(*sub, below, out);
            continue;
        }
        TomlEntry entry{section,
                        name,
                        {},
                        node.is_array(),
                        line_of(node),
                        place(key.source().begin),
                        place(node.source().begin),
                        place(node.source().end)};
        if (const auto* array = node.as_array()) {
            for (const toml::node& element : *array) entry.values.push_back(value_of(element, out.file, name));
        } else {
            entry.values.push_back(value_of(node, out.file, name));
        }
        out.entries.push_back(std::move(entry));
    }
}

}  // namespace

TomlFile parse_toml(const std::string& text, const std::string& name) {
    TomlFile out;
    out.file = name;
    require_shallow_keys(text, name);
    try {
        const toml::table table = toml::parse(text, name);
        flatten(table, {}, out);
    } catch (const toml::parse_error& error) {
        std::string reason(error.description());
        std::replace(reason.begin(), reason.end(), '\n', ' ');
        throw InputError(fmt::format("{}: line {}: not TOML: {}", name, error.source().begin.line, reason));
    }
    std::stable_sort(out.entries.begin(), out.entries.end(),
                     [](const TomlEntry& a, const TomlEntry& b) { return a.line < b.line; });
    std::stable_sort(out.sections.begin(), out.sections.end(),
                     [](const TomlSection& a, const TomlSection& b) { return a.line < b.line; });
    return out;
}

TomlFile read_toml(const std::string& file) { return parse_toml(text_of_toml(file), file); }

std::string toml_content(const TomlFile& file) {
    std::string out;
    for (const TomlEntry& entry : file.entries) {
        if (!out.empty()) out += "; ";
        for (const std::string& table : entry.section) out += table + '.';
        out += entry.key + " =";
        for (const TomlValue& value : entry.values) out += ' ' + value.text;
    }
    return out;
}

std::string toml_string(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        const bool is_control = static_cast<unsigned char>(c) < 32 || c == 127;
        out += is_control ? fmt::format("\\u{:04x}", static_cast<int>(c)) : std::string(1, c);
    }
    return out + '"';
}

std::string toml_value(const std::string& text) {
    const char* const end = text.data() + text.size();
    std::int64_t integer = 0;
    if (const auto r = std::from_chars(text.data(), end, integer); r.ec == std::errc{} && r.ptr == end) {
        if (std::to_string(integer) == text) return text;
    }
    double real = 0;
    if (const auto r = std::from_chars(text.data(), end, real); r.ec == std::errc{} && r.ptr == end && std::isfinite(real)) {
        if (format_number(real) == text && text.find('.') != std::string::npos) return text;
    }
    return toml_string(text);
}

std::string toml_key(const std::string& name) {
    constexpr const char* bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return !name.empty() && name.find_first_not_of(bare) == std::string::npos ? name : toml_string(name);
}

}  // namespace graincrack
