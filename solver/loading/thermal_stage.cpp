#include "solver/loading/thermal_stage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "share/file/specimen_measures.hpp"

namespace graincrack {
namespace {

constexpr double least_thermal_load = 0.2;  // thermal stress that counts, of the tensile strength

/// Σ |force of the elements on a node| under a uniform stress, N: each node has the mean of two sides of an element. Energies are
/// of a uniaxial stress.
HeatingScales heating_scales(const Specimen& s, const Rock& rock, double difference) {
    const double stress = least_thermal_load * rock.tensile_strength;
    const double strain = stress / rock.young_modulus;
    double sides = 0;
    for (const auto& nodes : s.element_nodes) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& from = s.node_position[static_cast<std::size_t>(nodes[i])];
            const auto& to = s.node_position[static_cast<std::size_t>(nodes[(i + 1) % 3])];
            sides += std::hypot(to[0] - from[0], to[1] - from[1]);
        }
    }
    const double area = std::accumulate(s.grain_area.begin(), s.grain_area.end(), 0.0);
    return {bar_transit_time(s, rock), difference > 0 ? strain / difference : 1, stress * sides / 2, stress * strain / 2 * area};
}

}  // namespace

ThermalStage::ThermalStage(const Program& program, const Specimen& specimen, const Rock& rock, double difference)
    : is_thermal_(program.has_temperature()),
      scales_(heating_scales(specimen, rock, difference)),
      control_(default_rate_tolerance, scales_) {}

void ThermalStage::begin(const Stage& stage, const Amplitude* amplitude, const Feedback& feedback, const History& history) {
    heats_ = stage.heating.has_value();
    if (heats_) {
        control_ = control_of(*stage.heating);
        from_ = amplitude->function.from;
    }
    if (is_thermal_ && stage.platens && !has_moved_) {
        has_moved_ = true;
        locked_in_ = feedback.stored_energy;
    }
    highest_ = 0;
    await_fall(stage);
    cracks_before_ = is_thermal_ ? cracks_in(history) : 0;
}

bool ThermalStage::heat(const Feedback& feedback, double duration, Amplitude& temperature) {
    const double present = temperature.at(feedback.time);
    const double left = std::abs(temperature.function.value - present);
    heats_ = left > 0;
    if (!heats_) return false;
    temperature = {starting_from(temperature.function, present), feedback.time, false};
    temperature.function.rate = control_.next(feedback, std::abs(present - from_), left, duration);
    return true;
}

Feedback ThermalStage::of_load(Feedback feedback, const PlatenControl& platens) {
    feedback.stored_energy -= locked_in_;
    const double load_stress = platens.load_stress();
    if (!is_thermal_ || load_stress <= 0) return feedback;
    const double stress = std::abs(feedback.axial_compression);
    highest_ = std::max(highest_, stress);
    if (highest_ >= load_stress && stress < fallen_ * highest_) {  // a peak is behind: as fast as damage may spread
        return {feedback.time, feedback.axial_strain, feedback.axial_compression, 0, 0, 0, 0, 0, 1};
    }
    const double share = std::min(1.0, stress / platens.settling_stress());
    feedback.force_difference *= share;  // all three are over a load that is none yet
    feedback.damping_load *= share;
    feedback.unbalanced_ratio *= share;
    return feedback;
}

}  // namespace graincrack
