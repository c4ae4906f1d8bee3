#include "solver/step/step.hpp"

#include <algorithm>
#include <cstddef>

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

template <class Stage>
void for_each_chunk(Range chunks, const Stage& stage) {
    for (std::int32_t chunk = chunks.begin; chunk < chunks.end; ++chunk) {
        stage(chunk);
    }
}

/// Whether the last detection found other active contacts than there were before.
bool have_changed(const ContactPairList& list) {
    const auto& changed = list.active.changed;
    return std::any_of(changed.begin(), changed.begin() + static_cast<std::ptrdiff_t>(list.chunks.size()),
                       [](std::uint8_t flag) { return flag != 0; });
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

    /// A step of nodes that move with their own masses.
    void advance(std::int64_t step, bool is_detection) {
        for_each_chunk(grains_, [&](std::int32_t chunk) {
            advance_nodal_forces(a_, boundary_, clock_.now(), chunk, s_);
            book_half_work(a_, boundary_, chunk, parameters_.time_step, s_);
            integrate_nodes(a_, boundary_, parameters_, chunk, s_);
            book_half_work(a_, boundary_, chunk, parameters_.time_step, s_);
        });
        team_.wait();
        clock_.tick();
        for_each_chunk(contacts_, [&](std::int32_t chunk) { advance_contacts(a_, parameters_.law, chunk, step, s_); });
        if (is_detection) {
            for_each_chunk(pairs_, [&](std::int32_t chunk) { detect_contacts(a_, parameters_, chunk, s_); });
            team_.wait();
            index_changed_contacts();
        } else {
            for_each_chunk(pairs_, [&](std::int32_t chunk) { move_active_contacts(a_, parameters_, chunk, s_); });
            team_.wait();
        }
    }
    /// A step with mass scaling, in which vertex clusters are integrated and there are no node–edge contacts.
    void advance_scaled(std::int64_t step) {
        for_each_chunk(grains_, [&](std::int32_t chunk) {
            advance_nodal_forces(a_, boundary_, clock_.now(), chunk, s_);
            book_half_work(a_, boundary_, chunk, parameters_.time_step, s_);
        });
        team_.wait();
        for_each_chunk(clusters_, [&](std::int32_t chunk) {
            update_clusters(a_, parameters_, clock_.now(), chunk, s_);
            integrate_clusters(a_, parameters_, clock_.now(), chunk, s_);
        });
        team_.wait();
        for_each_chunk(grains_, [&](std::int32_t chunk) { book_half_work(a_, boundary_, chunk, parameters_.time_step, s_); });
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
    void index_changed_contacts() {
        if (have_changed(s_.contact_pairs)) {
            if (is_first_) {
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

/// The steps between two updates of the pair list, each of so many substeps, with a team of threads.
void advance_steps(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, std::int64_t n_steps,
                   std::int64_t substeps, ThreadTeam& team, LoadingClock& clock, State& s) {
    const std::int64_t first_step = s.step + 1;
    const bool is_scaled = parameters.mass_scaling.is_on();
    LoadingClock clock_at_end = clock;
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
            clock_at_end = steps.clock();
        }
    });
    clock = clock_at_end;
    s.step += n_steps;
    s.integrations += n_steps * substeps;
    s.time = time_of(s, s.step, static_cast<double>(substeps) * parameters.time_step);
}

/// Ends mass scaling. Velocities stay, the added mass and its kinetic energy are removed, and from the next step on every step is
/// made of substeps. The energy balance at a step includes half a step of work at the present velocities; this half is booked at
/// its new, shorter length.
void end_mass_scaling(const Assemblage& a, const Boundary& boundary, const StepParameters& whole,
                      const StepParameters& of_substeps, const StepLoading& loading, State& s) {
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(a.grain_chunks.size()); ++chunk) {
        sum_nodal_forces(a, boundary, loading, chunk, s);
        book_half_work(a, boundary, chunk, whole.time_step - of_substeps.time_step, s);
    }
    drop_added_mass(a, whole, loading, of_substeps.time_step, s);
    s.subcycled = true;
    s.contact_pairs.next_check = s.step;
}

}  // namespace

void advance(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, const IntervalLoading& loading,
             std::int64_t n_steps, ThreadTeam& team, State& s) {
    LoadingClock clock(loading, n_steps, parameters.time_step, s);
    const StepParameters of_substeps = parameters_of_substeps(parameters);
    if (s.subcycled) {
        clock.subcycle(parameters.substeps);
    }
    const std::int64_t end = s.step + n_steps;
    while (s.step < end) {
        const StepParameters& now = s.subcycled ? of_substeps : parameters;
        const std::int64_t substeps = s.subcycled ? parameters.substeps : 1;
        if (s.step >= s.contact_pairs.next_check) {
            if (update_pair_list(a, now, substeps, s)) {
                end_mass_scaling(a, boundary, parameters, of_substeps, clock.now(), s);
                clock.subcycle(parameters.substeps);
                continue;
            }
            s.contact_pairs.next_check = s.step + std::max<std::int64_t>(1, (s.contact_pairs.next_check - s.step) / substeps);
        }
        advance_steps(a, boundary, now, std::min(end, s.contact_pairs.next_check) - s.step, substeps, team, clock, s);
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
