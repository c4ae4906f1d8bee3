// The explicit step: contact law, touches → nodal forces (elements, contacts, touches, platens, membrane) → damping →
// integration.
#pragma once

#include <cmath>
#include <cstdint>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"
#include "solver/law/contact_law.hpp"
#include "solver/law/damping.hpp"
#include "solver/model/vertex_clusters.hpp"
#include "solver/model/state.hpp"
#include "solver/step/thread_team.hpp"

namespace graincrack {

/// Constants of a run that the step needs.
struct StepParameters {
    ContactLaw law;
    double time_step = 0;  ///< s
    double damping = 0;    ///< α
    DampingForm damping_form = DampingForm::combined;
    MassScaling mass_scaling = {};
    /// With mass scaling, steps of masses as they are that go into one: grains that touch move freely, with their own mass, and
    /// the long step is not stable for contacts as stiff as bonded ones. From the first touch on each step is made of so many.
    std::int64_t parts = 1;
    [[nodiscard]] Damping damps() const { return make_damping(damping, damping_form); }
};

/// The parameters of the parts of a step, without mass scaling.
inline StepParameters parameters_of_parts(const StepParameters& p) {
    return {p.law, p.time_step / static_cast<double>(p.parts), p.damping, p.damping_form, {}, 1};
}

/// Advances the contacts of a block to the present displacements: histories, slots, energies, events.
void advance_contacts(const Assemblage& assemblage, const ContactLaw& law, std::int32_t block, std::int64_t step, State& state);

/// Sums the forces on the nodes of a block into `state.force`: contact slots, elements, touches, platens, membrane, drives,
/// in this order.
/// With `commit` the platen points remember their friction and the sums take it in; without it nothing but `force` changes.
void sum_nodal_forces(const Assemblage& assemblage, const Boundary& boundary, const StepLoading& loading, std::int32_t block,
                      bool commit, State& state);

/// Damps and integrates the nodes of a block by central differences, v += Δt (F + Fd)/m, u += Δt v, and books the work of
/// damping, platens and membrane, each force over the mean of the displacements before and after it. With mass scaling
/// `integrate_groups` does it, and the membrane's work is booked beside it.
void integrate_nodes(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters, std::int32_t block,
                     State& state);

/// Books the work of the membrane, of gravity and of loaded edges over half a step at the present velocities.
void book_half_work(const Assemblage& assemblage, const Boundary& boundary, std::int32_t block, double time_step, State& state);

/// Advances the state by `n_steps` steps under `loading` with a team of threads. On entry and on return contact forces
/// and histories belong to the present displacements (see `start`). Results do not depend on its size.
void advance(const Assemblage& assemblage, const Boundary& boundary, const StepParameters& parameters,
             const BatchLoading& loading, std::int64_t n_steps, Team& team, State& state);

/// Evaluates contacts and groups of nodes at the start, so that `advance` and `measure` find forces of the present
/// displacements.
void start(const Assemblage& assemblage, const StepParameters& parameters, State& state);

}  // namespace graincrack
