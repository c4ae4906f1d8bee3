// Constants of a run that the step needs.
#pragma once

#include "solver/law/contact_law.hpp"
#include "solver/law/damping.hpp"
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
}  // namespace graincrack
