#include "post/calibrate/design.hpp"

#include <gsl/gsl_qrng.h>

#include <memory>

namespace graincrack::calibrate {

Box box_between(const DesignPoint& low, const DesignPoint& high) { return {0.5 * (low + high), 0.5 * (high - low)}; }

Box hull(const Box& a, const Box& b) {
    return box_between((a.centre - a.half).cwiseMin(b.centre - b.half), (a.centre + a.half).cwiseMax(b.centre + b.half));
}

Box Box::about(const DesignPoint& at, double times, const Box& limits) const {
    const DesignPoint width = (times * half).cwiseMin(limits.half);
    const Box of_centres{limits.centre, limits.half - width};
    return {of_centres.nearest(at), width};
}

std::vector<DesignPoint> sobol_points(const Box& box, std::size_t first, std::size_t n) {
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(box.size())), &gsl_qrng_free);
    std::vector<DesignPoint> points;
    for (std::size_t i = 0; i < first + n; ++i) {
        DesignPoint share(box.size());
        gsl_qrng_get(sequence.get(), share.data());
        if (i >= first) points.emplace_back(box.centre + box.half.cwiseProduct(2 * share - DesignPoint::Ones(box.size())));
    }
    return points;
}

}  // namespace graincrack::calibrate
