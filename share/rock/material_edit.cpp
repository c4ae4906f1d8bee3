#include "share/rock/material_edit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>

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

/// A value as a TOML file has it: a bare number, or a text in quotes.
std::string text_of(const std::string& value) {
    // TOML has no .5, 5. and 007: such numbers are texts there.
    const std::string_view digits = std::string_view(value).substr(value.starts_with('-') || value.starts_with('+') ? 1 : 0);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const bool bare = value.find_first_not_of("+-0123456789.eE") == std::string::npos && !digits.empty() &&
                      is_digit(digits.front()) && is_digit(digits.back()) &&
                      !(digits.size() > 1 && digits[0] == '0' && is_digit(digits[1]));
    return bare ? value : '"' + value + '"';
}

/// A line of a TOML file, with a comment if it has one.
std::string edited_line(const std::string& key, const std::string& value, const std::string& comment) {
    const std::string line = key + " = " + text_of(value);
    return comment.empty() ? line : fmt::format("{:<39} # {}", line, comment);
}

/// What a template says behind the example of a key: `E` of `# young_modulus = "25.8 GPa"    # E`.
std::string comment_of_example(const std::string& line) {
    const std::size_t at = line.find("  # ");
    return at == std::string::npos ? "" : line.substr(at + 4);
}

bool is_header(const std::string& line) { return line.find_first_not_of(" \t") == line.find('['); }

std::string path_of(const std::vector<std::string>& section) { return fmt::format("{}", fmt::join(section, ".")); }

/// The lines of a file, in which a value can be set once.
class Edit {
public:
    Edit(const std::string& text, const std::string& name) : toml_(parse_toml(text, name)) {
        for (const std::string_view line : split(text, '\n')) lines_.emplace_back(line);
        if (lines_.back().empty()) lines_.pop_back();  // behind the end of the last line
    }
    /// \throws InputError
    void set(const MaterialSetting& setting) {
        const auto& [whole, value] = setting;
        if (section(whole) != nullptr) return set({whole + ".value", value});
        const auto [table, key] = parts_of(whole);
        if (const TomlEntry* const plain = entry(table)) {
            line_of(plain->line) = fmt::format("{} = {{value = {}}}", plain->key, text_of(plain->values[0].text));
            return set_in_row(plain->line, setting);
        }
        const TomlSection* const there = section(table);
        if (there != nullptr && !is_header(line_of(there->line))) return set_in_row(there->line, setting);
        if (const TomlEntry* const found = entry(whole)) {
            line_of(found->line) = edited_line(key, value, "was " + found->values[0].text);
        } else if (const auto example = example_of(table, key); example != lines_.end()) {
            *example = edited_line(key, value, comment_of_example(*example));
        } else {
            add(table, edited_line(key, value, "added"));
        }
    }
    [[nodiscard]] std::string text() const { return fmt::format("{}\n", fmt::join(lines_, "\n")); }

private:
    [[nodiscard]] const TomlEntry* entry(const std::string& whole) const {
        const auto is = [&](const TomlEntry& e) { return path_of(e.section) + (e.section.empty() ? "" : ".") + e.key == whole; };
        const auto found = std::find_if(toml_.entries.begin(), toml_.entries.end(), is);
        return found == toml_.entries.end() ? nullptr : &*found;
    }
    /// A table with a line of its own: that of [phases.mica] is none of [phases].
    [[nodiscard]] const TomlSection* section(const std::string& table) const {
        const auto& all = toml_.sections;
        const auto found = std::find_if(all.begin(), all.end(), [&](const TomlSection& s) { return path_of(s.name) == table; });
        if (found == all.end()) return nullptr;
        const bool is_of_another = std::any_of(all.begin(), all.end(), [&](const TomlSection& s) {
            return s.line == found->line && s.name.size() > found->name.size();
        });
        return is_of_another ? nullptr : &*found;
    }
    std::string& line_of(int number) { return lines_[static_cast<std::size_t>(number) - 1]; }
    /// Sets a key of the table that stands on a line, {value = "1 MPa", notch = "2 mm"}.
    void set_in_row(int number, const MaterialSetting& setting) {
        const std::string key = parts_of(setting.first).second;
        std::string& line = line_of(number);
        constexpr std::size_t longest = 1000;
        const std::size_t end = line.find('}');
        if (std::count(line.begin(), line.end(), '{') != 1 || end == std::string::npos || line.size() > longest) {
            throw InputError(fmt::format("{}: line {}: {} shares its line with other keys; each needs a line of its own",
                                         toml_.file, number, setting.first));
        }
        const std::string changed = key + " = " + text_of(setting.second);
        std::smatch old;
        if (std::regex_search(line, old, std::regex("([{,] *)" + key + " *= *(\"[^\"]*\"|'[^']*'|[^,} ]+)"))) {
            line = old.prefix().str() + old[1].str() + changed + old.suffix().str();
        } else {
            line.insert(end, ", " + changed);
        }
    }
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
        const TomlSection* const there = section(table);
        if (there == nullptr) {
            lines_.insert(lines_.end(), {"", "[" + table + "]", line});
            return;
        }
        int last = there->line;
        for (const TomlEntry& each : toml_.entries) {
            if (path_of(each.section) == table) last = std::max(last, each.line);
        }
        lines_.insert(lines_.begin() + last, line);
    }

    TomlFile toml_;
    std::vector<std::string> lines_;
};

std::string with_settings(std::string text, const std::string& name, const std::vector<MaterialSetting>& settings) {
    for (const MaterialSetting& setting : settings) {
        check(setting);
        Edit edit(text, name);
        edit.set(setting);
        text = edit.text();
    }
    return text;
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
    return with_settings(text_of_toml(file), file, settings);
}

std::string new_material(const std::string& kind, const std::string& name, const std::vector<MaterialSetting>& settings) {
    return with_settings(material_of_kind(kind, name), name, settings);
}

}  // namespace graincrack
