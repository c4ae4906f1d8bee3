// A picture is a list of shapes in pixels before it becomes PNG, SVG or PDF. It does not depend on Cairo or on the data drawn.
//
// The origin is at the top left, x points right and y downwards. Later shapes cover earlier ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace graincrack {

struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    bool operator==(const Colour&) const = default;
};

/// The colours of all pictures, which colour-blind readers can distinguish (red is light, black dark).
namespace palette {
inline constexpr Colour white{255, 255, 255};
inline constexpr Colour ink{30, 30, 30};
inline constexpr Colour faint{222, 222, 222};
inline constexpr Colour grain{232, 232, 230};
inline constexpr Colour outline{176, 176, 174};
inline constexpr Colour rim{110, 110, 110};
inline constexpr Colour tensile{232, 62, 28};
inline constexpr Colour shear{0, 0, 0};
inline constexpr Colour platen{120, 130, 145};
inline constexpr Colour pre_existing{0, 114, 178};
inline constexpr Colour intact_flaw{86, 180, 233};
/// Colour of curve i of a plot (Okabe & Ito 2008), repeating.
Colour series(std::size_t i);
/// Pale fills of mineral phases by name, the same in every picture. Unknown names have the remaining colours in order, repeating.
std::vector<Colour> phases(const std::vector<std::string>& names);
}  // namespace palette

struct Pixel {
    double x = 0;
    double y = 0;
};

/// Filled convex polygons with an equal number of corners, consecutive.
struct Polygons {
    std::vector<Pixel> corners;
    std::size_t sides = 3;
    Colour fill;
    [[nodiscard]] std::size_t size() const { return corners.size() / sides; }
    [[nodiscard]] std::span<Pixel> pixels() { return corners; }
    [[nodiscard]] std::span<const Pixel> operator[](std::size_t i) const { return std::span(corners).subspan(i * sides, sides); }
};
/// Straight strokes with round ends, two points each.
struct Strokes {
    std::vector<Pixel> ends;
    double width = 1;
    Colour colour;
    [[nodiscard]] std::size_t size() const { return ends.size() / 2; }
    [[nodiscard]] std::span<Pixel> pixels() { return ends; }
};
/// Dash pattern of a line, which distinguishes lines without colour.
enum class Dash { none, dashed, dotted, dash_dot, long_dashed };
/// A line through points with round ends and corners.
struct Polyline {
    std::vector<Pixel> points;
    double width = 1;
    Colour colour;
    Dash dash = Dash::none;
    [[nodiscard]] std::span<Pixel> pixels() { return points; }
};
enum class Anchor { start, middle, end };
/// One line of text. The anchor names the place of `at` on the baseline. `upwards` rotates it by 90° counter-clockwise.
struct Text {
    Pixel at;
    std::string label;
    double size = 24;
    Colour colour = palette::ink;
    Anchor anchor = Anchor::start;
    bool bold = false;
    bool upwards = false;
    [[nodiscard]] std::span<Pixel> pixels() { return {&at, 1}; }
};

class Drawing {
public:
    using Shape = std::variant<Polygons, Strokes, Polyline, Text>;

    Drawing(int width, int height) : width_(width), height_(height) {}

    /// Consecutive polygons or lines of one kind form one shape, because maps have millions.
    void polygon(std::span<const Pixel> corners, Colour fill);
    void polygon(std::initializer_list<Pixel> corners, Colour fill) { polygon(std::span(corners.begin(), corners.size()), fill); }
    void rectangle(Pixel top_left, Pixel bottom_right, Colour fill);
    void line(Pixel from, Pixel to, double width, Colour colour);
    void polyline(std::vector<Pixel> points, double width, Colour colour, Dash dash = Dash::none) {
        shapes_.emplace_back(Polyline{std::move(points), width, colour, dash});
    }
    void text(Text text) { shapes_.emplace_back(std::move(text)); }

    /// Adds all shapes of another drawing, moved.
    void add(const Drawing& other, Pixel offset);
    void set_height(double height) { height_ = static_cast<int>(std::ceil(height)); }

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }
    /// Number of polygons, lines and texts.
    [[nodiscard]] std::size_t n_marks() const;
    /// All texts, one per line, as a description for readers who do not see the picture.
    [[nodiscard]] std::string words() const;

private:
    int width_;
    int height_;
    std::vector<Shape> shapes_;
};

/// Text with escapes for the reserved characters of XML and HTML.
std::string escape_xml(const std::string& text);

/// About `wanted` round numbers with distances 1, 2 or 5 × 10^k inside [low, high], for ticks.
std::vector<double> round_ticks(double low, double high, int wanted);

}  // namespace graincrack
