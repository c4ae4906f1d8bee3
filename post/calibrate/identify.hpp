// Which parameter moves which response: exponents d ln response / d ln parameter of the surfaces.
#pragma once

#include <string>
#include <vector>

#include "post/calibrate/decide.hpp"

namespace graincrack::calibrate {

struct Sensitivity {
    std::string response;   ///< "first peak at 8 MPa"
    std::string parameter;  ///< "contact.cohesion"
    Estimate exponent;      ///< at the optimum, with its 95 % interval
    [[nodiscard]] bool is_told() const { return *exponent.low > 0 || *exponent.high < 0; }
};

/// Of all pairs that have a surface, response by response.
std::vector<Sensitivity> sensitivities(const std::vector<Parameter>& parameters, const Fit& fit);

/// The table identify.tsv: response, parameter, exponent, exponent_low, exponent_high.
std::string identify_table(const std::vector<Sensitivity>& sensitivities);

}  // namespace graincrack::calibrate
