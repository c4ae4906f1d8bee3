#include "post/statistics/logistic.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace graincrack {

Logistic fit_logistic(const Eigen::MatrixXd& factors, const Eigen::VectorXd& happened) {
    Eigen::MatrixXd x(factors.rows(), factors.cols() + 1);
    x << Eigen::VectorXd::Ones(factors.rows()), factors;
    Eigen::VectorXd b = Eigen::VectorXd::Zero(x.cols());
    for (int i = 0; i < 100; ++i) {
        const Eigen::VectorXd p = (1 + (-(x * b).array()).exp()).inverse();
        const Eigen::VectorXd w = (p.array() * (1 - p.array())).max(1e-12);
        const Eigen::MatrixXd information = x.transpose() * w.asDiagonal() * x;
        const Eigen::LDLT<Eigen::MatrixXd> solver(information);
        // h_i, the leverages, of the weighted regression
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
