#include "share/file/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "share/base/error.hpp"
#include "share/base/units.hpp"
#include "share/file/h5_file.hpp"

namespace graincrack {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char *request_attribute = "request", *fields_attribute = "request_fields";
constexpr std::array<std::string_view, 15> group_names{"none",       "seed",     "test",    "pressure", "heat",
                                                       "plane",      "material", "shape",   "size",     "cuts",
                                                       "grain_size", "fabric",   "loading", "rate",     "end"};

Json json_of(const SettingValue& value) {
    return std::visit(
        [](const auto& held) -> Json {
            if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
                return nullptr;
            } else {
                return held;
            }
        },
        value);
}

SettingValue value_of(const Json& json) {
    if (json.is_null()) return std::monostate{};
    if (json.is_boolean()) return json.get<bool>();
    if (json.is_number_unsigned()) return json.get<std::uint64_t>();
    if (json.is_number()) return json.get<double>();
    if (json.is_string()) return json.get<std::string>();
    if (!json.empty() && json.front().is_string()) return json.get<std::vector<std::string>>();
    return json.get<std::vector<double>>();
}

Dimension dimension_of(const std::string& unit) {
    const auto dimension = dimension_of_unit(unit);
    if (!dimension) throw InputError("unknown unit " + unit);
    return *dimension;
}

SettingGroup group_named(const std::string& name) {
    const auto* const found = std::find(group_names.begin(), group_names.end(), name);
    if (found == group_names.end()) throw InputError("unknown group " + name);
    return static_cast<SettingGroup>(found - group_names.begin());
}

/// The first few of many values, joined.
template <class Values, class Show>
std::string shown_list(const Values& values, const Show& show) {
    constexpr std::size_t most = 6;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(values.size(), most); ++i) texts.push_back(show(values[i]));
    return fmt::format("{}{}", fmt::join(texts, " "), values.size() > most ? fmt::format(" … ({})", values.size()) : "");
}

}  // namespace

std::string_view name_of(SettingGroup group) { return group_names[static_cast<std::size_t>(group)]; }

const Setting* find_setting(const Settings& settings, std::string_view name) {
    const auto found = std::find_if(settings.begin(), settings.end(), [&](const Setting& each) { return each.name == name; });
    return found == settings.end() ? nullptr : &*found;
}

double number_of(const Settings& settings, std::string_view name) {
    const Setting* const setting = find_setting(settings, name);
    const double* const number = setting == nullptr ? nullptr : std::get_if<double>(&setting->value);
    return number == nullptr ? std::numeric_limits<double>::quiet_NaN() : *number;
}

std::string text_of(const Settings& settings, std::string_view name) {
    const Setting* const setting = find_setting(settings, name);
    const std::string* const text = setting == nullptr ? nullptr : std::get_if<std::string>(&setting->value);
    return text == nullptr ? "" : *text;
}

std::string option_name(const Setting& setting) {
    std::string name = setting.name;
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

std::string shown(const Setting& setting, int digits) {
    struct Show {
        const Setting& setting;
        int digits;
        std::string operator()(std::monostate) const { return "none"; }
        std::string operator()(bool value) const { return value ? "given" : "left out"; }
        std::string operator()(double value) const {
            const bool is_none = value == 0 && option_name(setting) == "peak-drop";  // --peak-drop none
            return is_none ? "none" : format_quantity(value, setting.dimension, digits);
        }
        std::string operator()(std::uint64_t value) const { return std::to_string(value); }
        std::string operator()(const std::string& value) const { return value.empty() ? "none" : value.substr(0, 60); }
        std::string operator()(const std::vector<double>& values) const {
            return values.empty() ? "none" : shown_list(values, [this](double value) { return (*this)(value); });
        }
        std::string operator()(const std::vector<std::string>& values) const {
            return values.empty() ? "none" : shown_list(values, [](const std::string& value) { return value; });
        }
    };
    return std::visit(Show{setting, digits}, setting.value);
}

std::pair<const Setting*, const Setting*> first_difference(const Settings& a, const Settings& b,
                                                           const std::vector<SettingGroup>& ignored) {
    const auto counts = [&](const Setting& each) {
        return std::find(ignored.begin(), ignored.end(), each.group) == ignored.end();
    };
    for (const Setting& own : a) {
        const Setting* const other = find_setting(b, own.name);
        if (counts(own) && (other == nullptr || other->value != own.value)) return {&own, other};
    }
    for (const Setting& other : b) {
        if (counts(other) && find_setting(a, other.name) == nullptr) return {nullptr, &other};
    }
    return {nullptr, nullptr};
}

void write_settings(H5Output& file, const std::string& group, const Settings& settings) {
    Json request = Json::object(), fields = Json::object();
    for (const Setting& setting : settings) {
        request[setting.name] = json_of(setting.value);
        fields[setting.name] = {{"unit", si_unit(setting.dimension)}, {"group", name_of(setting.group)}};
    }
    file.attribute(group, request_attribute, request.dump());
    file.attribute(group, fields_attribute, fields.dump());
}

Settings read_settings(const H5Input& file, const std::string& group) {
    const auto text = file.attribute_or<std::string>(group, request_attribute, "");
    if (text.empty()) return {};
    Settings settings;
    try {
        const Json request = Json::parse(text);
        const Json fields = Json::parse(file.attribute<std::string>(group, fields_attribute));
        for (const auto& [name, value] : request.items()) {
            const Json& field = fields.at(name);
            settings.push_back({name, value_of(value), dimension_of(field.at("unit")), group_named(field.at("group"))});
        }
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: attribute {} of {} is damaged ({}); make the file again", file.name(),
                                     request_attribute, group, error.what()));
    }
    return settings;
}

}  // namespace graincrack
