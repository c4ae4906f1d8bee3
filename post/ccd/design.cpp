#include "post/ccd/design.hpp"

#include <cmath>

namespace graincrack::ccd {

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

}  // namespace graincrack::ccd
