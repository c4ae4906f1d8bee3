#include "mesher/cells/relaxed_corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "mesher/cells/polygon.hpp"
#include "mesher/cells/restored_areas.hpp"
#include "mesher/plane/step_length.hpp"

namespace graincrack::mesher {

namespace {

/// Longest moves of a corner in each sweep, over the root of the area of the smallest cell there.
constexpr std::array<double, 8> longest_moves{0.08, 0.08, 0.06, 0.06, 0.04, 0.04, 0.03, 0.02};
constexpr double acceptable_error = 1e-6;  ///< of areas
constexpr double hexagon_side = 0.6204;    ///< of a regular one, over the root of its area
constexpr double weight_of_flat_corners = 0.2;

/// Cost of a corner between sides in the directions `next` and `last`: of a sharp one that of the triangle it must have, of a
/// nearly straight one that of a shape which crystals do not have.
double corner_cost(Point next, Point last) {
    const double both = length(next) * length(last);
    const double cosine = dot(next, last) / both;
    const double sine = cross(next, last) / both;
    if (sine > 0 && cosine >= 0) return step_cost(0.5 * sine / std::sqrt(4 - 2 * cosine) / step_length_over_side);
    if (sine > 0 && cosine > -0.5) return 1;
    constexpr double least = 0.05;
    const double inverse = 0.5 * std::numbers::sqrt3 / std::max(sine, least);
    return 1 + weight_of_flat_corners * (inverse * inverse - 1 + (sine < least ? (least - sine) * 1e4 : 0));
}

class CornerRelaxer {
public:
    CornerRelaxer(PlaneCells& cells, std::size_t n_fixed)
        : cells_(cells), n_fixed_(n_fixed), tangent_(tangents_of(cells)), places_of_point_(cells.points.size()) {
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            for (std::size_t i = 0; i < cells.loop(cell).size(); ++i) {
                places_of_point_[index(cells.loop(cell)[i])].push_back({cell, i});
            }
        }
    }

    void sweep(double longest_move) {
        middles_.clear();
        sizes_.clear();
        for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
            const std::vector<Point> corners = corners_of(cells_, cell);
            middles_.push_back(middle_of(corners));
            sizes_.push_back(std::sqrt(std::max(0.0, area_of(corners))));
        }
        for (std::size_t p = n_fixed_; p < cells_.points.size(); ++p) move(p, longest_move);
    }

private:
    /// A corner of a cell.
    struct Corner {
        std::size_t cell;
        std::size_t number;
    };

    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Point at(int p) const { return cells_.points[index(p)]; }

    static Point middle_of(const std::vector<Point>& corners) {
        Point sum;
        double area = 0;
        for (std::size_t i = 2; i < corners.size(); ++i) {
            const double part = signed_area(corners[0], corners[i - 1], corners[i]);
            area += part;
            sum = sum + part / 3 * (corners[0] + corners[i - 1] + corners[i]);
        }
        return (1 / area) * sum;
    }

    void move(std::size_t p, double longest_move) {
        double size = INFINITY;
        for (const Corner& corner : places_of_point_[p]) size = std::min(size, sizes_[corner.cell]);
        if (!(size > 0) || places_of_point_[p].empty()) return;
        const Point before = cells_.points[p];
        const bool is_on_line = squared_length(tangent_[p]) > 0;
        Point best = before;
        double least = cost_at(p, size);
        const auto try_at = [&](Point place) {
            cells_.points[p] = place;
            const double cost = cost_at(p, size);
            if (!(cost < least)) return;
            least = cost;
            best = place;
        };
        for (double reach = longest_move * size, i = 0; i < 2; ++i, reach /= 2) {
            const Point start = best;
            for (const double sign : {1.0, -1.0}) {
                if (is_on_line) {
                    try_at(start + sign * reach * tangent_[p]);
                } else {
                    try_at(start + Point{sign * reach, 0});
                    try_at(start + Point{0, sign * reach});
                }
            }
        }
        cells_.points[p] = best;
    }

    /// Cost of what the move of a point changes, but for the middles of cells.
    [[nodiscard]] double cost_at(std::size_t p, double size) const {
        const double good = step_length_over_side * hexagon_side * size;
        double sum = 0;
        for (const auto& [cell, number] : places_of_point_[p]) {
            const auto loop = cells_.loop(cell);
            const std::size_t n = loop.size();
            const std::array<Point, 5> line{at(loop[(number + n - 2) % n]), at(loop[(number + n - 1) % n]), at(loop[number]),
                                            at(loop[(number + 1) % n]), at(loop[(number + 2) % n])};
            for (std::size_t i = 1; i < 4; ++i) sum += corner_cost(line[i + 1] - line[i], line[i - 1] - line[i]);
            for (std::size_t i = 1; i < 3; ++i) sum += step_cost(step_length(middles_[cell], line[i], line[i + 1]) / good);
        }
        return sum;
    }

    PlaneCells& cells_;
    std::size_t n_fixed_;
    std::vector<Point> tangent_;  ///< of the boundary or prescribed edge of a point, else 0
    std::vector<std::vector<Corner>> places_of_point_;
    std::vector<Point> middles_;  ///< of cells
    std::vector<double> sizes_;
};

}  // namespace

double relax_corners(PlaneCells& cells, std::size_t n_fixed, const std::vector<double>& areas) {
    double error = restore_areas(cells, n_fixed, areas);
    for (const double longest_move : longest_moves) {
        const std::vector<Point> before = cells.points;
        CornerRelaxer(cells, n_fixed).sweep(longest_move);
        const double after = restore_areas(cells, n_fixed, areas);
        if (after <= std::max(error, acceptable_error)) {
            error = after;
        } else {
            cells.points = before;
        }
    }
    return error;
}

}  // namespace graincrack::mesher
