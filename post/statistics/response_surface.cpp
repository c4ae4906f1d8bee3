#include "post/statistics/response_surface.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace graincrack {

namespace {

constexpr double dependent = 1e-10;  // of the largest pivot: a term that depends on the others

double power_of(double value, int power) {
    double product = 1;
    for (int i = 0; i < power; ++i) product *= value;
    return product;
}

/// Residuals that runs have when each is predicted without itself.
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

std::optional<ResponseSurface> ResponseSurface::fit(std::vector<SurfaceTerm> terms, std::vector<std::vector<double>> factors,
                                                    std::vector<double> response) {
    ResponseSurface surface{std::move(terms), std::move(factors), std::move(response), {}, {}, {}, {}, {}};
    const auto n = static_cast<Eigen::Index>(surface.response.size());
    const auto p = static_cast<Eigen::Index>(surface.terms.size());
    Eigen::MatrixXd& x = surface.design;
    x.resize(n, p);
    for (Eigen::Index i = 0; i < p; ++i) x.col(i) = column(surface.terms[static_cast<std::size_t>(i)], surface.factors);
    if (p == 0 || n < p) return std::nullopt;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(x);
    qr.setThreshold(dependent);
    if (qr.rank() < p) return std::nullopt;
    const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(surface.response.data(), n);
    surface.inverse = (x.transpose() * x).ldlt().solve(Eigen::MatrixXd::Identity(p, p));
    surface.coefficients = surface.inverse * (x.transpose() * y);
    surface.residuals = y - x * surface.coefficients;
    surface.leverages = (x * surface.inverse).cwiseProduct(x).rowwise().sum();
    return surface;
}

double ResponseSurface::total_sum() const {
    const double mean = std::accumulate(response.begin(), response.end(), 0.0) / static_cast<double>(response.size());
    double sum = 0;
    for (const double y : response) sum += (y - mean) * (y - mean);
    return sum;
}

double ResponseSurface::press() const { return sum_of_deleted(residuals, leverages); }

double ResponseSurface::press_with(const SurfaceTerm& term) const {
    const Eigen::VectorXd whole = column(term, factors);
    Eigen::VectorXd own = whole;  // less what the other terms have of it
    for (int twice = 0; twice < 2; ++twice) own -= design * (inverse * (design.transpose() * own));
    const double length = own.norm();
    if (!(length > 1e-8 * whole.norm())) return std::numeric_limits<double>::infinity();
    own /= length;
    return sum_of_deleted(residuals - own * own.dot(residuals), leverages + own.cwiseAbs2());
}

double ResponseSurface::standard_error(std::size_t term) const {
    const auto i = static_cast<Eigen::Index>(term);
    return std::sqrt(variance() * inverse(i, i));
}

double ResponseSurface::r_squared() const { return total_sum() > 0 ? 1 - residual_sum() / total_sum() : 1; }

std::optional<double> ResponseSurface::adjusted_r_squared() const {
    if (freedom() < 1 || !(total_sum() > 0)) return std::nullopt;
    return 1 - variance() / (total_sum() / static_cast<double>(response.size() - 1));
}

double ResponseSurface::predicted_r_squared() const { return total_sum() > 0 ? 1 - press() / total_sum() : 1; }

Eigen::VectorXd ResponseSurface::row(const std::vector<double>& at) const {
    Eigen::VectorXd values(coefficients.size());
    std::transform(terms.begin(), terms.end(), values.begin(), [&](const SurfaceTerm& term) { return term(at); });
    return values;
}

double ResponseSurface::leverage(const std::vector<double>& at) const {
    const Eigen::VectorXd x = row(at);
    return x.dot(inverse * x);
}

Estimate ResponseSurface::with_interval(const std::vector<double>& at, double own_variance) const {
    return estimate(value(at), variance() * (own_variance + leverage(at)), freedom());
}

Eigen::MatrixXd ResponseSurface::slopes(const std::vector<double>& at) const {
    Eigen::MatrixXd slopes(coefficients.size(), static_cast<Eigen::Index>(at.size()));
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
        for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
            slopes(i, k) = terms[static_cast<std::size_t>(i)].slope(at, static_cast<std::size_t>(k));
        }
    }
    return slopes;
}

std::optional<double> ResponseSurface::p_value(std::size_t term) const {
    if (freedom() < 1) return std::nullopt;
    return t_tail(coefficients(static_cast<Eigen::Index>(term)) / standard_error(term), freedom());
}

std::optional<FTest> ResponseSurface::significance() const {
    const int tested = static_cast<int>(terms.size()) - 1;
    if (freedom() < 1 || tested < 1) return std::nullopt;
    const double f = (total_sum() - residual_sum()) / tested / variance();
    return FTest{f, f_tail(f, tested, freedom())};
}

std::optional<LackOfFit> ResponseSurface::lack_of_fit() const {
    std::map<std::vector<double>, std::vector<double>> repeats;
    for (std::size_t i = 0; i < factors.size(); ++i) repeats[factors[i]].push_back(response[i]);
    LackOfFit test;
    for (const auto& [at, own] : repeats) {
        const double mean = std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(own.size());
        for (const double value : own) test.pure_error_sum += (value - mean) * (value - mean);
        test.pure_error_freedom += static_cast<int>(own.size()) - 1;
    }
    test.freedom = freedom() - test.pure_error_freedom;
    if (test.pure_error_freedom < 1 || test.freedom < 1 || !(test.pure_error_sum > 0)) return std::nullopt;
    test.sum = residual_sum() - test.pure_error_sum;
    test.f = test.sum / test.freedom / (test.pure_error_sum / test.pure_error_freedom);
    test.p = f_tail(test.f, test.freedom, test.pure_error_freedom);
    return test;
}

ResponseSurface eliminate_backward(ResponseSurface surface, double alpha) {
    while (true) {
        std::vector<SurfaceTerm> terms = surface.terms;
        auto weakest = terms.end();
        double largest = alpha;
        for (auto term = terms.begin(); term != terms.end(); ++term) {
            const bool is_needed = term->degree() == 0 || std::any_of(terms.begin(), terms.end(), [&](const SurfaceTerm& other) {
                                       return term->is_parent_of(other);
                                   });
            const std::optional<double> p = surface.p_value(static_cast<std::size_t>(term - terms.begin()));
            if (is_needed || !p || !(*p > largest)) continue;
            largest = *p;
            weakest = term;
        }
        if (weakest == terms.end()) return surface;
        terms.erase(weakest);
        surface = ResponseSurface::fit(std::move(terms), surface.factors, surface.response).value();
    }
}

ResponseSurface extend_forward(ResponseSurface surface, const std::vector<SurfaceTerm>& candidates) {
    while (surface.freedom() > static_cast<int>(surface.response.size() / 2)) {
        const SurfaceTerm* best = nullptr;
        double least = surface.press();
        for (const SurfaceTerm& term : candidates) {
            const double press = surface.press_with(term);
            if (!(press < least)) continue;
            least = press;
            best = &term;
        }
        if (best == nullptr) break;
        std::vector<SurfaceTerm> terms = surface.terms;
        terms.push_back(*best);
        auto extended = ResponseSurface::fit(std::move(terms), surface.factors, surface.response);
        if (!extended) break;
        surface = *std::move(extended);
    }
    return surface;
}

double f_tail(double f, int numerator_freedom, int denominator_freedom) {
    return gsl_cdf_fdist_Q(f, numerator_freedom, denominator_freedom);
}

// By bisection: GSL's own search (gsl_cdf_fdist_Qinv) does not converge for one in some hundred degrees of freedom.
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

double t_tail(double t, int freedom) { return 2 * gsl_cdf_tdist_Q(std::abs(t), freedom); }

}  // namespace graincrack
