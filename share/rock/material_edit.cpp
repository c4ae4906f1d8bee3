#include "share/rock/material_edit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "share/base/error.hpp"
#include "share/base/shared_file.hpp"
#include "share/base/text.hpp"
#include "share/base/toml_file.hpp"
#include "share/base/units.hpp"
#include "share/rock/contact_parameters.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

namespace {

namespace fs = std::filesystem;

RockKind read_kind(const fs::path& file) {
    const std::string text = text_of_toml(file.string());
    const std::size_t end = text.find('\n');
    if (!text.starts_with("# ") || end == std::string::npos || text.find("\nname = \"") == std::string::npos) {
        throw InputError(
            fmt::format("{}: a kind of rock begins with a comment that describes it, and has a name", file.string()));
    }
    return {file.stem().string(), text.substr(2, end - 2), text};
}

/// Every key of [contact] as a comment, with an example and its default.
std::string contact_examples() {
    std::string text;
    for (const ContactParameter& row : all_contact_parameters()) {
        text += fmt::format("# {:<39} # {}: {}{}\n", fmt::format("{} = \"{}\"", row.key(), row.example),
                            row.is_needed() ? "first guess" : "default", row.usual, row.every_law ? "" : "; some laws only");
    }
    return text;
}

/// "phases.quartz" and "fraction"; the name of the material is in no table.
std::pair<std::string, std::string> parts_of(const std::string& key) {
    const std::size_t dot = key.rfind('.');
    return dot == std::string::npos ? std::pair(std::string(), key) : std::pair(key.substr(0, dot), key.substr(dot + 1));
}

/// \throws UsageError
void check(const MaterialSetting& setting) {
    const auto& [key, value] = setting;
    if (key == "name") {
        if (value.empty() || value.find_first_of("\"\\\n") != std::string::npos) {
            throw UsageError(fmt::format("name={}: a name without quotes is needed", value));
        }
        return;
    }
    const TomlKey found = material_key(key);
    if (found.is_word()) return found.require_word(value, key);
    static_cast<void>(parse_quantity(value, found.quantity, key));
}

/// A line of a TOML file, with a comment if it has one.
std::string edited_line(const std::string& key, const std::string& value, const std::string& comment) {
    // TOML has no .5, 5. and 007: such numbers are texts there.
    const std::string_view digits = std::string_view(value).substr(value.starts_with('-') || value.starts_with('+') ? 1 : 0);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const bool bare = value.find_first_not_of("+-0123456789.eE") == std::string::npos && !digits.empty() &&
                      is_digit(digits.front()) && is_digit(digits.back()) &&
                      !(digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]));
    const std::string line = bare ? key + " = " + value : fmt::format("{} = \"{}\"", key, value);
    return comment.empty() ? line : fmt::format("{:<39} # {}", line, comment);
}

/// What a template says behind the example of a key: `E` of `# young_modulus = "25.8 GPa"    # E`.
std::string comment_of_example(const std::string& line) {
    const std::size_t at = line.find("  # ");
    return at == std::string::npos ? "" : line.substr(at + 4);
}

std::string path_of(const std::vector<std::string>& section) { return fmt::format("{}", fmt::join(section, ".")); }

/// Lines of a file, and those to add behind some of them.
class Edit {
public:
    Edit(const std::string& text, const std::string& name) : toml_(parse_toml(text, name)) {
        for (const std::string_view line : split(text, '\n')) lines_.emplace_back(line);
        if (lines_.back().empty()) lines_.pop_back();  // behind the end of the last line
    }
    /// \throws InputError
    void set(const MaterialSetting& setting) {
        const auto [table, key] = parts_of(setting.first);
        const auto same = [&, t = table, k = key](const TomlEntry& entry) {
            return path_of(entry.section) == t && entry.key == k;
        };
        const auto found = std::find_if(toml_.entries.begin(), toml_.entries.end(), same);
        if (found == toml_.entries.end()) {
            if (const auto example = example_of(table, key); example != lines_.end()) {
                *example = edited_line(key, setting.second, comment_of_example(*example));
                return;
            }
            return add(table, edited_line(key, setting.second, "added"));
        }
        const auto on_line = [&](const TomlEntry& entry) { return entry.line == found->line; };
        if (std::count_if(toml_.entries.begin(), toml_.entries.end(), on_line) > 1 || found->values.empty()) {
            throw InputError(fmt::format("{}: line {}: {} shares its line with other keys; each needs a line of its own",
                                         toml_.file, found->line, setting.first));
        }
        lines_[static_cast<std::size_t>(found->line) - 1] = edited_line(key, setting.second, "was " + found->values[0].text);
    }
    [[nodiscard]] std::string text() const {
        std::string text;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            text += lines_[i] + "\n";
            const auto [from, to] = added_.equal_range(static_cast<int>(i) + 1);
            for (auto line = from; line != to; ++line) text += line->second + "\n";
        }
        for (const auto& [table, lines] : new_tables_) {
            text += fmt::format("\n[{}]\n", table);
            for (const std::string& line : lines) text += line + "\n";
        }
        return text;
    }

private:
    /// The line of a template that has the key of a table with an example as a comment; the end if there is none.
    std::vector<std::string>::iterator example_of(const std::string& table, const std::string& key) {
        auto from = lines_.end();
        auto to = lines_.end();
        for (const TomlSection& section : toml_.sections) {
            const auto header = lines_.begin() + section.line - 1;
            if (from != lines_.end() && header > from) to = std::min(to, header);
            if (path_of(section.name) == table) from = header;
        }
        const auto found = std::find_if(from, to, [&](const std::string& line) { return line.starts_with("# " + key + " = "); });
        return found == to ? lines_.end() : found;
    }
    void add(const std::string& table, const std::string& line) {
        int last = 0;
        for (const TomlSection& section : toml_.sections) {
            if (path_of(section.name) == table) last = section.line;
        }
        if (last == 0) {
            new_tables_[table].push_back(line);
            return;
        }
        for (const TomlEntry& entry : toml_.entries) {
            if (path_of(entry.section) == table) last = std::max(last, entry.line);
        }
        added_.emplace(last, line);
    }

    TomlFile toml_;
    std::vector<std::string> lines_;
    std::multimap<int, std::string> added_;  ///< by the number of the line before
    std::map<std::string, std::vector<std::string>> new_tables_;
};

std::string with_settings(Edit edit, const std::vector<MaterialSetting>& settings) {
    for (const MaterialSetting& setting : settings) {
        check(setting);
        edit.set(setting);
    }
    return edit.text();
}

}  // namespace

std::vector<RockKind> rock_kinds() {
    std::map<std::string, RockKind> kinds;
    std::error_code ignored;
    for (const fs::path& place : materials().places()) {
        for (fs::directory_iterator entry(place / "kinds", ignored); entry != fs::directory_iterator();
             entry.increment(ignored)) {
            if (ignored) break;
            if (entry->path().extension() != ".toml" || kinds.contains(entry->path().stem().string())) continue;
            kinds.emplace(entry->path().stem().string(), read_kind(entry->path()));
        }
    }
    std::vector<RockKind> all;
    all.reserve(kinds.size());
    for (auto& [name, kind] : kinds) all.push_back(std::move(kind));
    std::stable_partition(all.begin(), all.end(), [](const RockKind& kind) { return kind.name != every_key; });
    return all;
}

std::string material_of_kind(const std::string& kind, const std::string& name) {
    const std::vector<RockKind> kinds = rock_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const RockKind& each) { return each.name == kind; });
    if (found == kinds.end()) {
        std::vector<std::string> known;
        for (const RockKind& each : kinds) known.push_back(each.name);
        throw UsageError(
            fmt::format("--kind {}: unknown kind{}; known are {}", kind, did_you_mean(kind, known), fmt::join(known, ", ")));
    }
    std::string text = found->text;
    if (kind == every_key) text.insert(text.find("# law = "), contact_examples());
    const std::size_t from = text.find("\nname = \"") + 1;
    return text.replace(from, text.find('\n', from) - from, fmt::format("name = \"{}\"", name));
}

std::string material_with(const std::string& name_or_file, const std::vector<MaterialSetting>& settings) {
    const std::string file = read_incomplete_material(name_or_file).material.file.string();
    return with_settings(Edit(text_of_toml(file), file), settings);
}

std::string new_material(const std::string& kind, const std::string& name, const std::vector<MaterialSetting>& settings) {
    return with_settings(Edit(material_of_kind(kind, name), name), settings);
}

}  // namespace graincrack
