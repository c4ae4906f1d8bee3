// The request of a run, besides the specimen.
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

/// The time of the machine's clock that is never set, s.
inline double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What a run is made of: the law and the values of its contacts.
struct MaterialRequest {
    Material material;                                    ///< with the contact parameters to use
    ContactParameters contact;                            ///< derived from it, validated
    std::optional<FractureEnergyChoice> fracture_energy;  ///< in place of the material's
    std::string fracture_energy_choice = "mode-i";
    PlaneCondition plane = PlaneCondition::strain;
    LawVariant law = default_law;
};

/// How a run begins and what is kept of it.
struct RecordRequest {
    std::string restart;                        ///< run file from whose saved state a program starts, checkpoint of a test, or ""
    bool save_state = false;                    ///< at the end, for another run to start from
    std::optional<double> checkpoint_interval;  ///< of wall time from one checkpoint to the next, s (`checkpoint_of`)
    std::function<double()> wall_clock = steady_seconds;  ///< that `checkpoint_interval` counts, s
    bool discard_checkpoint = false;                      ///< of a run of the same output that has not ended
    /// Asked after each row of the history, with the number of rows: whether to stop there with a checkpoint, as on a signal.
    std::function<bool(std::size_t)> stops_after;
    bool sensitivity = false;  ///< run again with one thing changed at a time
    int frames = 20;
    Settings settings;  ///< of the options by which the run was asked for, for its file
};

/// What computes a run; results do not depend on it.
struct MachineRequest {
    const Ranks* ranks = &Ranks::alone();       ///< that share the work
    int threads = 1;                            ///< of each rank, at most
    std::optional<VectorTarget> vector_target;  ///< `widest_vector_target` unless given
    /// At least: some 5 µs a step, against two barriers of up to 1 µs each. With 140 a step took half the time of 280 (sixteen
    /// processors, `share/results/benchmark`).
    std::size_t elements_per_thread = 150;

    /// Threads of a rank that are worth having.
    [[nodiscard]] int threads_for(std::size_t n_elements) const {
        const std::size_t share = n_elements / static_cast<std::size_t>(ranks->size());
        return std::max(1, std::min(threads, static_cast<int>(share / std::max<std::size_t>(elements_per_thread, 1))));
    }
};

/// Everything a run is made of, besides the specimen.
struct SimulationRequest : MaterialRequest, RecordRequest, MachineRequest {
    LoadingRequest loading;          ///< of a standard test; of a program only what platens are like
    std::optional<Program> program;  ///< to run; that of the standard test if missing (`program_of`)
    double peak_drop = 0.3;          ///< of a standard test; 0: it continues to the strain limit
    double damping = 0.8;
    DampingForm damping_form = DampingForm::combined;
    bool mass_scaling = false;                  ///< selective; the command line asks for it unless the test is dynamic
    std::optional<double> mass_scaling_factor;  ///< β; `sufficient_mass_scaling` unless given
    double time_step_fraction = 0.7;

    /// Why the run is not quasi-static, so that mass scaling would falsify it: it has no damping, or its program makes waves
    /// (`Program::why_dynamic`); "" for what is quasi-static, as all standard tests with damping are.
    [[nodiscard]] std::string why_dynamic() const {
        if (damping == 0) return "it has no damping";
        return program ? program->why_dynamic() : "";
    }
};

}  // namespace graincrack
