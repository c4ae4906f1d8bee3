#include "post/statistics/regression.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multifit.h>

#include <cmath>
#include <map>
#include <memory>
#include <numeric>

namespace graincrack {

namespace {

template <class T, void (*release)(T*)>
struct Release {
    void operator()(T* p) const { release(p); }
};
using Matrix = std::unique_ptr<gsl_matrix, Release<gsl_matrix, gsl_matrix_free>>;
using Vector = std::unique_ptr<gsl_vector, Release<gsl_vector, gsl_vector_free>>;
using LinearWorkspace =
    std::unique_ptr<gsl_multifit_linear_workspace, Release<gsl_multifit_linear_workspace, gsl_multifit_linear_free>>;

}  // namespace

std::optional<double> Regression::adjusted_r_squared() const {
    if (freedom < 1 || !(total_sum > 0)) return std::nullopt;
    const double runs = freedom + static_cast<double>(coefficients.size());
    return 1 - variance() / (total_sum / (runs - 1));
}

double Regression::standard_error(std::size_t term) const { return std::sqrt(variance() * inverse[term][term]); }

double Regression::predict(const std::vector<double>& terms) const {
    return std::inner_product(terms.begin(), terms.end(), coefficients.begin(), 0.0);
}

double Regression::leverage(const std::vector<double>& terms) const {
    double sum = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        for (std::size_t j = 0; j < terms.size(); ++j) sum += terms[i] * inverse[i][j] * terms[j];
    }
    return sum;
}

std::optional<Regression> regress(const DesignMatrix& design, const std::vector<double>& y) {
    const std::size_t n = design.size();
    const std::size_t p = n == 0 ? 0 : design[0].size();
    if (p == 0 || n < p) return std::nullopt;
    const Matrix X(gsl_matrix_alloc(n, p));
    const Matrix covariance(gsl_matrix_alloc(p, p));
    const Vector weights(gsl_vector_alloc(n));
    const Vector values(gsl_vector_alloc(n));
    const Vector solution(gsl_vector_alloc(p));
    for (std::size_t i = 0; i < n; ++i) {
        gsl_vector_set(values.get(), i, y[i]);
        gsl_vector_set(weights.get(), i, 1);
        for (std::size_t j = 0; j < p; ++j) gsl_matrix_set(X.get(), i, j, design[i][j]);
    }
    const LinearWorkspace work(gsl_multifit_linear_alloc(n, p));
    std::size_t rank = 0;
    Regression fit;
    // With unit weights GSL's covariance is (XᵀX)⁻¹.
    const int status = gsl_multifit_wlinear_tsvd(X.get(), weights.get(), values.get(), 1e-10, solution.get(), covariance.get(),
                                                 &fit.residual_sum, &rank, work.get());
    if (status != 0 || rank < p) return std::nullopt;
    fit.freedom = static_cast<int>(n) - static_cast<int>(p);
    fit.coefficients.assign(solution->data, solution->data + p);
    fit.inverse.resize(p, std::vector<double>(p));
    for (std::size_t i = 0; i < p; ++i) {
        for (std::size_t j = 0; j < p; ++j) fit.inverse[i][j] = gsl_matrix_get(covariance.get(), i, j);
    }
    const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
        fit.total_sum += (y[i] - mean) * (y[i] - mean);
        const double residual = y[i] - fit.predict(design[i]);
        const double left_out = residual / (1 - fit.leverage(design[i]));
        fit.press += left_out * left_out;
    }
    return fit;
}

std::optional<LackOfFit> lack_of_fit(const std::vector<std::vector<double>>& places, const std::vector<double>& values,
                                     double residual_sum, int freedom) {
    std::map<std::vector<double>, std::vector<double>> repeats;
    for (std::size_t i = 0; i < places.size(); ++i) repeats[places[i]].push_back(values[i]);
    LackOfFit test;
    for (const auto& [place, own] : repeats) {
        const double mean = std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(own.size());
        for (const double value : own) test.pure_error_sum += (value - mean) * (value - mean);
        test.pure_error_freedom += static_cast<int>(own.size()) - 1;
    }
    test.freedom = freedom - test.pure_error_freedom;
    if (test.pure_error_freedom < 1 || test.freedom < 1 || !(test.pure_error_sum > 0)) return std::nullopt;
    test.sum = residual_sum - test.pure_error_sum;
    test.f = test.sum / test.freedom / (test.pure_error_sum / test.pure_error_freedom);
    test.p = f_tail(test.f, test.freedom, test.pure_error_freedom);
    return test;
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
