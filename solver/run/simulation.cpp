#include "solver/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <utility>

#include "share/base/error.hpp"
#include "share/file/equilibrium.hpp"
#include "share/file/peak.hpp"
#include "solver/run/recorder.hpp"
#include "solver/run/run_output.hpp"
#include "solver/run/sensitivity.hpp"
#include "solver/setup/regions.hpp"
#include "solver/step/step.hpp"

namespace graincrack {
namespace {

RunHeader make_header(const SimulationRequest& r, const Program& program, const Setup& setup) {
    RunHeader h;
    static_cast<MaterialSettings&>(h) = setup.material;
    h.test = name_of(r.loading.test);
    h.platen_friction = r.loading.platen_friction;
    h.confining_pressure = r.loading.confining_pressure;
    h.heat = r.loading.heat;
    h.cooled = r.loading.cool ? 1 : 0;
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
    h.span = description_of(r.loading.test).loading == Loading::bending ? program.platens->span() : 0;
    h.request = r.settings;
    return h;
}

/// The run: everything that lives as long as it does.
class Simulation {
public:
    Simulation(const Specimen& specimen, const SimulationRequest& request, const std::string& label, Verbosity verbosity)
        : specimen_(specimen),
          request_(request),
          program_(program_of(request, specimen)),
          setup_(make_setup(specimen, request, program_)),
          driver_(program_, request.loading.test, setup_.assemblage, specimen, request.material.rock),
          state_(make_state(setup_.assemblage, setup_.boundary, specimen)),
          recorder_(specimen, request, setup_),
          header_(make_header(request, program_, setup_)),
          progress_(label, request.ranks->is_first() ? verbosity : Verbosity::quiet),
          verbosity_(verbosity),
          team_(request.threads_for(specimen.n_elements())) {
        set_initial_velocities(program_, setup_.assemblage, specimen, state_);
        if (begins_without_platens() && request.restart.empty()) remove_platens(state_);
        if (!request.restart.empty()) restart();
        if (program_.has_temperature()) take_temperature(setup_.assemblage, state_);
        if (state_.thermal.empty()) header_.fabric.phases = without_expansion(header_.fabric.phases);
        if (setup_.parameters.laws.wear()) state_.worn.resize(setup_.assemblage.n_nodes());
    }

    /// Writes the run to an output as it goes; to be called before `run`.
    void write_to(const std::string& output, Provenance provenance) {
        provenance.threads = team_.most();
        provenance.ranks = request_.ranks->size();
        provenance.vector_target = name_of(setup_.assemblage.vector_target);
        output_.emplace(Run{specimen_, request_, setup_, driver_, state_, recorder_, header_, team_, provenance}, output,
                        frames_);
    }

    const RunHeader& run() {
        if (request_.restart.empty()) start(setup_.assemblage, setup_.parameters, state_);
        if (recorder_.history().size() == 0) record();
        while (header_.stop_reason.empty()) {
            stop_if_asked();
            const std::int64_t steps = driver_.stages().interval_steps(header_.time_step);
            const IntervalLoading loading = driver_.next(static_cast<double>(steps) * header_.time_step);
            advance(setup_.assemblage, setup_.boundary, setup_.parameters, loading, steps, team_, state_);
            record();
            show_progress();
            header_.stop_reason = driver_.stop_reason();
            const bool goes_on = header_.stop_reason.empty();
            if (goes_on && output_) keep_checkpoints();
        }
        if (output_) output_->wait();
        progress_.finish();
        finish_header();
        return header_;
    }

    /// Completes the file. \param wall_time of the run, s
    void finish(const std::vector<SensitivityRow>& sensitivity, double wall_time) { output_->finish(sensitivity, wall_time); }
    /// \param wall_time of the run, s
    [[nodiscard]] RankSummary rank_summary(double wall_time) const {
        const Ranks& ranks = *request_.ranks;
        const MessageCounts counts = ranks.counts();
        std::array<double, 3> most{static_cast<double>(setup_.assemblage.part.own_nodes().size())};
        if (state_.ghosts) most[1] = static_cast<double>(state_.ghosts->n_ghosts());
        if (state_.ghosts) most[2] = static_cast<double>(state_.ghosts->n_neighbours());
        ranks.take_largest(most);
        std::array<std::int64_t, 3> sums{counts.bytes, counts.messages, static_cast<std::int64_t>(1e9 * counts.waited)};
        ranks.take_sums(sums);
        const double steps = std::max<double>(static_cast<double>(state_.step), 1) * ranks.size();
        return {ranks.size(),
                most[0],
                most[1],
                most[2],
                static_cast<double>(sums[0]) / steps,
                static_cast<double>(sums[1]) / steps,
                1e-9 * static_cast<double>(sums[2]) / (ranks.size() * wall_time),
                share_step(setup_.assemblage, setup_.boundary, &state_, team_.most()).balance,
                team_.mean_size()};
    }
    [[nodiscard]] const CrackLog& crack_log() const { return recorder_.crack_log(); }
    [[nodiscard]] const std::vector<std::string>& overshoots() const { return driver_.stages().overshoots(); }
    [[nodiscard]] TestOutcome outcome() const { return {header_, recorder_.history()}; }

private:
    /// Starts from the end of another run or resumes this very one from its checkpoint, after its last row.
    void restart() {
        const SavedState saved = read_saved_state(request_.restart, specimen_, request_, setup_);
        state_ = saved.state;
        recorder_.restore(saved);
        header_.energy_scale = recorder_.energy().scale();
        const RunReader run(request_.restart);
        header_.heat = run.header().heat;
        if (request_.loading.test == TestKind::program && !is_checkpoint(run)) {
            if (begins_without_platens() && !has_absent_platens()) {
                throw InputError(fmt::format("{}: stage.{}: platens: are there already in {}; they cannot be absent any more",
                                             program_.file, program_.order.front(), run.name()));
            }
            driver_.take_over(saved.loading);
            return;
        }
        if (state_.thermal.empty()) header_.fabric.phases = without_expansion(header_.fabric.phases);
        require_same_test(run.name(), run.header(), header_);
        driver_.resume(saved.loading, run);
        recorder_.resume(run, state_);
        frames_ = saved.frames;
    }

    [[nodiscard]] bool begins_without_platens() const { return program_.stage(program_.order.front()).without_platens; }
    [[nodiscard]] bool has_absent_platens() const {
        return !state_.platen_points.empty() && state_.platen_points.front().is_absent();
    }

    void record() {
        const Feedback feedback = recorder_.record(driver_.stages().platens().speed(), team_, state_);
        header_.energy_scale = recorder_.energy().scale();
        if (request_.loading.test == TestKind::program) take_heat(state_.loading.temperature);
        header_.steps = state_.step;
        header_.integrations = state_.step;
        driver_.record(setup_.assemblage, setup_.boundary, state_, recorder_.history(), feedback);
        const StageController& stages = driver_.stages();
        if (has_absent_platens() && !stages.finished() && !stages.is_without_platens()) {
            place_platens(setup_.assemblage, setup_.boundary, state_);
            recorder_.restart(state_);
        }
        driver_.start_next(recorder_.history());
        if (output_) output_->record();
    }

    /// What a program does to the temperature decides by which rule a fall of the stress is a peak.
    void take_heat(double temperature) {
        if (std::abs(temperature) > std::abs(header_.heat)) header_.heat = temperature;
        header_.cooled = header_.heat != 0 && temperature == 0 ? 1 : 0;
    }

    /// On a signal, keeps what there is in a checkpoint and ends the run.
    void stop_if_asked() {
        const bool asked = request_.stops_after && request_.stops_after(recorder_.history().size());
        const int own = stop_signal() != 0 ? stop_signal() : asked ? SIGTERM : 0;
        const int signal = static_cast<int>(request_.ranks->largest(own));
        if (signal == 0) return;
        const std::string checkpoint = output_ ? output_->write_checkpoint() : "";
        if (output_) output_->require_checkpoint();
        if (!checkpoint.empty()) {
            add_to_outcome("checkpoint", checkpoint);
            say(diagnostics(verbosity_),
                fmt::format("{}: the test so far is in {}; the same command with --restart {} resumes it", header_.test,
                            checkpoint, checkpoint));
        }
        throw Interrupted(signal);
    }

    /// What is wrong with them is told once.
    void keep_checkpoints() {
        const std::string problem = tells_of_problem_ ? output_->checkpoint_problem() : "";
        if (!problem.empty()) {
            tells_of_problem_ = false;
            warn(diagnostics(verbosity_), header_.test,
                 {problem + "; the run goes on, and tries again at its next checkpoint", "checkpoint"}, "");
        }
        if (!output_->wants_checkpoint()) return;
        output_->write_checkpoint();
        const double least = output_->least_checkpoint_interval();
        if (tells_of_interval_ && least > request_.checkpoint_interval.value_or(least)) {
            tells_of_interval_ = false;
            say(diagnostics(verbosity_), fmt::format("{}: a checkpoint takes {:.2g} s, so that one is written every {:.2g} s",
                                                     header_.test, least / 10, least));
        }
    }

    void show_progress() {
        const ModeCounts cracks = crack_log().counts(header_.crack_event);
        const std::string state = driver_.stages().is_without_platens()
                                      ? fmt::format("temperature {:+.0f} K", state_.loading.temperature)
                                      : (header_.loading() == Loading::bending ? "load " : "stress ") +
                                            load_text(header_, recorder_.axial_stress(), specimen_.width);
        progress_.update(driver_.stages().progress(), fmt::format("{}, cracks: {} tensile, {} shear", state,
                                                                  std::ceil(cracks.tensile), std::ceil(cracks.shear)));
    }

    void finish_header() {
        driver_.complete(header_);
        complete_header(recorder_.history(), specimen_.width, header_);
        header_.energy_balance_error = recorder_.energy().relative(recorder_.energy().largest_error());
        recorder_.energy().check_end(state_.step);
    }

    const Specimen& specimen_;
    const SimulationRequest& request_;
    Program program_;
    Setup setup_;
    ProgramDriver driver_;
    State state_;
    Recorder recorder_;
    RunHeader header_;
    Progress progress_;
    Verbosity verbosity_;
    ThreadTeam team_;
    std::optional<FrameProgress> frames_;  ///< of the checkpoint that the run resumes from
    std::optional<RunOutput> output_;
    bool tells_of_interval_ = true, tells_of_problem_ = true;  ///< once
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
    simulation.write_to(output, std::move(provenance));
    SimulationSummary summary;
    summary.header = simulation.run();
    const History& history = simulation.outcome().history;
    const auto strength = find_strength(summary.header, history, sign_of_strength(summary.header, history));
    if (strength) summary.strength = strength->stress;
    const ModeCounts before = simulation.crack_log().counts(summary.header.crack_event, summary.header.isotropic_end_time);
    summary.cracks_before = before.tensile + before.shear;
    summary.equilibrium_warning = equilibrium_warning(summary.header, history);
    if (summary.header.loading() == Loading::program) summary.overshoots = simulation.overshoots();
    summary.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    summary.ns_per_grain_step =
        1e9 * summary.wall_time / (static_cast<double>(summary.header.integrations) * static_cast<double>(specimen.n_grains()));
    summary.cracks = simulation.crack_log().counts(summary.header.crack_event);
    summary.ranks = simulation.rank_summary(summary.wall_time);
    if (request.sensitivity) {
        try {
            const auto run = [&](const Specimen& s, const SimulationRequest& r, const std::string& label) {
                return run_test(s, r, label, verbosity);
            };
            summary.sensitivity = find_sensitivity(specimen, request, simulation.outcome(), run);
        } catch (const Interrupted&) {
            simulation.finish({}, summary.wall_time);
            say(diagnostics(verbosity),
                fmt::format("{}: {} has the test without its sensitivities; the same command{} starts it anew",
                            summary.header.test, output, request.restart.empty() ? "" : " without --restart"));
            throw;
        }
    }
    simulation.finish(summary.sensitivity, summary.wall_time);
    return summary;
}

}  // namespace graincrack
