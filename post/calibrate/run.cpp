#include "post/calibrate/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace graincrack::calibrate {

double Specimens::mean_edge() const {
    if (edge) return *edge;
    if (grain_size) return *grain_size * std::sqrt(std::numbers::pi / std::numbers::sqrt3);
    return std::sqrt(4 * width * height / (std::numbers::sqrt3 * grains));
}

double Specimens::half_disc_grains() const {
    const double ratio = half_disc_diameter.value_or(diameter) / diameter;
    return std::max(2.0, std::round(0.5 * ratio * ratio * disc_grains));
}

std::vector<Test> tests_of(const std::vector<Target>& targets) {
    std::vector<Test> tests;
    for (const Target& target : targets) {
        const auto same = std::find_if(tests.begin(), tests.end(), [&](const Test& t) { return t.has(target); });
        if (same == tests.end()) {
            tests.push_back({target.test(), target.confining_pressure, target.kind.peak_drop});
        } else {
            same->peak_drop = std::max(same->peak_drop, target.kind.peak_drop);
        }
    }
    const auto length = [](const Test& t) {
        return t.name == "bend" ? -3 : t.name == "brazilian" ? -2 : t.name == "tension" ? -1 : t.confining_pressure;
    };
    std::stable_sort(tests.begin(), tests.end(), [&](const Test& a, const Test& b) { return length(a) > length(b); });
    return tests;
}

}  // namespace graincrack::calibrate
