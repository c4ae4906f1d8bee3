#include "share/rock/material_edit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "share/base/error.hpp"
#include "share/base/shared_file.hpp"
#include "share/base/text.hpp"
#include "share/base/toml_document.hpp"
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

/// The value of a setting as TOML writes it. \throws UsageError
std::string checked_value(const MaterialSetting& setting) {
    const auto& [key, value] = setting;
    if (key == "name" || key == "kind") {
        if (!value.empty() && value.find_first_of("\"\\\n") == std::string::npos) return toml_string(value);
        throw UsageError(fmt::format("{}={}: a name without quotes is needed", key, value));
    }
    const TomlKey found = material_key(key);
    if (found.is_word()) {
        found.require_word(value, key);
        return toml_string(value);
    }
    static_cast<void>(parse_quantity(value, found.quantity, key));
    return toml_value(value);
}

void set(TomlDocument& file, const MaterialSetting& setting) {
    const std::string_view given = trimmed(setting.second);
    const bool is_table = given.starts_with('{') && given.ends_with('}');
    const bool is_text = given.size() > 1 && given.starts_with('"') && given.ends_with('"');
    if (is_table || is_text) {  // as the comments of a template have it
        for (const TomlEntry& entry : parse_toml(fmt::format("value = {}", given), setting.first).entries) {
            if (entry.is_array) throw UsageError(setting.first + ": has a list; tables of single values fit");
            set(file, {setting.first + (is_table ? "." + entry.key : ""), entry.values.front().text});
        }
        return;
    }
    const std::string value = checked_value(setting);
    const auto names = split(setting.first, '.');
    TomlDocument::Path path(names.begin(), names.end());
    if (setting.first == measured_toughness && file.has_table(path)) path.emplace_back("value");
    const TomlDocument::Path table(path.begin(), path.end() - 1);
    if (const auto plain = file.value(table); plain && !file.has_table(table) && setting.first.starts_with(measured_toughness)) {
        file.set(table, fmt::format("{{value = {}}}", *plain));
    }
    file.set(path, value, true);
}

std::string with_settings(const std::string& text, const std::string& name, const std::vector<MaterialSetting>& settings) {
    TomlDocument file(text, name);
    for (const MaterialSetting& setting : settings) set(file, setting);
    return file.text();
}

}  // namespace

std::vector<RockKind> rock_kinds() {
    std::map<std::string, RockKind> kinds;
    for (const fs::path& file : materials().files_in("kinds")) {
        if (!kinds.contains(file.stem().string())) kinds.emplace(file.stem().string(), read_kind(file));
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
    TomlDocument file(text, kind);
    file.set({"name"}, toml_string(name));
    if (kind != every_key) file.set({"kind"}, toml_string(kind));
    return file.text();
}

std::string material_with(const std::string& name_or_file, const std::vector<MaterialSetting>& settings) {
    const std::string file = read_incomplete_material(name_or_file).material.file.string();
    return with_settings(text_of_toml(file), file, settings);
}

std::string new_material(const std::string& kind, const std::string& name, const std::vector<MaterialSetting>& settings) {
    return with_settings(material_of_kind(kind, name), name, settings);
}

}  // namespace graincrack
