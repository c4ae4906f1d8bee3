#include "solver/step/step.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/detection/pair_exchange.hpp"
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

/// The share of a thread in a list of chunks.
using Chunks = std::span<const std::int32_t>;
Chunks chunks_of(Chunks chunks, int thread, int n_threads) {
    const Range share = share_of(chunks.size(), thread, n_threads);
    return chunks.subspan(static_cast<std::size_t>(share.begin), static_cast<std::size_t>(share.size()));
}

/// True if the last detection found other active contacts than there were before.
bool have_changed(const ContactPairList& list) {
    for (std::size_t chunk = 0; chunk < list.chunks.size(); ++chunk) {
        if (list.active.changed[chunk] != 0) return true;
    }
    return false;
}

/// The steps of one thread of the team: its share of the chunks of nodes, elements, contacts and candidate pairs, and the stages
/// of a step on them. The team waits wherever a stage reads what other threads have written, and what reads the nodes of other
/// ranks waits for their message, which comes while all else is evaluated.
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
          nodes_(chunks_of(a.part.nodes.own, thread, team.size())),
          loaded_(chunks_of(a.part.loaded_chunks, thread, team.size())),
          inner_{chunks_of(a.part.evaluated_elements.inner, thread, team.size()),
                 chunks_of(a.part.evaluated_contacts.inner, thread, team.size())},
          outer_{chunks_of(a.part.evaluated_elements.outer, thread, team.size()),
                 chunks_of(a.part.evaluated_contacts.outer, thread, team.size())},
          pairs_(share_of(s.contact_pairs.chunks.size(), thread, team.size())) {}

    /// Before the first step: what follows from displacements and time alone.
    void begin() {
        for (const Evaluated& chunks : {inner_, outer_}) find_element_forces_of(chunks);
        find_loads();
        team_.wait();
    }
    /// A step. The work of loads is booked at the old velocity, then at the new one.
    void advance(std::int64_t step, bool detects_contacts) {
        for (const std::int32_t chunk : nodes_) {
            advance_nodal_forces(a_, boundary_, clock_.now(), chunk, s_);
            book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_);
            integrate(chunk);
            book_half_load_work(a_, boundary_, chunk, parameters_.time_step, s_);
        }
        team_.wait();
        clock_.tick();
        if (s_.ghosts && is_first_) send_motion(s_);
        evaluate(inner_, step);
        if (s_.ghosts) {
            if (is_first_) receive_motion(s_);
            team_.wait();
        }
        evaluate(outer_, step);
        find_loads();
        for (std::int32_t chunk = pairs_.begin; chunk < pairs_.end; ++chunk) {
            (detects_contacts ? detect_contacts : move_active_contacts)(a_, parameters_, chunk, s_);
        }
        team_.wait();
        if (detects_contacts) complete_detection();
    }
    /// After the last step: writes the active contacts into the pair list.
    void store_contacts() {
        for (std::int32_t chunk = pairs_.begin; chunk < pairs_.end; ++chunk) store_active(chunk, s_.contact_pairs);
    }
    [[nodiscard]] const LoadingClock& clock() const { return clock_; }

private:
    struct Evaluated {
        Chunks elements, contacts;
    };
    void integrate(std::int32_t chunk) {
        if (parameters_.mass_scaling.is_on()) {
            update_clusters(a_, parameters_, clock_.now(), chunk, s_);
            integrate_clusters(a_, parameters_, clock_.now(), chunk, s_);
        } else {
            integrate_nodes(a_, boundary_, parameters_, chunk, s_);
        }
    }
    void find_element_forces_of(const Evaluated& chunks) {
        for (const std::int32_t chunk : chunks.elements) find_element_forces(a_, chunk, s_);
    }
    void find_loads() {
        for (const std::int32_t chunk : loaded_) find_edge_loads(a_, boundary_.prescribed, clock_.now(), chunk, s_);
    }
    void evaluate(const Evaluated& chunks, std::int64_t step) {
        find_element_forces_of(chunks);
        for (const std::int32_t chunk : chunks.contacts) advance_contacts(a_, parameters_.laws, chunk, step, s_);
    }
    /// The ranks agree on the areas of new contacts wherever they may begin.
    void complete_detection() {
        const bool changed = have_changed(s_.contact_pairs);
        if (changed || (s_.ghosts && s_.contact_pairs.is_watched_anywhere)) {
            if (is_first_) {
                find_areas_of_new_contacts(a_, parameters_, s_);
                if (changed) index_node_forces(a_, s_.contact_pairs);
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
    Chunks nodes_, loaded_;
    Evaluated inner_, outer_;
    Range pairs_;
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
    find_ghosts(a, s);
    for_each_evaluated(a.part.evaluated_contacts,
                       [&](std::int32_t chunk) { advance_contacts(a, parameters.laws, chunk, s.step, s); });
    s.clusters = make_cluster_state(a, parameters.mass_scaling);
    complete_cluster_state(a, parameters.mass_scaling, s);
}

}  // namespace graincrack
