#include "post/calibrate/surface.hpp"

#include <algorithm>
#include <cmath>

#include "post/ccd/design.hpp"
#include "post/ccd/desirability.hpp"
#include "post/ccd/solve.hpp"

namespace graincrack::calibrate {

namespace {

using ccd::Model;
using Coded = std::vector<double>;

constexpr double step = 1e-4;  // of differences, which are exact for quadratics

/// Derivatives of both surfaces by both coded factors.
std::array<std::array<double, 2>, 2> jacobian(const std::array<Model, 2>& models, const Coded& at) {
    std::array<std::array<double, 2>, 2> out{};
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            Coded low = at;
            Coded high = at;
            low[k] -= step;
            high[k] += step;
            out[i][k] = (models[i].predict(high) - models[i].predict(low)) / (2 * step);
        }
    }
    return out;
}

using Inverse = std::array<std::array<double, 2>, 2>;
std::optional<Inverse> inverse(const std::array<std::array<double, 2>, 2>& m) {
    const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    if (!(std::abs(determinant) > 1e-12)) return std::nullopt;
    return Inverse{{{m[1][1] / determinant, -m[0][1] / determinant}, {-m[1][0] / determinant, m[0][0] / determinant}}};
}

/// The place where both surfaces are 1, by Newton's method from the centre; empty if it does not converge.
std::optional<Coded> root(const std::array<Model, 2>& models) {
    constexpr double most = 0.5;  // of one step: quadratics turn over far away
    Coded at{0, 0};
    for (int i = 0; i < 60; ++i) {
        const auto back = inverse(jacobian(models, at));
        if (!back) return std::nullopt;
        const std::array<double, 2> off{1 - models[0].predict(at), 1 - models[1].predict(at)};
        std::array<double, 2> move{};
        for (std::size_t k = 0; k < 2; ++k) move[k] = (*back)[k][0] * off[0] + (*back)[k][1] * off[1];
        const double length = std::hypot(move[0], move[1]);
        const double share = length > most ? most / length : 1;
        for (std::size_t k = 0; k < 2; ++k) at[k] += share * move[k];
        if (length < 1e-10) return at;
    }
    return std::nullopt;
}

/// The most desirable place of a grid over the design. Limits are wide: targets may lie far from the strengths.
Coded most_desirable(const std::array<Model, 2>& models, const ccd::Region& region) {
    using ccd::Goal;
    const Goal goal{Goal::Kind::target, "", 0, 1, 10};
    const auto desirability = [&](const Coded& at) {
        return ccd::overall_desirability({goal(models[0].predict(at)), goal(models[1].predict(at))});
    };
    constexpr std::size_t per_factor = 41;
    Coded best{0, 0};
    double most = desirability(best);
    for (const Coded& at : region.grid(per_factor)) {
        const double here = desirability(at);
        if (here > most) {
            most = here;
            best = at;
        }
    }
    return best;
}

using Matrix = std::array<std::array<double, 2>, 2>;

/// Covariance of pairs of values about pairs of means, over `freedom`.
Matrix covariance_of(const std::vector<std::array<double, 2>>& residuals, int freedom) {
    Matrix out{};
    for (const auto& residual : residuals) {
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) out[i][j] += residual[i] * residual[j] / freedom;
        }
    }
    return out;
}

Matrix residual_covariance(const std::array<Model, 2>& models) {
    std::vector<std::array<double, 2>> residuals;
    for (std::size_t r = 0; r < models[0].coded().size(); ++r) {
        residuals.push_back({models[0].response()[r] - models[0].predict(models[0].coded()[r]),
                             models[1].response()[r] - models[1].predict(models[1].coded()[r])});
    }
    return covariance_of(residuals, std::max(1, models[0].regression().freedom));
}

/// Intervals of both factors at a place from the covariance V of the strengths there: J⁻¹ V J⁻ᵀ.
std::array<Estimate, 2> intervals(const Frame& frame, const Inverse& back, const Matrix& covariance, const Coded& at,
                                  int freedom) {
    std::array<Estimate, 2> out;
    for (std::size_t k = 0; k < 2; ++k) {
        double variance = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t j = 0; j < 2; ++j) variance += back[k][i] * back[k][j] * covariance[i][j];
        }
        const Estimate coded = estimate(at[k], variance, freedom);
        Coded end = at;
        out[k].value = frame.place(at)[k];
        if (!coded.low) continue;
        end[k] = *coded.low;
        out[k].low = frame.place(end)[k];
        end[k] = *coded.high;
        out[k].high = frame.place(end)[k];
    }
    return out;
}

Matrix scaled(Matrix m, double by) {
    for (auto& row : m) {
        for (double& value : row) value *= by;
    }
    return m;
}

/// Variance of the change of a fitted mean from one place to another, over the residual variance.
double leverage_of_change(const Model& model, const Coded& from, const Coded& to) {
    std::vector<double> change;
    for (const ccd::Term& term : model.terms()) change.push_back(term(to) - term(from));
    return model.regression().leverage(change);
}

std::array<Model, 2> fit(const Frame& frame, const std::vector<SurfacePoint>& points) {
    std::vector<Coded> coded;
    std::array<std::vector<double>, 2> response;
    for (const SurfacePoint& point : points) {
        coded.push_back(frame.coded(point.place));
        for (std::size_t i = 0; i < 2; ++i) response[i].push_back(point.over_target[i]);
    }
    return {Model(ccd::quadratic_terms(2), coded, response[0]), Model(ccd::quadratic_terms(2), coded, response[1])};
}

}  // namespace

std::vector<double> Frame::coded(const Place& place) const {
    return {std::log(place[0] / centre[0]) / std::log(factor), (place[1] - centre[1]) / angle};
}

Place Frame::place(const std::vector<double>& coded) const {
    return {centre[0] * std::pow(factor, coded[0]), centre[1] + angle * coded[1]};
}

std::vector<Place> design_places(const Frame& frame, double scale, std::size_t centre_runs) {
    std::vector<Place> places;
    for (Coded run : ccd::coded_runs(2, ccd::Star::rotatable, centre_runs)) {
        for (double& x : run) x *= scale;
        places.push_back(frame.place(run));
    }
    return places;
}

SurfaceSolution solve_surfaces(const Frame& frame, const std::vector<SurfacePoint>& points) {
    const std::array<Model, 2> models = fit(frame, points);
    const ccd::Region region(models[0].coded());
    const std::optional<Coded> both = root(models);
    SurfaceSolution solution;
    solution.met = both && region.holds(*both);
    const Coded at = solution.met ? *both : most_desirable(models, region);
    solution.place = frame.place(at);
    for (std::size_t i = 0; i < 2; ++i) {
        solution.expected[i] = models[i].predict(at);
        if (const auto lack = models[i].lack_of_fit()) solution.lack_of_fit_p[i] = lack->p;
        solution.interval[i] = {solution.place[i], std::nullopt, std::nullopt};
    }
    const int freedom = models[0].regression().freedom;
    const auto back = inverse(jacobian(models, at));
    // Both have the same runs, and so the same leverage.
    if (back)
        solution.interval = intervals(frame, *back, scaled(residual_covariance(models), models[0].leverage(at)), at, freedom);
    return solution;
}

SurfaceSolution correct_by_replicates(const Frame& frame, const std::vector<SurfacePoint>& points,
                                      const std::vector<SurfacePoint>& replicates) {
    std::vector<SurfacePoint> all = points;
    all.insert(all.end(), replicates.begin(), replicates.end());
    SurfaceSolution solution = solve_surfaces(frame, all);
    const std::array<Model, 2> models = fit(frame, all);
    const Coded from = frame.coded(replicates.front().place);
    const auto back = inverse(jacobian(models, from));
    if (!back) return solution;
    const auto n = static_cast<double>(replicates.size());
    std::array<double, 2> mean{};
    for (const SurfacePoint& r : replicates) {
        for (std::size_t i = 0; i < 2; ++i) mean[i] += r.over_target[i] / n;
    }
    std::vector<std::array<double, 2>> residuals;
    for (const SurfacePoint& r : replicates) residuals.push_back({r.over_target[0] - mean[0], r.over_target[1] - mean[1]});
    Coded to = from;
    for (std::size_t k = 0; k < 2; ++k) to[k] += (*back)[k][0] * (1 - mean[0]) + (*back)[k][1] * (1 - mean[1]);
    const int freedom = static_cast<int>(replicates.size()) - 1;
    Matrix covariance = scaled(covariance_of(residuals, freedom), 1 / n);
    const Matrix of_slopes = scaled(residual_covariance(models), leverage_of_change(models[0], from, to));
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) covariance[i][j] += of_slopes[i][j];
    }
    solution.place = frame.place(to);
    solution.met = ccd::Region(models[0].coded()).holds(to);
    solution.interval = intervals(frame, *back, covariance, to, freedom);
    solution.expected = {1, 1};
    return solution;
}

}  // namespace graincrack::calibrate
