#include "mesher/cells/restored_areas.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/polygon.hpp"

namespace graincrack::mesher {

namespace {

constexpr int most_moves = 12;
constexpr int most_halvings_of_a_move = 8;
constexpr double smallest_pivot = 1e-12;  ///< over the largest

/// The change of a cell's area with the move of one of its corners over the reach of that corner, m².
struct Gradient {
    std::size_t cell;
    std::size_t point;
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

    /// One step, halved until it improves the areas. \return whether it did
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
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
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

    /// A move that a point cannot make is left out.
    [[nodiscard]] Point possible(std::size_t point, Point move) const {
        if (point < n_fixed_) return {};
        return squared_length(tangent_[point]) > 0 ? dot(move, tangent_[point]) * tangent_[point] : move;
    }

    /// By ascending points.
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

    /// The moves of points that change areas as requested, were these linear; the squares of moves over reach have the least sum.
    /// The area of the last cell is what the others leave of the whole.
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
        cholesky.setShift(smallest_pivot * matrix.diagonal().maxCoeff());  // for areas that depend on one another
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
    std::vector<double> reach_;  ///< the shortest edge at a point
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

}  // namespace graincrack::mesher
