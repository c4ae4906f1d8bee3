#include "post/calibrate/specimens.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace graincrack::calibrate {

double Specimens::mean_edge() const { return edge ? *edge : std::sqrt(4 * width * height / (std::numbers::sqrt3 * grains)); }

std::string specimen_name(const Specimens& specimens, const WantedRun& run) {
    const bool disc = run.test == "brazilian";
    std::string text = disc ? fmt::format("disc{:g}", specimens.diameter * 1e3)
                            : fmt::format("rectangle{:g}x{:g}", specimens.width * 1e3, specimens.height * 1e3);
    text += specimens.edge ? fmt::format("e{:g}", *specimens.edge * 1e3)
                           : fmt::format("g{:g}", disc ? specimens.disc_grains : specimens.grains);
    if (run.notched) text += fmt::format("n{:g}", specimens.notch() * 1e3);
    return fmt::format("{}-s{}", text, run.seed);
}

std::string mesh_options(const Specimens& specimens, const WantedRun& run) {
    const bool disc = run.test == "brazilian";
    std::string text =
        disc ? fmt::format("disc --diameter {:g}mm", specimens.diameter * 1e3)
             : fmt::format("rectangle --width {:g}mm --height {:g}mm", specimens.width * 1e3, specimens.height * 1e3);
    text += specimens.edge ? fmt::format(" --edge {:g}mm", *specimens.edge * 1e3)
                           : fmt::format(" --grains {:g}", disc ? specimens.disc_grains : specimens.grains);
    if (run.notched) text += fmt::format(" --notch {:g}mm", specimens.notch() * 1e3);
    return fmt::format("{} --seed {}", text, run.seed);
}

}  // namespace graincrack::calibrate
