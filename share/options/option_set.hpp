// Declares the options of a program or one of its subcommands: texts, flags, numbers, choices, and quantities with units. The
// handles hide CLI11, the library that reads command lines, which only share/options uses.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "share/base/quantities.hpp"
#include "share/file/settings.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): a name of CLI11
class App;
class Option;
}  // namespace CLI

namespace graincrack {

class ConfigurationFile;
struct FractureEnergyChoice;

/// A declared option with its further properties: `add_text(set, …).type_name("FILE").required()`.
class Option {
public:
    Option(CLI::Option* option, ConfigurationFile* file) : option_(option), file_(file) {}

    Option required();
    /// Sets the name of its value in help.
    Option type_name(const std::string& name);
    /// Excludes it from configuration files.
    Option only_on_command_line();
    /// Allows only one of the two.
    Option excludes(Option other);
    /// Refuses it without the other.
    Option needs(Option other);
    /// Allows repetition: each value is read.
    Option repeatable();
    /// Makes its value a setting of this group (`CommandLine::settings`); other options are not stored in files.
    Option of(SettingGroup group);
    /// Does the same with a value other than that of its target.
    Option of(SettingGroup group, const std::function<SettingValue()>& value);

private:
    CLI::Option* option_;
    ConfigurationFile* file_;
};

/// A handle of the options of a program or subcommand. It is valid as long as its `CommandLine`.
class OptionSet {
public:
    explicit OptionSet(CLI::App* app, const char* group = "Options") : app_(app), group_(group) {}

    /// The same set for frequently used options: --help of a command that has some shows these and the required ones.
    [[nodiscard]] OptionSet usual() const;
    /// The same set for options that --help omits; --help-all shows all.
    [[nodiscard]] OptionSet seldom() const;

    /// Adds a subcommand, one of which is then required. \param examples for its help; "": those of the program
    OptionSet add_subcommand(const std::string& name, const std::string& help, const std::string& examples = "");
    /// True if the subcommand was called.
    [[nodiscard]] bool is_called() const;
    /// The CLI11 object, for the sources of share/options. Their options go to the group of this set.
    [[nodiscard]] CLI::App& app() const;

private:
    CLI::App* app_;
    const char* group_;  ///< group of the options in help
};

/// Adds an option or positional argument; help shows the text of `target` as the default.
Option add_text(OptionSet set, const std::string& option, std::string& target, const std::string& help);
/// Adds an option that may be repeated. \param type of its value in help
Option add_texts(OptionSet set, const std::string& option, std::vector<std::string>& target, const std::string& type,
                 const std::string& help);
/// Adds a positional argument of files. \param several true: any number; false: one, and the caller refuses more
Option add_files(OptionSet set, const std::string& name, std::vector<std::string>& target, const std::string& help,
                 bool several = true);
/// Adds -o, --output. \param endings of file names, the usual one first: ".png"; empty for a folder
Option add_output_file(OptionSet set, std::string& target, const std::string& help, const std::vector<std::string>& endings);
Option add_flag(OptionSet set, const std::string& option, bool& target, const std::string& help);
/// Does the same for a flag that calls an action.
Option add_flag(OptionSet set, const std::string& option, const std::function<void()>& action, const std::string& help);
/// Adds an option with one value, read by `read`, whose exceptions propagate. A non-empty `default_text` is read at once and
/// shown in help.
Option add_value(OptionSet set, const std::string& option, const std::function<void(const std::string&)>& read,
                 const std::string& help, const std::string& type_name, const std::string& default_text = "");
/// Does the same for a quantity, or for words in its place: help lists units, and bounds of pure numbers up to 10.
Option add_value(OptionSet set, const std::string& option, const std::function<void(const std::string&)>& read,
                 const Quantity& quantity, const std::string& help, const std::string& type_name,
                 const std::string& default_text = "");

/// Adds an option for a quantity with a unit ("--edge 4mm"). `target` is SI, a `double` or an optional one, which is unset if the
/// option is not given. A non-empty `default_text` sets the target and is shown in help.
template <class Target>
Option add_quantity(OptionSet set, const std::string& option, Target& target, const Quantity& quantity, const std::string& help,
                    const std::string& default_text = "");
/// Does the same with a keyword in place of a value: "--damping 0.8|none".
Option add_quantity_or(OptionSet set, const std::string& option, double& target, const Quantity& quantity,
                       const std::string& word, double word_value, const std::string& help, const std::string& default_text = "");
/// Adds --fracture-energy mixed|mode-i|VALUE.
Option add_fracture_energy(OptionSet set, std::optional<FractureEnergyChoice>& target, const std::string& help);

/// Adds an option for a whole number T, `int`, `std::int64_t` or `std::uint64_t`. `target` is a T, whose value is shown as the
/// default, or an optional T, unset if the option is not given.
template <class T, class Target>
Option add_integer(OptionSet set, const std::string& option, Target& target, const std::string& help, T lower,
                   T upper = std::numeric_limits<T>::max());

/// Adds an option that takes one of several keywords, whose index `choose` receives. \param default_word "" for none
/// \param word returns the keyword in use, "" for none
Option add_keyword(OptionSet set, const std::string& option, const std::vector<std::string>& words,
                   const std::function<void(std::size_t)>& choose, const std::function<std::string()>& word,
                   const std::string& help, const std::string& default_word);
/// Adds an option that takes one of several keywords; help shows the keyword of `target` as the default.
template <class T>
Option add_choice(OptionSet set, const std::string& option, T& target, const std::vector<std::pair<std::string, T>>& choices,
                  const std::string& help) {
    std::vector<std::string> words;
    std::vector<T> values;
    std::string default_word;
    for (const auto& [word, value] : choices) {
        words.push_back(word);
        values.push_back(value);
        if (value == target) default_word = word;
    }
    const auto word = [&target, words, values] {
        const auto found = std::find(values.begin(), values.end(), target);
        return found == values.end() ? "" : words[static_cast<std::size_t>(found - values.begin())];
    };
    return add_keyword(
        set, option, words, [&target, values](std::size_t i) { target = values[i]; }, word, help, default_word);
}
/// Does the same with the keyword itself as the value.
Option add_choice(OptionSet set, const std::string& option, std::string& target, const std::vector<std::string>& choices,
                  const std::string& help);

/// Notes on numbers without units, in the order in which options are read.
std::vector<std::string>& bare_number_notes();
/// Adds the note on a number, if there is one and it is new. \param where as in `bare_number_note`
void note_bare_number(std::string_view text, const Quantity& quantity, const std::string& where);

}  // namespace graincrack
