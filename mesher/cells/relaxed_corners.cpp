#include "mesher/cells/relaxed_corners.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/polygon.hpp"
#include "mesher/plane/step_length.hpp"

namespace graincrack::mesher {

namespace {

constexpr int most_moves = 12;
constexpr int most_halvings_of_a_move = 8;
constexpr double smallest_pivot = 1e-12;  ///< over the largest pivot

/// Derivative of a cell's area by the move of a corner over the reach of that corner, m².
struct Gradient {
    std::size_t cell, point;
    Point value;
};

class AreaRestorer {
public:
    AreaRestorer(PlaneCells& cells, std::size_t n_fixed, const std::vector<double>& areas)
        : cells_(cells),
          n_fixed_(n_fixed),
          requested_(areas),
          reach_(cells.points.size(), INFINITY),
          tangent_(tangents_of(cells)) {
        for (const Edge& e : cells.edges) {
            const double size = length(at(e[1]) - at(e[0]));
            for (const int p : e) reach_[index(p)] = std::min(reach_[index(p)], size);
        }
        present_ = areas_of(cells);
    }

    [[nodiscard]] double largest_error() const { return largest_error(present_); }

    /// Makes one step, halved until it improves the areas. \return false if no step does
    bool improve() {
        const std::vector<Point> step = least_step();
        const std::vector<Point> before = cells_.points;
        double fraction = 1;
        for (int i = 0; i < most_halvings_of_a_move; ++i, fraction /= 2) {
            for (std::size_t p = 0; p < before.size(); ++p) cells_.points[p] = before[p] + fraction * step[p];
            std::vector<double> trial = areas_of(cells_);
            if (!(largest_error(trial) < largest_error()) || !are_sound()) continue;
            present_ = std::move(trial);
            return true;
        }
        cells_.points = before;
        return false;
    }

private:
    [[nodiscard]] Point at(int p) const { return cells_.points[index(p)]; }

    [[nodiscard]] double largest_error(const std::vector<double>& areas) const {
        double largest = 0;
        for (std::size_t i = 0; i < areas.size(); ++i) largest = std::max(largest, std::abs(areas[i] / requested_[i] - 1));
        return largest;
    }

    [[nodiscard]] bool are_sound() const {
        for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
            if (!is_sound(corners_of(cells_, cell))) return false;
        }
        return true;
    }

    /// Removes the part of a move that a point cannot make.
    [[nodiscard]] Point possible(std::size_t point, Point move) const {
        if (point < n_fixed_) return {};
        return squared_length(tangent_[point]) > 0 ? dot(move, tangent_[point]) * tangent_[point] : move;
    }

    /// Gradients of all areas, by ascending points.
    [[nodiscard]] std::vector<Gradient> gradients() const {
        std::vector<Gradient> all;
        for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
            const auto loop = cells_.loop(cell);
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Point before = at(loop[(i + loop.size() - 1) % loop.size()]);
                const Point after = at(loop[(i + 1) % loop.size()]);
                const std::size_t point = index(loop[i]);
                all.push_back({cell, point, possible(point, 0.5 * reach_[point] * left_of(before - after))});
            }
        }
        std::stable_sort(all.begin(), all.end(), [](const Gradient& a, const Gradient& b) { return a.point < b.point; });
        return all;
    }

    /// Moves of points that give the requested areas in linear approximation, with the least sum of squared moves over reach. The
    /// area of the last cell is the rest of the whole.
    [[nodiscard]] std::vector<Point> least_step() const {
        const std::vector<Gradient> all = gradients();
        const std::size_t n = cells_.size() - 1;
        std::vector<Eigen::Triplet<double>> entries;
        for (auto first = all.begin(); first != all.end();) {
            const auto end = std::find_if(first, all.end(), [&](const Gradient& g) { return g.point != first->point; });
            for (auto a = first; a != end; ++a) {
                for (auto b = first; b != end; ++b) {
                    if (a->cell < b->cell || a->cell >= n) continue;
                    entries.emplace_back(static_cast<int>(a->cell), static_cast<int>(b->cell), dot(a->value, b->value));
                }
            }
            first = end;
        }
        const auto size = static_cast<Eigen::Index>(n);
        Eigen::SparseMatrix<double> matrix(size, size);
        matrix.setFromTriplets(entries.begin(), entries.end());
        Eigen::VectorXd difference(size);
        for (std::size_t i = 0; i < n; ++i) difference[static_cast<Eigen::Index>(i)] = requested_[i] - present_[i];
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky;
        cholesky.setShift(smallest_pivot * matrix.diagonal().maxCoeff());  // for linearly dependent areas
        cholesky.compute(matrix);
        const Eigen::VectorXd factor = cholesky.solve(difference);
        std::vector<Point> step(cells_.points.size());
        for (const Gradient& g : all) {
            if (g.cell < n) step[g.point] = step[g.point] + factor[static_cast<Eigen::Index>(g.cell)] * reach_[g.point] * g.value;
        }
        return step;
    }

    PlaneCells& cells_;
    std::size_t n_fixed_;
    const std::vector<double>& requested_;
    std::vector<double> present_;
    std::vector<double> reach_;  ///< [points] shortest edge at the point, m
    std::vector<Point> tangent_;
};

}  // namespace

double restore_areas(PlaneCells& cells, std::size_t n_fixed, const std::vector<double>& areas) {
    AreaRestorer restorer(cells, n_fixed, areas);
    for (int i = 0; i < most_moves && restorer.largest_error() > allowed_area_error; ++i) {
        if (!restorer.improve()) break;
    }
    return restorer.largest_error();
}

namespace {

/// Longest moves of a corner in each sweep, over the root of the area of the smallest cell there. Chosen by trial.
constexpr std::array<double, 8> longest_moves{0.08, 0.08, 0.06, 0.06, 0.04, 0.04, 0.03, 0.02};
constexpr double acceptable_error = 1e-6;       ///< largest error of areas
constexpr double hexagon_side = 0.6204;         ///< side of a regular hexagon, over the root of its area
constexpr double weight_of_flat_corners = 0.2;  ///< of their cost against sharp ones; chosen by trial

/// Cost of a corner between sides in the directions `next` and `last`: for a sharp corner that of its triangle, for a nearly
/// straight one a penalty on shapes that crystals do not have.
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
        std::size_t cell, number;
    };

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

    /// Cost of everything that the move of a point changes, except for the middles of cells.
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
    std::vector<Point> tangent_;  ///< direction of the boundary or prescribed edge at a point, else 0
    std::vector<std::vector<Corner>> places_of_point_;
    std::vector<Point> middles_;  ///< middles of cells
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
