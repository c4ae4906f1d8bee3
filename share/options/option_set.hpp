// The options of a program or of one of its subcommands, as they are declared: texts, flags, numbers, choices, and quantities
// with units. The handles here stand for what share/options keeps; the library that reads command lines, CLI11, is known there
// alone.
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

/// An option that has been declared, and what else is asked of it: `add_text(set, …).type_name("FILE").required()`.
class Option {
public:
    Option(CLI::Option* option, ConfigurationFile* file) : option_(option), file_(file) {}

    Option required();
    /// How help names its value.
    Option type_name(const std::string& name);
    /// Leaves it out of configuration files.
    Option only_on_command_line();
    /// Only one of the two may be given.
    Option excludes(Option other);
    /// Given alone, it is refused.
    Option needs(Option other);
    /// May be given again: each value is read.
    Option repeatable();
    /// Its effective value is a setting of this group (`CommandLine::settings`); other options stand in no file.
    Option of(SettingGroup group);
    /// The same with a value other than that of its target.
    Option of(SettingGroup group, const std::function<SettingValue()>& value);

private:
    CLI::Option* option_;
    ConfigurationFile* file_;
};

/// A handle of the options of a program or subcommand; valid as long as the `CommandLine` it came from.
class OptionSet {
public:
    explicit OptionSet(CLI::App* app, const char* group = "Options") : app_(app), group_(group) {}

    /// The same set for options that many people use: --help of a command that has some shows these and what is required.
    [[nodiscard]] OptionSet usual() const;
    /// The same set for options that --help leaves out; --help-all has all.
    [[nodiscard]] OptionSet seldom() const;

    /// Adds a subcommand, one of which must be called then. \param examples for its help; those of the program unless given
    OptionSet add_subcommand(const std::string& name, const std::string& help, const std::string& examples = "");
    /// Whether the subcommand was called.
    [[nodiscard]] bool is_called() const;
    /// For the sources of share/options, whose options go to the group of this set.
    [[nodiscard]] CLI::App& app() const;

private:
    CLI::App* app_;
    const char* group_;  ///< in which help sorts the options
};

/// Adds an option or positional argument; help shows the text of `target` as the default.
Option add_text(OptionSet set, const std::string& option, std::string& target, const std::string& help);
/// Adds an option that may be given again. \param type of its value, as help shows it
Option add_texts(OptionSet set, const std::string& option, std::vector<std::string>& target, const std::string& type,
                 const std::string& help);
/// Adds a positional argument of files. \param several any number; else one, and the caller refuses more
Option add_files(OptionSet set, const std::string& name, std::vector<std::string>& target, const std::string& help,
                 bool several = true);
/// Adds -o, --output. \param endings of the name of a file, the usual one first: ".png"; none for a folder
Option add_output_file(OptionSet set, std::string& target, const std::string& help, const std::vector<std::string>& endings);
Option add_flag(OptionSet set, const std::string& option, bool& target, const std::string& help);
/// The same where the flag stands for an action.
Option add_flag(OptionSet set, const std::string& option, const std::function<void()>& action, const std::string& help);
/// Adds an option with one value, read by `read`, whose exceptions pass through. If `default_text` is not empty, it is read at
/// once and help shows it.
Option add_value(OptionSet set, const std::string& option, const std::function<void(const std::string&)>& read,
                 const std::string& help, const std::string& type_name, const std::string& default_text = "");
/// The same of a quantity, or of words in its place: help names units and the bounds of pure numbers up to 10.
Option add_value(OptionSet set, const std::string& option, const std::function<void(const std::string&)>& read,
                 const Quantity& quantity, const std::string& help, const std::string& type_name,
                 const std::string& default_text = "");

/// Adds an option for a quantity with a unit ("--edge 4mm"). `target` is SI, a `double` or an optional one, unset if the option
/// is not given. If `default_text` is not empty, the target is set from it and help shows it.
template <class Target>
Option add_quantity(OptionSet set, const std::string& option, Target& target, const Quantity& quantity, const std::string& help,
                    const std::string& default_text = "");
/// The same where a keyword stands for a value: "--damping 0.8|none".
Option add_quantity_or(OptionSet set, const std::string& option, double& target, const Quantity& quantity,
                       const std::string& word, double word_value, const std::string& help, const std::string& default_text = "");
/// Adds --fracture-energy mixed|mode-i|VALUE.
Option add_fracture_energy(OptionSet set, std::optional<FractureEnergyChoice>& target, const std::string& help);

/// Adds an option for a whole number T, `int`, `std::int64_t` or `std::uint64_t`. `target` is one, whose value help shows as the
/// default, or an optional one, unset if the option is not given.
template <class T, class Target>
Option add_integer(OptionSet set, const std::string& option, Target& target, const std::string& help, T lower,
                   T upper = std::numeric_limits<T>::max());

/// Adds an option that takes one of several keywords, whose index `choose` gets. \param default_word "" for none
/// \param word of its effective value, "" for none
Option add_keyword(OptionSet set, const std::string& option, const std::vector<std::string>& words,
                   const std::function<void(std::size_t)>& choose, const std::function<std::string()>& word,
                   const std::string& help, const std::string& default_word);
/// Adds an option that takes one of several keywords; help shows the keyword of the value of `target` as the default.
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
/// The same with the keyword itself as the value.
Option add_choice(OptionSet set, const std::string& option, std::string& target, const std::vector<std::string>& choices,
                  const std::string& help);

/// What bare numbers were taken for, as the options are read.
std::vector<std::string>& bare_number_notes();
/// Adds the note on a number, unless there is none or it is there already. \param where as in `bare_number_note`
void note_bare_number(std::string_view text, const Quantity& quantity, const std::string& where);

}  // namespace graincrack
