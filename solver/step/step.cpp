#include "solver/step/step.hpp"

#include <algorithm>

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

/// Whether the last review found other touches than there were before.
bool have_changed(const ContactPairList& list) {
    return std::any_of(list.active.changed.begin(), list.active.changed.begin() + static_cast<std::ptrdiff_t>(list.chunks.size()),
                       [](std::uint8_t changed) { return changed != 0; });
}

/// Steps between two looks after the touches, each of so many substeps, with a team of threads.
void advance_steps(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, std::int64_t n_steps,
                   std::int64_t substeps, ThreadTeam& team, LoadingClock& clock_at_start, State& s) {
    const std::int64_t first_step = s.step;
    const bool scaled = parameters.mass_scaling.is_on();
    LoadingClock clock_at_end = clock_at_start;
    team.run([&](int thread) {
        const Range grain_chunks = share_of(a.grain_chunks.size(), thread, team.size());
        const Range contact_chunks = share_of(a.contact_chunks.size(), thread, team.size());
        const Range group_chunks = share_of(parameters.mass_scaling.chunks.size(), thread, team.size());
        const Range detection_chunks = share_of(s.contact_pairs.chunks.size(), thread, team.size());
        LoadingClock clock = clock_at_start;
        for (std::int64_t k = 0; k < n_steps * substeps; ++k) {
            for (std::int32_t chunk = grain_chunks.begin; chunk < grain_chunks.end; ++chunk) {
                sum_nodal_forces(a, boundary, clock.now(), chunk, true, s);
                if (scaled) {
                    book_half_work(a, boundary, chunk, parameters.time_step, s);
                } else {
                    integrate_nodes(a, boundary, parameters, chunk, s);
                }
            }
            team.wait();
            if (scaled) {
                for (std::int32_t chunk = group_chunks.begin; chunk < group_chunks.end; ++chunk) {
                    update_clusters(a, parameters, clock.now(), chunk, s);
                    integrate_clusters(a, parameters, clock.now(), chunk, s);
                }
                team.wait();
                for (std::int32_t chunk = grain_chunks.begin; chunk < grain_chunks.end; ++chunk) {
                    book_half_work(a, boundary, chunk, parameters.time_step, s);
                }
            }
            clock.tick();
            for (std::int32_t chunk = contact_chunks.begin; chunk < contact_chunks.end; ++chunk) {
                advance_contacts(a, parameters.law, chunk, first_step + k / substeps + 1, s);
            }
            const bool is_detection = (s.integrations + k) % s.contact_pairs.detection_interval == 0;
            for (std::int32_t chunk = detection_chunks.begin; chunk < detection_chunks.end; ++chunk) {
                (is_detection ? detect_contacts : move_active_contacts)(a, parameters, chunk, s);
            }
            team.wait();
            if (is_detection && have_changed(s.contact_pairs)) {
                if (thread == 0) {
                    index_node_forces(a, s.contact_pairs);
                }
                team.wait();
            }
        }
        for (std::int32_t chunk = detection_chunks.begin; chunk < detection_chunks.end; ++chunk) {
            store_active(chunk, s.contact_pairs);
        }
        if (thread == 0) {
            clock_at_end = clock;
        }
    });
    clock_at_start = clock_at_end;
    s.step += n_steps;
    s.integrations += n_steps * substeps;
    s.time = time_of(s, s.step, static_cast<double>(substeps) * parameters.time_step);
}

/// Ends mass scaling: velocities stay, the added mass and what it carried are gone, and from the next step on steps are in
/// substeps. Books what half a step of the ledger's terms is shorter by.
void go_on_in_substeps(const Assemblage& a, const Boundary& boundary, const StepParameters& whole,
                       const StepParameters& of_substeps, const StepLoading& loading, State& s) {
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(a.grain_chunks.size()); ++chunk) {
        sum_nodal_forces(a, boundary, loading, chunk, false, s);
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
                go_on_in_substeps(a, boundary, parameters, of_substeps, clock.now(), s);
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
