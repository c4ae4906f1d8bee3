#include "post/chart/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/font.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

std::string superscript(int number) {
    static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out;
    for (const char c : std::to_string(number)) out += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    return out;
}

std::vector<double> logarithmic_ticks(const Axis& axis, int wanted) {
    const std::vector<std::vector<double>> choices{{1, 1.5, 2, 3, 4, 5, 6, 8}, {1, 2, 5}, {1, 3}, {1}};
    std::vector<double> ticks;
    for (const auto& factors : choices) {
        ticks.clear();
        for (double decade = std::pow(10, std::floor(std::log10(axis.low))); decade <= axis.high; decade *= 10) {
            for (const double factor : factors) {
                const double tick = factor * decade;
                if (tick >= axis.low * (1 - 1e-9) && tick <= axis.high * (1 + 1e-9)) ticks.push_back(tick);
            }
        }
        if (static_cast<int>(ticks.size()) <= wanted + 2) break;
    }
    return ticks;
}

/// Common power of ten of all ticks; 0 if plain numbers are readable.
int common_exponent(const std::vector<double>& ticks) {
    double most = 0;
    for (const double tick : ticks) most = std::max(most, std::abs(tick));
    if (most == 0 || (most >= 1e-3 && most < 1e5)) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(most) / 3 + 1e-9));
}

std::string with_exponent(const std::string& label, int exponent) {
    const std::string power = "10" + superscript(exponent);
    const std::size_t comma = label.find(", ");
    if (comma == std::string::npos) return label.empty() ? power : label + ", " + power;
    return label.substr(0, comma + 2) + power + " " + label.substr(comma + 2);
}

}  // namespace

double Axis::share(double value) const {
    if (!logarithmic) return (value - low) / (high - low);
    return std::log(value / low) / std::log(high / low);
}

std::string Axis::unit() const {
    const std::size_t comma = label.find(", ");
    if (comma == std::string::npos) return "";
    const std::string rest = label.substr(comma + 2);
    return rest.substr(0, rest.find(" ("));
}

Axis Axis::limited(const AxisLimits& limits) const {
    if (logarithmic && !(limits.low > 0)) throw UsageError(limits.text + ": the axis is logarithmic; numbers above 0 fit");
    return {label, limits.low, limits.high, logarithmic};
}

Ticks ticks_of(const Axis& axis, int wanted) {
    const bool decades = axis.logarithmic && axis.high >= 3 * axis.low;
    Ticks ticks{decades ? logarithmic_ticks(axis, wanted) : round_ticks(axis.low, axis.high, wanted), {}, axis.label};
    const int exponent = decades ? 0 : common_exponent(ticks.values);
    if (exponent != 0) ticks.label = with_exponent(axis.label, exponent);
    const double tiny = 1e-9 * (axis.high - axis.low);
    for (const double tick : ticks.values) {
        const double shown = std::abs(tick) < tiny && !decades ? 0 : tick * std::pow(10, -exponent);
        const bool power = decades && (tick < 0.9e-3 || tick >= 0.9e6);
        const double order = std::floor(std::log10(std::max(tick, 1e-300)) + 1e-9);
        std::string text = format_number(shown, 6);
        if (power) {
            const double factor = tick / std::pow(10, order);
            text = (factor < 1.001 ? "" : format_number(factor, 2) + "·") + "10" + superscript(static_cast<int>(order));
        }
        if (text.starts_with('-')) text.replace(0, 1, "−");
        ticks.texts.push_back(text);
    }
    return ticks;
}

Ticks ticks_along(const Axis& axis, double length, double text_size, int wanted) {
    const double gap = 0.6 * text_size;
    for (int n = wanted; n > 1; --n) {
        Ticks ticks = ticks_of(axis, n);
        double end = -std::numeric_limits<double>::infinity();
        bool fit = true;
        for (std::size_t i = 0; i < ticks.values.size(); ++i) {
            const double at = axis.share(ticks.values[i]) * length;
            const double half = text_width(ticks.texts[i], text_size) / 2;
            fit = fit && at - half >= end + gap;
            end = at + half;
        }
        if (fit) return ticks;
    }
    return ticks_of(axis, 1);
}

std::pair<double, double> padded_range(std::span<const double> values, double pad) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!(low <= high)) return {0, 1};
    const double room = high > low ? pad * (high - low) : std::max(pad * std::abs(high), 1e-12);
    return {low - room, high + room};
}

namespace {

std::vector<std::string> words_of(const std::string& text, char between) {
    std::vector<std::string> words;
    std::istringstream in(text);
    for (std::string word; std::getline(in, word, between);) words.push_back(word);
    return words;
}

/// The words of a column's name in print, with signs for some of them.
std::string in_print(const std::string& name) {
    static constexpr std::array<std::array<std::string_view, 2>, 6> signs{
        {{"phi", "φ"}, {"phic", "φc"}, {"sigma", "σ"}, {"nu", "ν"}, {"young", "Young's"}, {"poisson", "Poisson's"}}};
    std::string label;
    for (const std::string& word : words_of(name, '_')) {
        const auto sign = std::find_if(signs.begin(), signs.end(), [&](const auto& s) { return s[0] == word; });
        label += (label.empty() ? "" : " ") + std::string(sign == signs.end() ? std::string_view(word) : (*sign)[1]);
    }
    return label;
}

}  // namespace

std::string column_label(const std::string& column) {
    static const std::map<std::string, std::string> units{
        {"deg", "°"}, {"percent", "%"}, {"MPa", "MPa"}, {"GPa", "GPa"}, {"Pa", "Pa"}, {"rad", "rad"}, {"mm", "mm"},
        {"m", "m"},   {"kN", "kN"},     {"J", "J"},     {"s", "s"},     {"N", "N"},   {"ns", "ns"}};
    std::string label = column;
    std::string unit;
    const std::size_t last = column.rfind('_');
    if (last != std::string::npos) {
        const auto found = units.find(column.substr(last + 1));
        if (found != units.end()) {
            label = column.substr(0, last);
            unit = ", " + found->second;
        }
    }
    return in_print(label) + unit;
}

std::string mineral_label(const std::string& name) {
    std::string label;
    for (const std::string& mineral : words_of(name, '-')) {
        std::string own = mineral;
        if (own.size() > 2 && own[1] == '_') {  // such as "k_feldspar"
            own[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(own[0])));
            own[1] = '-';
        }
        std::replace(own.begin(), own.end(), '_', ' ');
        label += (label.empty() ? "" : "–") + own;
    }
    return label;
}

}  // namespace graincrack
