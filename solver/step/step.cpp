#include "solver/step/step.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/detection/pair_list.hpp"
#include "solver/step/contact_forces.hpp"
#include "solver/step/load_clock.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"

namespace graincrack {

namespace {

template <class Act>
void for_each_chunk(Range chunks, const Act& act) {
    for (std::int32_t chunk = chunks.begin; chunk < chunks.end; ++chunk) {
        act(chunk);
    }
}

/// Whether the last detection found other active contacts than there were before.
bool have_changed(const ContactPairList& list) {
    for (std::size_t chunk = 0; chunk < list.chunks.size(); ++chunk) {
        if (list.active.changed[chunk] != 0) {
            return true;
        }
    }
    return false;
}

/// The steps of one thread of the team: its share of the chunks of grains, vertex clusters, contacts and candidate pairs, and the
/// stages of a step on them. The team waits wherever a stage reads what other threads have written.
class ThreadSteps {
public:
    ThreadSteps(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, const LoadingClock& clock,
                int thread, ThreadTeam& team, State& s)
        : a_(a),
          boundary_(boundary),
          parameters_(parameters),
          team_(team),
          s_(s),
          clock_(clock),
          is_first_(thread == 0),
          grains_(share_of(a.grain_chunks.size(), thread, team.size())),
          clusters_(share_of(parameters.mass_scaling.chunks.size(), thread, team.size())),
          contacts_(share_of(a.contact_chunks.size(), thread, team.size())),
          pairs_(share_of(s.contact_pairs.chunks.size(), thread, team.size())) {}

    /// A step of nodes that move with their own masses. The work of loads is booked at the old velocity, then at the new one.
    void advance(std::int64_t step, bool detects_contacts) {
        for_each_chunk(grains_, [&](std::int32_t chunk) {
            advance_nodal_forces(a_, boundary_, clock_.now(), chunk, s_);
            book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_);
            integrate_nodes(a_, boundary_, parameters_, chunk, s_);
            book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_);
        });
        team_.wait();
        clock_.tick();
        for_each_chunk(contacts_, [&](std::int32_t chunk) { advance_contacts(a_, parameters_.law, chunk, step, s_); });
        if (detects_contacts) {
            for_each_chunk(pairs_, [&](std::int32_t chunk) { detect_contacts(a_, parameters_, chunk, s_); });
            team_.wait();
            complete_detection();
        } else {
            for_each_chunk(pairs_, [&](std::int32_t chunk) { move_active_contacts(a_, parameters_, chunk, s_); });
            team_.wait();
        }
    }
    /// A step with mass scaling, in which vertex clusters are integrated and there are no node–edge contacts.
    void advance_scaled(std::int64_t step) {
        for_each_chunk(grains_, [&](std::int32_t chunk) {
            advance_nodal_forces(a_, boundary_, clock_.now(), chunk, s_);
            book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_);
        });
        team_.wait();
        for_each_chunk(clusters_, [&](std::int32_t chunk) {
            update_clusters(a_, parameters_, clock_.now(), chunk, s_);
            integrate_clusters(a_, parameters_, clock_.now(), chunk, s_);
        });
        team_.wait();
        for_each_chunk(grains_,
                       [&](std::int32_t chunk) { book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_); });
        clock_.tick();
        for_each_chunk(contacts_, [&](std::int32_t chunk) { advance_contacts(a_, parameters_.law, chunk, step, s_); });
        team_.wait();
    }
    /// After the last step: writes the active contacts into the pair list.
    void store_contacts() {
        for_each_chunk(pairs_, [&](std::int32_t chunk) { store_active(chunk, s_.contact_pairs); });
    }
    [[nodiscard]] const LoadingClock& clock() const { return clock_; }

private:
    void complete_detection() {
        if (have_changed(s_.contact_pairs)) {
            if (is_first_) {
                find_areas_of_new_contacts(a_, s_.contact_pairs);
                index_node_forces(a_, s_.contact_pairs);
            }
            team_.wait();
        }
    }

    const Assemblage& a_;
    const Boundary& boundary_;
    const StepParameters& parameters_;
    ThreadTeam& team_;
    State& s_;
    LoadingClock clock_;
    bool is_first_;
    Range grains_, clusters_, contacts_, pairs_;
};

/// The steps between two updates of the pair list, each of so many substeps, with a team of threads. Steps with detection follow
/// from the number of integrations since the start, so that they are the same however the steps are divided into calls.
void advance_between_updates(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters,
                             std::int64_t n_steps, std::int64_t substeps, ThreadTeam& team, LoadingClock& clock, State& s) {
    const std::int64_t first_step = s.step + 1;
    const bool is_scaled = parameters.mass_scaling.is_on();
    LoadingClock clock_after = clock;  // each thread has a clock of its own; all end alike
    team.run([&](int thread) {
        ThreadSteps steps(a, boundary, parameters, clock, thread, team, s);
        for (std::int64_t k = 0; k < n_steps * substeps; ++k) {
            if (is_scaled) {
                steps.advance_scaled(first_step + k / substeps);
            } else {
                steps.advance(first_step + k / substeps, (s.integrations + k) % s.contact_pairs.detection_interval == 0);
            }
        }
        steps.store_contacts();
        if (thread == 0) {
            clock_after = steps.clock();
        }
    });
    clock = clock_after;
    s.step += n_steps;
    s.integrations += n_steps * substeps;
    s.time = time_of(s, s.step, static_cast<double>(substeps) * parameters.time_step);
}

/// Ends mass scaling. Velocities stay, the added mass and its kinetic energy are removed, and from the next step on every step is
/// made of substeps.
///
/// A load works over half the displacement before it and half the one after it. The next substep books both halves with its own
/// length Δt'; the displacement before it is that of a whole step Δt, so the difference, ½ (Δt − Δt') at the present velocities,
/// is booked here. First, nodal forces are summed in the present displacements: loads and `drop_added_mass` need them.
void end_mass_scaling(const Assemblage& a, const Boundary& boundary, const StepParameters& scaled, const StepParameters& substep,
                      const StepLoading& loading, State& s) {
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(a.grain_chunks.size()); ++chunk) {
        sum_nodal_forces(a, boundary, loading, chunk, s);
        book_half_load_work(a, boundary, chunk, scaled.time_step - substep.time_step, s);
    }
    drop_added_mass(a, scaled, loading, substep.time_step, s);
    s.subcycled = true;
}

}  // namespace

void advance(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, const IntervalLoading& loading,
             std::int64_t n_steps, ThreadTeam& team, State& s) {
    LoadingClock clock(loading, n_steps, parameters.time_step, s);
    const StepParameters of_substep = parameters_of_substeps(parameters);
    if (s.subcycled) {
        clock.subcycle(parameters.substeps);
    }
    const std::int64_t end = s.step + n_steps;
    while (s.step < end) {
        const StepParameters& in_use = s.subcycled ? of_substep : parameters;
        const std::int64_t substeps = s.subcycled ? parameters.substeps : 1;
        if (s.step >= s.contact_pairs.next_update) {
            const PairListUpdate update = update_pair_list(a, in_use, substeps, s);
            if (update.must_end_mass_scaling) {
                end_mass_scaling(a, boundary, parameters, of_substep, clock.now(), s);
                clock.subcycle(parameters.substeps);
                continue;  // the list is updated again, now for substeps and with node–edge contacts
            }
            s.contact_pairs.next_update = s.step + std::max<std::int64_t>(1, update.integrations_to_next / substeps);
        }
        advance_between_updates(a, boundary, in_use, std::min(end, s.contact_pairs.next_update) - s.step, substeps, team, clock,
                                s);
    }
    s.loading = clock.now();
}

void start(const Assemblage& a, const StepParameters& parameters, State& s) {
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(a.contact_chunks.size()); ++chunk) {
        advance_contacts(a, parameters.law, chunk, s.step, s);
    }
    s.clusters = make_cluster_state(a, parameters.mass_scaling, s);
    complete_cluster_state(parameters.mass_scaling, s);
}

}  // namespace graincrack
