#include "share/base/toml_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "share/base/error.hpp"
#include "share/base/units.hpp"

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

std::vector<std::string> TomlKeys::names() const {
    std::vector<std::string> names;
    for (const TomlKey& key : keys) names.push_back(key.name);
    return names;
}

void TomlKey::require_word(const std::string& word, const std::string& where) const {
    if (words.empty() ? word.empty() : std::find(words.begin(), words.end(), word) == words.end()) {
        throw InputError(fmt::format("{}: unknown word \"{}\"; {} fits", where, word,
                                     words.empty() ? "one that is not empty" : fmt::format("{}", fmt::join(words, " or "))));
    }
}

TomlKey* TomlKeys::find(const std::string& name) {
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const TomlKey& k) { return k.name == name; });
    return key == keys.end() ? nullptr : &*key;
}

std::optional<double> TomlKeys::read(const std::string& file, const TomlEntry& entry) {
    const std::string where = fmt::format("{}: line {}: ", file, entry.line);
    const std::string name = path + "." + entry.key;
    TomlKey* const key = find(entry.key);
    if (key == nullptr) {
        throw InputError(fmt::format("{}unknown key {}{}; known are {}", where, name, did_you_mean(entry.key, names()),
                                     fmt::join(names(), ", ")));
    }
    key->found = true;
    if (key->is_word()) {
        if (entry.is_array || entry.values.front().kind != TomlValue::Kind::text) {
            throw InputError(fmt::format("{}{}: a text is needed", where, name));
        }
        key->require_word(entry.values.front().text, where + name);
        key->set_word(entry.values.front().text);
        return std::nullopt;
    }
    const double value = read_value(entry, key->quantity, where + name);
    key->set(value);
    return value;
}

}  // namespace graincrack
