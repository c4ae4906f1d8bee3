#include "solver/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <numeric>
#include <optional>

#include "share/base/error.hpp"
#include "share/file/equilibrium.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/output_file.hpp"
#include "solver/model/transit_time.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/restart/saved_state.hpp"
#include "solver/run/crack_log.hpp"
#include "solver/run/damping_load.hpp"
#include "solver/run/frame_output.hpp"
#include "solver/run/gauges.hpp"
#include "solver/run/measure.hpp"
#include "solver/run/near_failure.hpp"
#include "solver/run/program_driver.hpp"
#include "solver/run/sensitivity.hpp"
#include "solver/setup/regions.hpp"
#include "solver/setup/setup.hpp"
#include "solver/step/step.hpp"

namespace graincrack {
namespace {

constexpr double unstable_residual = 1.0;  // imbalance over the largest stored energy: no run that means anything
constexpr double judged_stress = 0.01;     // of tc: below the energy of this stress the imbalance is noise of the start
constexpr double peak_frame_drop = 0.02;   // fall below the peak at which the frame of the peak is final
// Wall time from one writing of rows to the next, s: it takes some milliseconds, in which a kill would damage the unfinished
// file.
constexpr double flush_interval_of_frames = 0.25;
constexpr double longest_flush_interval = 2;

/// Axial stress of a test: load over the specimen's width (brazilian: over its diameter).
double axial_stress(const Specimen& s, double force_bottom, double force_top) {
    return 0.5 * (force_bottom + force_top) / s.width;
}

/// Contacts whose points have failed: one with a single failed point counts as one.
std::size_t whole_contacts(std::size_t points) { return (points + 1) / 2; }

RunHeader make_header(const SimulationRequest& r, const Program& program, const Setup& setup) {
    RunHeader h;
    h.test = name_of(r.loading.test);
    h.material = r.material.name;
    h.contact_law = name_of(r.law);
    h.crack_event = description_of(r.law).crack_event();
    h.coupling = name_of(r.coupling);
    h.fracture_energy_choice = r.fracture_energy_choice;
    h.plane = r.plane;
    h.rock = r.material.rock;
    h.contact = r.contact;
    h.fabric = setup.fabric;
    h.platen_friction = r.loading.platen_friction;
    h.confining_pressure = r.loading.confining_pressure;
    h.rate = r.loading.test == TestKind::program ? "program" : name_of(r.loading.rate);
    h.rate_tolerance = r.loading.control_tolerance();
    h.rate_share = r.loading.rate_share;
    h.platen_speed = r.loading.rate == RateKind::automatic ? 0 : r.loading.platen_speed;
    h.damping = r.damping;
    h.damping_form = name_of(r.damping_form);
    h.mass_scaling = r.mass_scaling ? "selective" : "none";
    h.peak_drop = r.peak_drop;
    h.mass_scaling_factor = setup.mass_scaling_factor;
    h.added_mass = setup.added_mass;
    h.stable_time_step = setup.stable_time_step;
    h.time_step = setup.parameters.time_step;
    h.max_strain = program.platens ? program.platens->max_strain : 0;
    return h;
}

/// The run: everything that lives as long as it does.
class Simulation {
public:
    Simulation(const Specimen& specimen, const SimulationRequest& request, const std::string& label, Verbosity verbosity)
        : specimen_(specimen),
          request_(request),
          program_(program_of(request, specimen)),
          is_dynamic_(!request.why_dynamic().empty()),
          setup_(make_setup(specimen, request, program_)),
          gauges_(make_gauges(assemblage_, specimen)),
          transit_time_(bar_transit_time(specimen, request.material.rock)),
          driver_(program_, request.loading.test, assemblage_, specimen, request.material.rock),
          state_(make_state(assemblage_, boundary_, specimen)),
          crack_log_(2 * specimen.n_contacts()),
          header_(make_header(request, program_, setup_)),
          progress_(label, verbosity),
          verbosity_(verbosity),
          team_(worthwhile_threads(request.threads, specimen.n_elements(), request.elements_per_thread)) {
        set_initial_velocities(program_, assemblage_, specimen, state_);
        if (!request.restart.empty()) {
            const SavedState saved = read_saved_state(request.restart, specimen, request, setup_);
            restore(saved);
            if (request.loading.test == TestKind::program && !is_checkpoint(request.restart)) {
                driver_.resume(saved.loading);
            } else {
                go_on(request.restart, saved.loading);
                frames_so_far_ = saved.frames;
            }
        }
    }

    /// Writes the run to an output as it goes; to be called before `run`.
    void write_to(const std::string& output) {
        auto place = std::make_unique<OutputFile>(output);
        const bool is_stream = place->is_stream();
        if (!is_stream) {
            checkpoint_ = checkpoint_of(output);
            make_way_for_checkpoint(checkpoint_, request_.restart, request_.discard_checkpoint);
        }
        writer_.emplace(H5Output(std::move(place), "run"), specimen_, header_);
        frames_.emplace(is_stream && request_.frames < 0 ? 0 : std::abs(request_.frames), 1.0 / 64, *writer_);
        if (frames_so_far_) {
            frames_->go_on(*frames_so_far_, RunReader(request_.restart));
        }
    }

    RunHeader run() {
        if (request_.restart.empty()) {
            start(assemblage_, parameters_, state_);
        }
        if (history_.size() == 0) {
            record();
        }
        while (header_.stop_reason.empty()) {
            stop_if_asked();
            const std::int64_t steps = driver_.interval_steps(parameters_.time_step);
            const IntervalLoading loading = driver_.next(static_cast<double>(steps) * parameters_.time_step);
            advance(assemblage_, boundary_, parameters_, loading, steps, team_, state_);
            record();
            show_progress();
            header_.stop_reason = driver_.stop_reason(axial_strain());
            if (header_.stop_reason.empty() && writes_checkpoint_now()) {
                write_checkpoint();
                since_checkpoint_.restart();
            }
        }
        progress_.finish();
        finish_header();
        return header_;
    }

    /// Completes the file.
    void finish(const std::vector<SensitivityRow>& sensitivity, const Provenance& provenance) {
        frames_->last(assemblage_, parameters_.laws, state_);
        append_rows();
        driver_.write(writer_->file());
        if (request_.save_state) {
            write_saved_state(writer_->file(), state_, driver_.saved(state_.time), largest_balance_error_);
        }
        writer_->finish(header_, crack_log_.rows(assemblage_, state_), provenance, sensitivity);
        if (!checkpoint_.empty()) {
            remove_checkpoint(checkpoint_);
        }
    }
    [[nodiscard]] const CrackLog& crack_log() const { return crack_log_; }
    [[nodiscard]] TestOutcome outcome() const { return {header_, history_}; }
    [[nodiscard]] int threads() const { return team_.size(); }
    [[nodiscard]] std::string vector_target() const { return std::string(name_of(assemblage_.vector_target)); }

private:
    [[nodiscard]] bool writes_checkpoint_now() {
        if (!writer_ || checkpoint_.empty()) {
            return false;
        }
        const bool is_asked = take_checkpoint_request();
        return is_asked || (request_.checkpoint_interval && since_checkpoint_.elapsed() >= *request_.checkpoint_interval);
    }

    /// On a signal, keeps what there is in a checkpoint and ends the run.
    void stop_if_asked() const {
        const bool asked = request_.stops_after && request_.stops_after(history_.size());
        if (stop_signal() == 0 && !asked) {
            return;
        }
        if (writer_ && !checkpoint_.empty()) {
            write_checkpoint();
            if (verbosity_ != Verbosity::quiet) {
                fmt::print(stderr, "{}: the test so far is in {}; the same command with --restart {} resumes it\n", header_.test,
                           checkpoint_, checkpoint_);
            }
        }
        throw Interrupted(stop_signal() != 0 ? stop_signal() : SIGTERM);
    }

    /// A run file of its own, with all rows, cracks and frames so far and the state of now.
    void write_checkpoint() const {
        RunWriter writer(H5Output(OutputFile::covered(checkpoint_), "run"), specimen_, header_);
        writer.append_history(history_);
        driver_.append(writer.file(), 0);
        driver_.write(writer.file());
        const FrameProgress frames = frames_->save(assemblage_, parameters_.laws, state_, writer);
        write_saved_state(writer.file(), state_, driver_.saved(state_.time), largest_balance_error_);
        write_frame_progress(writer.file(), frames);
        RunHeader header = header_;
        header.stop_reason = "checkpoint";
        header.steps = state_.step;
        header.integrations = state_.step;
        header.peak_axial_stress = peak_;
        Provenance provenance;
        provenance.tool = "graincrack-solve";
        provenance.threads = team_.size();
        provenance.vector_target = name_of(assemblage_.vector_target);
        writer.finish(header, crack_log_.rows(assemblage_, state_), provenance);
    }

    /// Resumes where this very run was, after its last row.
    void go_on(const std::string& checkpoint, const StageControllerState& loading) {
        const RunReader run(checkpoint);
        require_same_test(run.name(), run.header(), header_);
        driver_.go_on(loading, run);
        history_ = run.history();
        if (history_[HistoryColumn::time].back() != state_.time ||
            history_[HistoryColumn::step].back() != static_cast<double>(state_.step)) {
            throw InputError(run.name() + ": its state is not that of the last row of its history: the file is damaged");
        }
        for (const double work : history_[HistoryColumn::energy_external]) {
            worked_ = std::max(worked_, std::abs(work));
        }
        last_axial_stress_ = history_[HistoryColumn::axial_stress].back();
        peak_ = run.header().peak_axial_stress;
    }

    void restore(const SavedState& saved) {
        state_ = saved.state;
        crack_log_.restore(saved.cracks);
        header_.energy_scale = saved.energy_scale;
        largest_balance_error_ = saved.energy_balance_error;
    }

    void push(HistoryColumn column, double value) { history_[column].push_back(value); }
    [[nodiscard]] double absolute_stress() const { return std::abs(last_axial_stress_); }
    [[nodiscard]] double axial_strain() const {
        return (state_.loading.platen_displacement[top_platen] - state_.loading.platen_displacement[bottom_platen]) /
               specimen_.height;
    }

    void record() {
        crack_log_.collect(assemblage_, parameters_.time_step, state_);
        const Measurement m = measure(assemblage_, boundary_, parameters_, state_);
        check_stability(m.energies);
        last_axial_stress_ = axial_stress(specimen_, -m.force_bottom, m.force_top);
        follow_damping_load(assemblage_, state_, m.platen_power, mean_transits * transit_time_, state_.damping_load);
        push_row(m);
        rate_ = rate_measures(m);
        driver_.note(view());
        const bool counts = !crack_log_.empty();
        const bool is_highest = counts && absolute_stress() > peak_;
        peak_ = is_highest ? absolute_stress() : peak_;
        if (writer_) {
            const bool has_fallen = counts && absolute_stress() < (1 - peak_frame_drop) * peak_;
            const bool keeps_peak = frames_->peak(is_highest, has_fallen, assemblage_, parameters_.laws, state_);
            const bool keeps_this = frames_->regular(driver_.progress(view()), assemblage_, parameters_.laws, state_);
            const double flush_interval = keeps_peak || keeps_this ? flush_interval_of_frames : longest_flush_interval;
            if (rows_written_ == 0 || since_flush_.elapsed() >= flush_interval) {
                append_rows();
            }
        }
    }

    void append_rows() {
        driver_.append(writer_->file(), rows_written_);
        rows_written_ = history_.size();
        writer_->append_history(history_);
        since_flush_.restart();
    }

    [[nodiscard]] RunView view() const { return {assemblage_, boundary_, state_, history_, rate_, axial_strain()}; }

    [[nodiscard]] RateMeasures rate_measures(const Measurement& m) const {
        const double load = std::abs(m.force_top - m.force_bottom) / 2;
        RateMeasures rate;
        rate.kinetic_energy = m.own_kinetic;
        rate.stored_energy = m.energies.stored();
        rate.unbalanced_ratio = m.unbalanced_ratio;
        rate.force_difference = load > 0 ? std::abs(m.force_top + m.force_bottom) / load : 0;
        rate.damping_load = state_.damping_load.share();
        rate.near_failure = near_failure(assemblage_, parameters_.laws, state_, specimen_.width);
        return rate;
    }

    [[nodiscard]] double judged_energy() const {
        const double stress = judged_stress * request_.contact.tensile_strength;
        const double area = std::accumulate(specimen_.grain_area.begin(), specimen_.grain_area.end(), 0.0);
        return 0.5 * stress * stress / request_.material.rock.young_modulus * area;
    }

    void check_stability(const Energies& energies) {
        // What is dynamic may be all motion, and store next to nothing.
        const double scale = energies.stored() + (is_dynamic_ ? energies.kinetic : 0);
        header_.energy_scale = std::max(header_.energy_scale, scale);
        worked_ = std::max(worked_, std::abs(energies.external));
        // Where next to nothing is stored yet, an error is small or large against what the platens have worked.
        const double judged = std::max(header_.energy_scale, worked_);
        const double residual = judged > 0 ? energies.balance_error() / judged : 0;
        if (!std::isfinite(residual) || (header_.energy_scale > judged_energy() && std::abs(residual) > unstable_residual)) {
            throw_unstable(residual);
        }
        largest_balance_error_ = std::max(largest_balance_error_, std::abs(energies.balance_error()));
    }

    [[noreturn]] void throw_unstable(double residual) const {
        throw NumericalError(
            fmt::format("the run became unstable before step {} (error of the energy balance {:.0f} %); use a smaller "
                        "--time-step-fraction than {} (with this damping below {:.2f}) or a slower --rate",
                        state_.step, 100 * std::abs(residual), request_.time_step_fraction, 1 / std::sqrt(1 + request_.damping)));
    }

    void push_row(const Measurement& m) {
        using enum HistoryColumn;
        const Energies& e = m.energies;
        const double strain = this->axial_strain();
        push(time, state_.time);
        push(step, static_cast<double>(state_.step));
        push(HistoryColumn::axial_strain, strain);
        push(lateral_strain, gauges_.widening.strain(state_.displacement));
        push(gauge_axial_strain, gauges_.axial.strain(state_.displacement));
        push(gauge_lateral_strain, gauges_.lateral.strain(state_.displacement));
        push(HistoryColumn::axial_stress, last_axial_stress_);
        push(force_top, m.force_top);
        push(force_bottom, -m.force_bottom);
        push(confining_pressure, m.membrane_force / (specimen_.height * (1 + strain)));
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
        push(energy_balance_error, header_.energy_scale > 0 ? e.balance_error() / header_.energy_scale : 0);
        push(unbalanced_ratio, m.unbalanced_ratio);
        push(tensile_cracks, 0.5 * static_cast<double>(crack_log_.tensile_points()));
        push(shear_cracks, 0.5 * static_cast<double>(crack_log_.shear_points()));
        push(platen_speed, driver_.platen_speed());
        push(damping_load, state_.damping_load.share());
        push(energy_numerical, e.numerical);
    }

    void show_progress() {
        progress_.update(driver_.progress(view()),
                         fmt::format("stress {:.1f} MPa, contacts that failed: {} open, {} closed", absolute_stress() * 1e-6,
                                     whole_contacts(crack_log_.tensile_points()), whole_contacts(crack_log_.shear_points())));
    }

    void finish_header() {
        header_.steps = state_.step;
        header_.integrations = state_.step;
        driver_.complete(header_, state_.time);
        complete_header(history_, specimen_.width, header_);
        header_.energy_balance_error = header_.energy_scale > 0 ? largest_balance_error_ / header_.energy_scale : 0;
        if (const double judged = std::max(header_.energy_scale, worked_); largest_balance_error_ > unstable_residual * judged) {
            throw_unstable(largest_balance_error_ / judged);
        }
    }

    const Specimen& specimen_;
    const SimulationRequest& request_;
    Program program_;
    bool is_dynamic_;
    Setup setup_;
    const Assemblage& assemblage_ = setup_.assemblage;
    const Boundary& boundary_ = setup_.boundary;
    const StepParameters& parameters_ = setup_.parameters;
    Gauges gauges_;
    double transit_time_;  ///< of a bar wave over the height, s
    ProgramDriver driver_;
    State state_;
    CrackLog crack_log_;
    RunHeader header_;
    Progress progress_;
    Verbosity verbosity_;
    History history_;
    ThreadTeam team_;
    RateMeasures rate_;  ///< of the last row
    std::size_t rows_written_ = 0;
    double worked_ = 0;                 ///< largest external work so far, absolute, J
    double largest_balance_error_ = 0;  ///< of the energy balance, J
    double last_axial_stress_ = 0;      ///< tension positive, Pa
    double peak_ = 0;                   ///< of it since contacts have failed, absolute, Pa
    std::optional<RunWriter> writer_;
    std::optional<FrameOutput> frames_;
    std::optional<FrameProgress> frames_so_far_;  ///< of the checkpoint that the run resumes from
    std::string checkpoint_;                      ///< its file
    WallClock since_checkpoint_{request_.wall_clock};
    WallClock since_flush_{request_.wall_clock};
};

}  // namespace

TestOutcome run_test(const Specimen& specimen, const SimulationRequest& request, const std::string& label, Verbosity verbosity) {
    Simulation simulation(specimen, request, label, verbosity);
    simulation.run();
    return simulation.outcome();
}

SimulationSummary simulate(const Specimen& specimen, const SimulationRequest& request, const std::string& output,
                           Verbosity verbosity, Provenance provenance) {
    const auto begin = std::chrono::steady_clock::now();
    Simulation simulation(specimen, request, std::string(name_of(request.loading.test)), verbosity);
    simulation.write_to(output);
    SimulationSummary summary;
    summary.header = simulation.run();
    summary.equilibrium_warning = equilibrium_warning(summary.header, simulation.outcome().history);
    summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    summary.ns_per_grain_step =
        1e9 * summary.wall_time / (static_cast<double>(summary.header.integrations) * static_cast<double>(specimen.n_grains()));
    summary.tensile_cracks = whole_contacts(simulation.crack_log().tensile_points());
    summary.shear_cracks = whole_contacts(simulation.crack_log().shear_points());
    if (request.sensitivity) {
        summary.sensitivity = find_sensitivity(specimen, request, simulation.outcome(), verbosity);
    }
    provenance.wall_time = summary.wall_time;
    provenance.threads = simulation.threads();
    provenance.vector_target = simulation.vector_target();
    simulation.finish(summary.sensitivity, provenance);
    return summary;
}

}  // namespace graincrack
