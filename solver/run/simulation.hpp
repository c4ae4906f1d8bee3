// A run from specimen to run file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "share/material.hpp"
#include "share/progress.hpp"
#include "share/provenance.hpp"
#include "share/run_file.hpp"
#include "solver/law/contact_law.hpp"
#include "solver/law/damping.hpp"
#include "solver/loading/standard_tests.hpp"
#include "solver/setup/program.hpp"
#include "solver/simd.hpp"

namespace graincrack {

/// Everything a run is made of, besides the specimen.
struct SimulationRequest {
    LoadingRequest loading;          ///< of a test; of a program only what platens are like
    std::optional<Program> program;  ///< instead of one of the four tests
    Material material;               ///< with the contact parameters to use
    ContactParameters contact;       ///< derived from it, validated
    std::string fracture_energy_choice = "mode-i";
    PlaneCondition plane = PlaneCondition::strain;
    LawVariant law = LawVariant::consistent;
    Coupling coupling = Coupling::full;
    double peak_drop = 0.3;
    double damping = 0.8;
    DampingForm damping_form = DampingForm::combined;
    bool mass_scaling = false;                  ///< selective
    std::optional<double> mass_scaling_factor;  ///< β; `sufficient_mass_scaling` unless given
    double time_step_fraction = 0.7;
    bool save_state = false;                    ///< at the end, for another run to go on from
    std::string restart;                        ///< run file of whose saved state a program goes on, checkpoint of a test, or ""
    std::optional<double> checkpoint_interval;  ///< of wall time from one checkpoint to the next, s (`checkpoint_of`)
    bool sensitivity = false;                   ///< run again with one thing changed at a time
    int frames = 20;
    int threads = 1;                            ///< at most
    std::optional<VectorTarget> vector_target;  ///< `widest_vector_target` unless given
    std::size_t elements_per_thread = 250;      ///< at least: some 15 µs a step, against two barriers of up to 1 µs each
};

/// Size and length of a run before it is started.
struct SimulationPlan {
    std::size_t grains = 0, elements = 0, nodes = 0, contacts = 0;
    double stable_time_step = 0;  ///< s
    double time_step = 0;         ///< s
    std::int64_t max_steps = 0;   ///< to the strain cap, without an isotropic stage
    std::size_t memory = 0;       ///< of the state and the assemblage, bytes
    std::size_t file_size = 0;    ///< at most, before compression, bytes
};

SimulationPlan plan_simulation(const Specimen& specimen, const SimulationRequest& request);

/// What a finished run tells its user.
struct SimulationSummary {
    RunHeader header;
    std::size_t tensile_cracks = 0;  ///< contacts
    std::size_t shear_cracks = 0;
    double wall_time = 0;  ///< s
    double ns_per_grain_step = 0;
    std::vector<SensitivityRow> sensitivity;  ///< if asked for
};

/// A test that was run and not written.
struct TestOutcome {
    RunHeader header;
    History history;
};
/// Row of the largest axial stress in the sense of the test: tension pulls, all others press. \pre the history has rows
std::size_t peak_row(const RunHeader& header, const History& history);

/// Runs the test and writes nothing. \param label what the progress says
/// \throws NumericalError, Interrupted
TestOutcome run_test(const Specimen& specimen, const SimulationRequest& request, const std::string& label, Verbosity verbosity);

/// Runs the test and writes the run file to `output` ("-": stdout).
/// \throws NumericalError if the run becomes unstable, Interrupted on a signal, OutputError
SimulationSummary simulate(const Specimen& specimen, const SimulationRequest& request, const std::string& output,
                           Verbosity verbosity, Provenance provenance);

}  // namespace graincrack
