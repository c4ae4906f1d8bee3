#include "post/ccd/solve.hpp"

#include <fmt/format.h>
#include <gsl/gsl_multimin.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "post/ccd/design.hpp"
#include "share/base/error.hpp"

namespace graincrack::ccd {

double Goal::operator()(double value) const {
    double share = 0;
    if (kind != Kind::minimum && value < target) {
        share = (value - low) / (target - low);
    } else if (kind != Kind::maximum && value > target) {
        share = (high - value) / (high - target);
    } else {
        share = 1;
    }
    return std::clamp(share, 0.0, 1.0);
}

Goal parse_goal(const std::string& text, Goal::Kind kind, const std::string& option) {
    const char* const form = kind == Goal::Kind::target    ? "NAME=TARGET or NAME=LOW:TARGET:HIGH"
                             : kind == Goal::Kind::maximum ? "NAME=LOW:GOOD"
                                                           : "NAME=GOOD:HIGH";
    const Assignment given = parse_assignment(text, option, form);
    const std::vector<double>& v = given.values;
    const bool rises = std::is_sorted(v.begin(), v.end(), std::less_equal<>());
    const std::size_t wanted = kind == Goal::Kind::target && v.size() != 1 ? 3 : kind == Goal::Kind::target ? 1 : 2;
    if (v.size() != wanted || !rises) {
        throw UsageError(fmt::format("{} {}: {} with rising numbers is needed", option, text, form));
    }
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (kind == Goal::Kind::maximum) return {kind, given.name, v[0], v[1], none};
    if (kind == Goal::Kind::minimum) return {kind, given.name, none, v[0], v[1]};
    if (v.size() == 3) return {kind, given.name, v[0], v[1], v[2]};
    return {kind, given.name, none, v[0], none};
}

void set_limits(Goal& goal, const std::vector<double>& measured) {
    if (goal.kind != Goal::Kind::target || !std::isnan(goal.low)) return;
    const auto [low, high] = std::ranges::minmax_element(measured);
    goal.low = *low;
    goal.high = *high;
    if (goal.low < goal.target && goal.target < goal.high) return;
    throw UsageError(
        fmt::format("--target {}={:.6g}: not between the measured {:.6g} and {:.6g}; give limits, {}=LOW:TARGET:HIGH",
                    goal.response, goal.target, goal.low, goal.high, goal.response));
}

double overall_desirability(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        if (!(value > 0)) return 0;
        sum += std::log(value);
    }
    return std::exp(sum / static_cast<double>(values.size()));
}

namespace {

using Place = std::vector<double>;

double distance(const Place& a, const Place& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}
double norm(const Place& a) { return distance(a, Place(a.size(), 0.0)); }

double desirability(const std::vector<LinearModel>& models, const std::vector<Goal>& goals, const Place& place) {
    std::vector<double> values;
    for (std::size_t i = 0; i < goals.size(); ++i) values.push_back(goals[i](models[i].value(place)));
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

/// The point nearest to the centre at which all targets are met, by iteration: for the models linearised at a point the nearest
/// solution is known, and the next iteration linearises there. Empty if the iteration does not converge.
std::optional<Place> nearest_to_centre(const std::vector<LinearModel>& models, const std::vector<Goal>& goals, Place place) {
    constexpr double fraction = 0.3;  // of each correction: the full one may overshoot where the models are curved
    const auto q = static_cast<Eigen::Index>(models.size());
    const auto n = static_cast<Eigen::Index>(place.size());
    for (int round = 0; round < 500; ++round) {
        Eigen::MatrixXd jacobian(q, n);
        Eigen::VectorXd targets(q);
        const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(place.data(), n);
        for (Eigen::Index i = 0; i < q; ++i) {
            const LinearModel& model = models[static_cast<std::size_t>(i)];
            jacobian.row(i) = model.gradient(place).transpose();
            targets(i) = goals[static_cast<std::size_t>(i)].target - model.value(place) + jacobian.row(i).dot(at);
        }
        Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
        svd.setThreshold(1e-10);
        if (svd.rank() < q) return std::nullopt;
        const Eigen::VectorXd step = svd.solve(targets) - at;  // to the solution of least norm
        const double part = step.norm() < 1e-11 ? 1 : fraction;
        for (Eigen::Index k = 0; k < n; ++k) place[static_cast<std::size_t>(k)] += part * step(k);
        if (part == 1) return place;
    }
    return std::nullopt;
}

/// One optimum in place of the many that a search finds on a line (or a surface) of equal desirability.
std::vector<Optimum> without_choice(const std::vector<LinearModel>& models, const std::vector<Goal>& goals, const Region& region,
                                    std::vector<Optimum> optima) {
    const auto targets =
        static_cast<std::size_t>(std::ranges::count_if(goals, [](const Goal& g) { return g.kind == Goal::Kind::target; }));
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

std::vector<Optimum> solve(const std::vector<LinearModel>& models, const std::vector<Goal>& goals, const Region& region) {
    const Objective objective = [&](const Place& place) {
        return region.holds(place) ? -desirability(models, goals, place) : norm(place);
    };
    std::vector<Place> starts = region.grid(grid_size(region.n_factors()));
    std::erase_if(starts, [&](const Place& place) { return !(objective(place) < 0); });
    std::ranges::stable_sort(starts, [&](const Place& a, const Place& b) { return objective(a) < objective(b); });
    std::vector<Optimum> found;
    // Starts lie far apart: otherwise all would surround the first optimum, and a second one would be missed.
    const double apart = 0.4;
    std::vector<Place> used;
    for (const Place& start : starts) {
        if (used.size() == 12) break;
        const auto near = [&](const Place& other) { return distance(start, other) < apart; };
        if (std::ranges::any_of(used, near)) continue;
        used.push_back(start);
        const Place end = descend(objective, start, 0.1);
        found.push_back({end, -objective(end)});
    }
    if (found.empty()) return found;
    const double best = std::ranges::max_element(found, {}, &Optimum::desirability)->desirability;
    std::erase_if(found, [&](const Optimum& o) { return o.desirability < best - 1e-6; });
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return norm(a.coded) < norm(b.coded); });
    std::vector<Optimum> distinct;
    for (const Optimum& each : found) {
        const auto same = [&](const Optimum& other) { return distance(each.coded, other.coded) < 1e-3; };
        if (std::ranges::none_of(distinct, same)) distinct.push_back(each);
    }
    return without_choice(models, goals, region, std::move(distinct));
}

ConfidenceRegion::ConfidenceRegion(std::vector<LinearModel> models, std::vector<double> targets)
    : models_(std::move(models)), targets_(std::move(targets)) {
    const std::size_t q = models_.size();
    if (q == 0) return;
    int freedom = models_[0].freedom;
    for (const LinearModel& model : models_) freedom = std::min(freedom, model.freedom);
    const int second = freedom - static_cast<int>(q) + 1;
    if (second < 1) return;
    Eigen::MatrixXd residuals(models_[0].residuals.size(), static_cast<Eigen::Index>(q));
    for (std::size_t i = 0; i < q; ++i) residuals.col(static_cast<Eigen::Index>(i)) = models_[i].residuals;
    covariance_ = residuals.transpose() * residuals / freedom;
    const double factor = static_cast<double>(q) * freedom / second;
    limit_ = factor * f_quantile(0.05, static_cast<int>(q), second);
}

double ConfidenceRegion::operator()(const Place& coded) const {
    const Eigen::Index q = covariance_.rows();
    Eigen::VectorXd difference(q);
    Eigen::VectorXd root(q);  // of the leverages
    for (Eigen::Index i = 0; i < q; ++i) {
        const LinearModel& model = models_[static_cast<std::size_t>(i)];
        difference(i) = model.value(coded) - targets_[static_cast<std::size_t>(i)];
        root(i) = std::sqrt(model.leverage(coded));
    }
    const Eigen::LLT<Eigen::MatrixXd> variance(root.asDiagonal() * covariance_ * root.asDiagonal());
    if (variance.info() != Eigen::Success) return difference(0) == 0 ? 0 : HUGE_VAL;
    return difference.dot(variance.solve(difference)) / limit_;
}

}  // namespace graincrack::ccd
