#include "solver/step/step.hpp"

#include <algorithm>

#include "solver/step/thread_team.hpp"

namespace graincrack {

State make_state(const Assemblage& a, const Boundary& boundary, const Specimen& specimen) {
    State s;
    s.displacement.resize(a.position.size());
    s.velocity.resize(a.position.size());
    s.force.resize(a.position.size());
    s.last_force.resize(a.position.size());
    s.damping_load.mean_displacement.resize(a.position.size());
    s.drag.resize(a.position.size());
    s.touching.resize(a.position.size());
    s.contact_force.resize(a.n_slot_values());
    s.points = PointMemories(2 * a.contacts.size());
    s.opening.resize(2 * a.contacts.size());
    s.sliding.resize(2 * a.contacts.size());
    s.slip.resize(2 * a.contacts.size());
    s.failed.resize(2 * a.contacts.size());
    s.spent.resize(2 * a.contacts.size());
    s.cohesion_left.assign(2 * a.contacts.size(), 1);
    for (std::size_t c = 0; c < a.contacts.size(); ++c) {
        if (specimen.contact_kind[c] == static_cast<std::uint8_t>(ContactKind::pre_existing_crack)) {
            s.points.of(2 * c) = s.points.of(2 * c + 1) = broken_contact();
            s.failed[2 * c] = s.failed[2 * c + 1] = 1;  // and spent as soon as the law has seen them
            s.cohesion_left[2 * c] = s.cohesion_left[2 * c + 1] = 0;
        }
    }
    s.fracture_energy.resize(2 * a.contacts.size());
    s.touches = make_touch_list(a);
    s.platen_points = boundary.platen_points;
    s.membrane_force.resize(boundary.membrane_edges.size());
    s.drives.nodes.resize(boundary.drives.nodes.size());
    s.drives.load.resize(boundary.drives.edges.size());
    s.drives.pressing.resize(boundary.drives.edges.size());
    s.grain_sums.resize(a.grain_blocks.size());
    s.contact_sums.resize(a.contact_blocks.size());
    s.events.resize(a.contact_blocks.size());
    return s;
}

namespace {

/// Platens and pressure at step `k` of a batch: the same arithmetic in every thread.
class LoadingClock {
public:
    LoadingClock(const BatchLoading& batch, std::int64_t n_steps, double time_step, const State& s)
        : batch_(batch),
          n_steps_(n_steps),
          time_step_(time_step),
          origin_time_(s.origin_time),
          steps_since_origin_(s.step - s.origin_step),
          now_(s.loading) {
        now_.channels.resize(batch.channels == nullptr ? 0 : batch.channels->size());
        prepare();
    }
    [[nodiscard]] const StepLoading& now() const { return now_; }
    /// From here on every step is `parts` steps.
    void part(std::int64_t parts) {
        n_steps_ *= parts;
        k_ *= parts;
        steps_since_origin_ *= parts;
        time_step_ /= static_cast<double>(parts);
        prepare();
    }
    void tick() {
        ++k_;
        for (std::size_t p = 0; p < 2; ++p) {
            now_.platen_displacement[p] += now_.increment_after[p];
            now_.increment_before[p] = now_.increment_after[p];
        }
        prepare();
    }

private:
    void prepare() {
        const double share = (static_cast<double>(k_) + 0.5) / static_cast<double>(n_steps_);
        for (std::size_t p = 0; p < 2; ++p) {
            const double velocity = batch_.velocity_begin[p] + share * (batch_.velocity_end[p] - batch_.velocity_begin[p]);
            now_.increment_after[p] = time_step_ * velocity;
        }
        const double done = static_cast<double>(k_) / static_cast<double>(n_steps_);
        now_.pressure = batch_.pressure_begin + done * (batch_.pressure_end - batch_.pressure_begin);
        const double time = origin_time_ + static_cast<double>(steps_since_origin_ + k_) * time_step_;
        for (std::size_t i = 0; i < now_.channels.size(); ++i) {
            const Channel& channel = (*batch_.channels)[i];
            now_.channels[i] = channel.at(channel.of_velocity ? time + 0.5 * time_step_ : time);
        }
    }
    BatchLoading batch_;
    std::int64_t n_steps_;
    double time_step_;
    double origin_time_;
    std::int64_t steps_since_origin_;
    std::int64_t k_ = 0;
    StepLoading now_;
};

/// Whether the last review found other touches than there were before.
bool have_changed(const TouchList& list) {
    return std::any_of(list.moving.changed.begin(), list.moving.changed.begin() + static_cast<std::ptrdiff_t>(list.blocks.size()),
                       [](std::uint8_t changed) { return changed != 0; });
}

/// Steps between two looks after the touches, each of so many parts, with a team of threads.
void advance_steps(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, std::int64_t n_steps,
                   std::int64_t parts, Team& team, LoadingClock& clock_at_start, State& s) {
    const std::int64_t first_step = s.step;
    const bool scaled = parameters.mass_scaling.is_on();
    LoadingClock clock_at_end = clock_at_start;
    team.run([&](int thread) {
        const Range grain_blocks = share_of(a.grain_blocks.size(), thread, team.size());
        const Range contact_blocks = share_of(a.contact_blocks.size(), thread, team.size());
        const Range group_blocks = share_of(parameters.mass_scaling.blocks.size(), thread, team.size());
        const Range touch_blocks = share_of(s.touches.blocks.size(), thread, team.size());
        LoadingClock clock = clock_at_start;
        for (std::int64_t k = 0; k < n_steps * parts; ++k) {
            for (std::int32_t block = grain_blocks.begin; block < grain_blocks.end; ++block) {
                sum_nodal_forces(a, boundary, clock.now(), block, true, s);
                if (scaled) {
                    book_half_work(a, boundary, block, parameters.time_step, s);
                } else {
                    integrate_nodes(a, boundary, parameters, block, s);
                }
            }
            team.wait();
            if (scaled) {
                for (std::int32_t block = group_blocks.begin; block < group_blocks.end; ++block) {
                    update_groups(a, parameters, clock.now(), block, s);
                    integrate_groups(a, parameters, clock.now(), block, s);
                }
                team.wait();
                for (std::int32_t block = grain_blocks.begin; block < grain_blocks.end; ++block) {
                    book_half_work(a, boundary, block, parameters.time_step, s);
                }
            }
            clock.tick();
            for (std::int32_t block = contact_blocks.begin; block < contact_blocks.end; ++block) {
                advance_contacts(a, parameters.law, block, first_step + k / parts + 1, s);
            }
            const bool is_review = (s.integrations + k) % s.touches.review_interval == 0;
            for (std::int32_t block = touch_blocks.begin; block < touch_blocks.end; ++block) {
                (is_review ? review_touches : move_touches)(a, parameters, block, s);
            }
            team.wait();
            if (is_review && have_changed(s.touches)) {
                if (thread == 0) {
                    arrange_gathers(a, s.touches);
                }
                team.wait();
            }
        }
        for (std::int32_t block = touch_blocks.begin; block < touch_blocks.end; ++block) {
            settle_touches(block, s.touches);
        }
        if (thread == 0) {
            clock_at_end = clock;
        }
    });
    clock_at_start = clock_at_end;
    s.step += n_steps;
    s.integrations += n_steps * parts;
    s.time = time_of(s, s.step, static_cast<double>(parts) * parameters.time_step);
}

/// Ends mass scaling: velocities stay, the added mass and what it carried are gone, and from the next step on steps are in parts.
/// Books what half a step of the ledger's terms is shorter by.
void go_on_in_parts(const Assemblage& a, const Boundary& boundary, const StepParameters& whole, const StepParameters& of_parts,
                    const StepLoading& loading, State& s) {
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(a.grain_blocks.size()); ++block) {
        sum_nodal_forces(a, boundary, loading, block, false, s);
        book_half_work(a, boundary, block, whole.time_step - of_parts.time_step, s);
    }
    shed_added_mass(a, whole, loading, of_parts.time_step, s);
    s.in_parts = true;
    s.touches.next_check = s.step;
}

}  // namespace

void advance(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, const BatchLoading& loading,
             std::int64_t n_steps, Team& team, State& s) {
    LoadingClock clock(loading, n_steps, parameters.time_step, s);
    const StepParameters of_parts = parameters_of_parts(parameters);
    if (s.in_parts) {
        clock.part(parameters.parts);
    }
    const std::int64_t end = s.step + n_steps;
    while (s.step < end) {
        const StepParameters& now = s.in_parts ? of_parts : parameters;
        const std::int64_t parts = s.in_parts ? parameters.parts : 1;
        if (s.step >= s.touches.next_check) {
            if (look_after_touches(a, now, parts, s)) {
                go_on_in_parts(a, boundary, parameters, of_parts, clock.now(), s);
                clock.part(parameters.parts);
                continue;
            }
            s.touches.next_check = s.step + std::max<std::int64_t>(1, (s.touches.next_check - s.step) / parts);
        }
        advance_steps(a, boundary, now, std::min(end, s.touches.next_check) - s.step, parts, team, clock, s);
    }
    s.loading = clock.now();
}

void start(const Assemblage& a, const StepParameters& parameters, State& s) {
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(a.contact_blocks.size()); ++block) {
        advance_contacts(a, parameters.law, block, s.step, s);
    }
    s.groups = make_group_state(a, parameters.mass_scaling, s);
    complete_group_state(parameters.mass_scaling, s);
}

}  // namespace graincrack
