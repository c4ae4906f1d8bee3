#include "post/ccd/design.hpp"

#include <fmt/format.h>

#include <cmath>

#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"
#include "share/base/error.hpp"
#include "share/base/text.hpp"

namespace graincrack::ccd {

Assignment parse_assignment(const std::string& text, const std::string& option, const std::string& form) {
    const auto [name, numbers] = key_and_value(text, option, form);
    Assignment out{name, {}};
    for (const std::string_view number : split(numbers, ':')) {
        const auto value = parse_number(std::string(number));
        if (!value || !std::isfinite(*value)) throw UsageError(option + " " + text + ": " + form + " is needed");
        out.values.push_back(*value);
    }
    return out;
}

double star_distance(Star star, std::size_t n_factors) {
    return star == Star::face_centred ? 1 : std::pow(2, static_cast<double>(n_factors) / 4);
}

std::vector<std::vector<double>> coded_runs(std::size_t n_factors, Star star, std::size_t n_centre) {
    std::vector<std::vector<double>> runs;
    for (std::size_t corner = 0; corner < (std::size_t{1} << n_factors); ++corner) {
        std::vector<double> run(n_factors);
        for (std::size_t k = 0; k < n_factors; ++k) run[k] = (corner >> k) % 2 == 0 ? -1 : 1;
        runs.push_back(run);
    }
    const double alpha = star_distance(star, n_factors);
    for (std::size_t k = 0; k < n_factors; ++k) {
        for (const double sign : {-1.0, 1.0}) {
            std::vector<double> run(n_factors, 0.0);
            run[k] = sign * alpha;
            runs.push_back(run);
        }
    }
    runs.insert(runs.end(), n_centre, std::vector<double>(n_factors, 0.0));
    return runs;
}

namespace {

/// The first other column that is linear in a coded one, up to the rounding of printed digits.
Factor quantity_of(const TableFile& table, const std::string& coded_name, const std::vector<double>& coded) {
    for (const std::string& column : table.columns()) {
        if (column == coded_name || column == "run") continue;
        std::vector<double> values;
        try {
            values = table.numbers(column);
        } catch (const InputError&) {
            continue;  // a column of text
        }
        const std::optional<Line> line = fit_line(coded, values);
        constexpr double rounding = 1e-6;
        if (line && line->slope != 0 && line->r_squared > 1 - rounding) {
            return {column, line->intercept - line->slope, line->intercept + line->slope};
        }
    }
    return {coded_name, -1, 1};
}

}  // namespace

Runs read_runs(const TableFile& table, const std::vector<Factor>& given) {
    Runs runs;
    runs.coded.resize(table.n_rows());
    const auto add = [&runs](const std::vector<double>& column) {
        for (std::size_t i = 0; i < column.size(); ++i) runs.coded[i].push_back(column[i]);
    };
    std::size_t n_factors = 0;
    for (std::string name = "x1"; table.has(name); name = fmt::format("x{}", n_factors + 1)) {
        const std::vector<double> column = table.numbers(name);
        add(column);
        ++n_factors;
        if (given.empty()) runs.factors.push_back(quantity_of(table, name, column));
    }
    for (const Factor& factor : n_factors == 0 ? given : std::vector<Factor>()) {
        std::vector<double> column = table.numbers(factor.name);
        for (double& value : column) value = factor.coded(value);
        add(column);
        ++n_factors;
    }
    if (n_factors == 0) {
        throw InputError(table.name() +
                         ": no columns x1, x2, …; a table as ccd design writes it, or --factor NAME=LOW:HIGH for "
                         "its columns, is needed");
    }
    if (given.empty()) return runs;
    if (given.size() != n_factors) {
        throw UsageError(fmt::format("--factor: {} given, {} has {}; give each or none", given.size(), table.name(), n_factors));
    }
    runs.factors = given;
    return runs;
}

Factor parse_factor(const std::string& text) {
    const Assignment given = parse_assignment(text, "--factor", "NAME=LOW:HIGH");
    if (given.values.size() != 2 || !(given.values[0] < given.values[1])) {
        throw UsageError("--factor " + text + ": NAME=LOW:HIGH with LOW below HIGH is needed");
    }
    return {given.name, given.values[0], given.values[1]};
}

LinearModel fit_quadratic(const std::vector<std::vector<double>>& coded, const std::vector<double>& response) {
    const std::vector<SurfaceTerm> terms = quadratic_terms(coded.empty() ? 0 : coded[0].size());
    auto surface = LinearModel::fit(terms, coded, response);
    if (surface) return *std::move(surface);
    throw InputError(fmt::format("ccd: {} runs do not determine the {} terms of the model; more runs at other factors are needed",
                                 coded.size(), terms.size()));
}

LinearModel fit_response(const TableFile& table, const Runs& runs, const std::string& response, const ModelChoice& choice) {
    LinearModel full = fit_quadratic(runs.coded, table.numbers(response));
    return choice.reduce ? eliminate_backward(std::move(full), choice.alpha) : full;
}

}  // namespace graincrack::ccd
