#include "solver/model/damping_load.hpp"

#include <cmath>
#include <cstdint>

#include "solver/model/state.hpp"

namespace graincrack {

void follow_damping_load(const Assemblage& a, const State& s, double platen_power, double time_constant, DampingLoad& load) {
    const double fraction = -std::expm1(-(s.time - load.time) / time_constant);
    load.time = s.time;
    const double power = -sum_over_nodes(a, [&](std::int32_t i) {
        const Vector2 lag = s.displacement[i] - load.mean_displacement[i];
        load.mean_displacement[i] += fraction * lag;
        return dot(s.damping_force[i], lag);
    });
    load.damping_power += fraction * (power / time_constant - load.damping_power);
    load.platen_power += fraction * (platen_power - load.platen_power);
}

}  // namespace graincrack
