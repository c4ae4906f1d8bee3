// Constants of a run that the step needs.
#pragma once

#include <cstddef>
#include <cstdint>

#include "solver/law/contact_law.hpp"
#include "solver/law/damping.hpp"
#include "solver/model/memory.hpp"
#include "solver/model/vertex_clusters.hpp"

namespace graincrack {

struct StepParameters {
    ContactLaws laws;
    double time_step = 0;  ///< s
    double damping = 0;    ///< α
    DampingForm damping_form = DampingForm::combined;
    MassScaling mass_scaling = {};
    [[nodiscard]] Damping damps() const { return make_damping(damping, damping_form); }
};
/// Bytes of its arrays.
inline std::size_t memory_of(const StepParameters& parameters) {
    const auto& [laws, time_step, damping, damping_form, mass_scaling] = parameters;
    return memory_of_all(laws.of_class, mass_scaling);
}

}  // namespace graincrack
