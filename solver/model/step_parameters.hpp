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
    ContactLaw law;
    double time_step = 0;  ///< s
    double damping = 0;    ///< α
    DampingForm damping_form = DampingForm::combined;
    MassScaling mass_scaling = {};
    /// Substeps of which each step is made once mass scaling has ended. It ends with the first node–edge contact: grains in such
    /// a contact move freely, with their own mass, and the long step is not stable for contacts as stiff as bonds.
    std::int64_t substeps = 1;
    [[nodiscard]] Damping damps() const { return make_damping(damping, damping_form); }
};
/// Bytes of its arrays.
inline std::size_t memory_of(const StepParameters& parameters) {
    const auto& [law, time_step, damping, damping_form, mass_scaling, substeps] = parameters;
    return memory_of_all(mass_scaling);
}

/// The parameters of the substeps of a step, which have no mass scaling.
inline StepParameters parameters_of_substeps(const StepParameters& p) {
    return {p.law, p.time_step / static_cast<double>(p.substeps), p.damping, p.damping_form, {}, 1};
}

}  // namespace graincrack
