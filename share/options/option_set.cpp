#include "share/options/option_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"
#include "share/options/configuration_file.hpp"
#include "share/rock/material.hpp"

namespace graincrack {
namespace {

std::string type_name(Dimension dimension) { return std::string(row_of(dimension).option_type); }

/// Help with units and bounds: "mean edge [m, mm, cm, um, km]", "strain limit [above 0 and at most 0.5; %]". Pure numbers have
/// informative bounds only, and % if they are parts of a whole.
std::string help_of(const std::string& help, const Quantity& quantity) {
    std::vector<std::string> parts;
    if (quantity.dimension == Dimension::one) {
        if (quantity.upper <= 10) parts.push_back(bounds_text(quantity));
        if (quantity.upper <= 1) parts.push_back("%");
    } else {
        std::vector<std::string_view> symbols;
        for (const Unit& unit : units_of(quantity.dimension)) symbols.push_back(unit.symbol);
        parts.push_back(fmt::to_string(fmt::join(symbols, ", ")));
    }
    return parts.empty() ? help : fmt::format("{} [{}]", help, fmt::join(parts, "; "));
}

/// "--edge" of "-e,--edge"; the name of a positional argument unchanged.
std::string long_name(const std::string& option) {
    const auto dashes = option.find("--");
    if (dashes == std::string::npos) return option.substr(0, option.find(','));
    return option.substr(dashes, option.find(',', dashes) - dashes);
}

/// Reads a whole number within bounds. \throws UsageError naming `where`
template <class T>
T parse_integer(const std::string& text, const std::string& where, T lower, T upper) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || value < lower || value > upper) {
        const bool open = upper == std::numeric_limits<T>::max();
        throw UsageError(
            where + ": \"" + text + "\" does not fit; it must be a whole number " +
            (open ? "of at least " + std::to_string(lower) : "from " + std::to_string(lower) + " to " + std::to_string(upper)));
    }
    return value;
}

/// The value of a target as a setting.
template <class T>
SettingValue value_of(const T& target) {
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, bool> || std::is_same_v<T, std::uint64_t>) {
        return target;
    } else if constexpr (std::is_integral_v<T>) {
        return static_cast<double>(target);
    } else {
        return target.empty() ? SettingValue() : SettingValue(target);
    }
}
template <class T>
SettingValue value_of(const std::optional<T>& target) {
    return target ? value_of(*target) : SettingValue();
}

/// The handle of a CLI11 option, whose value is that of a target.
template <class Target>
Option keep(OptionSet set, CLI::Option* added, Target& target) {
    auto* const file = configuration_file(set.app());
    if (file != nullptr) file->remember(added, {.read = nullptr, .value = [&target] { return value_of(target); }});
    return {added, file};
}

/// Adds an option with one value and stores its bounds for the description.
Option add_bounded(OptionSet set, const std::string& option, const ConfigurationFile::Value& value, const std::string& help,
                   const std::string& type_name, const std::string& default_text) {
    CLI::callback_t callback = [read = value.read](const CLI::results_t& results) {
        for (const std::string& text : results) read(text);
        return true;
    };
    if (!default_text.empty()) value.read(default_text);
    CLI::Option* added = set.app().add_option(option, std::move(callback), help);
    added->type_name(type_name);
    added->default_str(default_text);
    auto* const file = configuration_file(set.app());
    if (file != nullptr) file->remember(added, value);
    return {added, file};
}

}  // namespace

Option Option::required() { return {option_->required(), file_}; }
Option Option::type_name(const std::string& name) { return {option_->type_name(name), file_}; }
Option Option::only_on_command_line() { return {option_->configurable(false), file_}; }
Option Option::excludes(Option other) { return {option_->excludes(other.option_), file_}; }
Option Option::needs(Option other) { return {option_->needs(other.option_), file_}; }
Option Option::repeatable() { return {option_->multi_option_policy(CLI::MultiOptionPolicy::TakeAll), file_}; }
Option Option::of(SettingGroup group) { return of(group, nullptr); }
Option Option::of(SettingGroup group, const std::function<SettingValue()>& value) {
    if (file_ != nullptr) file_->make_setting(option_, group, value);
    return *this;
}

OptionSet OptionSet::usual() const { return OptionSet(app_, usual_options); }
OptionSet OptionSet::seldom() const { return OptionSet(app_, seldom_options); }

CLI::App& OptionSet::app() const {
    app_->option_defaults()->group(group_);
    return *app_;
}

OptionSet OptionSet::add_subcommand(const std::string& name, const std::string& help, const std::string& examples) {
    app().require_subcommand(1);
    CLI::App* added = app_->add_subcommand(name, help);
    if (!examples.empty()) added->footer("Examples:\n" + examples);
    return OptionSet(added);
}

bool OptionSet::is_called() const { return app_->parsed(); }

Option add_text(OptionSet set, const std::string& option, std::string& target, const std::string& help) {
    return keep(set, set.app().add_option(option, target, help), target);
}

Option add_texts(OptionSet set, const std::string& option, std::vector<std::string>& target, const std::string& type,
                 const std::string& help) {
    const auto read = [&target](const std::string& text) { target.push_back(text); };
    return add_bounded(set, option, {.read = read, .value = [&target] { return value_of(target); }}, help, type, "").repeatable();
}

Option add_files(OptionSet set, const std::string& name, std::vector<std::string>& target, const std::string& help,
                 bool several) {
    CLI::Option* added = set.app().add_option(name, target, help)->type_name("FILE")->default_str("");
    return {several ? added : added->expected(1, CLI::detail::expected_max_vector_size - 1), configuration_file(set.app())};
}

Option add_output_file(OptionSet set, std::string& target, const std::string& help, const std::vector<std::string>& endings) {
    CLI::Option* added = set.app().add_option("-o,--output", target, help)->type_name(endings.empty() ? "FOLDER" : "FILE");
    auto* const file = configuration_file(set.app());
    if (file != nullptr) file->remember(added, {.read = nullptr, .endings = endings});
    return {added, file};
}

Option add_flag(OptionSet set, const std::string& option, bool& target, const std::string& help) {
    return keep(set, set.app().add_flag(option, target, help), target);
}

Option add_flag(OptionSet set, const std::string& option, const std::function<void()>& action, const std::string& help) {
    return {set.app().add_flag_callback(option, action, help), configuration_file(set.app())};
}

Option add_value(OptionSet set, const std::string& option, const std::function<void(const std::string&)>& read,
                 const std::string& help, const std::string& type_name, const std::string& default_text) {
    return add_bounded(set, option, {.read = read}, help, type_name, default_text);
}

Option add_value(OptionSet set, const std::string& option, const std::function<void(const std::string&)>& read,
                 const Quantity& quantity, const std::string& help, const std::string& type_name,
                 const std::string& default_text) {
    return add_bounded(set, option, {.read = read, .bounds = quantity}, help_of(help, quantity), type_name, default_text);
}

template <class Target>
Option add_quantity(OptionSet set, const std::string& option, Target& target, const Quantity& quantity, const std::string& help,
                    const std::string& default_text) {
    const auto read = [&target, quantity, where = long_name(option)](const std::string& text) {
        target = parse_quantity(text, quantity, where);
        note_bare_number(text, quantity, where);
    };
    return add_bounded(set, option, {.read = read, .bounds = quantity, .value = [&target] { return value_of(target); }},
                       help_of(help, quantity), type_name(quantity.dimension), default_text);
}
template Option add_quantity(OptionSet, const std::string&, double&, const Quantity&, const std::string&, const std::string&);
template Option add_quantity(OptionSet, const std::string&, std::optional<double>&, const Quantity&, const std::string&,
                             const std::string&);

Option add_quantity_or(OptionSet set, const std::string& option, double& target, const Quantity& quantity,
                       const std::string& word, double word_value, const std::string& help, const std::string& default_text) {
    const std::string where = long_name(option);
    const auto read = [&target, quantity, where, word, word_value](const std::string& text) {
        target = parse_quantity_or(text, word, word_value, quantity, where);
    };
    return add_bounded(set, option, {.read = read, .bounds = quantity, .value = [&target] { return value_of(target); }},
                       help_of(help, quantity), type_name(quantity.dimension) + "|" + word, default_text);
}

Option add_fracture_energy(OptionSet set, std::optional<FractureEnergyChoice>& target, const std::string& help) {
    return add_value(
        set, "--fracture-energy",
        [&target](const std::string& text) { target = parse_fracture_energy(text, "--fracture-energy"); },
        contact_parameter(&ContactParameters::fracture_energy).quantity, help, "mixed|mode-i|ENERGY/AREA");
}

template <class T, class Target>
Option add_integer(OptionSet set, const std::string& option, Target& target, const std::string& help, T lower, T upper) {
    std::string default_text;
    if constexpr (std::is_same_v<T, Target>) default_text = std::to_string(target);
    const auto read = [&target, where = long_name(option), lower, upper](const std::string& text) {
        target = parse_integer<T>(text, where, lower, upper);
    };
    const double most = upper == std::numeric_limits<T>::max() ? quantity::unbounded : static_cast<double>(upper);
    const Quantity bounds{"", Dimension::one, static_cast<double>(lower), most, ""};
    return add_bounded(set, option, {.read = read, .bounds = bounds, .value = [&target] { return value_of(target); }}, help, "N",
                       default_text);
}
template Option add_integer(OptionSet, const std::string&, int&, const std::string&, int, int);
template Option add_integer(OptionSet, const std::string&, std::optional<int>&, const std::string&, int, int);
template Option add_integer(OptionSet, const std::string&, std::int64_t&, const std::string&, std::int64_t, std::int64_t);
template Option add_integer(OptionSet, const std::string&, std::optional<std::int64_t>&, const std::string&, std::int64_t,
                            std::int64_t);
template Option add_integer(OptionSet, const std::string&, std::uint64_t&, const std::string&, std::uint64_t, std::uint64_t);
template Option add_integer(OptionSet, const std::string&, std::optional<std::uint64_t>&, const std::string&, std::uint64_t,
                            std::uint64_t);

Option add_keyword(OptionSet set, const std::string& option, const std::vector<std::string>& words,
                   const std::function<void(std::size_t)>& choose, const std::function<std::string()>& word,
                   const std::string& help, const std::string& default_word) {
    const std::string keywords = fmt::to_string(fmt::join(words, "|"));
    const auto read = [words, choose, keywords, where = long_name(option)](const std::string& text) {
        const auto found = std::find(words.begin(), words.end(), text);
        if (found == words.end()) {
            throw UsageError(
                fmt::format("{}: unknown choice \"{}\"; one of {} fits", where, printable(text.substr(0, 40)), keywords));
        }
        choose(static_cast<std::size_t>(found - words.begin()));
    };
    const auto value = [word] { return value_of(word()); };
    return add_bounded(set, option, {.read = read, .value = value}, help, keywords, default_word);
}

Option add_choice(OptionSet set, const std::string& option, std::string& target, const std::vector<std::string>& choices,
                  const std::string& help) {
    const auto choose = [&target, choices](std::size_t i) { target = choices[i]; };
    const bool is_choice = std::find(choices.begin(), choices.end(), target) != choices.end();
    return add_keyword(
        set, option, choices, choose, [&target] { return target; }, help, is_choice ? target : "");
}

std::vector<std::string>& bare_number_notes() {
    static std::vector<std::string> notes;
    return notes;
}

void note_bare_number(std::string_view text, const Quantity& quantity, const std::string& where) {
    const std::string note = bare_number_note(text, quantity, where);
    const bool is_known = std::find(bare_number_notes().begin(), bare_number_notes().end(), note) != bare_number_notes().end();
    if (!note.empty() && !is_known) bare_number_notes().push_back(note);
}

}  // namespace graincrack
