#include "share/base/toml_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {
namespace {

using Path = TomlDocument::Path;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

Path table_of(const Path& key) { return {key.begin(), key.end() - 1}; }

std::string dotted(const Path& path) {
    std::vector<std::string> names;
    for (const std::string& name : path) names.push_back(toml_key(name));
    return fmt::format("{}", fmt::join(names, "."));
}

std::string with_comment(const std::string& line, std::string_view comment) {
    return comment.empty() ? line : fmt::format("{:<39} # {}", line, comment);
}

/// A value for a comment: its first line; texts without quotes.
std::string shown(const std::string& value) {
    const std::size_t line = value.find_first_of("\r\n");
    if (line != std::string::npos) return value.substr(0, line) + " …";
    const bool is_text = value.size() > 1 && (value[0] == '"' || value[0] == '\'');
    return is_text ? value.substr(1, value.size() - 2) : value;
}

/// Ends of lines before their line breaks, and beginnings of the lines after them.
std::size_t line_end(const std::string& text, std::size_t at) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    return end > at && text[end - 1] == '\r' ? end - 1 : end;
}
std::size_t next_line(const std::string& text, std::size_t at) { return std::min(text.find('\n', at), text.size() - 1) + 1; }

std::string line_break(const std::string& text) { return text.find("\r\n") == std::string::npos ? "\n" : "\r\n"; }

}  // namespace

TomlDocument::TomlDocument(std::string text, const std::string& name) : text_(std::move(text)), toml_(parse_toml(text_, name)) {}

const TomlEntry* TomlDocument::entry(const Path& key) const {
    const auto found = std::find_if(toml_.entries.begin(), toml_.entries.end(), [&](const TomlEntry& each) {
        return !key.empty() && each.key == key.back() && each.section == table_of(key);
    });
    return found == toml_.entries.end() ? nullptr : &*found;
}

const TomlSection* TomlDocument::row(const Path& table) const {
    const TomlSection* found = nullptr;
    for (const TomlSection& each : toml_.sections) {
        const std::size_t n = each.name.size();
        if (!each.is_inline || n > table.size() || !std::equal(each.name.begin(), each.name.end(), table.begin())) continue;
        if (found == nullptr || n > found->name.size()) found = &each;
    }
    return found;
}

const TomlSection* TomlDocument::header(const Path& table) const {
    const TomlSection* found = nullptr;
    for (const TomlSection& each : toml_.sections) {
        if (each.name == table && text_[byte(each.begin)] == '[') found = &each;
    }
    // [phases.mica] is also the beginning of [phases].
    const auto is_of_another = [&](const TomlSection& each) {
        return found != nullptr && each.line == found->line && each.name.size() > table.size();
    };
    return std::any_of(toml_.sections.begin(), toml_.sections.end(), is_of_another) ? nullptr : found;
}

std::optional<std::string> TomlDocument::value(const Path& key) const {
    const auto between = [this](const auto& there) {
        return text_.substr(byte(there.begin), byte(there.end) - byte(there.begin));
    };
    if (const TomlEntry* const there = entry(key)) return between(*there);
    const TomlSection* const in = row(key);
    return in != nullptr && in->name == key ? std::optional(between(*in)) : std::nullopt;
}

bool TomlDocument::has_table(const Path& table) const {
    return std::any_of(toml_.sections.begin(), toml_.sections.end(), [&](const TomlSection& each) { return each.name == table; });
}

std::size_t TomlDocument::byte(TomlPlace place) const {
    std::size_t at = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    for (int line = 1; line < place.line; ++line) at = text_.find('\n', at) + 1;
    for (int column = 1; column < place.column; ++column) {
        do ++at;
        while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xc0U) == 0x80U);
    }
    return at;
}

void TomlDocument::replace(std::size_t begin, std::size_t end, const std::string& by) {
    std::string changed = text_;
    changed.replace(begin, end - begin, by);
    toml_ = parse_toml(changed, toml_.file);
    text_ = std::move(changed);
}

void TomlDocument::insert_line(std::size_t behind, const std::string& line) {
    const std::size_t at = next_line(text_, behind);
    const bool ends_line = at > 0 && text_[at - 1] == '\n';
    replace(at, at, ends_line ? line + line_break(text_) : line_break(text_) + line);
}

void TomlDocument::add_table(const Path& table, const std::string& comment) {
    const std::string end = text_.empty() || text_.ends_with('\n') ? "" : line_break(text_);
    const std::string header = fmt::format("[{}]{}{}", dotted(table), comment.empty() ? "" : "  # ", comment);
    replace(text_.size(), text_.size(), end + line_break(text_) + header + line_break(text_));
}

std::optional<std::size_t> TomlDocument::example(const Path& key) const {
    const TomlSection* const table = header(table_of(key));
    if (table == nullptr) return std::nullopt;
    const std::size_t from = byte(table->begin);
    std::size_t to = text_.size();
    for (const TomlSection& each : toml_.sections) {
        const std::size_t begin = byte(each.begin);
        if (begin > from && text_[begin] == '[') to = std::min(to, begin);
    }
    const std::string words = "# " + toml_key(key.back()) + " = ";
    for (std::size_t at = next_line(text_, from); at < to; at = next_line(text_, at)) {
        if (text_.compare(at, words.size(), words) != 0) continue;
        const bool is_in_value = std::any_of(toml_.entries.begin(), toml_.entries.end(),
                                             [&](const TomlEntry& each) { return byte(each.begin) < at && at < byte(each.end); });
        if (!is_in_value) return at;
    }
    return std::nullopt;
}

void TomlDocument::put(const Path& key, const std::string& line) {
    const Path table = table_of(key);
    if (const TomlSection* const in = row(table)) {
        const std::size_t end = text_.find_last_not_of(" \t", byte(in->end) - 2) + 1;
        const Path between(table.begin() + static_cast<std::ptrdiff_t>(in->name.size()), table.end());
        const std::string member = between.empty() ? line : dotted(between) + "." + line;
        return replace(end, end, text_[end - 1] == '{' ? member : ", " + member);
    }
    const TomlEntry* last = nullptr;
    for (const TomlEntry& each : toml_.entries) {
        if (each.section == table) last = &each;
    }
    if (last != nullptr) {  // with its indentation, or its tables if it is a dotted key
        const std::size_t begin = byte({last->key_begin.line, 1});
        return insert_line(byte(last->end), text_.substr(begin, byte(last->key_begin) - begin) + line);
    }
    if (table.empty()) return replace(byte({1, 1}), byte({1, 1}), line + line_break(text_));
    if (header(table) == nullptr) add_table(table);
    insert_line(byte(header(table)->begin), line);
}

void TomlDocument::set(const Path& key, const std::string& value, bool is_remarked) {
    const std::string line = toml_key(key.back()) + " = " + value;
    const std::string where = fmt::format("{}: {}", toml_.file, dotted(key));
    if (has_table(key)) throw InputError(where + " is a table there; set one of its keys, or take the table out");
    TomlDocument changed = *this;
    try {
        if (const TomlEntry* const old = entry(key)) {
            changed.replace(byte(old->begin), byte(old->end), value);
            if (is_remarked) changed.remark(key, "was " + shown(*this->value(key)));
        } else if (const auto at = example(key)) {
            const std::string words = text_.substr(*at, line_end(text_, *at) - *at);
            const std::size_t comment = words.find("  # ");
            changed.replace(*at, line_end(text_, *at),
                            with_comment(line, comment == std::string::npos ? "" : words.substr(comment + 4)));
        } else {
            changed.put(key, line);
            if (is_remarked) changed.remark(key, "added");
        }
    } catch (const InputError& error) {
        throw InputError(fmt::format("{} finds no place beside what stands there ({})", where, error.what()));
    }
    if (changed.value(key) != value) throw InputError(where + " is to be set to what is not one value of TOML");
    *this = std::move(changed);
}

void TomlDocument::remark(const Path& key, const std::string& words) {
    if (row(table_of(key)) != nullptr) return;
    const std::size_t begin = byte({entry(key)->end.line, 1});
    const std::size_t behind = byte(entry(key)->end);
    const std::size_t end = line_end(text_, behind);
    const std::size_t comment = std::min(text_.find('#', behind), end);
    const std::string_view old = trimmed(std::string_view(text_).substr(comment, end - comment)).substr(comment < end ? 1 : 0);
    replace(begin, end,
            with_comment(text_.substr(begin, behind - begin), fmt::format("{}{}{}", words, old.empty() ? "" : ";", old)));
}

void TomlDocument::remove(const Path& key) {
    const TomlEntry* const there = entry(key);
    if (there == nullptr) return;
    if (row(table_of(key)) != nullptr) {
        throw InputError(fmt::format("{}: line {}: {} shares its line with other keys; each needs a line of its own", toml_.file,
                                     there->line, dotted(key)));
    }
    replace(byte({there->key_begin.line, 1}), next_line(text_, byte(there->end)), "");
}

}  // namespace graincrack
