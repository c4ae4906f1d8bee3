#include "share/options/configuration_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {
namespace {

[[noreturn]] void refuse(const TomlFile& toml, int line, const std::string& message) {
    throw UsageError(fmt::format("{}: line {}: {}", toml.file, line, message));
}

std::string toml_line(const CLI::Option& option) {
    const std::string key = key_of(option);
    if (option.get_expected_min() == 0) {
        return option.count() > 0 && option.as<bool>() ? fmt::format("{} = true\n", key) : fmt::format("# {} = true\n", key);
    }
    std::vector<std::string> values = option.results();
    const bool many = option.get_items_expected_max() > 1 || option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (values.empty()) {
        const std::set<CLI::Option*> others = option.get_excludes();
        // The default applies unless an option that excludes this one is given, or has a default itself.
        const bool replaced = std::any_of(others.begin(), others.end(), [](const CLI::Option* other) {
            return other->count() > 0 || !other->get_default_str().empty();
        });
        if (many || option.get_required() || replaced || option.get_default_str().empty()) return fmt::format("# {} =\n", key);
        values.push_back(option.get_default_str());
    }
    if (!many) return fmt::format("{} = {}\n", key, toml_value(values.front()));
    for (std::string& value : values) value = toml_value(value);
    return fmt::format("{} = [{}]\n", key, fmt::join(values, ", "));
}

}  // namespace

std::vector<CLI::ConfigItem> ConfigurationFile::from_config(std::istream& stream) const {
    const std::string name = app_.get_config_ptr()->results().front();
    TomlFile toml;
    try {
        toml = parse_toml(text_of_stream(stream, name, longest_toml, "; a TOML file is needed"), name);
    } catch (const InputError& error) {
        throw UsageError(fmt::format("--config: {}", error.what()));
    }
    for (const TomlSection& section : toml.sections) check_section(toml, section);
    // CLI11 keeps the first value it receives: sections come before keys at the top.
    std::stable_sort(toml.entries.begin(), toml.entries.end(),
                     [](const TomlEntry& a, const TomlEntry& b) { return a.section.size() > b.section.size(); });
    std::vector<CLI::ConfigItem> loaded;
    for (const TomlEntry& entry : toml.entries) add_item(toml, entry, loaded);
    return loaded;
}

std::string ConfigurationFile::to_config(const CLI::App*, bool, bool, std::string) const { return effective_configuration(app_); }

std::string ConfigurationFile::origin(const CLI::Option* option) const {
    const auto found = origins_.find(option);
    return found == origins_.end() ? "" : found->second;
}

void ConfigurationFile::apply_default(const CLI::Option* option) const {
    const auto value = values_.find(option);
    if (value != values_.end() && value->second.read && option->count() == 0 && !option->get_default_str().empty()) {
        value->second.read(option->get_default_str());
    }
}

ConfigurationFile::Value ConfigurationFile::value(const CLI::Option* option) const {
    const auto value = values_.find(option);
    return value == values_.end() ? Value{} : value->second;
}

void ConfigurationFile::make_setting(const CLI::Option* option, SettingGroup group, const std::function<SettingValue()>& value) {
    Value& own = values_[option];
    own.group = group;
    if (value) own.value = value;
}

Settings ConfigurationFile::settings() const {
    Settings all;
    for (const CLI::App* each : running(std::as_const(app_))) {
        for (const CLI::Option* option : each->get_options()) {
            const auto found = values_.find(option);
            if (found == values_.end() || !found->second.group) continue;
            const Value& own = found->second;
            std::string name = key_of(*option);
            std::replace(name.begin(), name.end(), '-', '_');
            all.push_back({name, own.value(), own.bounds ? own.bounds->dimension : Dimension::one, *own.group});
        }
    }
    return all;
}

void ConfigurationFile::check_section(const TomlFile& toml, const TomlSection& section) const {
    CLI::App* app = &app_;
    for (const std::string& word : section.name) {
        const std::vector<std::string> known = subcommand_names(*app);
        if (std::find(known.begin(), known.end(), word) == known.end()) {
            refuse(
                toml, section.line,
                fmt::format("unknown section [{}]{}; {}", fmt::join(section.name, "."), did_you_mean(word, known),
                            known.empty() ? "there are no sections here" : fmt::format("known are {}", fmt::join(known, ", "))));
        }
        app = app->get_subcommand(word);
    }
}

/// Adds the option of an entry, in the subcommand of its section (checked before); keys at the top belong to the subcommand
/// that runs.
void ConfigurationFile::add_item(const TomlFile& toml, const TomlEntry& entry, std::vector<CLI::ConfigItem>& loaded) const {
    const std::vector<CLI::App*> chain = running(app_);
    std::vector<std::string> parents = entry.section;
    CLI::App* owner = &app_;
    bool runs = true;
    for (std::size_t i = 0; i < parents.size(); ++i) {
        owner = owner->get_subcommand(parents[i]);
        runs = runs && i + 1 < chain.size() && chain[i + 1] == owner;
    }
    CLI::Option* option = find_key(*owner, entry.key);
    if (option == nullptr && entry.section.empty()) {
        for (std::size_t depth = 1; depth < chain.size() && option == nullptr; ++depth) {
            parents.push_back(chain[depth]->get_name());
            owner = chain[depth];
            option = find_key(*owner, entry.key);
        }
    }
    if (option == nullptr) refuse_key(toml, entry, entry.section.empty() ? chain : std::vector<CLI::App*>{owner});
    if (!option->get_configurable()) {
        refuse(toml, entry.line, fmt::format("{} cannot stand in a file; give it on the command line", entry.key));
    }
    if (!runs || entry.values.empty() || option->count() > 0) return;
    for (const CLI::Option* other : option->get_excludes()) {
        if (other->count() > 0) return;
    }
    if (option->get_expected_min() == 0 && (entry.is_array || entry.values.front().kind != TomlValue::Kind::boolean)) {
        refuse(toml, entry.line, fmt::format("{} is true or false", entry.key));
    }
    if (option->get_expected_min() == 0 && entry.values.front().text == "false") return;  // as if not given
    CLI::ConfigItem item{parents, entry.key, {}};
    for (const TomlValue& value : entry.values) item.inputs.push_back(value.text);
    if (origins_.emplace(option, fmt::format("{}, line {}", toml.file, entry.line)).second) loaded.push_back(std::move(item));
}

void ConfigurationFile::refuse_key(const TomlFile& toml, const TomlEntry& entry, const std::vector<CLI::App*>& owners) const {
    std::vector<std::string> known;
    for (CLI::App* owner : owners) {
        for (const CLI::Option* option : owner->get_options()) {
            if (option->get_configurable()) known.push_back(key_of(*option));
        }
    }
    const std::string command = owners.back()->get_name();
    if (entry.section.empty()) {
        for (CLI::App* sub : app_.get_subcommands({})) {
            if (find_key(*sub, entry.key) == nullptr) continue;
            refuse(toml, entry.line,
                   fmt::format("{} is no option of {}; keys of {} stand in a section [{}]", entry.key, command, sub->get_name(),
                               sub->get_name()));
        }
    }
    refuse(toml, entry.line,
           fmt::format("unknown key {}{}; known to {} are {}", entry.key, did_you_mean(entry.key, known), command,
                       fmt::join(known, ", ")));
}

ConfigurationFile* configuration_file(const CLI::App& app) {
    return dynamic_cast<ConfigurationFile*>(app.get_config_formatter().get());
}

std::string effective_configuration(const CLI::App& app) {
    std::string text, section;
    for (const CLI::App* each : running(app)) {
        if (each != &app) {
            section += (section.empty() ? "" : ".") + each->get_name();
            text += fmt::format("\n[{}]\n", section);
        }
        for (const CLI::Option* option : each->get_options()) {
            if (option->get_configurable()) text += toml_line(*option);
        }
    }
    return text;
}

}  // namespace graincrack
