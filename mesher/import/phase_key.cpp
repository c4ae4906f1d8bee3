#include "mesher/import/phase_key.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>
#include <system_error>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::mesher {

namespace {

constexpr std::size_t longest_phase_name = 40;
constexpr std::size_t digits_of_colour = 6;

std::string shown_key(std::string_view text) { return printable(text.substr(0, longest_phase_name)); }

bool is_hexadecimal(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

/// True if a line begins with a colour: #, six hexadecimal digits and an end.
bool begins_with_colour(std::string_view line) {
    const std::string_view digits = line.substr(1, digits_of_colour);
    if (digits.size() < digits_of_colour || !std::all_of(digits.begin(), digits.end(), is_hexadecimal)) return false;
    return line.size() == 1 + digits_of_colour || std::string_view("\t ,;").find(line[1 + digits_of_colour]) != std::string::npos;
}

std::string without_quotes(std::string_view field) {
    const bool is_quoted = field.size() >= 2 && field.front() == field.back() && (field.front() == '"' || field.front() == '\'');
    return std::string(is_quoted ? field.substr(1, field.size() - 2) : field);
}

std::vector<std::string> key_fields(std::string_view line) {
    std::vector<std::string> fields;
    for (const std::string_view field : split(line, '\t')) fields.push_back(without_quotes(field));
    return fields;
}

bool is_phase_name(const std::string& name) {
    return !name.empty() && name.size() <= longest_phase_name &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

}  // namespace

std::optional<int> colour_of_text(std::string_view text) {
    const bool is_marked = text.substr(0, 1) == "#";
    if (is_marked) text.remove_prefix(1);
    if (text.size() != digits_of_colour || !std::all_of(text.begin(), text.end(), is_hexadecimal)) return std::nullopt;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (!is_marked && std::all_of(text.begin(), text.end(), is_digit)) return std::nullopt;
    int colour = 0;
    std::from_chars(text.data(), text.data() + text.size(), colour, 16);
    return colour;
}

std::string colour_text(int colour) { return fmt::format("#{:06x}", colour); }

PhaseKey::PhaseKey(const std::string& path) : path_(path) {
    std::istringstream file(text_of_file(path));
    std::size_t phase_column = 1;
    bool has_names = false;  // true for names of columns
    std::string line;
    for (std::size_t number = 1; std::getline(file, line); ++number) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty() || (line.front() == '#' && !begins_with_colour(line))) continue;
        const std::vector<std::string> fields = key_fields(line);
        if (phases_.empty() && !has_names && fields.front() == "key") {
            const auto found = std::find(fields.begin(), fields.end(), "phase");
            has_names = found != fields.end();
            phase_column = has_names ? static_cast<std::size_t>(found - fields.begin()) : 1;
            if (has_names) continue;
        }
        const std::string& name = fields.front();
        const std::string phase = phase_column < fields.size() && (has_names || fields.size() == 2) ? fields[phase_column] : "";
        if (phase != phase_to_be_named && !is_phase_name(phase)) {
            throw InputError(
                fmt::format("{}: line {}: \"{}\" is no row; a key, a tab and the name of a phase (a-z, 0-9, _) are needed", path,
                            number, shown_key(line)));
        }
        if (!phases_.emplace(name, phase).second) {
            throw InputError(fmt::format("{}: line {}: {} has a phase already", path, number, shown_key(name)));
        }
        if (phase != phase_to_be_named) order_.push_back(phase);
    }
    if (phases_.empty()) throw InputError(path + ": no rows; a table with the columns key and phase is needed");
}

std::string PhaseKey::phase(const std::vector<std::string>& names) const {
    for (const std::string& name : names) {
        const auto found = phases_.find(name);
        if (found != phases_.end() && found->second != phase_to_be_named) return found->second;
    }
    throw InputError(fmt::format("{}: no row for {}; each grain needs one", path_, shown_key(names.front())));
}

PhaseKey::OfLabels PhaseKey::of_labels() const {
    OfLabels labels;
    for (const auto& [name, phase] : phases_) {
        int number = 0;
        const auto result = std::from_chars(name.data(), name.data() + name.size(), number);
        const bool is_number = result.ec == std::errc{} && result.ptr == name.data() + name.size();
        const std::optional<int> colour = colour_of_text(name);
        if (!is_number && !colour) {
            throw InputError(fmt::format("{}: the key \"{}\" is no label; of pictures keys are integers or colours as #c03020",
                                         path_, shown_key(name)));
        }
        if (phase == phase_to_be_named) continue;
        auto& phases = is_number ? labels.by_number : labels.by_colour;
        const auto [place, is_new] = phases.emplace(is_number ? number : *colour, phase);
        if (!is_new && place->second != phase) {
            throw InputError(
                fmt::format("{}: {} has the phases {} and {}; give one", path_, shown_key(name), place->second, phase));
        }
    }
    if (labels.by_number.empty() && labels.by_colour.empty()) {
        throw InputError(fmt::format("{}: no phase is named yet; the name of a phase (a-z, 0-9, _) is needed in place of each {}",
                                     path_, phase_to_be_named));
    }
    return labels;
}

}  // namespace graincrack::mesher
