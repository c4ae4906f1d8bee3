// The records of a run: history, crack log, energies and the peak of its axial stress.
#pragma once

#include "share/file/run_file.hpp"
#include "solver/loading/rate_control.hpp"
#include "solver/model/state.hpp"
#include "solver/restart/saved_state.hpp"
#include "solver/run/crack_log.hpp"
#include "solver/run/energy_check.hpp"
#include "solver/run/gauges.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/setup.hpp"

namespace graincrack {

class Recorder {
public:
    Recorder(const Specimen& specimen, const SimulationRequest& request, const Setup& setup);
    /// Measures the state and adds a row. \param platen_speed approach of each, m/s
    /// \throws NumericalError if the run has become unstable
    Feedback record(double platen_speed, ThreadTeam& team, State& state);
    /// Strains, which the last row has none of, and the balance of energies count from it on.
    void restart(State& state);
    /// Continues the cracks and energies of another run.
    void restore(const SavedState& saved);
    /// Also its rows, as those of this very run. \param state of the checkpoint \throws InputError if they end elsewhere
    void resume(const RunReader& checkpoint, const State& state);

    [[nodiscard]] const History& history() const { return history_; }
    [[nodiscard]] const CrackLog& crack_log() const { return crack_log_; }
    [[nodiscard]] const EnergyCheck& energy() const { return energy_; }
    [[nodiscard]] double axial_stress() const;                     ///< of the last row, absolute, Pa
    [[nodiscard]] double peak() const { return peak_; }            ///< of it since contacts have failed, Pa
    [[nodiscard]] bool is_at_peak() const { return is_at_peak_; }  ///< whether the last row is the highest so far

private:
    /// Fraction of the external work of the last wave transits that friction dissipated, 0 to 1; 1 if it exceeds that work.
    [[nodiscard]] double recent_friction() const;
    void push(HistoryColumn column, double value) { history_[column].push_back(value); }
    void push_row(const Measurement& m, double strain, double speed_of_platens, const State& state);

    const Specimen& specimen_;
    const Setup& setup_;
    Gauges gauges_;
    double time_constant_;  ///< of the means of damping, s
    CrackLog crack_log_;
    Energies energies_;  ///< of the last row
    EnergyCheck energy_;
    History history_;
    double peak_ = 0;
    bool is_at_peak_ = false;
};

}  // namespace graincrack
