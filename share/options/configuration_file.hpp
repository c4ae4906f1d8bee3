// Reads and writes configuration files: TOML with the names of options as keys, by the rules of command_line.hpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/base/toml_file.hpp"
#include "share/file/settings.hpp"

namespace graincrack {

/// Reads configuration files for CLI11, and stores what CLI11 does not have of options: how values are read, and their bounds.
class ConfigurationFile : public CLI::Config {
public:
    struct Value {
        std::function<void(const std::string&)> read;
        std::optional<Quantity> bounds = {};       ///< bounds of a quantity or a whole number
        std::vector<std::string> endings = {};     ///< allowed endings of the name of a file
        std::function<SettingValue()> value = {};  ///< returns the effective value
        std::optional<SettingGroup> group = {};    ///< group of an option that is a setting of files
    };
    explicit ConfigurationFile(CLI::App& app) : app_(app) {}

    std::vector<CLI::ConfigItem> from_config(std::istream& stream) const override;
    std::string to_config(const CLI::App*, bool, bool, std::string) const override;

    /// "file, line n" if a configuration file set the option, else "".
    [[nodiscard]] std::string origin(const CLI::Option* option) const;

    /// Stores how the value of an option is read. Its default is applied once it is known which subcommand runs.
    void remember(const CLI::Option* option, const Value& value) { values_[option] = value; }
    void apply_default(const CLI::Option* option) const;
    /// The stored properties of an option.
    [[nodiscard]] Value value(const CLI::Option* option) const;
    /// Makes the effective value of an option a setting. \param value replaces the value of the option's target, unless empty
    void make_setting(const CLI::Option* option, SettingGroup group, const std::function<SettingValue()>& value);
    /// The settings of the commands that run.
    [[nodiscard]] Settings settings() const;

private:
    void check_section(const TomlFile& toml, const TomlSection& section) const;
    void add_item(const TomlFile& toml, const TomlEntry& entry, std::vector<CLI::ConfigItem>& loaded) const;
    [[noreturn]] void refuse_key(const TomlFile& toml, const TomlEntry& entry, const std::vector<CLI::App*>& owners) const;

    CLI::App& app_;
    mutable std::map<const CLI::Option*, std::string> origins_;
    std::map<const CLI::Option*, Value> values_;
};

/// The configuration file of an application; nullptr if it has none.
ConfigurationFile* configuration_file(const CLI::App& app);

/// The effective options of an application as TOML.
std::string effective_configuration(const CLI::App& app);

/// Headings of the options of `OptionSet::usual` and `OptionSet::seldom` in help texts.
inline constexpr const char *usual_options = "Usual options", *seldom_options = "Further options";

/// The name of an option in a configuration file: "edge" of "-e,--edge".
inline std::string key_of(const CLI::Option& option) {
    if (!option.get_lnames().empty()) return option.get_lnames().front();
    if (option.get_positional()) return option.get_name(true);
    return option.get_snames().front();
}

/// The application and the subcommands that were called, outermost first.
template <class App>
std::vector<App*> running(App& app) {
    std::vector<App*> chain{&app};
    while (!chain.back()->get_subcommands().empty()) chain.push_back(chain.back()->get_subcommands().front());
    return chain;
}

/// An option by its key in a configuration file; nullptr if there is none.
inline CLI::Option* find_key(CLI::App& app, const std::string& key) {
    for (CLI::Option* option : app.get_options()) {
        if (key_of(*option) == key) return option;
    }
    return nullptr;
}

inline std::vector<std::string> subcommand_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
    return names;
}

}  // namespace graincrack
