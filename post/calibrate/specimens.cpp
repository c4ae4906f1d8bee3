#include "post/calibrate/specimens.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace graincrack::calibrate {

double Specimens::mean_edge() const { return edge ? *edge : std::sqrt(4 * width * height / (std::numbers::sqrt3 * grains)); }

std::string label_of(const Specimens& specimens, const WantedRun& run) {
    const bool disc = run.test == "brazilian";
    const std::string size = specimens.edge ? fmt::format("e{:g}", *specimens.edge * 1e3)
                                            : fmt::format("g{:g}", disc ? specimens.disc_grains : specimens.grains);
    if (disc) return fmt::format("disc{:g}{}", specimens.diameter * 1e3, size);
    std::string text = fmt::format("rectangle{:g}x{:g}{}", specimens.width * 1e3, specimens.height * 1e3, size);
    if (run.notched) text += fmt::format("n{:g}", specimens.notch_over_width * specimens.width * 1e3);
    return text;
}

}  // namespace graincrack::calibrate
