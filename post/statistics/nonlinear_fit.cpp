#include "post/statistics/nonlinear_fit.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>

namespace graincrack {

namespace {

using NonlinearWorkspace = std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)>;

int call_residuals(const gsl_vector* x, void* pointer, gsl_vector* f) {
    const auto& residuals = *static_cast<const Residuals*>(pointer);
    // GSL also passes columns of matrices, whose elements are a stride apart.
    std::vector<double> parameters(x->size);
    std::vector<double> values(f->size);
    for (std::size_t i = 0; i < x->size; ++i) parameters[i] = gsl_vector_get(x, i);
    residuals(parameters, values);
    for (std::size_t i = 0; i < f->size; ++i) gsl_vector_set(f, i, values[i]);
    return GSL_SUCCESS;
}

/// True for convergence. For a start that cannot be improved (no scatter) GSL reports EMAXITER with the reason ENOPROG.
bool settles(gsl_multifit_nlinear_workspace* work) {
    int reason = 0;
    const int status = gsl_multifit_nlinear_driver(500, 1e-12, 1e-12, 0, nullptr, nullptr, &reason, work);
    return status == GSL_SUCCESS || status == GSL_ENOPROG || reason == GSL_ENOPROG;
}

}  // namespace

Estimate NonlinearFit::estimate(std::size_t parameter) const {
    const double variance = freedom > 0 ? residual_sum / freedom * inverse[parameter][parameter] : 0;
    return graincrack::estimate(parameters[parameter], variance, freedom);
}

std::optional<NonlinearFit> fit_nonlinear(const Residuals& residuals, std::vector<double> start, std::size_t n_residuals) {
    const std::size_t p = start.size();
    gsl_multifit_nlinear_fdf problem{};
    problem.f = call_residuals;
    problem.n = n_residuals;
    problem.p = p;
    problem.params = const_cast<Residuals*>(&residuals);  // NOLINT: GSL's pointer is not const
    gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
    options.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
    const NonlinearWorkspace work(gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, n_residuals, p),
                                  &gsl_multifit_nlinear_free);
    const gsl_vector_view view = gsl_vector_view_array(start.data(), p);
    gsl_multifit_nlinear_init(&view.vector, &problem, work.get());
    if (!settles(work.get())) return std::nullopt;
    NonlinearFit fit;
    fit.parameters.assign(work->x->data, work->x->data + p);
    if (!std::ranges::all_of(fit.parameters, [](double v) { return std::isfinite(v); })) return std::nullopt;
    std::vector<double> covariance(p * p);
    gsl_matrix_view matrix = gsl_matrix_view_array(covariance.data(), p, p);
    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work.get()), 0, &matrix.matrix);
    for (std::size_t i = 0; i < p; ++i) {
        fit.inverse.emplace_back(covariance.begin() + static_cast<std::ptrdiff_t>(i * p),
                                 covariance.begin() + static_cast<std::ptrdiff_t>((i + 1) * p));
    }
    gsl_blas_ddot(work->f, work->f, &fit.residual_sum);
    fit.freedom = static_cast<int>(n_residuals) - static_cast<int>(p);
    return fit;
}

Logistic fit_logistic(const Eigen::MatrixXd& factors, const Eigen::VectorXd& happened) {
    Eigen::MatrixXd x(factors.rows(), factors.cols() + 1);
    x << Eigen::VectorXd::Ones(factors.rows()), factors;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(x.cols());
    for (int i = 0; i < 100; ++i) {
        const Eigen::VectorXd p = (1 + (-(x * b).array()).exp()).inverse();
        const Eigen::VectorXd w = (p.array() * (1 - p.array())).max(1e-12);
        const Eigen::MatrixXd information = x.transpose() * w.asDiagonal() * x;
        const Eigen::LDLT<Eigen::MatrixXd> solver(information);
        // leverages h_i of the weighted regression
        const Eigen::VectorXd h = w.array() * (x.array() * solver.solve(x.transpose()).transpose().array()).rowwise().sum();
        Eigen::VectorXd step = solver.solve(x.transpose() * (happened - p + (h.array() * (0.5 - p.array())).matrix()));
        const double longest = step.lpNorm<Eigen::Infinity>();
        if (longest > 2) step *= 2 / longest;
        b += step;
        if (longest < 1e-10) break;
    }
    return {b};
}

}  // namespace graincrack
