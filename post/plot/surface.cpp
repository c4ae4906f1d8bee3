#include "post/plot/plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "post/chart/axis.hpp"
#include "post/chart/chart.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack {

namespace {

/// Values at the nodes of a grid: value[j * nx + i] at (x[i], y[j]).
struct GridValues {
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> value;
};

using Place = Chart::Place;

struct Corner {
    Place place;
    double value;
};

/// The point between two corners at which the value is the level.
Place crossing(const Corner& a, const Corner& b, double level) {
    const double share = (level - a.value) / (b.value - a.value);
    return {a.place[0] + share * (b.place[0] - a.place[0]), a.place[1] + share * (b.place[1] - a.place[1])};
}

/// Adds the segment of a level in a triangle. Each triangle has at most one, so there is no ambiguous saddle.
void add_triangle(const std::array<Corner, 3>& corners, double level, std::vector<std::array<Place, 2>>& segments) {
    std::vector<Place> points;
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner& a = corners[k];
        const Corner& b = corners[(k + 1) % 3];
        if (std::isnan(a.value) || std::isnan(b.value)) return;
        if ((a.value < level) != (b.value < level)) points.push_back(crossing(a, b, level));
    }
    if (points.size() == 2) segments.push_back({points[0], points[1]});
}

/// Contours of a level by marching triangles; cells with a NaN corner are left out.
std::vector<std::array<Place, 2>> contour_segments(const GridValues& grid, double level) {
    std::vector<std::array<Place, 2>> segments;
    const std::size_t nx = grid.x.size();
    const auto corner = [&](std::size_t i, std::size_t j) { return Corner{{grid.x[i], grid.y[j]}, grid.value[j * nx + i]}; };
    for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) {
        for (std::size_t i = 0; i + 1 < nx; ++i) {
            add_triangle({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)}, level, segments);
            add_triangle({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)}, level, segments);
        }
    }
    return segments;
}

constexpr std::size_t fine = 161;
constexpr Colour region_fill{214, 230, 243};

/// The plane of the first two factors through the optimum, within the design.
class Plane {
public:
    explicit Plane(const ccd::Problem& problem)
        : problem_(problem), design_(problem.runs.coded), through_(problem.optima[0].coded) {}

    /// A function of the coded factors on a grid in real values; NaN outside the design.
    template <class Function>
    GridValues on_grid(const Function& function) const {
        GridValues grid;
        for (std::size_t i = 0; i < fine; ++i) {
            grid.x.push_back(value(0, i));
            grid.y.push_back(value(1, i));
        }
        for (std::size_t j = 0; j < fine; ++j) {
            for (std::size_t i = 0; i < fine; ++i) {
                const std::vector<double> place = at(coded(0, i), coded(1, j));
                grid.value.push_back(design_.holds(place) ? function(place) : std::numeric_limits<double>::quiet_NaN());
            }
        }
        return grid;
    }
    [[nodiscard]] Axis axis(std::size_t k) const {
        const ccd::Factor& factor = problem_.runs.factors[k];
        const double pad = 0.08 * (design_.high(k) - design_.low(k));
        return {column_label(factor.name), factor.value(design_.low(k) - pad), factor.value(design_.high(k) + pad)};
    }

private:
    [[nodiscard]] double coded(std::size_t k, std::size_t i) const {
        return design_.low(k) + (design_.high(k) - design_.low(k)) * static_cast<double>(i) / (fine - 1);
    }
    [[nodiscard]] double value(std::size_t k, std::size_t i) const { return problem_.runs.factors[k].value(coded(k, i)); }
    [[nodiscard]] std::vector<double> at(double first, double second) const {
        std::vector<double> place = through_;
        place[0] = first;
        place[1] = second;
        return place;
    }
    const ccd::Problem& problem_;
    ccd::Region design_;
    std::vector<double> through_;
};

void draw_contour(Chart& chart, const GridValues& grid, double level, const Stroke& stroke) {
    for (const auto& [from, to] : contour_segments(grid, level)) chart.line(from, to, stroke);
}

void draw_region(Chart& chart, const Plane& plane, const ccd::Problem& problem) {
    if (!problem.confidence.is_known()) return;
    const GridValues grid = plane.on_grid(problem.confidence);
    const double dx = (grid.x[1] - grid.x[0]) / 2;
    const double dy = (grid.y[1] - grid.y[0]) / 2;
    for (std::size_t j = 0; j < fine; ++j) {
        for (std::size_t i = 0; i < fine; ++i) {
            if (!(grid.value[j * fine + i] <= 1)) continue;
            chart.box(grid.x[i] - dx, grid.x[i] + dx, grid.y[j] - dy, grid.y[j] + dy, region_fill);
        }
    }
    draw_contour(chart, grid, 1, Stroke{palette::rim, 1.6});
    chart.legend(region_fill, "joint 95 % region of the factors");
}

/// A contour and its label.
struct LabelledContour {
    std::vector<Place> places;
    std::string label;
    Colour colour;
};

std::vector<Place> places_of(const GridValues& grid, double level) {
    std::vector<Place> places;
    for (const auto& segment : contour_segments(grid, level)) places.push_back(segment[0]);
    return places;
}

/// Draws contours of a response: thin at round levels, thick at the target. \return contours for labelling
std::vector<LabelledContour> draw_response(Chart& chart, const Plane& plane, const LinearModel& model, const ccd::Goal& goal,
                                           std::size_t index) {
    const Colour colour = palette::series(index);
    const bool odd = index % 2 == 1;
    const double width = odd ? 2.8 : 1.4;  // distinguishable without colour
    const GridValues grid = plane.on_grid([&](const std::vector<double>& place) { return model.value(place); });
    const auto [low, high] = padded_range(grid.value, 0);
    std::vector<LabelledContour> contours;
    for (const double level : round_ticks(low, high, 6)) {
        draw_contour(chart, grid, level, Stroke{colour, width});
        contours.push_back({places_of(grid, level), format_number(level, 6), colour});
    }
    const Axis axis{column_label(goal.response)};
    chart.legend(Stroke{colour, width}, axis.label);
    if (goal.kind != ccd::Goal::Kind::target) return contours;
    const double thick = odd ? 7 : 4.5;
    draw_contour(chart, grid, goal.target, Stroke{colour, thick});
    contours.push_back({places_of(grid, goal.target), "", colour});  // unlabelled, but no label may cover it
    chart.legend(Stroke{colour, thick}, fmt::format("{} wanted: {}{}{}", axis.label.substr(0, axis.label.find(", ")),
                                                    format_number(goal.target, 6), axis.unit() == "°" ? "" : " ", axis.unit()));
    return contours;
}

/// Labels contours where no other contour runs, preferably near their middles.
void label_contours(Chart& chart, const std::vector<LabelledContour>& contours) {
    for (std::size_t i = 0; i < contours.size(); ++i) {
        if (contours[i].label.empty()) continue;
        std::vector<Place> others;
        for (std::size_t k = 0; k < contours.size(); ++k) {
            if (k != i) others.insert(others.end(), contours[k].places.begin(), contours[k].places.end());
        }
        std::vector<Place> places = contours[i].places;
        std::sort(places.begin(), places.end());
        const auto middle = static_cast<std::ptrdiff_t>(places.size() / 2);
        std::vector<Place> outwards;
        for (std::ptrdiff_t step = 0; step <= middle; ++step) {
            if (middle + step < std::ssize(places)) outwards.push_back(places[static_cast<std::size_t>(middle + step)]);
            if (step > 0) outwards.push_back(places[static_cast<std::size_t>(middle - step)]);
        }
        (void)chart.label_line(outwards, contours[i].label, contours[i].colour, others);
    }
}

std::string optimum_label(const ccd::Problem& problem) {
    std::string label = "optimum";
    for (std::size_t k = 0; k < problem.runs.factors.size(); ++k) {
        const ccd::Factor& factor = problem.runs.factors[k];
        const Axis axis{column_label(factor.name)};
        label += fmt::format("{} {} {:.4g}{}{}", k == 0 ? ":" : ";", axis.label.substr(0, axis.label.find(", ")),
                             factor.value(problem.optima[0].coded[k]), axis.unit() == "°" ? "" : " ", axis.unit());
    }
    return label;
}

}  // namespace

Drawing draw_surface(const ccd::Problem& problem, const PictureStyle& style) {
    if (problem.runs.factors.size() < 2) throw InputError("plot surface: one factor; contours need two");
    const Plane plane(problem);
    std::vector<std::string> subtitle{optimum_label(problem),
                                      fmt::format("desirability {:.4g} by the quadratic models of {} runs",
                                                  problem.optima[0].desirability, problem.runs.coded.size())};
    if (problem.optima[0].free_factors > 0) {
        subtitle.push_back(
            fmt::format("the goals leave {} of the factors free: nearest to the centre", problem.optima[0].free_factors));
    }
    if (problem.runs.factors.size() > 2) subtitle.emplace_back("further factors are held at the optimum");
    Chart chart(style, {"Response surfaces", subtitle}, plane.axis(0), plane.axis(1));
    const auto place = [&](const std::vector<double>& coded) {
        return Place{problem.runs.factors[0].value(coded[0]), problem.runs.factors[1].value(coded[1])};
    };
    const Marker run{palette::rim, MarkerShape::square, 12};
    const Marker best{palette::ink, MarkerShape::disc, 24};
    for (const auto& coded : problem.runs.coded) chart.keep_clear(place(coded), run.size / 2);
    for (const auto& optimum : problem.optima) chart.keep_clear(place(optimum.coded), best.size / 2);
    draw_region(chart, plane, problem);
    std::vector<LabelledContour> contours;
    for (std::size_t i = 0; i < problem.models.size(); ++i) {
        const auto own = draw_response(chart, plane, problem.models[i], problem.goals[i], i);
        contours.insert(contours.end(), own.begin(), own.end());
    }
    label_contours(chart, contours);
    for (const auto& coded : problem.runs.coded) chart.point(place(coded), run);
    for (const auto& optimum : problem.optima) chart.point(place(optimum.coded), best);
    chart.legend(run, "runs");
    chart.legend(best, "optimum");
    return chart.finish();
}

}  // namespace graincrack
