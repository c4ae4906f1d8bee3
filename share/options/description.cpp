#include "share/options/description.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "share/base/units.hpp"
#include "share/options/configuration_file.hpp"

namespace graincrack {
namespace {

using Json = nlohmann::ordered_json;

bool is_word(const std::string& text) {
    return !text.empty() && std::none_of(text.begin(), text.end(), [](char c) { return c >= 'A' && c <= 'Z'; });
}

/// True if the value is a whole number.
bool is_whole(const CLI::Option& option) { return option.get_type_name() == "N"; }

/// The kind of value of an option. \param alternatives of its value as shown in help: "auto", "SPEED"
std::string type_of(const CLI::Option& option, const std::optional<Quantity>& bounds,
                    const std::vector<std::string>& alternatives) {
    if (option.get_expected_min() == 0) return "flag";
    if (bounds) return is_whole(option) ? "integer" : "quantity";
    if (std::all_of(alternatives.begin(), alternatives.end(), is_word)) return "choice";
    if (option.get_type_name() == "FOLDER") return "folder";
    const auto is_file = [](const std::string& text) { return text == "FILE" || text == "FOLDER" || text == "-"; };
    return std::all_of(alternatives.begin(), alternatives.end(), is_file) ? "file" : "text";
}

void add_bounds(Json& own, const Quantity& bounds, bool whole) {
    if (!whole) {
        own["unit"] = bounds.unit();
        for (const Unit& unit : units_of(bounds.dimension)) own["units"].push_back(unit.symbol);
    }
    for (const auto& [name, value] : {std::pair{"minimum", bounds.lower}, {"maximum", bounds.upper}}) {
        if (std::isfinite(value)) own[name] = whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
    }
    if (bounds.open_below) own["exclusive_minimum"] = true;
}

/// The names of options, sorted. CLI11 keeps options in the order of their addresses.
std::set<std::string> keys_of(const std::set<CLI::Option*>& options) {
    std::set<std::string> keys;
    for (const CLI::Option* option : options) keys.insert(key_of(*option));
    return keys;
}

Json describe(const CLI::Option& option, const ConfigurationFile::Value& kept, bool usual) {
    const bool is_positional = !option.nonpositional();
    const std::vector<std::string> alternatives = CLI::detail::split(option.get_type_name(), '|');
    const std::string type = type_of(option, kept.bounds, alternatives);
    Json own{{"name", CLI::detail::to_lower(key_of(option))}};
    const auto add = [&](const char* name, const auto& value, bool holds) {
        if (holds) own[name] = value;
    };
    if (!option.get_snames().empty()) own["short"] = option.get_snames().front();
    add("positional", true, is_positional);
    own["type"] = type;
    if (kept.bounds) add_bounds(own, *kept.bounds, type == "integer");
    add("endings", kept.endings, !kept.endings.empty());
    for (const std::string& word : alternatives) {
        if (type != "flag" && is_word(word)) own["choices"].push_back(word);
    }
    add("default", shown_default(option), !shown_default(option).empty());
    add("required", true, option.get_required());
    add("repeatable", true, !is_positional && option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll);
    add("many", true, option.get_expected_max() == CLI::detail::expected_max_vector_size);
    add("excludes", keys_of(option.get_excludes()), !option.get_excludes().empty());
    add("needs", keys_of(option.get_needs()), !option.get_needs().empty());
    add("usual", true, usual || is_positional);
    own["meaning"] = option.get_description();
    return own;
}

}  // namespace

bool is_help(const CLI::Option* option, const CLI::App* app) {
    return option == app->get_help_ptr() || option == app->get_help_all_ptr();
}

std::vector<const CLI::Option*> shown_options(const CLI::App* app, bool all) {
    const auto is_usual = [](const CLI::Option* option) { return option->get_group() == usual_options; };
    const bool has_usual = !app->get_options(is_usual).empty();
    const auto is_shown = [&](const CLI::Option* option) {
        return is_help(option, app) || option->get_required() ||
               (has_usual ? is_usual(option) : option->get_group() != seldom_options);
    };
    return app->get_options([&](const CLI::Option* option) { return option->nonpositional() && (all || is_shown(option)); });
}

std::string shown_default(const CLI::Option& option) {
    return option.get_type_size() == 0 || option.get_required() ? "" : option.get_default_str();
}

nlohmann::ordered_json describe(const CLI::App& app) {
    Json own{{"name", app.get_name()},
             {"description", app.get_description()},
             {"options", Json::array()},
             {"commands", Json::array()}};
    const ConfigurationFile* file = configuration_file(app);
    const std::vector<const CLI::Option*> usual = shown_options(&app, false);
    for (const CLI::Option* option : app.get_options()) {
        if (is_help(option, &app) && app.get_parent() != nullptr) continue;  // each command has these
        own["options"].push_back(
            describe(*option, file->value(option), std::find(usual.begin(), usual.end(), option) != usual.end()));
    }
    for (const CLI::App* command : app.get_subcommands(nullptr)) own["commands"].push_back(describe(*command));
    return own;
}

}  // namespace graincrack
