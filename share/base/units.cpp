#include "share/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack {
namespace {

/// Alternative spellings, which are accepted but not listed, with their symbols.
constexpr std::array<std::pair<std::string_view, std::string_view>, 17> other_spellings{{
    {"\u00b5m", "um"},
    {"\u03bcm", "um"},
    {"\u00b5s", "us"},
    {"\u03bcs", "us"},
    {"\u00b0", "deg"},
    {"Pa\u221am", "Pa.m^0.5"},
    {"kPa\u221am", "kPa.m^0.5"},
    {"MPa\u221am", "MPa.m^0.5"},
    {"Pa*m^0.5", "Pa.m^0.5"},
    {"kPa*m^0.5", "kPa.m^0.5"},
    {"MPa*m^0.5", "MPa.m^0.5"},
    {"MPa.sqrt(m)", "MPa.m^0.5"},
    {"J/m^2", "J/m2"},
    {"kJ/m^2", "kJ/m2"},
    {"kg/m^3", "kg/m3"},
    {"g/cm^3", "g/cm3"},
    {"m/s^2", "m/s2"},
}};

std::optional<Unit> find_unit(std::string_view symbol, Dimension dimension) {
    for (const auto& [spelling, meant] : other_spellings) {
        if (symbol == spelling) symbol = meant;
    }
    if (symbol.empty()) return Unit{si_unit(dimension), 1};
    for (const Unit& unit : units_of(dimension)) {
        if (unit.symbol == symbol) return unit;
    }
    return std::nullopt;
}

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return lower;
}

/// The accepted units in words: "a length in m, mm, cm, um or km (a bare number is m)".
std::string what_fits(Dimension dimension) {
    if (dimension == Dimension::one) return "a pure number, or one in %, fits";
    std::string list;
    const std::vector<Unit> units = units_of(dimension);
    for (std::size_t i = 0; i < units.size(); ++i) {
        if (i > 0) list += i + 1 < units.size() ? ", " : " or ";
        list += units[i].symbol;
    }
    return fmt::format("units that fit: {} (a bare number is in {})", list, si_unit(dimension));
}

std::string quoted(std::string_view text) { return '"' + shortened(printable(text), 60) + '"'; }

[[noreturn]] void refuse(std::string_view where, const std::string& wrong, const std::string& right) {
    throw UsageError(fmt::format("{}: {}; {}", where, wrong, right));
}

/// Refuses a number out of bounds that fits with another unit, which may have been meant.
void refuse_bare(std::string_view text, double value, const Quantity& quantity, std::string_view where) {
    for (const Unit& unit : units_of(quantity.dimension)) {
        if (!quantity.admits(value * unit.to_si)) continue;
        refuse(where,
               fmt::format("{} has no unit and was taken for {}, which is out of bounds", quoted(text),
                           format_quantity(value, quantity.dimension)),
               fmt::format("write {}{}; it must be {}", text, unit.symbol, bounds_text(quantity)));
    }
}

[[noreturn]] void refuse_unit(std::string_view text, std::string_view symbol, Dimension dimension, std::string_view where) {
    for (std::size_t i = 0; i < dimension_rows.size(); ++i) {
        const auto other = static_cast<Dimension>(i);
        if (other == dimension || !find_unit(symbol, other)) continue;
        refuse(where, fmt::format("{} has the unit of a {}, a {} is needed", quoted(text), name_of(other), name_of(dimension)),
               what_fits(dimension));
    }
    std::string hint;
    if (symbol.front() == ',') {
        hint = "the decimal mark is a point; ";
    } else {
        for (const Unit& unit : units_of(dimension)) {
            if (lower_case(unit.symbol) == lower_case(symbol)) hint = fmt::format("did you mean {}? ", unit.symbol);
        }
    }
    refuse(where, fmt::format("unknown unit {} in {}", quoted(symbol), quoted(text)), hint + what_fits(dimension));
}

/// The number of `text`, times the factor. A power of ten is added to the exponent in the text, so that it is rounded once.
std::optional<double> scaled_number(std::string_view text, double factor) {
    const double decade = std::round(std::log10(factor));
    const bool is_decade = std::abs(factor / std::pow(10.0, decade) - 1) < 1e-12;
    int own = 0;
    const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
    if (mantissa.size() < text.size()) {
        std::string_view digits = text.substr(mantissa.size() + 1);
        if (digits.front() == '+') digits.remove_prefix(1);
        if (std::from_chars(digits.data(), digits.data() + digits.size(), own).ec != std::errc{}) return std::nullopt;
    }
    const std::string shifted = fmt::format("{}e{}", mantissa, own + (is_decade ? static_cast<int>(decade) : 0));
    double value = 0;
    if (std::from_chars(shifted.data(), shifted.data() + shifted.size(), value).ec != std::errc{}) return std::nullopt;
    return is_decade ? value : value * factor;
}

}  // namespace

std::optional<Dimension> dimension_of_unit(std::string_view si_unit) {
    const auto* const row = std::find_if(dimension_rows.begin(), dimension_rows.end(),
                                         [&](const DimensionRow& each) { return each.units.front().symbol == si_unit; });
    if (row == dimension_rows.end()) return std::nullopt;
    return static_cast<Dimension>(row - dimension_rows.begin());
}

std::vector<Unit> units_of(Dimension dimension) {
    const auto& units = row_of(dimension).units;
    return {units.begin(), std::find_if(units.begin(), units.end(), [](const Unit& unit) { return unit.symbol.empty(); })};
}

double parse_quantity(std::string_view text, const Quantity& quantity, std::string_view where) {
    const std::string_view whole = trimmed(text);
    std::string_view digits = whole;
    if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-' && digits[1] != '+') digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument) {
        refuse(where, whole.empty() ? "no value given" : fmt::format("{} is not a number", quoted(whole)),
               what_fits(quantity.dimension));
    }
    const std::string_view symbol = trimmed(std::string_view(end, static_cast<std::size_t>(digits.data() + digits.size() - end)));
    digits = digits.substr(0, static_cast<std::size_t>(end - digits.data()));
    const auto require = [&](bool holds, const std::string& wrong) {
        const std::string right = fmt::format("it must be {}", bounds_text(quantity));
        if (!holds) refuse(where, fmt::format("{} {}", quoted(whole), wrong), right);
    };
    require(error != std::errc::result_out_of_range && std::isfinite(value), "is not a finite number");
    const auto unit = find_unit(symbol, quantity.dimension);
    if (!unit) refuse_unit(whole, symbol, quantity.dimension, where);
    const auto si = scaled_number(digits, unit->to_si);
    require(si && std::isfinite(*si), "is not a finite number");
    if (symbol.empty() && !quantity.admits(*si)) refuse_bare(whole, *si, quantity, where);
    const bool is_explained = *si > quantity.upper && !quantity.why_upper.empty();
    require(quantity.admits(*si), is_explained ? fmt::format("is out of bounds ({})", quantity.why_upper) : "is out of bounds");
    return *si;
}

double parse_quantity_or(std::string_view text, std::string_view word, double word_value, const Quantity& quantity,
                         std::string_view where) {
    if (trimmed(text) == word) return word_value;
    try {
        return parse_quantity(text, quantity, where);
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{}; the word {} fits too", error.what(), word));
    }
}

std::string bare_number_note(std::string_view text, const Quantity& quantity, std::string_view where) {
    constexpr double fast = 1;     // m/s
    constexpr double light = 100;  // kg/m³
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || rest != end || value == 0) return "";
    const Dimension dimension = quantity.dimension;
    const bool is_unusual = dimension == Dimension::length || dimension == Dimension::stress ||
                            (dimension == Dimension::speed && value >= fast) ||
                            (dimension == Dimension::density && value < light);
    if (!is_unusual) return "";
    return fmt::format("{}: {} has no unit and was taken for {} {}", where, text, text, quantity.unit());
}

std::string bounds_text(const Quantity& quantity) {
    const auto shown = [&](double bound) { return format_quantity(bound, quantity.dimension); };
    const bool from_below = std::isfinite(quantity.lower);
    const bool from_above = std::isfinite(quantity.upper);
    if (from_below && from_above) {
        return quantity.open_below ? fmt::format("above {} and at most {}", shown(quantity.lower), shown(quantity.upper))
                                   : fmt::format("from {} to {}", shown(quantity.lower), shown(quantity.upper));
    }
    if (from_below) return fmt::format("{} {}", quantity.open_below ? "above" : "at least", shown(quantity.lower));
    if (from_above) return fmt::format("at most {}", shown(quantity.upper));
    return "a finite number";
}

double in_unit(double value, Dimension dimension, std::string_view unit) {
    const auto found = find_unit(unit, dimension);
    if (!found) throw std::invalid_argument(fmt::format("no unit {} of a {}", unit, name_of(dimension)));
    // 1000 is exact and 1e-3 is not: multiplying keeps 0.00513 m at 5.13 mm.
    const double inverse = std::round(1 / found->to_si);
    if (found->to_si < 1 && std::abs(inverse * found->to_si - 1) < 1e-12) return value * inverse;
    return value / found->to_si;
}

std::string format_number(double value) {
    if (std::isnan(value)) return "nan";
    return fmt::format("{}", value);
}

std::string format_number(double value, int digits) {
    if (std::isnan(value)) return "nan";
    return fmt::format("{:.{}g}", value, std::max(digits, 1));
}

double rounded(double value, int digits) {
    const std::string text = format_number(value, digits);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::string format_quantity(double value, Dimension dimension, int digits) {
    if (dimension == Dimension::one) return format_number(value, digits);
    std::string_view chosen = row_of(dimension).shown.front();
    const auto number = [&](std::string_view symbol) { return format_number(in_unit(value, dimension, symbol), digits); };
    if (value == 0 || !std::isfinite(value)) {
        if (dimension != Dimension::angle) chosen = si_unit(dimension);
    } else {
        for (const std::string_view symbol : row_of(dimension).shown) {
            if (symbol.empty()) break;
            const bool has_exponent = number(chosen).find("e+") != std::string::npos;  // with two digits 0.8 mm, not 8e+02 um
            if (has_exponent || std::abs(in_unit(value, dimension, symbol)) >= 1) chosen = symbol;
        }
    }
    return fmt::format("{} {}", number(chosen), chosen);
}

std::string format_length(double value) { return format_quantity(value, Dimension::length); }

}  // namespace graincrack
