// Responses over the free parameters: surfaces of their logarithms, linear in all of them, with those quadratic terms by which
// they predict better; the design point where surfaces meet their targets, by weighted least squares inside a box, and how well
// the data determine it.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "post/calibrate/parameter.hpp"
#include "post/statistics/response_surface.hpp"

namespace graincrack::calibrate {

/// Probability of an outcome as a function of several factors: logistic regression, penalised so that outcomes that all are
/// alike, or that a plane separates, have finite coefficients too.
struct Logistic {
    Eigen::VectorXd coefficients;  ///< of 1 and the factors

    /// ln(p/(1 − p)) at some factors.
    [[nodiscard]] double logit(const Eigen::VectorXd& factors) const {
        return coefficients(0) + coefficients.tail(coefficients.size() - 1).dot(factors);
    }
    [[nodiscard]] double probability(const Eigen::VectorXd& factors) const;
};

/// Maximum of the likelihood times Jeffreys' prior (Firth 1993, Biometrika 80, 27–38).
/// \param factors a row a case \param happened 0 or 1 of each case \pre there are cases
Logistic fit_logistic(const Eigen::MatrixXd& factors, const Eigen::VectorXd& happened);

/// A response surface whose factors are the local coordinates of a box.
class LocalSurface {
public:
    /// Least squares: the linear terms, extended forward by quadratic ones. \param values ln of the response at each point; NaN:
    /// it has none there, and is left out \return empty unless there are two values more than linear terms, and these determine
    /// them
    static std::optional<LocalSurface> fit(const Box& box, const std::vector<DesignPoint>& points,
                                           const std::vector<double>& values);

    [[nodiscard]] double value(const DesignPoint& point) const { return surface_.value(local(point)); }
    /// Variance of `value`, by the scatter about the surface.
    [[nodiscard]] double variance(const DesignPoint& point) const {
        return surface_.variance() * surface_.leverage(local(point));
    }
    /// Derivatives by the coordinates of a point, and their covariance.
    [[nodiscard]] DesignPoint gradient(const DesignPoint& point) const {
        return slopes(point).transpose() * surface_.coefficients;
    }
    [[nodiscard]] Eigen::MatrixXd gradient_covariance(const DesignPoint& point) const {
        const Eigen::MatrixXd at = slopes(point);
        return surface_.variance() * at.transpose() * surface_.inverse * at;
    }

    [[nodiscard]] double scatter() const { return std::sqrt(surface_.variance()); }  ///< standard deviation about the surface
    [[nodiscard]] double prediction_error() const { return std::sqrt(surface_.press() / n_values()); }  ///< √(PRESS/n)
    [[nodiscard]] int n_values() const { return static_cast<int>(surface_.response.size()); }
    [[nodiscard]] int freedom() const { return surface_.freedom(); }
    [[nodiscard]] int n_quadratic() const { return static_cast<int>(surface_.terms.size()) - 1 - static_cast<int>(box_.size()); }

private:
    LocalSurface(Box box, ResponseSurface surface) : box_(std::move(box)), surface_(std::move(surface)) {}
    [[nodiscard]] std::vector<double> local(const DesignPoint& point) const;
    /// Derivative of each term, a row a term.
    [[nodiscard]] Eigen::MatrixXd slopes(const DesignPoint& point) const {
        return surface_.slopes(local(point)).array().rowwise() / box_.half.transpose().array();
    }

    Box box_;
    ResponseSurface surface_;
};

/// A response with its target, whose difference over the deviation is a residual.
struct Residual {
    const LocalSurface* surface;
    double value = 0;      ///< ln of the target
    double deviation = 0;  ///< standard deviation of the measured value, of its ln
};

/// A probability, by a logistic function of design points, with its lower bound.
struct ProbabilityConstraint {
    const Logistic* probability;
    double least = 0;
};

struct Optimum {
    DesignPoint point;
    /// Covariance of the point, by the scatter of surfaces and measured values; 0 along directions that are unidentified or were
    /// moved.
    Eigen::MatrixXd covariance;
    /// Directions (of length 1) along which the data determine the point no better than by half the width of the first box, one
    /// standard deviation: along these it stays at the first guess.
    std::vector<DesignPoint> unidentified;
    /// Directions (of length 1) along which no target changes, that were moved as far as the targets need.
    std::vector<DesignPoint> moved;
    std::vector<double> deviations;  ///< off the targets over their standard deviations, of each residual
    double condition = 1;            ///< number of the matrix of sensitivities
    int freedom = 0;                 ///< the least of the surfaces

    /// Half of the 95 % interval of a coordinate.
    [[nodiscard]] double half_interval(Eigen::Index coordinate) const;
    /// Fraction of a coordinate that lies in unidentified directions, 0 to 1.
    [[nodiscard]] double unidentified_fraction(Eigen::Index coordinate) const;
    /// Fraction of a coordinate that lies in directions unidentified or moved, 0 to 1.
    [[nodiscard]] double undetermined_fraction(Eigen::Index coordinate) const;
};

/// \param first guess, inside the box or not \pre there is a residual
Optimum find_optimum(const Box& box, const DesignPoint& first, const std::vector<Residual>& residuals,
                     const std::vector<ProbabilityConstraint>& constraints = {});

}  // namespace graincrack::calibrate
