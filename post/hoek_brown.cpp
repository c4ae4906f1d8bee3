#include "post/hoek_brown.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace graincrack {

namespace {

/// Strengths in units of the largest, so that σci and mi are of like size for the solver.
struct Data {
    std::vector<double> confining;
    std::vector<double> strength;
};

/// Residuals and their derivatives by σci and mi. With u = σci² + mi σci σ3 the envelope is σ3 + √u.
double envelope_root(double sigma_ci, double mi, double confining) {
    return std::sqrt(std::max(sigma_ci * (sigma_ci + mi * confining), 1e-12));
}

int residuals(const gsl_vector* x, void* pointer, gsl_vector* f) {
    const Data& data = *static_cast<const Data*>(pointer);
    for (std::size_t i = 0; i < data.confining.size(); ++i) {
        const double root = envelope_root(gsl_vector_get(x, 0), gsl_vector_get(x, 1), data.confining[i]);
        gsl_vector_set(f, i, data.confining[i] + root - data.strength[i]);
    }
    return GSL_SUCCESS;
}

int derivatives(const gsl_vector* x, void* pointer, gsl_matrix* J) {
    const Data& data = *static_cast<const Data*>(pointer);
    const double sigma_ci = gsl_vector_get(x, 0);
    const double mi = gsl_vector_get(x, 1);
    for (std::size_t i = 0; i < data.confining.size(); ++i) {
        const double root = envelope_root(sigma_ci, mi, data.confining[i]);
        gsl_matrix_set(J, i, 0, (2 * sigma_ci + mi * data.confining[i]) / (2 * root));
        gsl_matrix_set(J, i, 1, sigma_ci * data.confining[i] / (2 * root));
    }
    return GSL_SUCCESS;
}

/// (σ1 − σ3)² = σci² + mi σci σ3 is a straight line in σ3: exact for exact data.
std::array<double, 2> first_guess(const Data& data) {
    std::vector<double> squares(data.confining.size());
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = std::pow(data.strength[i] - data.confining[i], 2);
    double intercept = 0;
    double slope = 0;
    std::array<double, 3> covariance{};
    double sum = 0;
    gsl_fit_linear(data.confining.data(), 1, squares.data(), 1, squares.size(), &intercept, &slope, covariance.data(),
                   &covariance[1], &covariance[2], &sum);
    const double smallest = *std::min_element(squares.begin(), squares.end());
    const double sigma_ci = std::sqrt(intercept > 0.01 * smallest ? intercept : 0.1 * smallest);
    return {sigma_ci, slope / sigma_ci};
}

bool two_pressures(std::span<const double> confining) {
    return std::any_of(confining.begin(), confining.end(), [&](double c) { return c != confining[0]; });
}

Estimate scaled(Estimate e, double scale) {
    e.value *= scale;
    for (auto* end : {&e.low, &e.high}) {
        if (*end) **end *= scale;
    }
    return e;
}

}  // namespace

std::optional<HoekBrown> fit_hoek_brown(std::span<const double> confining, std::span<const double> strength) {
    constexpr std::size_t n_parameters = 2;
    const std::size_t n = confining.size();
    if (n < n_parameters || !two_pressures(confining)) return std::nullopt;
    const double scale = *std::max_element(strength.begin(), strength.end());
    if (!(scale > 0)) return std::nullopt;
    Data data;
    for (std::size_t i = 0; i < n; ++i) {
        data.confining.push_back(confining[i] / scale);
        data.strength.push_back(strength[i] / scale);
    }
    gsl_set_error_handler_off();
    std::array<double, 2> start = first_guess(data);
    gsl_multifit_nlinear_fdf problem{};
    problem.f = residuals;
    problem.df = derivatives;
    problem.n = n;
    problem.p = n_parameters;
    problem.params = &data;
    const gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
    const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> work(
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, n, n_parameters), &gsl_multifit_nlinear_free);
    const gsl_vector_view view = gsl_vector_view_array(start.data(), n_parameters);
    gsl_multifit_nlinear_init(&view.vector, &problem, work.get());
    int reason = 0;
    const int status = gsl_multifit_nlinear_driver(500, 1e-12, 1e-12, 0, nullptr, nullptr, &reason, work.get());
    const double sigma_ci = gsl_vector_get(work->x, 0);
    const double mi = gsl_vector_get(work->x, 1);
    // A start that cannot be improved, as for data without scatter, is reported as EMAXITER with the reason ENOPROG.
    const bool settled = status == GSL_SUCCESS || status == GSL_ENOPROG || reason == GSL_ENOPROG;
    if (!settled || !(sigma_ci > 1e-5) || !std::isfinite(mi)) return std::nullopt;

    const int freedom = static_cast<int>(n - n_parameters);
    std::array<double, 4> variances{};
    gsl_matrix_view covariance = gsl_matrix_view_array(variances.data(), n_parameters, n_parameters);
    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work.get()), 0, &covariance.matrix);
    double sum = 0;
    gsl_blas_ddot(work->f, work->f, &sum);
    const double variance = freedom > 0 ? sum / freedom : 0;
    return HoekBrown{scaled(estimate(sigma_ci, variance * variances[0], freedom), scale),
                     estimate(mi, variance * variances[3], freedom)};
}

}  // namespace graincrack
