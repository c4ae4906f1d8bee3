#include "post/chart/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "share/base/text.hpp"

namespace graincrack {

Colour palette::series(std::size_t i) {
    static constexpr std::array<Colour, 7> colours{
        {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {230, 159, 0}, {90, 90, 90}}};
    return colours[i % colours.size()];
}

std::vector<Colour> palette::phases(const std::vector<std::string>& names) {
    struct Mineral {
        std::string_view name;
        Colour colour;
    };
    // Grey, blue, brown, green and violet get darker by a tenth of white in grey each.
    constexpr Colour blue{178, 204, 235}, brown{214, 168, 126}, green{128, 168, 140}, violet{138, 112, 160},
        yellow{236, 222, 160}, rose{222, 190, 206}, olive{158, 168, 96};
    static constexpr std::array<Mineral, 22> minerals{
        {{"quartz", grain},     {"plagioclase", blue}, {"albite", blue},      {"anorthite", blue},   {"labradorite", blue},
         {"feldspar", brown},   {"k_feldspar", brown}, {"orthoclase", brown}, {"microcline", brown}, {"amphibole", green},
         {"hornblende", green}, {"mica", violet},      {"dark_mica", violet}, {"biotite", violet},   {"calcite", yellow},
         {"carbonate", yellow}, {"dolomite", rose},    {"muscovite", rose},   {"white_mica", rose},  {"pyroxene", olive},
         {"augite", olive},     {"diopside", olive}}};
    static constexpr std::array others{grain, blue, brown, green, violet, yellow, rose, olive};
    std::vector<std::optional<Colour>> found(names.size());
    const auto is_free = [&](const Colour& colour) { return std::ranges::count(found, std::optional(colour)) == 0; };
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto* const known = std::ranges::find(minerals, names[i], &Mineral::name);
        if (known != minerals.end() && is_free(known->colour)) found[i] = known->colour;
    }
    std::vector<Colour> colours;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto* const left = std::ranges::find_if(others, is_free);
        if (!found[i]) found[i] = left != others.end() ? *left : others[i % others.size()];
        colours.push_back(*found[i]);
    }
    return colours;
}

void Drawing::polygon(std::span<const Pixel> corners, Colour fill) {
    auto* last = shapes_.empty() ? nullptr : std::get_if<Polygons>(&shapes_.back());
    if (last == nullptr || last->sides != corners.size() || !(last->fill == fill)) {
        shapes_.emplace_back(Polygons{{}, corners.size(), fill});
        last = &std::get<Polygons>(shapes_.back());
    }
    last->corners.insert(last->corners.end(), corners.begin(), corners.end());
}

void Drawing::line(Pixel from, Pixel to, double width, Colour colour) {
    auto* last = shapes_.empty() ? nullptr : std::get_if<Strokes>(&shapes_.back());
    if (last == nullptr || last->width != width || !(last->colour == colour)) {
        shapes_.emplace_back(Strokes{{}, width, colour});
        last = &std::get<Strokes>(shapes_.back());
    }
    last->ends.insert(last->ends.end(), {from, to});
}

void Drawing::rectangle(Pixel top_left, Pixel bottom_right, Colour fill) {
    polygon({top_left, {bottom_right.x, top_left.y}, bottom_right, {top_left.x, bottom_right.y}}, fill);
}

void Drawing::add(const Drawing& other, Pixel offset) {
    for (const Shape& shape : other.shapes_) {
        shapes_.push_back(shape);
        for (Pixel& each : std::visit([](auto& own) { return own.pixels(); }, shapes_.back())) {
            each = {each.x + offset.x, each.y + offset.y};
        }
    }
}

std::size_t Drawing::n_marks() const {
    std::size_t n = 0;
    for (const Shape& shape : shapes_) {
        const auto* const polygons = std::get_if<Polygons>(&shape);
        const auto* const strokes = std::get_if<Strokes>(&shape);
        n += polygons != nullptr ? polygons->size() : strokes != nullptr ? strokes->size() : 1;
    }
    return n;
}

std::string Drawing::words() const {
    std::string lines;
    for (const Shape& shape : shapes_) {
        if (const auto* text = std::get_if<Text>(&shape)) lines += text->label + "\n";
    }
    return lines;
}

std::string escape_xml(const std::string& text) {
    std::string out;
    for (char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\n': out += c; break;
            default: out += printable({&c, 1});
        }
    }
    return out;
}

std::vector<double> round_ticks(double low, double high, int wanted) {
    std::vector<double> ticks;
    if (!(high > low) || wanted < 1) return ticks;
    const double raw = (high - low) / wanted;
    const double decade = std::pow(10.0, std::floor(std::log10(raw)));
    double step = 10 * decade;
    for (double factor : {1.0, 2.0, 5.0}) {
        if (factor * decade >= raw * (1 - 1e-9)) {
            step = factor * decade;
            break;
        }
    }
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1) ticks.push_back(k * step);
    return ticks;
}

}  // namespace graincrack
