// A quadratic response surface: its terms, its fit to runs, its reduction, and what it predicts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/statistics/regression.hpp"
#include "post/statistics/statistics.hpp"

namespace graincrack::ccd {

/// A product of powers of coded factors: power[k] of factor k. The constant has all zero.
struct Term {
    std::vector<int> power;
    [[nodiscard]] double operator()(const std::vector<double>& coded) const;
    [[nodiscard]] int degree() const;
    /// "1", "x1", "x1 x2", "x1^2"
    [[nodiscard]] std::string name() const;
    /// Whether this term divides another: x1 and x2 are parents of x1 x2.
    [[nodiscard]] bool is_parent_of(const Term& other) const;
    bool operator==(const Term&) const = default;
};

/// Constant, linear terms, products of two, squares: in this order, as in Eq 19.
std::vector<Term> quadratic_terms(std::size_t n_factors);

class Model {
public:
    /// \param coded runs × factors \throws InputError if there are too few runs for the terms
    Model(std::vector<Term> terms, std::vector<std::vector<double>> coded, std::vector<double> response);

    [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
    [[nodiscard]] const Regression& regression() const { return regression_; }
    [[nodiscard]] std::size_t n_factors() const { return coded_[0].size(); }
    [[nodiscard]] const std::vector<std::vector<double>>& coded() const { return coded_; }
    [[nodiscard]] const std::vector<double>& response() const { return response_; }

    [[nodiscard]] double predict(const std::vector<double>& coded) const;
    /// The mean with its 95 % confidence interval.
    [[nodiscard]] Estimate confidence(const std::vector<double>& coded) const;
    /// A single new run with its 95 % prediction interval.
    [[nodiscard]] Estimate prediction(const std::vector<double>& coded) const;
    /// Variance of the fitted mean over the residual variance.
    [[nodiscard]] double leverage(const std::vector<double>& coded) const;

    /// Partial F test of a term (1 degree of freedom): p of leaving it out. Empty without degrees of freedom.
    [[nodiscard]] std::optional<double> p_value(std::size_t term) const;
    /// F test of all terms but the constant.
    struct Test {
        double f = 0;
        double p = 0;
    };
    [[nodiscard]] std::optional<Test> significance() const;
    /// Empty without repeated runs or without degrees of freedom beyond them.
    [[nodiscard]] std::optional<LackOfFit> lack_of_fit() const;

private:
    [[nodiscard]] std::vector<double> row(const std::vector<double>& coded) const;
    [[nodiscard]] Estimate with_interval(const std::vector<double>& coded, double own_variance) const;

    std::vector<Term> terms_;
    std::vector<std::vector<double>> coded_;
    std::vector<double> response_;
    Regression regression_;
};

/// Leaves out, one by one, the term with the largest p above alpha; never the constant, nor a term whose product or square
/// is still there (hierarchy).
Model eliminate_backward(Model model, double alpha);

}  // namespace graincrack::ccd
