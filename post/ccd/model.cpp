#include "post/ccd/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "share/base/error.hpp"

namespace graincrack::ccd {

namespace {

Regression fit(const std::vector<Term>& terms, const std::vector<std::vector<double>>& coded,
               const std::vector<double>& response) {
    DesignMatrix design;
    for (const auto& run : coded) {
        std::vector<double> row;
        for (const Term& term : terms) row.push_back(term(run));
        design.push_back(std::move(row));
    }
    const auto regression = regress(design, response);
    if (!regression) {
        throw InputError(
            fmt::format("ccd: {} runs do not determine the {} terms of the model; more runs at other factors are needed",
                        coded.size(), terms.size()));
    }
    return *regression;
}

}  // namespace

double Term::operator()(const std::vector<double>& coded) const {
    double product = 1;
    for (std::size_t k = 0; k < power.size(); ++k) product *= std::pow(coded[k], power[k]);
    return product;
}

int Term::degree() const { return std::accumulate(power.begin(), power.end(), 0); }

std::string Term::name() const {
    std::string label;
    for (std::size_t k = 0; k < power.size(); ++k) {
        if (power[k] == 0) continue;
        label += fmt::format("{}x{}{}", label.empty() ? "" : " ", k + 1, power[k] == 1 ? "" : fmt::format("^{}", power[k]));
    }
    return label.empty() ? "1" : label;
}

bool Term::is_parent_of(const Term& other) const {
    if (*this == other) return false;
    for (std::size_t k = 0; k < power.size(); ++k) {
        if (power[k] > other.power[k]) return false;
    }
    return true;
}

std::vector<Term> quadratic_terms(std::size_t n_factors) {
    const Term constant{std::vector<int>(n_factors, 0)};
    std::vector<Term> terms{constant};
    const auto add = [&](std::size_t i, std::optional<std::size_t> j) {
        Term term = constant;
        ++term.power[i];
        if (j) ++term.power[*j];
        terms.push_back(std::move(term));
    };
    for (std::size_t i = 0; i < n_factors; ++i) add(i, std::nullopt);
    for (std::size_t i = 0; i < n_factors; ++i) {
        for (std::size_t j = i + 1; j < n_factors; ++j) add(i, j);
    }
    for (std::size_t i = 0; i < n_factors; ++i) add(i, i);
    return terms;
}

Model::Model(std::vector<Term> terms, std::vector<std::vector<double>> coded, std::vector<double> response)
    : terms_(std::move(terms)),
      coded_(std::move(coded)),
      response_(std::move(response)),
      regression_(fit(terms_, coded_, response_)) {}

std::vector<double> Model::row(const std::vector<double>& coded) const {
    std::vector<double> values;
    for (const Term& term : terms_) values.push_back(term(coded));
    return values;
}

double Model::predict(const std::vector<double>& coded) const { return regression_.predict(row(coded)); }
double Model::leverage(const std::vector<double>& coded) const { return regression_.leverage(row(coded)); }

Estimate Model::with_interval(const std::vector<double>& coded, double own_variance) const {
    return estimate(predict(coded), regression_.variance() * (own_variance + leverage(coded)), regression_.freedom);
}
Estimate Model::confidence(const std::vector<double>& coded) const { return with_interval(coded, 0); }
Estimate Model::prediction(const std::vector<double>& coded) const { return with_interval(coded, 1); }

std::optional<double> Model::p_value(std::size_t term) const {
    if (regression_.freedom < 1) return std::nullopt;
    return t_tail(regression_.coefficients[term] / regression_.standard_error(term), regression_.freedom);
}

std::optional<Model::Test> Model::significance() const {
    const int terms = static_cast<int>(terms_.size()) - 1;
    if (regression_.freedom < 1 || terms < 1) return std::nullopt;
    const double f = (regression_.total_sum - regression_.residual_sum) / terms / regression_.variance();
    return Test{f, f_tail(f, terms, regression_.freedom)};
}

std::optional<LackOfFit> Model::lack_of_fit() const {
    return graincrack::lack_of_fit(coded_, response_, regression_.residual_sum, regression_.freedom);
}

Model eliminate_backward(Model model, double alpha) {
    while (true) {
        const std::vector<Term>& terms = model.terms();
        std::optional<std::size_t> weakest;
        double largest = alpha;
        for (std::size_t i = 0; i < terms.size(); ++i) {
            const bool needed = terms[i].degree() == 0 || std::any_of(terms.begin(), terms.end(), [&](const Term& other) {
                                    return terms[i].is_parent_of(other);
                                });
            const std::optional<double> p = model.p_value(i);
            if (needed || !p || !(*p > largest)) continue;
            largest = *p;
            weakest = i;
        }
        if (!weakest) return model;
        std::vector<Term> left = terms;
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(*weakest));
        model = Model(std::move(left), model.coded(), model.response());
    }
}

}  // namespace graincrack::ccd
