#include "share/command_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <thread>

#include "share/provenance.hpp"
#include "share/toml_file.hpp"
#include "share/units.hpp"

namespace graincrack {
namespace {

// --- names -----------------------------------------------------------------------------------------------------------

/// The name of an option in a configuration file: "edge" of "-e,--edge".
std::string key_of(const CLI::Option& option) {
    if (!option.get_lnames().empty()) return option.get_lnames().front();
    if (option.get_positional()) return option.get_name(true);
    return option.get_snames().front();
}

/// The name of an option in a message: "--edge".
std::string shown_name(const CLI::Option& option) {
    return option.get_lnames().empty() ? option.get_name(option.get_positional()) : "--" + option.get_lnames().front();
}

/// Text as part of a one-line message.
std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    while (!text.empty() && (text.back() == '.' || text.back() == ' ')) text.pop_back();
    return text;
}

bool in_environment(const std::string& name) {
    const char* value = name.empty() ? nullptr : std::getenv(name.c_str());
    return value != nullptr && *value != '\0';
}

/// The application and the subcommands that run, from the top.
template <class App>
std::vector<App*> running(App& app) {
    std::vector<App*> chain{&app};
    while (!chain.back()->get_subcommands().empty()) chain.push_back(chain.back()->get_subcommands().front());
    return chain;
}

/// An option by its key in a file, "" prefix allowed; nullptr if there is none.
CLI::Option* find_key(CLI::App& app, const std::string& key) {
    for (CLI::Option* option : app.get_options()) {
        if (key_of(*option) == key) return option;
    }
    return nullptr;
}

/// What to type for help on the subcommand that runs.
std::string help_command(CLI::App& app) {
    std::string command;
    for (const CLI::App* each : running(app)) command += each->get_name() + " ";
    return command + "--help";
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known) {
    const std::string nearest = nearest_word(word, known);
    return nearest.empty() ? "" : fmt::format("did you mean {}? ", nearest);
}

/// Gives the options of an application, not of its subcommands, their environment variables: --max-strain:
/// GRAINCRACK_MAX_STRAIN.
void name_variables(CLI::App& app) {
    for (CLI::Option* option : app.get_options()) {
        if (!option->get_configurable() || option->get_lnames().empty() || !option->get_envname().empty()) continue;
        std::string name = "GRAINCRACK_" + option->get_lnames().front();
        for (char& c : name) c = c == '-' ? '_' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        option->envname(name);
    }
}

void for_each_app(CLI::App& app, const std::function<void(CLI::App&)>& action) {
    action(app);
    for (CLI::App* sub : app.get_subcommands({})) for_each_app(*sub, action);
}

std::vector<std::string> subcommand_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
    return names;
}

// --- configuration files ---------------------------------------------------------------------------------------------

/// Reads configuration files for CLI11 with the rules told in the header.
class ConfigurationFile : public CLI::Config {
public:
    explicit ConfigurationFile(CLI::App& app) : app_(app) {}

    std::vector<CLI::ConfigItem> from_config(std::istream& stream) const override {
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        const std::string name = app_.get_config_ptr()->results().front();
        TomlFile toml;
        try {
            toml = parse_toml(text, name);
        } catch (const InputError& error) {
            throw UsageError(fmt::format("--config: {}", error.what()));
        }
        for (const TomlSection& section : toml.sections) check_section(toml, section);
        // CLI11 keeps the first value it gets: sections before keys at the top
        std::stable_sort(toml.entries.begin(), toml.entries.end(),
                         [](const TomlEntry& a, const TomlEntry& b) { return a.section.size() > b.section.size(); });
        std::vector<CLI::ConfigItem> loaded;
        for (const TomlEntry& entry : toml.entries) add_item(toml, entry, loaded);
        return loaded;
    }

    std::string to_config(const CLI::App*, bool, bool, std::string) const override { return effective_configuration(app_); }

    /// "file, line n" of an option that a file gave a value, else "".
    [[nodiscard]] std::string origin(const CLI::Option* option) const {
        const auto found = origins_.find(option);
        return found == origins_.end() ? "" : found->second;
    }

    /// Keeps how the value of an option is read, so that its default can be applied once it is known which subcommand runs.
    void remember(const CLI::Option* option, const std::function<void(const std::string&)>& read) { readers_[option] = read; }
    void apply_default(const CLI::Option* option) const {
        const auto reader = readers_.find(option);
        if (reader != readers_.end() && option->count() == 0 && !option->get_default_str().empty()) {
            reader->second(option->get_default_str());
        }
    }

private:
    [[noreturn]] static void refuse(const TomlFile& toml, int line, const std::string& message) {
        throw UsageError(fmt::format("{}: line {}: {}", toml.file, line, message));
    }

    void check_section(const TomlFile& toml, const TomlSection& section) const {
        CLI::App* app = &app_;
        for (const std::string& word : section.name) {
            const std::vector<std::string> known = subcommand_names(*app);
            if (std::find(known.begin(), known.end(), word) == known.end()) {
                refuse(
                    toml, section.line,
                    fmt::format("unknown section [{}]; {}", fmt::join(section.name, "."),
                                known.empty() ? "there are no sections here"
                                              : fmt::format("{}known are {}", suggestion(word, known), fmt::join(known, ", "))));
            }
            app = app->get_subcommand(word);
        }
    }

    /// The application or subcommand of a section (checked before) and its option; top keys belong to whatever runs.
    void add_item(const TomlFile& toml, const TomlEntry& entry, std::vector<CLI::ConfigItem>& loaded) const {
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
        if (!runs || entry.values.empty() || option->count() > 0 || in_environment(option->get_envname())) return;
        for (const CLI::Option* other : option->get_excludes()) {
            if (other->count() > 0 || in_environment(other->get_envname())) return;
        }
        if (option->get_expected_min() == 0 && (entry.is_array || entry.values.front().kind != TomlValue::Kind::boolean)) {
            refuse(toml, entry.line, fmt::format("{} is true or false", entry.key));
        }
        if (option->get_expected_min() == 0 && entry.values.front().text == "false") return;  // as if not given
        CLI::ConfigItem item{parents, entry.key, {}};
        for (const TomlValue& value : entry.values) item.inputs.push_back(value.text);
        if (origins_.emplace(option, fmt::format("{}, line {}", toml.file, entry.line)).second) loaded.push_back(std::move(item));
    }

    [[noreturn]] void refuse_key(const TomlFile& toml, const TomlEntry& entry, const std::vector<CLI::App*>& owners) const {
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
                       fmt::format("{} is no option of {}; keys of {} stand in a section [{}]", entry.key, command,
                                   sub->get_name(), sub->get_name()));
            }
        }
        const std::string nearest = suggestion(entry.key, known);
        refuse(toml, entry.line,
               fmt::format("unknown key {}; {}known to {} are {}", entry.key, nearest, command, fmt::join(known, ", ")));
    }

    CLI::App& app_;
    mutable std::map<const CLI::Option*, std::string> origins_;
    std::map<const CLI::Option*, std::function<void(const std::string&)>> readers_;
};

ConfigurationFile* configuration_file(const CLI::App& app) {
    return dynamic_cast<ConfigurationFile*>(app.get_config_formatter().get());
}

// --- help ------------------------------------------------------------------------------------------------------------

/// Help without the noise of environment variables; help of a subcommand shows the options of the tool as well.
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override {
        std::string text;
        for (const CLI::App* parent = app->get_parent(); parent != nullptr && mode == CLI::AppFormatMode::Normal;
             parent = parent->get_parent()) {
            const auto options = parent->get_options([parent](const CLI::Option* option) {
                return !option->get_group().empty() && option->nonpositional() && option != parent->get_help_ptr();
            });
            if (!options.empty()) text += make_group("Options of " + parent->get_name(), false, options);
        }
        return text + CLI::Formatter::make_subcommands(app, mode);
    }

    /// Descriptions in lines of a readable length.
    std::string make_option_desc(const CLI::Option* option) const override {
        constexpr std::size_t width = 88;
        std::istringstream words(CLI::Formatter::make_option_desc(option));
        std::string text;
        std::size_t length = 0;
        for (std::string word; words >> word; length += word.size()) {
            if (length > 0 && length + 1 + word.size() > width) {
                text += '\n';
                length = 0;
            } else if (length > 0) {
                text += ' ';
                ++length;
            }
            text += word;
        }
        return text;
    }

    std::string make_option_opts(const CLI::Option* option) const override {
        std::string text;
        if (option->get_type_size() != 0) {
            if (!option->get_type_name().empty()) text += " " + option->get_type_name();
            if (option->get_required()) {
                text += " REQUIRED";
            } else if (!option->get_default_str().empty()) {
                text += " = " + option->get_default_str();
            }
            if (option->get_expected_max() == CLI::detail::expected_max_vector_size) text += " ...";
        }
        return text;
    }
};

std::string type_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::one: return "NUMBER";
        case Dimension::length: return "LENGTH";
        case Dimension::area: return "AREA";
        case Dimension::angle: return "ANGLE";
        case Dimension::time: return "TIME";
        case Dimension::speed: return "SPEED";
        case Dimension::stress: return "STRESS";
        case Dimension::force: return "FORCE";
        case Dimension::energy: return "ENERGY";
        case Dimension::stiffness: return "STIFFNESS";
        case Dimension::toughness: return "TOUGHNESS";
        case Dimension::fracture_energy: return "ENERGY/AREA";
        case Dimension::density: return "DENSITY";
        case Dimension::acceleration: return "ACCELERATION";
        case Dimension::frequency: return "FREQUENCY";
    }
    return "VALUE";
}

/// "mean edge [above 0 m and at most 1 km; m, mm, cm, um, km]"
std::string help_of(const std::string& help, const Quantity& quantity) {
    std::vector<std::string_view> symbols;
    for (const Unit& unit : units_of(quantity.dimension)) {
        if (unit.symbol != "1") symbols.push_back(unit.symbol);
    }
    return fmt::format("{} [{}; {}]", help, bounds_text(quantity), fmt::join(symbols, ", "));
}

// --- errors ----------------------------------------------------------------------------------------------------------

/// What was parsed, for the messages.
struct Call {
    CLI::App& app;
    std::vector<std::string> arguments;
};

CLI::Option* find_option(const Call& call, const std::string& name) {
    for (CLI::App* each : running(call.app)) {
        if (CLI::Option* option = each->get_option_no_throw(name); option != nullptr) return option;
    }
    return nullptr;
}

bool on_command_line(const Call& call, const CLI::Option& option) {
    const auto given = [&](const std::string& argument) {
        return std::any_of(option.get_lnames().begin(), option.get_lnames().end(),
                           [&](const std::string& name) {
                               return argument == "--" + name || argument.compare(0, name.size() + 3, "--" + name + "=") == 0;
                           }) ||
               std::any_of(option.get_snames().begin(), option.get_snames().end(),
                           [&](const std::string& name) { return argument.compare(0, name.size() + 1, "-" + name) == 0; });
    };
    return std::any_of(call.arguments.begin(), call.arguments.end(), given);
}

/// "--edge" or, if the value was not on the command line, "--edge (from run.toml, line 3)".
std::string with_origin(const Call& call, const std::string& name) {
    const CLI::Option* option = find_option(call, name);
    if (option == nullptr || on_command_line(call, *option)) return name;
    if (in_environment(option->get_envname())) return fmt::format("{} (from {})", name, option->get_envname());
    const ConfigurationFile* file = configuration_file(call.app);
    const std::string origin = file == nullptr ? "" : file->origin(option);
    return origin.empty() ? name : fmt::format("{} (from {})", name, origin);
}

/// A message that starts "--option: …", with the origin of the value after the option.
std::string with_origin_in(const Call& call, const std::string& message) {
    const auto end = message.find(": ");
    if (end == std::string::npos || message.find(' ') < end) return message;
    return with_origin(call, message.substr(0, end)) + message.substr(end);
}

std::string subcommand_message(const CLI::App& app, const std::string& wrong) {
    const std::vector<std::string> names = subcommand_names(app);
    const std::string given = wrong.empty() ? "no subcommand given" : fmt::format("unknown subcommand \"{}\"", wrong);
    return fmt::format("{}; {}one of {} fits", given, wrong.empty() ? "" : suggestion(wrong, names), fmt::join(names, ", "));
}

/// What is left over: unknown options and arguments too many.
std::string leftover_message(const Call& call, const std::vector<std::string>& left) {
    for (const std::string& argument : left) {
        if (argument.size() < 2 || argument.front() != '-') continue;
        const std::string name = argument.substr(0, argument.find('='));
        std::vector<std::string> known;
        for (const CLI::App* each : running(call.app)) {
            for (const CLI::Option* option : each->get_options()) {
                for (const std::string& other : option->get_lnames()) known.push_back("--" + other);
            }
        }
        const std::string nearest = suggestion(name, known);
        for (const CLI::App* sub : call.app.get_subcommands({})) {
            if (sub->get_option_no_throw(name) != nullptr) {
                return fmt::format("{}: no option of {}, but of {}; see {}", name, running(call.app).back()->get_name(),
                                   sub->get_name(), help_command(call.app));
            }
        }
        return fmt::format("{}: unknown option; {}see {}", name, nearest, help_command(call.app));
    }
    const CLI::App* last = running(call.app).back();
    if (!last->get_subcommands({}).empty()) return subcommand_message(*last, left.front());
    return fmt::format("unexpected argument \"{}\"; see {}", left.front(), help_command(call.app));
}

/// CLI11's complaint in our words.
std::string message_of(const Call& call, const CLI::ParseError& error) {
    const std::string text = one_line(error.what());
    const auto before = [&](const std::string& mark) { return text.substr(0, text.find(mark)); };
    const std::vector<std::string> left = call.app.remaining(true);

    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr || dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
        if (!left.empty()) return leftover_message(call, left);
        if (text.find("subcommand") != std::string::npos) return subcommand_message(*running(call.app).back(), "");
        const CLI::Option* option = find_option(call, before(" "));
        if (option == nullptr) return fmt::format("{}; see {}", text, help_command(call.app));
        return fmt::format("{}: missing; it is needed: {}", shown_name(*option), option->get_description());
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        const std::string name = before(": ");
        const CLI::Option* option = find_option(call, name);
        if (text.find("missing") != std::string::npos) {
            return fmt::format("{}: no value given; write {} {}", name, name,
                               option == nullptr ? "VALUE" : option->get_type_name());
        }
        if (text.find("At Most") != std::string::npos || text.find("At most") != std::string::npos) {
            return fmt::format("{}: given more than once; give it once", with_origin(call, name));
        }
        return with_origin_in(call, text) + "; see " + help_command(call.app);
    }
    if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
        const std::string lead = "Could not convert: ";
        if (text.compare(0, lead.size(), lead) == 0) {
            const std::string name = text.substr(lead.size(), text.find(" = ") - lead.size());
            const auto value = text.find(" = ");
            const CLI::Option* option = find_option(call, name);
            return fmt::format("{}: \"{}\" does not fit; write {} {}", with_origin(call, name),
                               value == std::string::npos ? "" : text.substr(value + 3), name,
                               option == nullptr ? "VALUE" : option->get_type_name());
        }
        return with_origin_in(call, text) + "; see " + help_command(call.app);
    }
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr) {
        const auto mark = text.find(" excludes ");
        return fmt::format("{} and {}: only one of them can be given; leave one out", with_origin(call, text.substr(0, mark)),
                           with_origin(call, text.substr(mark + 10)));
    }
    if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr) {
        const auto mark = text.find(" requires ");
        return fmt::format("{}: not alone; give {} as well", with_origin(call, text.substr(0, mark)), text.substr(mark + 10));
    }
    if (dynamic_cast<const CLI::FileError*>(&error) != nullptr) {
        return fmt::format("--config: {} cannot be read; a TOML file is wanted", before(" was not readable"));
    }
    return fmt::format("{}; see {}", with_origin_in(call, text), help_command(call.app));
}

// --- effective configuration -----------------------------------------------------------------------------------------

/// A text as a TOML string.
std::string toml_string(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 32 || c == 127) {
            out += fmt::format("\\u{:04x}", static_cast<int>(c));
        } else {
            out += c;
        }
    }
    return out + '"';
}

/// A value as TOML: a number stands bare if it reads back as it was written.
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

std::string toml_line(const CLI::Option& option) {
    const std::string key = key_of(option);
    if (option.get_expected_min() == 0) {
        return option.count() > 0 && option.as<bool>() ? fmt::format("{} = true\n", key) : fmt::format("# {} = true\n", key);
    }
    std::vector<std::string> values = option.results();
    const bool many = option.get_items_expected_max() > 1;
    if (values.empty()) {
        const std::set<CLI::Option*> others = option.get_excludes();
        // the default stands unless another option takes its place, or may do so by a default of its own
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

// --- processors ------------------------------------------------------------------------------------------------------

/// Processors worth of time the control group of this process may use, or a large number.
double control_group_quota() {
    double least = 1e9;
    const auto take = [&](const std::string& quota, double period) {
        if (quota.empty() || quota == "max" || quota.front() == '-' || !(period > 0)) return;
        least = std::min(least, std::strtod(quota.c_str(), nullptr) / period);
    };
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {
        if (line.compare(0, 3, "0::") != 0) continue;
        for (std::string path = line.substr(3);; path.erase(path.find_last_of('/'))) {
            std::string quota;
            double period = 0;
            if (std::ifstream file("/sys/fs/cgroup" + path + "/cpu.max"); file >> quota >> period) take(quota, period);
            if (path.find('/') == std::string::npos) break;
        }
    }
    std::string quota;
    double period = 0;
    std::ifstream quota_file("/sys/fs/cgroup/cpu/cpu.cfs_quota_us");  // version 1
    std::ifstream period_file("/sys/fs/cgroup/cpu/cpu.cfs_period_us");
    if (quota_file >> quota && period_file >> period) take(quota, period);
    return least;
}

}  // namespace

namespace detail {

std::string long_name(const std::string& option) {
    const auto dashes = option.find("--");
    if (dashes == std::string::npos) return option.substr(0, option.find(','));
    return option.substr(dashes, option.find(',', dashes) - dashes);
}

CLI::Option* add_value(CLI::App& app, const std::string& option, const std::function<void(const std::string&)>& read,
                       const std::string& help, const std::string& type_name, const std::string& default_text) {
    CLI::callback_t callback = [read](const CLI::results_t& results) {
        read(results.front());
        return true;
    };
    if (!default_text.empty()) read(default_text);
    CLI::Option* added = app.add_option(option, std::move(callback), help);
    added->type_name(type_name);
    added->default_str(default_text);
    if (auto* file = configuration_file(app); file != nullptr) file->remember(added, read);
    return added;
}

}  // namespace detail

CLI::Option* add_quantity(CLI::App& app, const std::string& option, double& target, const Quantity& quantity,
                          const std::string& help, const std::string& default_text) {
    const std::string where = detail::long_name(option);
    return detail::add_value(
        app, option, [&target, quantity, where](const std::string& text) { target = parse_quantity(text, quantity, where); },
        help_of(help, quantity), type_name(quantity.dimension), default_text);
}

CLI::Option* add_quantity(CLI::App& app, const std::string& option, std::optional<double>& target, const Quantity& quantity,
                          const std::string& help) {
    const std::string where = detail::long_name(option);
    return detail::add_value(
        app, option, [&target, quantity, where](const std::string& text) { target = parse_quantity(text, quantity, where); },
        help_of(help, quantity), type_name(quantity.dimension), "");
}

CLI::Option* add_quantity_or(CLI::App& app, const std::string& option, double& target, const Quantity& quantity,
                             const std::string& word, double word_value, const std::string& help,
                             const std::string& default_text) {
    const std::string where = detail::long_name(option);
    return detail::add_value(
        app, option,
        [&target, quantity, where, word, word_value](const std::string& text) {
            target = parse_quantity_or(text, word, word_value, quantity, where);
        },
        help_of(help, quantity), type_name(quantity.dimension) + "|" + word, default_text);
}

CLI::Option* add_fracture_energy(CLI::App& app, std::optional<FractureEnergyChoice>& target, const std::string& help) {
    return detail::add_value(
        app, "--fracture-energy",
        [&target](const std::string& text) { target = parse_fracture_energy(text, "--fracture-energy"); },
        help_of(help, quantity::fracture_energy), "mixed|mode-i|ENERGY/AREA", "");
}

CLI::Option* add_choice(CLI::App& app, const std::string& option, std::string& target, const std::vector<std::string>& choices,
                        const std::string& help) {
    std::vector<std::pair<std::string, std::string>> pairs;
    pairs.reserve(choices.size());
    for (const std::string& choice : choices) pairs.emplace_back(choice, choice);
    return add_choice<std::string>(app, option, target, pairs, help);
}

CLI::Option* add_threads(CLI::App& app, int& threads) {
    threads = available_processors();
    return add_integer<int>(app, "--threads", threads, "threads; default: the processors this process may use", 1, 4096);
}

CLI::Option* add_dry_run(CLI::App& app, CommonOptions& options, const std::string& help) {
    return app.add_flag("--dry-run", options.dry_run, help);
}

void add_common_options(CLI::App& app, const std::string& tool, CommonOptions& options, const std::string& examples,
                        const std::vector<std::string>& libraries) {
    app.name(tool);
    app.option_defaults()->always_capture_default();
    app.formatter(std::make_shared<HelpFormatter>());
    app.get_formatter()->column_width(40);
    app.get_formatter()->label("OPTIONS", "options");
    app.get_formatter()->label("SUBCOMMAND", "subcommand");
    app.footer(
        "Numbers take units (4mm, 24.15MPa, 48.76deg); a bare number is SI. Any option may stand in the file of --config\n"
        "(TOML, by its name) or in the environment (GRAINCRACK_MAX_STRAIN for --max-strain); flags win over the\n"
        "environment, which wins over the file.\n\nExamples:\n" +
        examples);
    app.set_help_flag("-h,--help", "print this and exit");
    app.set_version_flag(
        "--version",
        [tool, libraries] {
            const std::string commit = project_commit();
            std::string text =
                fmt::format("{} {}{}", tool, project_version(), commit.empty() ? "" : fmt::format(" ({})", commit));
            for (const std::string& library : library_versions()) text += "\n" + library;
            for (const std::string& library : libraries) text += "\n" + library;
            return text + "\nCLI11 " CLI11_VERSION;
        },
        "print version, commit and libraries and exit");
    app.config_formatter(std::make_shared<ConfigurationFile>(app));
    app.allow_config_extras(CLI::config_extras_mode::error);
    app.set_config("--config", "", "TOML file with options by their names")->type_name("FILE")->configurable(false);
    app.add_flag("--print-config", options.print_config, "print the effective options as TOML for --config and exit")
        ->configurable(false);
    const auto say = [&options](Verbosity verbosity) { return [&options, verbosity] { options.verbosity = verbosity; }; };
    CLI::Option* quiet = app.add_flag_callback("-q,--quiet", say(Verbosity::quiet), "say nothing but errors");
    CLI::Option* verbose = app.add_flag_callback("-v,--verbose", say(Verbosity::verbose), "say more");
    quiet->excludes(verbose);
}

bool parse_command_line(CLI::App& app, int argc, const char* const* argv) {
    Call call{app, {argv + std::min(argc, 1), argv + argc}};
    const auto ends = std::find(call.arguments.begin(), call.arguments.end(), "--");
    const bool print_config = std::find(call.arguments.begin(), ends, "--print-config") != ends;
    std::vector<CLI::Option*> required;
    name_variables(app);
    for_each_app(app, [&](CLI::App& each) {
        if (each.get_parent() != nullptr) {
            each.fallthrough();
            // only now, for a variable is no concern of subcommands that do not run
            each.preparse_callback([&each](std::size_t) { name_variables(each); });
        }
        for (CLI::Option* option : each.get_options()) {
            if (print_config && option->get_required()) {
                required.push_back(option);
                option->required(false);
            }
        }
    });
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        app.exit(success, std::cout, std::cerr);
        return false;
    } catch (const CLI::ParseError& error) {
        throw UsageError(message_of(call, error));
    } catch (const UsageError& error) {
        throw UsageError(with_origin_in(call, error.what()));
    }
    if (const ConfigurationFile* file = configuration_file(app); file != nullptr) {
        for (CLI::App* each : running(app)) {
            for (const CLI::Option* option : each->get_options()) file->apply_default(option);
        }
    }
    if (!print_config) return true;
    for (CLI::Option* option : required) option->required();
    std::cout << effective_configuration(app);
    return false;
}

std::string effective_configuration(const CLI::App& app) {
    std::string text;
    std::string section;
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

int available_processors() {
    int processors = 0;
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) == 0) processors = CPU_COUNT(&set);
    if (processors < 1) processors = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, static_cast<int>(std::min<double>(processors, std::ceil(control_group_quota() - 1e-6))));
}

}  // namespace graincrack
