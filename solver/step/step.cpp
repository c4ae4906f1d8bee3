#include "solver/step/step.hpp"

#include <algorithm>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/detection/pair_exchange.hpp"
#include "solver/detection/pair_list.hpp"
#include "solver/step/contact_forces.hpp"
#include "solver/step/element_forces.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "solver/step/prescribed.hpp"
#include "solver/step/step_shares.hpp"

namespace graincrack {

namespace {

/// Platens and amplitudes at each step of a loading interval. Each thread has its own clock; all compute the same values.
class LoadingClock {
public:
    LoadingClock(const IntervalLoading& interval, std::int64_t n_steps, double time_step, const State& s)
        : interval_(interval),
          n_steps_(n_steps),
          time_step_(time_step),
          origin_time_(s.origin_time),
          steps_since_origin_(s.step - s.origin_step),
          now_(s.loading) {
        now_.amplitudes.resize(interval.amplitudes == nullptr ? 0 : interval.amplitudes->size());
        prepare();
    }
    [[nodiscard]] const StepLoading& now() const { return now_; }
    void tick() {
        ++k_;
        for (std::size_t p = 0; p < 2; ++p) now_.platen_displacement[p] += now_.increment_after[p];
        now_.increment_before = now_.increment_after;
        prepare();
    }

private:
    void prepare() {
        const double fraction = (static_cast<double>(k_) + 0.5) / static_cast<double>(n_steps_);
        for (std::size_t p = 0; p < 2; ++p) {
            const double velocity =
                interval_.velocity_begin[p] + fraction * (interval_.velocity_end[p] - interval_.velocity_begin[p]);
            now_.increment_after[p] = time_step_ * velocity;
        }
        const double time = origin_time_ + static_cast<double>(steps_since_origin_ + k_) * time_step_;
        for (std::size_t i = 0; i < now_.amplitudes.size(); ++i) {
            const Amplitude& amplitude = (*interval_.amplitudes)[i];
            now_.amplitudes[i] = amplitude.at(amplitude.of_velocity ? time + 0.5 * time_step_ : time);
        }
        if (interval_.temperature != no_amplitude) now_.temperature = now_.amplitudes[interval_.temperature];
    }

    IntervalLoading interval_;
    std::int64_t n_steps_;
    double time_step_, origin_time_;
    std::int64_t steps_since_origin_, k_ = 0;
    StepLoading now_;
};

/// The steps of one thread: the stages of a step on its share. The team waits before a stage that reads values written by other
/// threads. Stages that read nodes of other ranks wait for their message, which arrives while everything else is evaluated.
struct ThreadSteps {
    const Assemblage& a;
    const Boundary& boundary;
    const StepParameters& parameters;
    const StepShare& share;
    bool is_first;
    ThreadTeam& team;
    LoadingClock clock;
    State& s;
    Warmth warmth = {};

    void warm() {
        if (!s.thermal.empty()) warmth.go_to(clock.now().temperature, a.expansion);
    }
    /// Computes, before the first step, the quantities that follow from displacements and time alone.
    void begin() {
        warm();
        for (const auto& elements : {share.inner_elements, share.outer_elements}) {
            for (const std::int32_t chunk : elements) find_element_forces(a, warmth, chunk, s);
        }
        for (const std::int32_t chunk : share.loaded) find_edge_loads(a, boundary.prescribed, clock.now(), chunk, s);
        team.wait();
    }
    /// Makes one step. The work of loads is added at the old velocity and then at the new one.
    void advance(std::int64_t step, bool detects_contacts) {
        for (const std::int32_t chunk : share.nodes) {
            advance_nodal_forces(a, boundary, clock.now(), chunk, s);
            book_half_load_work(a, boundary, chunk, parameters.time_step, s);
            if (parameters.mass_scaling.is_on()) {
                update_clusters(a, parameters, clock.now(), chunk, s);
                integrate_clusters(a, parameters, clock.now(), chunk, s);
            } else {
                integrate_nodes(a, boundary, parameters, chunk, s);
            }
            book_half_load_work(a, boundary, chunk, parameters.time_step, s);
        }
        team.wait();
        clock.tick();
        warm();
        if (s.ghosts && is_first) send_motion(s);
        evaluate(share.inner_elements, share.inner_contacts, step);
        if (s.ghosts) {
            if (is_first) receive_motion(s);
            team.wait();
        }
        evaluate(share.outer_elements, share.outer_contacts, step);
        for (const std::int32_t chunk : share.loaded) find_edge_loads(a, boundary.prescribed, clock.now(), chunk, s);
        for (std::int32_t chunk = share.pairs.begin; chunk < share.pairs.end; ++chunk) {
            (detects_contacts ? detect_contacts : move_active_contacts)(a, parameters, chunk, s);
        }
        team.wait();
        if (detects_contacts) complete_detection();
    }
    void evaluate(StepShare::Chunks elements, StepShare::Chunks contacts, std::int64_t step) {
        for (const std::int32_t chunk : elements) find_element_forces(a, warmth, chunk, s);
        for (const std::int32_t chunk : contacts) advance_contacts(a, parameters.laws, chunk, step, s);
    }
    /// Makes the ranks agree on the areas of new contacts.
    void complete_detection() {
        const auto& changes = s.contact_pairs.active.changed;
        const bool changed = std::find(changes.begin(), changes.end(), 1) != changes.end();
        if (changed || (s.ghosts && s.contact_pairs.is_watched_anywhere)) {
            if (is_first) {
                find_areas_of_new_contacts(a, parameters, s);
                if (changed) index_node_forces(a, s.contact_pairs);
            }
            team.wait();
        }
    }
};

/// Makes the steps between two updates of the pair list with a team of threads. Steps with detection are counted from the start
/// of the run, so that they do not depend on how calls divide the steps.
void advance_between_updates(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters,
                             std::int64_t n_steps, ThreadTeam& team, LoadingClock& clock, State& s) {
    const std::int64_t first_step = s.step + 1;
    LoadingClock clock_after = clock;  // all clocks of the threads end alike
    team.adapt();
    const StepShares shares = share_step(a, boundary, &s, team.size());
    team.run([&](int thread) {
        ThreadSteps steps{a, boundary, parameters, shares.of_threads[thread], thread == 0, team, clock, s};
        steps.begin();
        for (std::int64_t step = first_step; step < first_step + n_steps; ++step) {
            steps.advance(step, (step - 1) % s.contact_pairs.detection_interval == 0);
        }
        if (thread == 0) clock_after = steps.clock;
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
    complete_cluster_state(a, parameters.mass_scaling, s);
}

}  // namespace graincrack
