#include "solver/step.hpp"

#include <omp.h>

#include <cmath>

#include "solver/team.hpp"

namespace graincrack {

State make_state(const Assemblage& a, const Boundary& boundary, const Specimen& specimen) {
    State s;
    s.displacement.resize(a.position.size());
    s.velocity.resize(a.position.size());
    s.force.resize(a.position.size());
    s.contact_force.resize(4 * a.contacts.size());
    s.points.resize(2 * a.contacts.size());
    for (std::size_t c = 0; c < a.contacts.size(); ++c) {
        if (specimen.contact_kind[c] == static_cast<std::uint8_t>(ContactKind::pre_existing_crack)) {
            s.points[2 * c] = s.points[2 * c + 1] = broken_contact();
        }
    }
    s.fracture_energy.resize(2 * a.contacts.size());
    s.platen_points = boundary.platen_points;
    s.membrane_force.resize(boundary.membrane_edges.size());
    s.grain_sums.resize(a.grain_blocks.size());
    s.contact_sums.resize(a.contact_blocks.size());
    s.events.resize(a.contact_blocks.size());
    return s;
}

namespace {

/// Traction of an intact point that stays on its branch and short of its peak; false if the full law is needed.
inline bool intact_traction(const ContactLaw& law, const ContactMotion& to, const ContactHistory& h, ContactTraction& traction) {
    if (h.failed() || (h.motion.opening >= 0) != (to.opening >= 0)) {
        return false;
    }
    if (to.opening < 0) {
        const double y = std::abs(to.sliding) * law.inv_dcs;
        traction = {law.kt * to.opening, law.ks * to.sliding * exp_of_minus(y)};
        return y <= 1;
    }
    if (law.variant == LawVariant::continuous) {
        return false;
    }
    const double x = contact_law::effective_displacement(law, to) * law.inv_dct;
    const double stiffness = law.kt * exp_of_minus(x);
    traction = {stiffness * to.opening, stiffness * law.w * to.sliding};
    return x <= 1;
}

struct PointContext {
    std::int64_t step;
    std::int32_t contact;
    std::uint8_t point;
    double area;
    Vector2 tangent;
    Vector2 position;
};

/// The full law at one point: energies and events on top of the traction.
ContactTraction advance_point(const ContactLaw& law, const ContactMotion& to, const PointContext& context,
                              ContactHistory& history, double& fracture_energy, ContactSums& sums,
                              std::vector<ContactEvent>& events) {
    const ContactResponse r = update_contact(law, to, history);
    const double fracture = context.area * r.dissipation.fracture;
    if (r.history.failed()) {
        (r.history.first_mode == CrackMode::tensile ? sums.fracture_tension : sums.fracture_shear) += fracture;
        fracture_energy += fracture;
    }
    sums.friction += context.area * r.dissipation.friction;
    sums.mismatch += context.area * r.dissipation.mismatch;
    const bool fails = r.history.failed() && !history.failed();
    const bool separates = r.history.separated && !history.separated;
    if (fails || separates) {
        ContactEvent event{context.step, context.contact, context.point,   false, r.history.first_mode, to,
                           {},           context.tangent, context.position};
        event.peak_traction = update_contact(law, history.motion, history).traction;
        if (fails) {
            events.push_back(event);
        }
        if (separates) {
            event.is_separation = true;
            events.push_back(event);
        }
    }
    history = r.history;
    return r.traction;
}

}  // namespace

void advance_contacts(const Assemblage& a, const ContactLaw& law, std::int32_t block, std::int64_t step, State& s) {
    const Range range = a.contact_blocks[block];
    for (std::int32_t c = range.begin; c < range.end; ++c) {
        const ContactGeometry& g = a.contacts[c];
        const Vector2 ua1 = s.displacement[g.nodes[0]];
        const Vector2 ua2 = s.displacement[g.nodes[1]];
        const Vector2 ub1 = s.displacement[g.nodes[2]];
        const Vector2 ub2 = s.displacement[g.nodes[3]];
        const ContactFrame frame = contact_frame(g, ua1, ua2, ub1, ub2);
        const Vector2 jumps[2] = {ub1 - ua1, ub2 - ua2};
        Vector2 forces[2];
        double moment = 0;  // that the tractions would exert because they act at a jump's length from each other
        for (int p = 0; p < 2; ++p) {
            const ContactMotion to{dot(jumps[p], frame.normal), dot(jumps[p], frame.tangent)};
            ContactHistory& history = s.points[2 * c + p];
            ContactTraction traction;
            if (intact_traction(law, to, history, traction)) {
                history.motion = to;
            } else {
                const double along = p == 0 ? 0.25 : 0.75;
                const Vector2 first = a.position[g.nodes[0]] + 0.5 * (ua1 + ub1);
                const Vector2 second = a.position[g.nodes[1]] + 0.5 * (ua2 + ub2);
                traction = advance_point(
                    law, to,
                    {step, c, static_cast<std::uint8_t>(p), g.point_area, frame.tangent, first + along * (second - first)},
                    history, s.fracture_energy[2 * c + p], s.contact_sums[block], s.events[block]);
            }
            const double normal_force = g.point_area * traction.normal;
            const double shear_force = g.point_area * traction.shear;
            forces[p] = {normal_force * frame.normal.x + shear_force * frame.tangent.x,
                         normal_force * frame.normal.y + shear_force * frame.tangent.y};
            moment += normal_force * to.sliding - shear_force * to.opening;
        }
        // The frame turns with the mid-edge: its share of the forces balances the moment, so that angular momentum holds
        // and the energy is that of a potential of the displacements.
        const Vector2 couple = (0.5 * moment * frame.inv_length) * frame.normal;
        Vector2* slots = &s.contact_force[4 * static_cast<std::size_t>(c)];
        slots[0] = {forces[0].x - couple.x, forces[0].y - couple.y};
        slots[1] = {forces[1].x + couple.x, forces[1].y + couple.y};
        slots[2] = {-forces[0].x - couple.x, -forces[0].y - couple.y};
        slots[3] = {-forces[1].x + couple.x, -forces[1].y + couple.y};
    }
}

namespace {

void add_platens(const Boundary& boundary, const StepLoading& loading, std::int32_t block, bool commit, State& s) {
    const Range points = boundary.platen_points_of_block[block];
    for (std::int32_t i = points.begin; i < points.end; ++i) {
        PlatenPoint& point = s.platen_points[i];
        const PlatenResponse r = platen_response(boundary.platens[point.platen], point, s.displacement[point.node],
                                                 loading.platen_displacement[point.platen]);
        s.force[point.node] += r.force;
        if (commit) {
            point.anchor = r.anchor;
            point.shear = r.shear;
            s.grain_sums[block].platen_friction += r.friction;
            s.grain_sums[block].platen_work +=
                0.5 * r.force.y * (loading.increment_before[point.platen] + loading.increment_after[point.platen]);
        }
    }
}

void add_membrane(const Assemblage& a, const Boundary& boundary, double pressure, std::int32_t block, State& s) {
    const double half_pressure = 0.5 * pressure;
    const Range edges = boundary.membrane_edges_of_block[block];
    for (std::int32_t i = edges.begin; i < edges.end; ++i) {
        const auto [first, second] = boundary.membrane_edges[i];
        const Vector2 along = (a.position[second] + s.displacement[second]) - (a.position[first] + s.displacement[first]);
        s.membrane_force[i] = {-half_pressure * along.y, half_pressure * along.x};
        s.force[first] += s.membrane_force[i];
        s.force[second] += s.membrane_force[i];
    }
}

/// Work of the membrane over half a step at the present velocities.
double membrane_half_work(const Boundary& boundary, std::int32_t block, double time_step, const State& s) {
    double work = 0;
    const Range edges = boundary.membrane_edges_of_block[block];
    for (std::int32_t i = edges.begin; i < edges.end; ++i) {
        const auto [first, second] = boundary.membrane_edges[i];
        work += 0.5 * time_step * dot(s.membrane_force[i], s.velocity[first] + s.velocity[second]);
    }
    return work;
}

}  // namespace

void sum_nodal_forces(const Assemblage& a, const Boundary& boundary, const StepLoading& loading, std::int32_t block, bool commit,
                      State& s) {
    const GrainBlock& range = a.grain_blocks[block];
    for (std::int32_t i = range.nodes.begin; i < range.nodes.end; ++i) {
        s.force[i] = {};
    }
    for (std::int32_t e = range.elements.begin; e < range.elements.end; ++e) {
        const auto [n0, n1, n2] = a.element_nodes[e];
        const TriangleGeometry& g = a.element_geometry[e];
        const TriangleState state = triangle_state(g, a.elasticity, s.displacement[n0], s.displacement[n1], s.displacement[n2]);
        const std::array<Vector2, 3> forces = triangle_forces(g, state);
        s.force[n0] += forces[0];
        s.force[n1] += forces[1];
        s.force[n2] += forces[2];
    }
    for (std::int32_t i = range.nodes.begin; i < range.nodes.end; ++i) {
        for (std::int32_t k = a.slot_begin[i]; k < a.slot_begin[i + 1]; ++k) {
            s.force[i] += s.contact_force[a.slots[k]];
        }
    }
    add_platens(boundary, loading, block, commit, s);
    add_membrane(a, boundary, loading.pressure, block, s);
}

void integrate_nodes(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, std::int32_t block,
                     State& s) {
    const Range nodes = a.grain_blocks[block].nodes;
    GrainSums& sums = s.grain_sums[block];
    const double dt = parameters.time_step;
    sums.membrane_work += membrane_half_work(boundary, block, dt, s);
    double absorbed = 0;
    for (std::int32_t i = nodes.begin; i < nodes.end; ++i) {
        const Vector2 old_velocity = s.velocity[i];
        const Vector2 drag = damping_force(parameters.damping, s.force[i], old_velocity);
        const double rate = dt * a.inverse_mass[i];
        s.velocity[i] = {old_velocity.x + rate * (s.force[i].x + drag.x), old_velocity.y + rate * (s.force[i].y + drag.y)};
        s.displacement[i] += dt * s.velocity[i];
        absorbed -= dot(drag, old_velocity + s.velocity[i]);
    }
    sums.damping += 0.5 * dt * absorbed;
    sums.membrane_work += membrane_half_work(boundary, block, dt, s);
}

namespace {

/// Platens and pressure at step `k` of a batch: the same arithmetic in every thread.
class LoadingClock {
public:
    LoadingClock(const BatchLoading& batch, std::int64_t n_steps, double time_step, const StepLoading& at_start)
        : batch_(batch), n_steps_(n_steps), time_step_(time_step), now_(at_start) {
        prepare();
    }
    [[nodiscard]] const StepLoading& now() const { return now_; }
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
    }
    BatchLoading batch_;
    std::int64_t n_steps_;
    double time_step_;
    std::int64_t k_ = 0;
    StepLoading now_;
};

}  // namespace

void advance(const Assemblage& a, const Boundary& boundary, const StepParameters& parameters, const BatchLoading& loading,
             std::int64_t n_steps, int n_threads, State& s) {
    SpinBarrier barrier(n_threads);
    const std::int64_t first_step = s.step;
#pragma omp parallel num_threads(n_threads)
    {
        const int thread = omp_get_thread_num();
        const Range grain_blocks = share_of(a.grain_blocks.size(), thread, n_threads);
        const Range contact_blocks = share_of(a.contact_blocks.size(), thread, n_threads);
        LoadingClock clock(loading, n_steps, parameters.time_step, s.loading);
        for (std::int64_t k = 0; k < n_steps; ++k) {
            for (std::int32_t block = grain_blocks.begin; block < grain_blocks.end; ++block) {
                sum_nodal_forces(a, boundary, clock.now(), block, true, s);
                integrate_nodes(a, boundary, parameters, block, s);
            }
            barrier.wait();
            clock.tick();
            for (std::int32_t block = contact_blocks.begin; block < contact_blocks.end; ++block) {
                advance_contacts(a, parameters.law, block, first_step + k + 1, s);
            }
            barrier.wait();
        }
        if (thread == 0) {
            s.loading = clock.now();  // behind the last barrier: every thread has its own clock by now
        }
    }
    s.step += n_steps;
    s.time = static_cast<double>(s.step) * parameters.time_step;
}

void start(const Assemblage& a, const StepParameters& parameters, State& s) {
    for (std::int32_t block = 0; block < static_cast<std::int32_t>(a.contact_blocks.size()); ++block) {
        advance_contacts(a, parameters.law, block, s.step, s);
    }
}

}  // namespace graincrack
