#include "post/calibrate/identify.hpp"

#include <fmt/format.h>

#include <cmath>

namespace graincrack::calibrate {

std::vector<Sensitivity> sensitivities(const std::vector<Parameter>& parameters, const Fit& fit) {
    std::vector<Sensitivity> all;
    const Place& place = fit.optimum.place;
    for (const Response& response : fit.responses) {
        if (!response.surface) continue;
        const Place gradient = response.surface->gradient(place);
        const Eigen::MatrixXd covariance = response.surface->gradient_covariance(place);
        for (Eigen::Index k = 0; k < place.size(); ++k) {
            const Parameter& p = parameters[static_cast<std::size_t>(k)];
            const double by_log = p.coordinate_by_log(p.value(place(k)));
            all.push_back({response.target.symbol(), p.key,
                           estimate(gradient(k) * by_log, covariance(k, k) * by_log * by_log, response.surface->freedom())});
        }
    }
    return all;
}

std::string identify_table(const std::vector<Sensitivity>& sensitivities) {
    std::string text = "response\tparameter\texponent\texponent_low\texponent_high\n";
    for (const Sensitivity& s : sensitivities) {
        text += fmt::format("{}\t{}\t{:.4g}\t{:.4g}\t{:.4g}\n", s.response, s.parameter, s.exponent.value, *s.exponent.low,
                            *s.exponent.high);
    }
    return text;
}

}  // namespace graincrack::calibrate
