#include "post/ccd/solve.hpp"

#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multimin.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>

namespace graincrack::ccd {

namespace {

using Place = std::vector<double>;

double distance(const Place& a, const Place& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}
double norm(const Place& a) { return distance(a, Place(a.size(), 0.0)); }

double desirability(const std::vector<Model>& models, const std::vector<Goal>& goals, const Place& place) {
    std::vector<double> values;
    for (std::size_t i = 0; i < goals.size(); ++i) values.push_back(goals[i](models[i].predict(place)));
    return overall_desirability(values);
}

using Objective = std::function<double(const Place&)>;

double call_objective(const gsl_vector* x, void* pointer) {
    Place place(x->size);
    for (std::size_t k = 0; k < place.size(); ++k) place[k] = gsl_vector_get(x, k);
    return (*static_cast<const Objective*>(pointer))(place);
}

/// The minimum near a start, by simplex searches of which each starts where the one before ended.
Place descend(const Objective& objective, Place start, double step) {
    using Minimizer = std::unique_ptr<gsl_multimin_fminimizer, decltype(&gsl_multimin_fminimizer_free)>;
    using Vector = std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)>;
    const std::size_t n = start.size();
    gsl_multimin_function function{&call_objective, n, const_cast<Objective*>(&objective)};  // NOLINT: GSL's is not const
    for (int round = 0; round < 4; ++round, step /= 10) {
        const Minimizer minimizer(gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, n),
                                  &gsl_multimin_fminimizer_free);
        const Vector steps(gsl_vector_alloc(n), &gsl_vector_free);
        gsl_vector_set_all(steps.get(), step);
        const gsl_vector_view view = gsl_vector_view_array(start.data(), n);
        gsl_multimin_fminimizer_set(minimizer.get(), &function, &view.vector, steps.get());
        for (int i = 0; i < 500 && gsl_multimin_fminimizer_iterate(minimizer.get()) == 0; ++i) {
            if (gsl_multimin_fminimizer_size(minimizer.get()) < 1e-9) break;
        }
        for (std::size_t k = 0; k < n; ++k) start[k] = gsl_vector_get(minimizer->x, k);
    }
    return start;
}

/// The x of least norm with J x = b, by singular values; empty if rows of J depend on each other.
std::optional<Place> min_norm(const std::vector<Place>& jacobian, const std::vector<double>& b) {
    const std::size_t m = jacobian.size();
    const std::size_t n = jacobian[0].size();
    std::vector<double> u(n * m);  // Jᵀ = U S Vᵀ
    for (std::size_t i = 0; i < m; ++i) {
        for (std::size_t k = 0; k < n; ++k) u[k * m + i] = jacobian[i][k];
    }
    std::vector<double> v(m * m);
    std::vector<double> s(m);
    std::vector<double> work(m);
    gsl_matrix_view U = gsl_matrix_view_array(u.data(), n, m);
    gsl_matrix_view V = gsl_matrix_view_array(v.data(), m, m);
    gsl_vector_view S = gsl_vector_view_array(s.data(), m);
    gsl_vector_view W = gsl_vector_view_array(work.data(), m);
    gsl_linalg_SV_decomp(&U.matrix, &V.matrix, &S.vector, &W.vector);
    if (!(s[m - 1] > 1e-10 * s[0])) return std::nullopt;
    Place x(n, 0.0);
    for (std::size_t j = 0; j < m; ++j) {
        double share = 0;
        for (std::size_t i = 0; i < m; ++i) share += v[i * m + j] * b[i];
        for (std::size_t k = 0; k < n; ++k) x[k] += u[k * m + j] * share / s[j];
    }
    return x;
}

/// The point nearest to the centre at which all targets are met, by iteration: for the models linearised at a point the nearest
/// solution is known, and the next iteration linearises there. Empty if the iteration does not converge.
std::optional<Place> nearest_to_centre(const std::vector<Model>& models, const std::vector<Goal>& goals, Place place) {
    constexpr double step = 1e-4;
    constexpr double share = 0.3;  // of each correction: the full one may overshoot where the models are curved
    for (int round = 0; round < 500; ++round) {
        std::vector<Place> jacobian;
        std::vector<double> b;
        for (std::size_t i = 0; i < models.size(); ++i) {
            Place slope(place.size());
            for (std::size_t k = 0; k < place.size(); ++k) {
                Place low = place;
                Place high = place;
                low[k] -= step;
                high[k] += step;
                slope[k] = (models[i].predict(high) - models[i].predict(low)) / (2 * step);  // exact for a quadratic
            }
            b.push_back(goals[i].target - models[i].predict(place) +
                        std::inner_product(slope.begin(), slope.end(), place.begin(), 0.0));
            jacobian.push_back(std::move(slope));
        }
        std::optional<Place> next = min_norm(jacobian, b);
        if (!next) return std::nullopt;
        if (distance(*next, place) < 1e-11) return next;
        for (std::size_t k = 0; k < place.size(); ++k) place[k] += share * ((*next)[k] - place[k]);
    }
    return std::nullopt;
}

/// One optimum in place of the many that a search finds on a line (or a surface) of equal desirability.
std::vector<Optimum> without_choice(const std::vector<Model>& models, const std::vector<Goal>& goals, const Region& region,
                                    std::vector<Optimum> optima) {
    const auto targets = static_cast<std::size_t>(
        std::count_if(goals.begin(), goals.end(), [](const Goal& g) { return g.kind == Goal::Kind::target; }));
    constexpr double met = 1 - 1e-6;
    if (optima.empty() || optima[0].desirability < met || targets >= region.n_factors()) return optima;
    optima.resize(1);
    optima[0].free_factors = region.n_factors() - targets;
    if (targets < goals.size()) return optima;
    const auto nearest = nearest_to_centre(models, goals, optima[0].coded);
    if (nearest && region.holds(*nearest) && desirability(models, goals, *nearest) >= met) optima[0].coded = *nearest;
    return optima;
}

/// As many points along a factor as keep the grid small.
std::size_t grid_size(std::size_t n_factors) {
    constexpr double most = 20000;
    return std::max<std::size_t>(4, static_cast<std::size_t>(std::pow(most, 1.0 / static_cast<double>(n_factors))));
}

}  // namespace

Region::Region(const std::vector<Place>& coded) : low_(coded[0]), high_(coded[0]) {
    for (const Place& run : coded) {
        for (std::size_t k = 0; k < run.size(); ++k) {
            low_[k] = std::min(low_[k], run[k]);
            high_[k] = std::max(high_[k], run[k]);
        }
        radius_ = std::max(radius_, norm(run));
    }
}

bool Region::holds(const Place& coded) const {
    constexpr double slack = 1e-9;
    for (std::size_t k = 0; k < coded.size(); ++k) {
        if (coded[k] < low_[k] - slack || coded[k] > high_[k] + slack) return false;
    }
    return norm(coded) <= radius_ * (1 + 1e-4);  // printed tables round √2 to 1.41421
}

std::vector<Place> Region::grid(std::size_t per_factor) const {
    std::vector<Place> points;
    std::size_t n = 1;
    for (std::size_t k = 0; k < n_factors(); ++k) n *= per_factor;
    for (std::size_t i = 0; i < n; ++i) {
        Place place(n_factors());
        std::size_t rest = i;
        for (std::size_t k = 0; k < n_factors(); ++k, rest /= per_factor) {
            const double share = static_cast<double>(rest % per_factor) / static_cast<double>(per_factor - 1);
            place[k] = low_[k] + share * (high_[k] - low_[k]);
        }
        if (holds(place)) points.push_back(std::move(place));
    }
    return points;
}

std::vector<Optimum> solve(const std::vector<Model>& models, const std::vector<Goal>& goals, const Region& region) {
    const Objective objective = [&](const Place& place) {
        return region.holds(place) ? -desirability(models, goals, place) : norm(place);
    };
    std::vector<Place> starts = region.grid(grid_size(region.n_factors()));
    std::erase_if(starts, [&](const Place& place) { return !(objective(place) < 0); });
    std::stable_sort(starts.begin(), starts.end(), [&](const Place& a, const Place& b) { return objective(a) < objective(b); });
    std::vector<Optimum> found;
    // Starts lie far apart: otherwise all would surround the first optimum, and a second one would be missed.
    const double apart = 0.4;
    std::vector<Place> used;
    for (const Place& start : starts) {
        if (used.size() == 12) break;
        const auto near = [&](const Place& other) { return distance(start, other) < apart; };
        if (std::any_of(used.begin(), used.end(), near)) continue;
        used.push_back(start);
        const Place end = descend(objective, start, 0.1);
        found.push_back({end, -objective(end)});
    }
    if (found.empty()) return found;
    const double best = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
                            return a.desirability < b.desirability;
                        })->desirability;
    std::erase_if(found, [&](const Optimum& o) { return o.desirability < best - 1e-6; });
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return norm(a.coded) < norm(b.coded); });
    std::vector<Optimum> distinct;
    for (const Optimum& each : found) {
        const auto same = [&](const Optimum& other) { return distance(each.coded, other.coded) < 1e-3; };
        if (std::none_of(distinct.begin(), distinct.end(), same)) distinct.push_back(each);
    }
    return without_choice(models, goals, region, std::move(distinct));
}

ConfidenceRegion::ConfidenceRegion(std::vector<Model> models, std::vector<double> targets)
    : models_(std::move(models)), targets_(std::move(targets)) {
    const std::size_t q = models_.size();
    if (q == 0) return;
    int freedom = models_[0].regression().freedom;
    for (const Model& model : models_) freedom = std::min(freedom, model.regression().freedom);
    const int second = freedom - static_cast<int>(q) + 1;
    if (second < 1) return;
    covariance_.assign(q, std::vector<double>(q, 0.0));
    const std::vector<Place>& runs = models_[0].coded();
    for (std::size_t r = 0; r < runs.size(); ++r) {
        std::vector<double> residual;
        for (const Model& model : models_) residual.push_back(model.response()[r] - model.predict(runs[r]));
        for (std::size_t i = 0; i < q; ++i) {
            for (std::size_t j = 0; j < q; ++j) covariance_[i][j] += residual[i] * residual[j] / freedom;
        }
    }
    const double factor = static_cast<double>(q) * freedom / second;
    limit_ = factor * f_quantile(0.05, static_cast<int>(q), second);
}

double ConfidenceRegion::operator()(const Place& coded) const {
    const std::size_t q = models_.size();
    std::vector<double> matrix(q * q);
    std::vector<double> difference(q);
    std::vector<double> solution(q);
    std::vector<double> leverage;
    for (const Model& model : models_) leverage.push_back(model.leverage(coded));
    for (std::size_t i = 0; i < q; ++i) {
        difference[i] = models_[i].predict(coded) - targets_[i];
        for (std::size_t j = 0; j < q; ++j) matrix[i * q + j] = covariance_[i][j] * std::sqrt(leverage[i] * leverage[j]);
    }
    gsl_matrix_view V = gsl_matrix_view_array(matrix.data(), q, q);
    const gsl_vector_view d = gsl_vector_view_array(difference.data(), q);
    gsl_vector_view x = gsl_vector_view_array(solution.data(), q);
    if (gsl_linalg_cholesky_decomp1(&V.matrix) != 0) return difference[0] == 0 ? 0 : HUGE_VAL;
    gsl_linalg_cholesky_solve(&V.matrix, &d.vector, &x.vector);
    return std::inner_product(difference.begin(), difference.end(), solution.begin(), 0.0) / limit_;
}

}  // namespace graincrack::ccd
