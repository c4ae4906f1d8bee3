#include "mesher/cells/laguerre.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/cells/clipped_diagram.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr int growing_rounds = 12;              ///< rounds of Lloyd in which weights grow to those of circles of the areas
constexpr int grown_rounds = 4;                 ///< further rounds with these weights; both numbers chosen by trial
constexpr double coarse_error = 0.5;            ///< area error below which seeds may move; chosen by trial
constexpr double coarse_error_in_zones = 0.05;  ///< the same if cells are cut later; chosen by trial
constexpr int most_fillings = 5;
constexpr double filling = 0.05;  ///< weight of an empty cell beyond that of a mere point, over its area
constexpr int most_weight_steps = 100;
constexpr int most_weight_halvings = 40;
constexpr double allowed_error = 1e-6;
constexpr double distance_from_walls = 0.45;  ///< distance of seeds from walls, over the root of the area; chosen by trial
constexpr double kept_share = 0.2;            ///< fraction of an area or smaller target that a step must leave; by trial

/// Random seeds inside the outline.
std::vector<Point> random_seeds(const ConvexOutline& outline, const GradedAreas& areas, RandomNumbers& random) {
    const Box box = box_of(outline.corners);
    const auto inside = [&] {
        while (true) {
            const double x = random.uniform();
            const double y = random.uniform();
            const Point p{box.low.x + x * box.width(), box.low.y + y * box.height()};
            bool is_inside = true;
            for (std::size_t k = 0; k < outline.size() && is_inside; ++k) {
                is_inside = cross(outline.corner(k + 1) - outline.corner(k), p - outline.corner(k)) > 0;
            }
            if (is_inside) return p;
        }
    };
    std::vector<Point> seeds;
    seeds.reserve(areas.size());
    while (seeds.size() < areas.size()) seeds.push_back(areas.random_place(inside, random));
    return seeds;
}

/// Seeds, weights and cells of the iteration.
class Solver {
public:
    Solver(const ConvexOutline& outline, std::vector<Point> seeds)
        : outline_(outline), seeds_(std::move(seeds)), weights_(seeds_.size(), 0.0), diagram_(outline, seeds_, weights_) {}

    [[nodiscard]] const ClippedDiagram& diagram() const { return diagram_; }

    [[nodiscard]] double largest_error(const std::vector<double>& aim) const {
        double largest = 0;
        for (std::size_t i = 0; i < aim.size(); ++i) largest = std::max(largest, std::abs(diagram_.areas()[i] / aim[i] - 1));
        return largest;
    }

    /// Sets weights, larger ones for cells that would be empty.
    void set_weights(std::vector<double> weights, const std::vector<double>& areas) {
        weights_ = std::move(weights);
        diagram_ = ClippedDiagram(outline_, seeds_, weights_);
        for (int i = 0; i < most_fillings && fill_cells(areas); ++i) diagram_ = ClippedDiagram(outline_, seeds_, weights_);
    }

    [[nodiscard]] const std::vector<Point>& seeds() const { return seeds_; }

    /// Moves seeds to the centroids of their cells, whatever their areas become; those of empty cells stay. \param zones zones in
    /// which seeds stay, or null
    void spread(const std::vector<double>& areas, const Zones* zones) {
        for (std::size_t k = 0; k < seeds_.size(); ++k) {
            if (!(diagram_.areas()[k] > 0)) continue;
            const Point goal = diagram_.centroids()[k];
            seeds_[k] = zones == nullptr ? goal : zones->moved(seeds_[k], goal, distance_from_walls * std::sqrt(areas[k]));
        }
    }

    [[nodiscard]] bool has_all_cells() const {
        return diagram_.is_consistent() && *std::min_element(diagram_.areas().begin(), diagram_.areas().end()) > 0;
    }

    /// Makes one step of Newton's method towards areas, halved until it improves them. \return false if no step does
    bool improve(const std::vector<double>& aim) {
        const std::vector<double> step = newton_step(aim);
        const double before = residual(diagram_, aim);
        double share = 1;
        for (int i = 0; i < most_weight_halvings; ++i, share /= 2) {
            std::vector<double> weights = weights_;
            for (std::size_t k = 0; k < step.size(); ++k) weights[k] += share * step[k];
            ClippedDiagram trial(outline_, seeds_, weights);
            if (!leaves_cells(trial, aim, kept_share) || !(residual(trial, aim) <= (1 - share / 2) * before)) continue;
            weights_ = std::move(weights);
            diagram_ = std::move(trial);
            return true;
        }
        return false;
    }

private:
    /// Increases the weights of empty cells until their seeds lie inside. \return false if no cell was empty
    bool fill_cells(const std::vector<double>& areas) {
        bool were_empty = false;
        for (std::size_t i = 0; i < seeds_.size(); ++i) {
            if (diagram_.areas()[i] > 0) continue;
            were_empty = true;
            double power = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < seeds_.size(); ++k) {
                if (k != i) power = std::min(power, squared_length(seeds_[k] - seeds_[i]) - weights_[k]);
            }
            weights_[i] = -power + filling * areas[i];
        }
        return were_empty;
    }

    [[nodiscard]] bool leaves_cells(const ClippedDiagram& trial, const std::vector<double>& aim, double least) const {
        if (!trial.is_consistent()) return false;
        for (std::size_t i = 0; i < aim.size(); ++i) {
            if (!(trial.areas()[i] > least * std::min(aim[i], diagram_.areas()[i]))) return false;
        }
        return true;
    }

    /// Root of the sum of squared differences from areas, m².
    static double residual(const ClippedDiagram& diagram, const std::vector<double>& aim) {
        double sum = 0;
        for (std::size_t i = 0; i < aim.size(); ++i) sum += (diagram.areas()[i] - aim[i]) * (diagram.areas()[i] - aim[i]);
        return std::sqrt(sum);
    }

    /// Solves the linearised equations for changes of weights that give the areas; the last weight stays.
    [[nodiscard]] std::vector<double> newton_step(const std::vector<double>& aim) const {
        const auto n = static_cast<int>(aim.size()) - 1;
        std::vector<double> diagonal(aim.size(), 0);
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(diagram_.sides().size() + aim.size());
        for (const ClippedDiagram::Side& side : diagram_.sides()) {
            const auto a = index(side.left);
            const auto b = index(side.right);
            const double value = 0.5 * length(side.to - side.from) / length(seeds_[a] - seeds_[b]);
            diagonal[a] += value;
            diagonal[b] += value;
            if (side.left < n && side.right < n) {
                entries.emplace_back(std::max(side.left, side.right), std::min(side.left, side.right), -value);
            }
        }
        for (int i = 0; i < n; ++i) entries.emplace_back(i, i, diagonal[index(i)]);
        Eigen::SparseMatrix<double> matrix(n, n);
        matrix.setFromTriplets(entries.begin(), entries.end());
        Eigen::VectorXd difference(n);
        for (int i = 0; i < n; ++i) difference[i] = aim[index(i)] - diagram_.areas()[index(i)];
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky(matrix);
        const Eigen::VectorXd solution = cholesky.solve(difference);
        std::vector<double> step(solution.data(), solution.data() + n);
        step.push_back(0);
        return step;
    }

    const ConvexOutline& outline_;
    std::vector<Point> seeds_;
    std::vector<double> weights_;
    ClippedDiagram diagram_;
};

/// A fraction of the squared radii of circles with given areas, m².
std::vector<double> weights_of(const std::vector<double>& areas, double share) {
    std::vector<double> weights;
    weights.reserve(areas.size());
    for (const double area : areas) weights.push_back(share * area / std::numbers::pi);
    return weights;
}

/// Cells after their seeds are spread. \param error sufficient area error
LaguerreCells solved_cells(const ConvexOutline& outline, std::vector<Point> seeds, const GradedAreas& requested, double error,
                           const Zones* zones, const std::function<void(double)>& progress) {
    constexpr int rounds = growing_rounds + grown_rounds;
    int n_done = 0;
    const auto report = [&] {
        throw_if_interrupted();
        if (progress) progress(std::min(0.95, static_cast<double>(n_done++) / (2 * rounds + 20)));
    };
    Solver solver(outline, std::move(seeds));
    std::vector<double> areas = requested.at(solver.seeds());
    const auto move_seeds = [&] {
        solver.spread(areas, zones);
        areas = requested.at(solver.seeds());
    };
    const auto spread = [&](double share) {
        report();
        solver.set_weights(weights_of(areas, share), areas);
        move_seeds();
    };
    const auto solve = [&](double largest) {
        solver.set_weights(weights_of(areas, 1), areas);
        if (!solver.has_all_cells()) solver.set_weights(weights_of(areas, 0), areas);
        for (int i = 0; i < most_weight_steps && solver.largest_error(areas) > largest; ++i) {
            report();
            if (!solver.improve(areas)) break;
        }
    };
    for (int round = 0; round < growing_rounds; ++round) spread(static_cast<double>(round) / growing_rounds);
    for (int round = 0; round < grown_rounds; ++round) spread(1);
    solve(coarse_error);
    // Seeds of cells that were empty or far from their areas now have places.
    move_seeds();
    for (int round = 0; round < grown_rounds; ++round) spread(1);
    solve(error);
    return {solver.diagram().cells(), solver.diagram().areas(), areas, solver.largest_error(areas), solver.seeds()};
}

}  // namespace

LaguerreCells laguerre_cells(const ConvexOutline& outline, const GradedAreas& areas, RandomNumbers& random,
                             const std::function<void(double)>& progress) {
    LaguerreCells result =
        solved_cells(outline, random_seeds(outline, areas, random), areas, allowed_area_error, nullptr, progress);
    if (!(result.largest_error <= allowed_error)) throw Error(ExitCode::internal, "polygons did not reach their areas");
    return result;
}

LaguerreCells laguerre_cells_in_zones(const Walls& walls, const Zones& zones, const std::vector<std::size_t>& zone_of_cell,
                                      const GradedAreas& areas, RandomNumbers& random,
                                      const std::function<void(double)>& progress) {
    std::vector<Point> seeds;
    seeds.reserve(areas.size());
    for (const std::size_t zone : zone_of_cell) {
        seeds.push_back(areas.random_place([&] { return zones.random_point(zone, random); }, random));
    }
    return solved_cells(walls.hull, std::move(seeds), areas, coarse_error_in_zones, &zones, progress);
}

}  // namespace graincrack::mesher
