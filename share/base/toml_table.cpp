#include "share/base/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack {

void TomlKey::require_word(const std::string& word, const std::string& where) const {
    if (words.empty() ? word.empty() : std::find(words.begin(), words.end(), word) == words.end()) {
        throw InputError(fmt::format("{}: unknown word \"{}\"; {} fits", where, word,
                                     words.empty() ? "one that is not empty" : fmt::format("{}", fmt::join(words, " or "))));
    }
}

TomlTable::TomlTable(const TomlFile& file) : file_(std::make_shared<const TomlFile>(file)) {}
TomlTable::TomlTable(std::shared_ptr<const TomlFile> file, std::vector<std::string> section)
    : file_(std::move(file)), section_(std::move(section)), path_(fmt::format("{}", fmt::join(section_, "."))) {}

bool TomlTable::is_inside(const std::vector<std::string>& section) const {
    return section.size() >= section_.size() && std::equal(section_.begin(), section_.end(), section.begin());
}

const TomlEntry* TomlTable::entry(const std::string& key) const {
    const auto found = std::find_if(file_->entries.begin(), file_->entries.end(),
                                    [&](const TomlEntry& e) { return e.section == section_ && e.key == key; });
    return found == file_->entries.end() ? nullptr : &*found;
}

std::vector<std::pair<int, std::string>> TomlTable::keys() const {
    std::vector<std::pair<int, std::string>> keys;
    const auto add = [&](int line, const std::string& name) {
        if (std::none_of(keys.begin(), keys.end(), [&](const auto& k) { return k.second == name; })) {
            keys.emplace_back(line, name);
        }
    };
    for (const TomlEntry& e : file_->entries) {
        if (e.section == section_) add(e.line, e.key);
    }
    for (const TomlSection& s : file_->sections) {
        if (is_inside(s.name) && s.name.size() > section_.size()) add(s.line, s.name[section_.size()]);
    }
    std::stable_sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return keys;
}

bool TomlTable::has_table(const std::string& key) const {
    return std::any_of(file_->sections.begin(), file_->sections.end(), [&](const TomlSection& s) {
        return is_inside(s.name) && s.name.size() > section_.size() && s.name[section_.size()] == key;
    });
}
bool TomlTable::has_value(const std::string& key) const { return entry(key) != nullptr; }
bool TomlTable::has_array(const std::string& key) const { return has_value(key) && entry(key)->is_array; }
bool TomlTable::has(const std::string& key) const { return has_value(key) || has_table(key); }
std::string TomlTable::name() const { return section_.empty() ? "" : section_.back(); }
std::string TomlTable::shown(const std::string& key) const { return has_value(key) ? entry(key)->values.front().text : ""; }

std::string TomlTable::where(const std::string& key) const {
    int line = 0;
    for (const TomlSection& s : file_->sections) line = line == 0 && is_inside(s.name) && !section_.empty() ? s.line : line;
    for (const auto& [at, name] : keys()) line = name == key ? at : line;
    const std::string dotted = path_.empty() ? key : key.empty() ? path_ : path_ + "." + key;
    return line == 0 ? fmt::format("{}: {}", file_->file, dotted) : fmt::format("{}: line {}: {}", file_->file, line, dotted);
}

void TomlTable::refuse(const std::string& key, const std::string& wrong_and_right) const {
    throw InputError(fmt::format("{}: {}", where(key), wrong_and_right));
}

const TomlEntry* TomlTable::asked(const std::string& key, bool (*fits)(const TomlEntry&), const std::string& otherwise) {
    asked_.insert(key);
    const TomlEntry* const found = entry(key);
    if (has(key) && (found == nullptr || !fits(*found))) refuse(key, otherwise);
    return found;
}

void TomlTable::given(const std::string& key, std::vector<std::string>& value) {
    const auto are_texts = [](const TomlEntry& e) {
        return std::all_of(e.values.begin(), e.values.end(), [](auto& each) { return each.kind == TomlValue::Kind::text; });
    };
    const TomlEntry* const found = asked(key, are_texts, "is no text; a text in quotes, or an array of such texts, fits");
    if (found == nullptr) return;
    value.clear();
    for (const TomlValue& each : found->values) value.push_back(each.text);
}

void TomlTable::given(const std::string& key, std::string& value) {
    const auto is_text = [](const TomlEntry& e) { return !e.is_array && e.values.front().kind == TomlValue::Kind::text; };
    const TomlEntry* const found = asked(key, is_text, "is no text; one text in quotes fits");
    if (found != nullptr) value = found->values.front().text;
}

void TomlTable::given(const std::string& key, bool& value) {
    const auto is_flag = [](const TomlEntry& e) { return !e.is_array && e.values.front().kind == TomlValue::Kind::boolean; };
    const TomlEntry* const found = asked(key, is_flag, "is neither true nor false");
    if (found != nullptr) value = found->values.front().text == "true";
}

double TomlTable::number(const std::string& key, const TomlValue& value, const Quantity& quantity) const {
    try {
        return parse_quantity(value.text, quantity, where(key));
    } catch (const UsageError& error) {
        throw InputError(error.what());
    }
}

void TomlTable::given(const std::string& key, const Quantity& quantity, std::vector<double>& values) {
    const auto are_quantities = [](const TomlEntry& e) {
        const auto is_flag = [](const TomlValue& value) { return value.kind == TomlValue::Kind::boolean; };
        return e.is_array && std::none_of(e.values.begin(), e.values.end(), is_flag);
    };
    const TomlEntry* const found =
        asked(key, are_quantities,
              fmt::format("is no array of quantities; texts with units of a {} or bare numbers in {} fit",
                          name_of(quantity.dimension), quantity.unit()));
    if (found == nullptr) return;
    values.clear();
    for (const TomlValue& value : found->values) values.push_back(number(key, value, quantity));
}

void TomlTable::given(const std::string& key, const Quantity& quantity, double& value) {
    const auto is_quantity = [](const TomlEntry& e) { return !e.is_array && e.values.front().kind != TomlValue::Kind::boolean; };
    const TomlEntry* const found = asked(key, is_quantity,
                                         fmt::format("is no quantity; a text with a unit of a {} or a bare number in {} fits",
                                                     name_of(quantity.dimension), quantity.unit()));
    if (found != nullptr) value = number(key, found->values.front(), quantity);
}

void TomlTable::given(const std::string& key, const Quantity& quantity, std::int64_t& value) {
    auto number = static_cast<double>(value);
    given(key, quantity, number);
    if (number != std::floor(number)) refuse(key, fmt::format("{} is no whole number", number));
    value = static_cast<std::int64_t>(number);
}

void TomlTable::given(const std::string& key, const Quantity& quantity, std::optional<double>& value, const char* none) {
    if (none != nullptr && is_word(key, none)) {
        value = 0;
        return;
    }
    double number = 0;
    given(key, quantity, number);
    if (has(key)) value = number;
}

bool TomlTable::is_word(const std::string& key, const std::string& word) {
    asked_.insert(key);
    const TomlEntry* found = entry(key);
    return found != nullptr && !found->is_array && found->values.front().text == word;
}

void TomlTable::choice(const std::string& key, bool& value, const std::string& word_of_false, const std::string& word_of_true) {
    value = is_word(key, word_of_true);
    if (!value && !is_word(key, word_of_false)) {
        refuse(key, fmt::format("is none of the words that fit, \"{}\" and \"{}\"", word_of_false, word_of_true));
    }
}

void TomlTable::require(const std::string& key, const std::string& what) {
    const TomlEntry* found = entry(key);
    if (!has(key) || (found != nullptr && found->values.empty())) {
        asked_.insert(key);
        refuse(key, "missing; " + what);
    }
}

std::optional<TomlTable> TomlTable::table(const std::string& key) {
    asked_.insert(key);
    if (has_value(key)) refuse(key, "is a value; a table fits");
    if (!has_table(key)) return std::nullopt;
    std::vector<std::string> section = section_;
    section.push_back(key);
    return TomlTable(file_, section);
}

std::vector<TomlTable> TomlTable::tables() {
    std::vector<TomlTable> found;
    for (const auto& [line, key] : keys()) {
        if (has_table(key)) found.push_back(*table(key));
    }
    return found;
}

TomlTable TomlTable::needed_table(const std::string& key, const std::string& what) {
    auto found = table(key);
    if (!found) refuse(key, "missing; " + what);
    return *found;
}

void TomlTable::refuse_others() const {
    for (const auto& [line, key] : keys()) {
        if (asked_.contains(key)) continue;
        refuse(key, fmt::format("unknown key{}; known are {}", did_you_mean(key, {asked_.begin(), asked_.end()}),
                                fmt::join(asked_, ", ")));
    }
}

}  // namespace graincrack
