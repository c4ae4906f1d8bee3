#include "post/statistics/linear_model.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace graincrack {

namespace {

constexpr double dependent = 1e-10;  // over the largest pivot, below which a term depends on the others

double power_of(double value, int power) {
    double product = 1;
    for (int i = 0; i < power; ++i) product *= value;
    return product;
}

/// Sum of squared deviations from the mean.
double sum_of_squares(const std::vector<double>& values) {
    const Eigen::Map<const Eigen::ArrayXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
    return (all - all.mean()).square().sum();
}

/// Sum of squared residuals when each run is predicted without itself.
double sum_of_deleted(const Eigen::VectorXd& residuals, const Eigen::VectorXd& leverages) {
    return (residuals.array() / (1 - leverages.array()).max(1e-9)).square().sum();
}

Eigen::VectorXd column(const SurfaceTerm& term, const std::vector<std::vector<double>>& factors) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(factors.size()));
    std::transform(factors.begin(), factors.end(), values.begin(), term);
    return values;
}

}  // namespace

double SurfaceTerm::operator()(const std::vector<double>& factors) const {
    double product = 1;
    for (std::size_t k = 0; k < power.size(); ++k) product *= power_of(factors[k], power[k]);
    return product;
}

double SurfaceTerm::slope(const std::vector<double>& factors, std::size_t factor) const {
    if (power[factor] == 0) return 0;
    SurfaceTerm lower = *this;
    --lower.power[factor];
    return power[factor] * lower(factors);
}

int SurfaceTerm::degree() const { return std::accumulate(power.begin(), power.end(), 0); }

std::string SurfaceTerm::name() const {
    std::string label;
    for (std::size_t k = 0; k < power.size(); ++k) {
        if (power[k] == 0) continue;
        label += fmt::format("{}x{}{}", label.empty() ? "" : " ", k + 1, power[k] == 1 ? "" : fmt::format("^{}", power[k]));
    }
    return label.empty() ? "1" : label;
}

bool SurfaceTerm::is_parent_of(const SurfaceTerm& other) const {
    return *this != other && std::equal(power.begin(), power.end(), other.power.begin(), std::less_equal<>());
}

std::vector<SurfaceTerm> quadratic_terms(std::size_t n_factors) {
    const SurfaceTerm constant{std::vector<int>(n_factors, 0)};
    std::vector<SurfaceTerm> linear;
    std::vector<SurfaceTerm> products;
    std::vector<SurfaceTerm> squares;
    for (std::size_t i = 0; i < n_factors; ++i) {
        linear.push_back(constant);
        linear.back().power[i] = 1;
        squares.push_back(constant);
        squares.back().power[i] = 2;
        for (std::size_t j = i + 1; j < n_factors; ++j) {
            products.push_back(linear.back());
            products.back().power[j] = 1;
        }
    }
    std::vector<SurfaceTerm> terms{constant};
    for (const auto* group : {&linear, &products, &squares}) terms.insert(terms.end(), group->begin(), group->end());
    return terms;
}

LinearModel::LinearModel(std::vector<SurfaceTerm> of, std::vector<std::vector<double>> at, std::vector<double> values)
    : terms(std::move(of)), n_values(static_cast<int>(values.size())), factors(std::move(at)), response(std::move(values)) {
    design.resize(static_cast<Eigen::Index>(response.size()), static_cast<Eigen::Index>(terms.size()));
    for (Eigen::Index i = 0; i < design.cols(); ++i) design.col(i) = column(terms[static_cast<std::size_t>(i)], factors);
}

double LinearModel::solve(const Eigen::VectorXd& weights) {
    const Eigen::Index p = design.cols();
    const Eigen::Map<const Eigen::VectorXd> y(response.data(), design.rows());
    const Eigen::LDLT<Eigen::MatrixXd> matrix(design.transpose() * design + Eigen::MatrixXd(weights.asDiagonal()));
    inverse = matrix.solve(Eigen::MatrixXd::Identity(p, p));
    coefficients = inverse * (design.transpose() * y);
    residuals = y - design * coefficients;
    leverages = (design * inverse).cwiseProduct(design).rowwise().sum();
    const double sum = residual_sum() + weights.dot(coefficients.cwiseAbs2());
    const Eigen::Index n_drawn = (weights.array() > 0).count();
    const auto without_free = static_cast<double>(design.rows() - p + n_drawn);
    variance = without_free > 0 ? sum / without_free : 0;
    freedom = static_cast<int>(std::lround(static_cast<double>(design.rows()) - leverages.sum()));
    const double log_weights = (weights.array() > 0).select(weights.array().max(1e-300).log(), 0).sum();
    return (log_weights - matrix.vectorD().array().log().sum() - without_free * std::log(sum)) / 2;
}

std::optional<LinearModel> LinearModel::fit(std::vector<SurfaceTerm> terms, std::vector<std::vector<double>> factors,
                                            std::vector<double> response) {
    LinearModel model(std::move(terms), std::move(factors), std::move(response));
    const Eigen::Index p = model.design.cols();
    if (p == 0 || model.design.rows() < p) return std::nullopt;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(model.design);
    qr.setThreshold(dependent);
    if (qr.rank() < p) return std::nullopt;
    model.solve(Eigen::VectorXd::Zero(p));
    return model;
}

double LinearModel::make_independent(const std::vector<std::string>& specimens, double correlation) {
    std::map<std::string, std::vector<Eigen::Index>> members;
    for (std::size_t i = 0; i < specimens.size(); ++i) members[specimens[i]].push_back(static_cast<Eigen::Index>(i));
    Eigen::MatrixXd both(design.rows(), design.cols() + 1);
    both << design, Eigen::Map<const Eigen::VectorXd>(response.data(), design.rows());
    double log_determinant = 0;
    for (const auto& [specimen, own] : members) {
        const auto others = static_cast<double>(own.size()) - 1;
        const double left = std::sqrt((1 - correlation) / (1 + others * correlation));  // factor on their mean
        const Eigen::RowVectorXd mean = both(own, Eigen::all).colwise().mean();
        for (const Eigen::Index i : own) both.row(i) = (both.row(i) - (1 - left) * mean) / std::sqrt(1 - correlation);
        log_determinant += std::log(left) - (others + 1) / 2 * std::log(1 - correlation);
    }
    design = both.leftCols(design.cols());
    Eigen::Map<Eigen::VectorXd>(response.data(), design.rows()) = both.rightCols<1>();
    return log_determinant;
}

std::optional<LinearModel> LinearModel::fit_restricted(std::vector<SurfaceTerm> terms, std::size_t n_free,
                                                       std::vector<std::vector<double>> factors, std::vector<double> response,
                                                       const std::vector<std::string>& specimens) {
    const auto free = fit({terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(n_free)}, factors, response);
    if (!free || free->freedom < 2) return std::nullopt;
    const LinearModel given(std::move(terms), std::move(factors), std::move(response));
    Eigen::VectorXd drawn = Eigen::VectorXd::Ones(given.design.cols());
    drawn.head(static_cast<Eigen::Index>(n_free)).setZero();
    std::optional<LinearModel> best;
    double most = -std::numeric_limits<double>::infinity();
    const bool share = std::set<std::string>(specimens.begin(), specimens.end()).size() < specimens.size();
    double weight = 1;
    double correlation = share ? 0.5 : 0;
    const auto attempt = [&](double own_weight, double own_correlation) {
        LinearModel model = given;
        const double log_determinant = model.make_independent(specimens, own_correlation);
        const double likelihood = log_determinant + model.solve(own_weight * drawn);
        if (!(likelihood > most)) return;
        std::tie(most, weight, correlation) = std::tuple(likelihood, own_weight, own_correlation);
        best = std::move(model);
    };
    for (int round = 0; round < (share ? 2 : 1); ++round) {
        for (double each = 1; each < 1e4; each *= 1.5) attempt(each, correlation);
        for (double own = 1; share && own > 0.01; own *= 0.75) attempt(weight, 1 - own);  // the rest is of specimens
    }
    return best;
}

void LinearModel::update(const std::vector<double>& at, double value, double scatter) {
    const Eigen::VectorXd x = row(at);
    const Eigen::VectorXd gain = inverse * x / (x.dot(inverse * x) + scatter);
    coefficients += gain * (value - x.dot(coefficients));
    inverse -= (gain * (x.transpose() * inverse)).eval();
    inverse = (0.5 * (inverse + inverse.transpose())).eval();
    ++n_values;
}

double LinearModel::residual_correlation(const LinearModel& other) const {
    if (terms != other.terms || factors != other.factors) return 0;
    return residuals.dot(other.residuals) / (residuals.norm() * other.residuals.norm());
}

double LinearModel::total_sum() const { return sum_of_squares(response); }

double LinearModel::press() const { return sum_of_deleted(residuals, leverages); }

double LinearModel::press_with(const SurfaceTerm& term) const {
    const Eigen::VectorXd whole = column(term, factors);
    Eigen::VectorXd own = whole;  // minus the part along the other terms
    for (int twice = 0; twice < 2; ++twice) own -= design * (inverse * (design.transpose() * own));
    const double length = own.norm();
    if (!(length > 1e-8 * whole.norm())) return std::numeric_limits<double>::infinity();
    own /= length;
    return sum_of_deleted(residuals - own * own.dot(residuals), leverages + own.cwiseAbs2());
}

double LinearModel::prediction_error() const { return std::sqrt(press() / static_cast<double>(response.size())); }

double LinearModel::standard_error(std::size_t term) const {
    const auto i = static_cast<Eigen::Index>(term);
    return std::sqrt(variance * inverse(i, i));
}

double LinearModel::r_squared() const { return total_sum() > 0 ? 1 - residual_sum() / total_sum() : 1; }

std::optional<double> LinearModel::adjusted_r_squared() const {
    if (freedom < 1 || !(total_sum() > 0)) return std::nullopt;
    return 1 - variance / (total_sum() / static_cast<double>(response.size() - 1));
}

double LinearModel::predicted_r_squared() const { return total_sum() > 0 ? 1 - press() / total_sum() : 1; }

Eigen::VectorXd LinearModel::row(const std::vector<double>& at) const {
    Eigen::VectorXd values(coefficients.size());
    std::transform(terms.begin(), terms.end(), values.begin(), [&](const SurfaceTerm& term) { return term(at); });
    return values;
}

double LinearModel::leverage(const std::vector<double>& at) const {
    const Eigen::VectorXd x = row(at);
    return x.dot(inverse * x);
}

Estimate LinearModel::with_interval(const std::vector<double>& at, double own_variance) const {
    return estimate(value(at), variance * (own_variance + leverage(at)), freedom);
}

Eigen::VectorXd LinearModel::gradient(const std::vector<double>& at) const {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(at.size()));
    for (std::size_t k = 0; k < at.size(); ++k) {
        for (std::size_t i = 0; i < terms.size(); ++i) {
            gradient(static_cast<Eigen::Index>(k)) += coefficients(static_cast<Eigen::Index>(i)) * terms[i].slope(at, k);
        }
    }
    return gradient;
}

std::optional<double> LinearModel::p_value(std::size_t term) const {
    if (freedom < 1) return std::nullopt;
    const double t = coefficients(static_cast<Eigen::Index>(term)) / standard_error(term);
    return 2 * gsl_cdf_tdist_Q(std::abs(t), freedom);
}

std::optional<FTest> LinearModel::significance() const {
    const int tested = static_cast<int>(terms.size()) - 1;
    if (freedom < 1 || tested < 1) return std::nullopt;
    const double f = (total_sum() - residual_sum()) / tested / variance;
    return FTest{f, f_tail(f, tested, freedom)};
}

std::optional<LackOfFit> LinearModel::lack_of_fit() const {
    std::map<std::vector<double>, std::vector<double>> repeats;
    for (std::size_t i = 0; i < factors.size(); ++i) repeats[factors[i]].push_back(response[i]);
    LackOfFit test;
    for (const auto& [at, own] : repeats) {
        test.pure_error_sum += sum_of_squares(own);
        test.pure_error_freedom += static_cast<int>(own.size()) - 1;
    }
    test.freedom = freedom - test.pure_error_freedom;
    if (test.pure_error_freedom < 1 || test.freedom < 1 || !(test.pure_error_sum > 0)) return std::nullopt;
    test.sum = residual_sum() - test.pure_error_sum;
    test.f = test.sum / test.freedom / (test.pure_error_sum / test.pure_error_freedom);
    test.p = f_tail(test.f, test.freedom, test.pure_error_freedom);
    return test;
}

Eigen::MatrixXd square_root(const Eigen::MatrixXd& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    const Eigen::VectorXd roots = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
    return solver.eigenvectors() * roots.asDiagonal() * solver.eigenvectors().transpose();
}

LinearModel eliminate_backward(LinearModel model, double alpha) {
    while (true) {
        std::vector<SurfaceTerm> terms = model.terms;
        auto weakest = terms.end();
        double largest = alpha;
        for (auto term = terms.begin(); term != terms.end(); ++term) {
            const bool is_needed = term->degree() == 0 || std::ranges::any_of(terms, [&](const SurfaceTerm& other) {
                                       return term->is_parent_of(other);
                                   });
            const std::optional<double> p = model.p_value(static_cast<std::size_t>(term - terms.begin()));
            if (is_needed || !p || !(*p > largest)) continue;
            largest = *p;
            weakest = term;
        }
        if (weakest == terms.end()) return model;
        terms.erase(weakest);
        model = LinearModel::fit(std::move(terms), model.factors, model.response).value();
    }
}

LinearModel extend_forward(LinearModel model, const std::vector<SurfaceTerm>& candidates) {
    while (model.freedom > static_cast<int>(model.response.size() / 2)) {
        const SurfaceTerm* best = nullptr;
        double least = model.press();
        for (const SurfaceTerm& term : candidates) {
            const double press = model.press_with(term);
            if (!(press < least)) continue;
            least = press;
            best = &term;
        }
        if (best == nullptr) break;
        std::vector<SurfaceTerm> terms = model.terms;
        terms.push_back(*best);
        auto extended = LinearModel::fit(std::move(terms), model.factors, model.response);
        if (!extended) break;
        model = *std::move(extended);
    }
    return model;
}

double f_tail(double f, int numerator_freedom, int denominator_freedom) {
    return gsl_cdf_fdist_Q(f, numerator_freedom, denominator_freedom);
}

// This is a bisection: GSL's search (gsl_cdf_fdist_Qinv) fails to converge for one in some hundred degrees of freedom.
double f_quantile(double tail, int numerator_freedom, int denominator_freedom) {
    const auto exceeds = [&](double f) { return f_tail(f, numerator_freedom, denominator_freedom) > tail; };
    double high = 1;
    while (exceeds(high)) high *= 2;
    double low = 0;
    for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2) {
        (exceeds(middle) ? low : high) = middle;
    }
    return high;
}

}  // namespace graincrack
