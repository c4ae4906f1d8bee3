#include "solver/step/step.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/detection/pair_list.hpp"
#include "solver/step/contact_forces.hpp"
#include "solver/step/element_forces.hpp"
#include "solver/step/load_clock.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "solver/step/prescribed.hpp"

namespace graincrack {

namespace {

template <class Act>
void for_each_chunk(Range chunks, const Act& act) {
    for (std::int32_t chunk = chunks.begin; chunk < chunks.end; ++chunk) act(chunk);
}

/// Whether the last detection found other active contacts than there were before.
bool have_changed(const ContactPairList& list) {
    for (std::size_t chunk = 0; chunk < list.chunks.size(); ++chunk) {
        if (list.active.changed[chunk] != 0) return true;
    }
    return false;
}

/// The steps of one thread of the team: its share of the chunks of nodes, elements, contacts and candidate pairs, and the stages
/// of a step on them. The team waits wherever a stage reads what other threads have written.
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
          nodes_(share_of(a.node_chunks.size(), thread, team.size())),
          elements_(share_of(a.element_chunks.size(), thread, team.size())),
          contacts_(share_of(a.contact_chunks.size(), thread, team.size())),
          pairs_(share_of(s.contact_pairs.chunks.size(), thread, team.size())) {}

    /// Before the first step: what follows from displacements and time alone.
    void begin() {
        find_forces_without_history();
        team_.wait();
    }
    /// A step. The work of loads is booked at the old velocity, then at the new one.
    void advance(std::int64_t step, bool detects_contacts) {
        for_each_chunk(nodes_, [&](std::int32_t chunk) {
            advance_nodal_forces(a_, boundary_, clock_.now(), chunk, s_);
            book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_);
            integrate(chunk);
            book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_);
        });
        team_.wait();
        clock_.tick();
        find_forces_without_history();
        for_each_chunk(contacts_, [&](std::int32_t chunk) { advance_contacts(a_, parameters_.laws, chunk, step, s_); });
        for_each_chunk(pairs_, [&](std::int32_t chunk) {
            (detects_contacts ? detect_contacts : move_active_contacts)(a_, parameters_, chunk, s_);
        });
        team_.wait();
        if (detects_contacts) complete_detection();
    }
    /// After the last step: writes the active contacts into the pair list.
    void store_contacts() {
        for_each_chunk(pairs_, [&](std::int32_t chunk) { store_active(chunk, s_.contact_pairs); });
    }
    [[nodiscard]] const LoadingClock& clock() const { return clock_; }

private:
    void integrate(std::int32_t chunk) {
        if (parameters_.mass_scaling.is_on()) {
            update_clusters(a_, parameters_, clock_.now(), chunk, s_);
            integrate_clusters(a_, parameters_, clock_.now(), chunk, s_);
        } else {
            integrate_nodes(a_, boundary_, parameters_, chunk, s_);
        }
    }
    void find_forces_without_history() {
        for_each_chunk(elements_, [&](std::int32_t chunk) { find_element_forces(a_, chunk, s_); });
        for_each_chunk(nodes_, [&](std::int32_t chunk) { find_edge_loads(a_, boundary_.prescribed, clock_.now(), chunk, s_); });
    }
    void complete_detection() {
        if (have_changed(s_.contact_pairs)) {
            if (is_first_) {
                find_areas_of_new_contacts(a_, parameters_, s_);
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
    Range nodes_, elements_, contacts_, pairs_;
};

/// The steps between two updates of the pair list, with a team of threads. Steps with detection are counted from the start, so
/// that they are the same however the steps are divided into calls.
void advance_between_updates(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters,
                             std::int64_t n_steps, ThreadTeam& team, LoadingClock& clock, State& s) {
    const std::int64_t first_step = s.step + 1;
    LoadingClock clock_after = clock;  // each thread has a clock of its own; all end alike
    team.run([&](int thread) {
        ThreadSteps steps(a, boundary, parameters, clock, thread, team, s);
        steps.begin();
        for (std::int64_t step = first_step; step < first_step + n_steps; ++step) {
            const bool detects_contacts = (step - 1) % s.contact_pairs.detection_interval == 0;
            steps.advance(step, detects_contacts);
        }
        steps.store_contacts();
        if (thread == 0) clock_after = steps.clock();
    });
    clock = clock_after;
    s.step += n_steps;
    s.time = time_of(s, s.step, parameters.time_step);
}

}  // namespace

void advance(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, const IntervalLoading& loading,
             std::int64_t n_steps, ThreadTeam& team, State& s) {
    LoadingClock clock(loading, n_steps, parameters.time_step, s);
    const std::int64_t end = s.step + n_steps;
    while (s.step < end) {
        if (s.step >= s.contact_pairs.next_update) update_pair_list(a, parameters, s);
        advance_between_updates(a, boundary, parameters, std::min(end, s.contact_pairs.next_update) - s.step, team, clock, s);
    }
    s.loading = clock.now();
}

void start(const Assemblage& a, const StepParameters& parameters, State& s) {
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(a.contact_chunks.size()); ++chunk) {
        advance_contacts(a, parameters.laws, chunk, s.step, s);
    }
    s.clusters = make_cluster_state(a, parameters.mass_scaling);
    complete_cluster_state(a, parameters.mass_scaling, s);
}

}  // namespace graincrack
