#include "post/chart/labels.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

namespace graincrack {

namespace {

std::vector<std::string> words_of(const std::string& text, char between) {
    std::vector<std::string> words;
    std::istringstream in(text);
    for (std::string word; std::getline(in, word, between);) words.push_back(word);
    return words;
}

/// The words of a column's name, with the signs and names that they stand for.
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
        if (own.size() > 2 && own[1] == '_') {  // "k_feldspar", by its element
            own[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(own[0])));
            own[1] = '-';
        }
        std::replace(own.begin(), own.end(), '_', ' ');
        label += (label.empty() ? "" : "–") + own;
    }
    return label;
}

}  // namespace graincrack
