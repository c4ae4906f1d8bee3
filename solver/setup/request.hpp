// What a run is asked for, apart from the specimen.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "share/file/settings.hpp"
#include "share/rock/material.hpp"
#include "solver/arithmetic/simd.hpp"
#include "solver/law/contact_law.hpp"
#include "solver/law/damping.hpp"
#include "solver/program/program.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/ranks/ranks.hpp"

namespace graincrack {

/// Time of the monotonic clock of the machine, s. Changes of the date do not affect it.
inline double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The contact law and material values of a run.
struct MaterialRequest {
    Material material;                                    ///< the material with the contact parameters to use
    ContactParameters contact;                            ///< contact parameters derived from it, validated
    std::optional<FractureEnergyChoice> fracture_energy;  ///< overrides the material's choice
    std::string fracture_energy_choice = "mode-i";
    PlaneCondition plane = PlaneCondition::strain;
    LawVariant law = default_law;
};

/// The start of a run and the files that it writes.
struct RecordRequest {
    std::string restart;      ///< run file with the saved state from which a program starts, or checkpoint of a test; or ""
    bool save_state = false;  ///< saves the final state, from which another run can start
    std::optional<double> checkpoint_interval;            ///< wall time between checkpoints, s (`checkpoint_of`)
    std::function<double()> wall_clock = steady_seconds;  ///< the clock of `checkpoint_interval`, s
    bool discard_checkpoint = false;                      ///< discards the checkpoint of an unfinished run with the same output
    /// Called after each row of the history with the number of rows; true stops the run with a checkpoint, as a signal does.
    std::function<bool(std::size_t)> stops_after;
    bool sensitivity = false;  ///< repeats the run with one setting changed at a time
    int frames = 20;
    Settings settings;  ///< options of the run, as recorded in its file
};

/// The processors that compute a run. Results do not depend on them.
struct MachineRequest {
    const Ranks* ranks = &Ranks::alone();       ///< ranks that share the work
    int threads = 1;                            ///< largest number of threads of each rank
    std::optional<VectorTarget> vector_target;  ///< missing: `widest_vector_target`
    /// Smallest number of elements for a thread: about 5 µs of work a step, against two barriers of up to 1 µs each. Measured:
    /// with 140 a step took half the time of 280 (16 processors, `share/results/benchmark`).
    std::size_t elements_per_thread = 150;

    /// Number of threads of a rank that shorten a step.
    [[nodiscard]] int threads_for(std::size_t n_elements) const {
        const std::size_t share = n_elements / static_cast<std::size_t>(ranks->size());
        return std::max(1, std::min(threads, static_cast<int>(share / std::max<std::size_t>(elements_per_thread, 1))));
    }
};

/// The complete request of a run, apart from the specimen.
struct SimulationRequest : MaterialRequest, RecordRequest, MachineRequest {
    LoadingRequest loading;          ///< loading of a standard test; a program uses its platens' properties only
    std::optional<Program> program;  ///< program to run; missing: that of the standard test (`program_of`)
    double peak_drop = 0.3;          ///< fall that ends a standard test, as a fraction of the peak; 0: none
    double damping = 0.8;
    DampingForm damping_form = DampingForm::combined;
    bool mass_scaling = false;                  ///< selective mass scaling; the command line sets it unless the test is dynamic
    std::optional<double> mass_scaling_factor;  ///< β; missing: `sufficient_mass_scaling`
    double time_step_fraction = 0.7;

    /// Returns why the run is not quasi-static, so that mass scaling would falsify it: it has no damping, or its program makes
    /// waves (`Program::why_dynamic`). It returns "" for a quasi-static run, such as each standard test with damping.
    [[nodiscard]] std::string why_dynamic() const {
        if (damping == 0) return "it has no damping";
        return program ? program->why_dynamic() : "";
    }
};

}  // namespace graincrack
