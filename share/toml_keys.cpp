#include "share/toml_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "share/error.hpp"
#include "share/units.hpp"

namespace graincrack {
namespace {

double read_value(const TomlEntry& entry, const Quantity& quantity, const std::string& where) {
    if (entry.is_array || entry.values.front().kind == TomlValue::Kind::boolean) {
        throw InputError(fmt::format("{}: {} is no quantity; a text with a unit or a bare number in {} fits", where,
                                     entry.is_array ? "an array" : entry.values.front().text, quantity.unit()));
    }
    try {
        return parse_quantity(entry.values.front().text, quantity, where);
    } catch (const UsageError& error) {
        throw InputError(error.what());
    }
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::string nearest = nearest_word(word, known);
    return nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest);
}

std::vector<std::string> TomlKeys::names() const {
    std::vector<std::string> names;
    for (const TomlKey& key : keys) names.push_back(key.name);
    return names;
}

double TomlKeys::read(const std::string& file, const TomlEntry& entry) {
    const std::string where = fmt::format("{}: line {}: ", file, entry.line);
    const std::string name = path + "." + entry.key;
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const TomlKey& k) { return k.name == entry.key; });
    if (key == keys.end()) {
        throw InputError(fmt::format("{}unknown key {}{}; known are {}", where, name, did_you_mean(entry.key, names()),
                                     fmt::join(names(), ", ")));
    }
    const double value = read_value(entry, key->quantity, where + name);
    key->set(value);
    key->found = true;
    return value;
}

}  // namespace graincrack
