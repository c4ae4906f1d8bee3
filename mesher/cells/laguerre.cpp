#include "mesher/cells/laguerre.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "mesher/cells/clipped_diagram.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr int plain_rounds = 3;     ///< in which seeds spread without weights
constexpr int weighted_rounds = 10;  ///< in which seeds move to the centroids of cells with weights
constexpr int blended_rounds = 5;   ///< of these, in which the aim goes from the present areas to the wanted ones
constexpr int most_steps = 100;
constexpr int most_halvings = 40;
constexpr double wanted_error = 1e-9;  ///< of areas
constexpr double allowed_error = 1e-6;
constexpr double kept_share = 0.2;  ///< of an area, or of the one aimed at if that is less, that a step leaves

/// Seeds at random inside of the outline.
std::vector<Point> random_seeds(const ConvexOutline& outline, std::size_t n, RandomNumbers& random) {
    Point low = outline.corners.front();
    Point high = low;
    for (const Point p : outline.corners) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    std::vector<Point> seeds;
    while (seeds.size() < n) {
        const double x = random.uniform();
        const double y = random.uniform();
        const Point p{low.x + x * (high.x - low.x), low.y + y * (high.y - low.y)};
        bool is_inside = true;
        for (std::size_t k = 0; k < outline.size() && is_inside; ++k) {
            is_inside = cross(outline.corner(k + 1) - outline.corner(k), p - outline.corner(k)) > 0;
        }
        if (is_inside) seeds.push_back(p);
    }
    return seeds;
}

/// Seeds, weights and cells, step by step.
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

    /// One step of Newton's method towards areas, halved until it improves them. \return whether it did
    bool improve(const std::vector<double>& aim) {
        const std::vector<double> step = newton_step(aim);
        const double before = residual(diagram_, aim);
        double share = 1;
        for (int i = 0; i < most_halvings; ++i, share /= 2) {
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

    /// Moves seeds to the centroids of their cells; less far if a cell would become empty.
    void move_to_centroids() {
        double share = 1;
        for (int i = 0; i < 6; ++i, share /= 2) {
            std::vector<Point> seeds = seeds_;
            for (std::size_t k = 0; k < seeds.size(); ++k) seeds[k] = seeds[k] + share * (diagram_.centroids()[k] - seeds[k]);
            ClippedDiagram trial(outline_, seeds, weights_);
            if (!leaves_cells(trial, diagram_.areas(), kept_share)) continue;
            seeds_ = std::move(seeds);
            diagram_ = std::move(trial);
            return;
        }
    }

private:
    [[nodiscard]] bool leaves_cells(const ClippedDiagram& trial, const std::vector<double>& aim, double least) const {
        if (!trial.is_consistent()) return false;
        for (std::size_t i = 0; i < aim.size(); ++i) {
            if (!(trial.areas()[i] > least * std::min(aim[i], diagram_.areas()[i]))) return false;
        }
        return true;
    }

    /// Root of the sum of the squares of differences from areas.
    static double residual(const ClippedDiagram& diagram, const std::vector<double>& aim) {
        double sum = 0;
        for (std::size_t i = 0; i < aim.size(); ++i) sum += (diagram.areas()[i] - aim[i]) * (diagram.areas()[i] - aim[i]);
        return std::sqrt(sum);
    }

    /// Solves for the changes of weights that would give the areas if these were linear in them; the last weight stays.
    [[nodiscard]] std::vector<double> newton_step(const std::vector<double>& aim) const {
        const auto n = static_cast<int>(aim.size()) - 1;
        std::vector<double> diagonal(aim.size(), 0);
        std::vector<Eigen::Triplet<double>> entries;
        entries.reserve(diagram_.sides().size() + aim.size());
        for (const ClippedDiagram::Side& side : diagram_.sides()) {
            const auto a = static_cast<std::size_t>(side.left);
            const auto b = static_cast<std::size_t>(side.right);
            const double value = 0.5 * length(side.to - side.from) / length(seeds_[a] - seeds_[b]);
            diagonal[a] += value;
            diagonal[b] += value;
            if (side.left < n && side.right < n) {
                entries.emplace_back(std::max(side.left, side.right), std::min(side.left, side.right), -value);
            }
        }
        for (int i = 0; i < n; ++i) entries.emplace_back(i, i, diagonal[static_cast<std::size_t>(i)]);
        Eigen::SparseMatrix<double> matrix(n, n);
        matrix.setFromTriplets(entries.begin(), entries.end());
        Eigen::VectorXd difference(n);
        for (int i = 0; i < n; ++i) {
            difference[i] = aim[static_cast<std::size_t>(i)] - diagram_.areas()[static_cast<std::size_t>(i)];
        }
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

}  // namespace

LaguerreCells laguerre_cells(const ConvexOutline& outline, const std::vector<double>& areas, RandomNumbers& random,
                             const std::function<void(double)>& progress) {
    constexpr int rounds = plain_rounds + weighted_rounds;
    const auto report = [&](int round) {
        throw_if_interrupted();
        if (progress) progress(static_cast<double>(round) / (rounds + 4));
    };
    Solver solver(outline, random_seeds(outline, areas.size(), random));
    for (int round = 0; round < plain_rounds; ++round) {
        report(round);
        solver.move_to_centroids();
    }
    std::vector<double> aim(areas.size());
    for (int round = 0; round < weighted_rounds; ++round) {
        report(plain_rounds + round);
        const double blend = std::min(1.0, (round + 1.0) / blended_rounds);
        for (std::size_t i = 0; i < aim.size(); ++i) {
            aim[i] = (1 - blend) * solver.diagram().areas()[i] + blend * areas[i];
        }
        solver.improve(aim);
        solver.move_to_centroids();
    }
    report(rounds);
    for (int i = 0; i < most_steps && solver.largest_error(areas) > wanted_error; ++i) {
        throw_if_interrupted();
        if (!solver.improve(areas)) break;
    }
    LaguerreCells result;
    result.largest_error = solver.largest_error(areas);
    if (!(result.largest_error <= allowed_error)) throw Error(ExitCode::internal, "polygons did not reach their areas");
    result.areas = solver.diagram().areas();
    result.cells = solver.diagram().cells();
    return result;
}

}  // namespace graincrack::mesher
