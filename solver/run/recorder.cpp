#include "solver/run/recorder.hpp"

#include <algorithm>
#include <cmath>

#include "share/base/error.hpp"
#include "share/file/specimen_measures.hpp"
#include "solver/model/damping_load.hpp"
#include "solver/run/near_failure.hpp"

namespace graincrack {
namespace {

constexpr double recent_means = 2.5;  // time constants of `recent_friction`: ten wave transits. Chosen; not varied since

/// Load over the specimen's width (brazilian: over its diameter), tension positive, Pa.
double axial_stress_of(const Measurement& m, const Specimen& s) { return 0.5 * (m.force_top - m.force_bottom) / s.width; }

double axial_strain_of(const State& state, const Specimen& s) {
    const auto& platens = state.loading.platen_displacement;
    return (platens[top_platen] - platens[bottom_platen]) / s.height;
}

EnergyOrigin origin_of(const State& s) {
    return s.energy_origin.empty() ? EnergyOrigin() : EnergyOrigin{s.energy_origin[0], s.energy_origin[1], s.energy_origin[2]};
}

}  // namespace

Recorder::Recorder(const Specimen& specimen, const SimulationRequest& request, const Setup& setup)
    : specimen_(specimen),
      setup_(setup),
      gauges_(make_gauges(setup.assemblage, specimen)),
      time_constant_(mean_transits * bar_transit_time(specimen, request.material.rock)),
      crack_log_(2 * specimen.n_contacts()),
      energy_(specimen, request) {}

Feedback Recorder::record(double platen_speed, ThreadTeam& team, State& state) {
    const Assemblage& a = setup_.assemblage;
    crack_log_.collect(a, setup_.parameters.time_step, state);
    const Measurement m = measure(a, setup_.boundary, setup_.parameters, team, state);
    energies_ = m.energies;
    energy_.add(energies_, state.step);
    follow_damping_load(a, state, m.platen_power, time_constant_, state.damping_load);
    const double strain = axial_strain_of(state, specimen_);
    push_row(m, strain, platen_speed, state);
    is_at_peak_ = !crack_log_.empty() && axial_stress() > peak_;
    peak_ = is_at_peak_ ? axial_stress() : peak_;
    const double load = std::abs(m.force_top - m.force_bottom) / 2;
    Feedback feedback;
    feedback.time = state.time;
    feedback.axial_strain = strain;
    feedback.axial_compression = -axial_stress_of(m, specimen_);
    feedback.unbalanced_ratio = m.unbalanced_ratio;
    feedback.element_force = m.element_force;
    feedback.kinetic_energy = m.own_kinetic;
    feedback.stored_energy = m.energies.stored();
    feedback.force_difference = load > 0 ? std::abs(m.force_top + m.force_bottom) / load : 0;
    feedback.damping_load = state.damping_load.fraction();
    feedback.near_failure = near_failure(a, setup_.parameters.laws, state, specimen_.width, recent_friction(), team);
    return feedback;
}

double Recorder::recent_friction() const {
    const std::vector<double>& time = history_[HistoryColumn::time];
    const auto since = std::lower_bound(time.begin(), time.end(), time.back() - recent_means * time_constant_) - time.begin();
    const auto rise = [&](HistoryColumn column) {
        return history_[column].back() - history_[column][static_cast<std::size_t>(since)];
    };
    const double friction = rise(HistoryColumn::energy_friction);
    const double work = rise(HistoryColumn::energy_external);
    return friction <= 0 ? 0 : work <= friction ? 1 : friction / work;
}

void Recorder::restart(State& state) {
    state.energy_origin = {energies_.stored(), energies_.balance_error(), energies_.external};
    energy_.restart(origin_of(state));
    const GaugeStrains now = gauges_.strains(setup_.assemblage, state.displacement);
    state.strain_origin = {now.widening, now.axial, now.lateral};
    using enum HistoryColumn;
    for (const HistoryColumn column : {lateral_strain, gauge_axial_strain, gauge_lateral_strain}) history_[column].back() = 0;
}

void Recorder::restore(const SavedState& saved) {
    crack_log_.restore(saved.cracks);
    energy_.restore(saved.energy_scale, saved.energy_balance_error);
    energy_.count_from(origin_of(saved.state));
}

void Recorder::resume(const RunReader& checkpoint, const State& state) {
    history_ = checkpoint.history();
    if (history_[HistoryColumn::time].back() != state.time ||
        history_[HistoryColumn::step].back() != static_cast<double>(state.step)) {
        throw InputError(checkpoint.name() + ": its state is not that of the last row of its history: the file is damaged");
    }
    energy_.resume(history_[HistoryColumn::energy_external]);
    peak_ = checkpoint.header().peak_axial_stress;
}

double Recorder::axial_stress() const { return std::abs(history_[HistoryColumn::axial_stress].back()); }

void Recorder::push_row(const Measurement& m, double strain, double speed_of_platens, const State& state) {
    using enum HistoryColumn;
    const Energies& e = m.energies;
    push(time, state.time);
    push(step, static_cast<double>(state.step));
    push(HistoryColumn::axial_strain, strain);
    const GaugeStrains strains = gauges_.strains(setup_.assemblage, state.displacement);
    const bool has_origin = !state.strain_origin.empty();
    push(lateral_strain, has_origin ? strains.widening - state.strain_origin[0] : strains.widening);
    push(gauge_axial_strain, has_origin ? strains.axial - state.strain_origin[1] : strains.axial);
    push(gauge_lateral_strain, has_origin ? strains.lateral - state.strain_origin[2] : strains.lateral);
    push(HistoryColumn::axial_stress, axial_stress_of(m, specimen_));
    push(force_top, m.force_top);
    push(force_bottom, -m.force_bottom);
    push(confining_pressure, m.confining_force / (specimen_.height * (1 + strain)));
    push(energy_external, e.external);
    push(energy_kinetic, e.kinetic);
    push(energy_strain, e.strain);
    push(energy_contact, e.contact);
    push(energy_fracture_tension, e.fracture_tension);
    push(energy_fracture_shear, e.fracture_shear);
    push(energy_friction, e.friction);
    push(energy_damping, e.damping);
    push(energy_platen, e.platen);
    push(non_conservative_work, e.non_conservative_work);
    push(energy_balance_error, energy_.relative_error(e));
    push(unbalanced_ratio, m.unbalanced_ratio);
    push(tensile_cracks, 0.5 * static_cast<double>(crack_log_.tensile_points()));
    push(shear_cracks, 0.5 * static_cast<double>(crack_log_.shear_points()));
    push(platen_speed, speed_of_platens);
    push(damping_load, state.damping_load.fraction());
    push(energy_numerical, e.numerical);
    push(temperature, state.loading.temperature);
    history_.has_temperature = !state.thermal.empty();
}

}  // namespace graincrack
