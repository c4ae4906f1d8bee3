#include "solver/solve_options.hpp"

#include <fmt/format.h>

#include <cctype>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "share/base/error.hpp"
#include "share/base/shared_file.hpp"
#include "share/base/units.hpp"
#include "share/file/output_file.hpp"
#include "share/options/command_line.hpp"
#include "solver/contact_options.hpp"
#include "solver/program/program_file.hpp"
#include "solver/restart/checkpoint.hpp"

namespace graincrack {
namespace {

const char* const examples =
    "  graincrack-solve uniaxial specimen.h5 --material augig-granite -o uniaxial.h5\n"
    "  graincrack-solve triaxial specimen.h5 --material augig-granite --confining-pressure 4MPa --rate 5mm/s -o triaxial.h5";

const char* const program_examples =
    "  graincrack-solve program specimen.h5 --material augig-granite --program unload-reload -o cycles.h5\n"
    "  graincrack-solve program bar.h5 --material augig-granite --plane stress --program pulse -o pulse.h5";

/// Values of options that end in a request only together with the material.
struct RawOptions {
    ContactOptions contact;
    std::optional<double> platen_friction, heat, confining_pressure, rate_tolerance, block_speed;
    std::optional<std::int64_t> block_steps;
    std::optional<double> rate_share, mass_scaling_factor, walltime;
    std::optional<bool> mass_scaling;
    std::string program;   ///< its file
    double damping = NAN;  ///< of a program; NaN if not given
};

/// --rate auto|blocks|SPEED
void read_rate(const std::string& text, LoadingRequest& loading) {
    for (const RateKind kind : {RateKind::automatic, RateKind::blocks}) {
        if (text == name_of(kind)) {
            loading.rate = kind;
            return;
        }
    }
    if (!text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0) {
        throw UsageError("--rate: \"" + text + "\" is neither a speed such as 5mm/s nor one of the words auto, blocks");
    }
    loading.rate = RateKind::fixed;
    loading.platen_speed = parse_quantity(text, quantity::platen_speed, "--rate");
    note_bare_number(text, quantity::platen_speed, "--rate");
}

void add_rate_options(OptionSet command, LoadingRequest& loading, RawOptions& raw, const TestDescription& test) {
    add_value(
        command, "--rate", [&loading](const std::string& text) { read_rate(text, loading); }, quantity::platen_speed,
        "speed of each platen; auto: as fast as quasi-static equilibrium allows; blocks: loading and equilibration alternate",
        "auto|blocks|SPEED", "auto")
        .of(SettingGroup::rate, [&loading]() -> SettingValue {
            if (loading.rate == RateKind::fixed) return loading.platen_speed;
            return std::string(name_of(loading.rate));
        });
    add_quantity(
        command.usual(), "--rate-tolerance", raw.rate_tolerance, quantity::rate_tolerance,
        fmt::format(
            "tolerance of quasi-static loading: relative load increase per wave transit (auto; default {}), or unbalanced-force "
            "ratio regarded as equilibrium (blocks; default {})",
            test.rate_tolerance, default_rest_tolerance))
        .of(SettingGroup::rate, [&loading] { return loading.control_tolerance(); });
    add_quantity(command, "--block-speed", raw.block_speed, quantity::platen_speed,
                 "speed of each platen in a block; default 5mm/s")
        .of(SettingGroup::rate,
            [&loading] { return loading.rate == RateKind::blocks ? SettingValue(loading.platen_speed) : SettingValue(); });
    add_quantity(command, "--rate-share", raw.rate_share, quantity::rate_share,
                 "factor on all platen speeds and limits of the automatic rate; default 1")
        .of(SettingGroup::rate, [&loading] { return loading.rate_share; });
    add_integer(command, "--block-steps", raw.block_steps, "number of steps of a block; default 5000", std::int64_t{5})
        .of(SettingGroup::rate, [&loading] {
            return loading.rate == RateKind::blocks ? SettingValue(static_cast<double>(loading.block_steps)) : SettingValue();
        });
}

/// \throws UsageError where an option does not belong to the chosen --rate
void complete_rate(LoadingRequest& loading, const RawOptions& raw) {
    if (raw.rate_tolerance && loading.rate == RateKind::fixed) {
        throw UsageError("--rate-tolerance: a fixed rate has none; give --rate auto or blocks, or leave it out");
    }
    if ((raw.block_speed || raw.block_steps) && loading.rate != RateKind::blocks) {
        throw UsageError(std::string(raw.block_speed ? "--block-speed" : "--block-steps") +
                         ": there are no blocks; give --rate blocks, or leave it out");
    }
    if (raw.rate_share && loading.rate != RateKind::automatic) {
        throw UsageError("--rate-share: belongs to the automatic rate; give --rate auto, or leave it out");
    }
    loading.rate_share = raw.rate_share.value_or(loading.rate_share);
    if (loading.rate == RateKind::blocks) {
        loading.rest_tolerance = raw.rate_tolerance.value_or(loading.rest_tolerance);
    } else {
        loading.rate_tolerance = raw.rate_tolerance;
    }
    loading.block_steps = raw.block_steps.value_or(loading.block_steps);
    if (loading.rate == RateKind::blocks) loading.platen_speed = raw.block_speed.value_or(loading.platen_speed);
}

void add_method_options(OptionSet command, SimulationRequest& request, RawOptions& raw) {
    add_choice<DampingForm>(command, "--damping-form", request.damping_form,
                            {{"combined", DampingForm::combined}, {"local", DampingForm::local}},
                            "combined: half opposes the motion, half follows the rate of the force, so that steady sliding is "
                            "hardly resisted; local: all of it opposes the motion")
        .of(SettingGroup::loading);
    add_choice<std::optional<bool>>(
        command, "--mass-scaling", raw.mass_scaling, {{"none", false}, {"selective", true}},
        "selective: mass is added to the relative motion of nodes across contacts, which allows a time step about ten times as "
        "long; default: selective, but none for tests without damping and for programs that make waves")
        .of(SettingGroup::loading, [&request] { return std::string(request.mass_scaling ? "selective" : "none"); });
    add_quantity(command, "--mass-scaling-factor", raw.mass_scaling_factor, quantity::mass_scaling_factor,
                 "ratio of added to real mass in relative motion across contacts; default: large enough that the grains, not the "
                 "contacts, limit the time step")
        .of(SettingGroup::loading);
    add_quantity(command, "--time-step-fraction", request.time_step_fraction, quantity::time_step_fraction,
                 "time step over the stable time step of undamped motion; with damping it must be below 1/sqrt(1 + damping)",
                 "0.7")
        .of(SettingGroup::loading);
    add_flag(command, "--save-state", request.save_state,
             "store the final state in the run file, so that a program can start from it")
        .of(SettingGroup::none);
    add_integer(command.usual(), "--frames", request.frames,
                "number of frames to store, evenly spaced (at most twice as many), besides those at the peak and the end; 0: the "
                "end only",
                0)
        .of(SettingGroup::none);
    add_threads(command.usual(), request.threads);
    add_choice<std::optional<VectorTarget>>(
        command, "--vector", request.vector_target,
        {{"auto", std::nullopt}, {"plain", VectorTarget::plain}, {"avx2", VectorTarget::avx2}, {"avx512", VectorTarget::avx512}},
        "vector instructions to use; auto: the widest that the processor has");
}

void add_checkpoint_options(OptionSet command, SimulationRequest& request, RawOptions& raw) {
    static constexpr Quantity walltime{"walltime", Dimension::time, 0, 1e7, "wall time of a run", true};
    add_quantity(command, "--walltime", raw.walltime, walltime,
                 "stop after this wall-clock time as on SIGTERM: write RUN.checkpoint and end with exit code 143");
    add_quantity(command.usual(), "--checkpoint-every", request.checkpoint_interval, quantity::checkpoint_interval,
                 "wall-clock interval between checkpoints (RUN.checkpoint, removed when the run is complete)");
    add_flag(command, "--discard-checkpoint", request.discard_checkpoint,
             "start again although RUN.checkpoint exists, and remove it; without this option such a start is refused");
}

void add_sensitivity_flag(OptionSet command, SimulationRequest& request) {
    add_flag(
        command, "--sensitivity", request.sensitivity,
        "repeat the test with half the loading rate, half the time step, half the damping, a quarter of the mass scaling and "
        "twice the elements along an edge; print the changes of the results and store them in the run file")
        .of(SettingGroup::none);
}

void add_run_options(OptionSet command, SimulationRequest& request, RawOptions& raw, const TestDescription& test) {
    LoadingRequest& loading = request.loading;
    const bool rolls = test.loading == Loading::bending;
    if (rolls) {
        static constexpr Quantity gauge{"gauge", Dimension::length, 0, 1e4, "length of a gauge over the mouth of a notch", true};
        static constexpr Quantity mouth_opening{"opening", Dimension::length, 0, 1, "elongation of such a gauge", true};
        add_quantity(command.usual(), "--span", loading.span, quantity::span,
                     "distance of the lower rollers, which stand at the nodes next to its ends; default: four heights of a beam, "
                     "0.6 diameters of a half-disc")
            .of(SettingGroup::size);
        add_quantity(
            command, "--roller-width", loading.roller_width, quantity::roller_width,
            "width of the flat faces of the rollers; default: the mean edge of the boundary, so that each meets one node")
            .of(SettingGroup::loading);
        add_quantity(command, "--mouth-gauge", loading.mouth_gauge, gauge,
                     "record the elongation of a gauge of this length over the mouth of the notch (`history --probe mouth`)")
            .of(SettingGroup::none);
        add_quantity(command, "--mouth-opening", loading.mouth_opening, mouth_opening,
                     "elongation of that gauge at which the test ends; default: none")
            .of(SettingGroup::end);
    }
    if (test.is_confined) {
        add_quantity(command, "--confining-pressure", raw.confining_pressure, quantity::confining_pressure,
                     "confining pressure on the lateral edges")
            .of(SettingGroup::pressure)
            .required();
    }
    add_quantity(command, "--heat", raw.heat, quantity::heat,
                 "heat the free specimen by so much before the test, below 0 cool it, as fast as equilibrium allows; platens are "
                 "placed afterwards "
                 "where its faces then are, and strains count from there")
        .of(SettingGroup::heat);
    add_flag(command, "--cool", loading.cool, "bring it back before the test").of(SettingGroup::heat);
    add_quantity(command, "--platen-friction", raw.platen_friction, quantity::platen_friction,
                 rolls ? "friction angle between rock and rollers; default: 0, since they roll"
                       : "friction angle between rock and platens; default: the material's")
        .of(SettingGroup::loading, [&loading] { return loading.platen_friction; });
    add_rate_options(command, loading, raw, test);
    add_quantity_or(command, "--peak-drop", request.peak_drop, quantity::peak_drop, "none", 0,
                    "fall of the stress that ends the test, as a fraction of the peak; none: continue to --max-strain", "0.3")
        .of(SettingGroup::end);
    add_quantity(command.usual(), "--max-strain", loading.max_strain, quantity::max_strain,
                 "strain limit: platen travel over specimen height at which the test ends", "0.015")
        .of(SettingGroup::end);
    add_quantity_or(command, "--damping", request.damping, quantity::damping, "none", 0,
                    "damping force as a fraction of the unbalanced force", "0.8")
        .of(SettingGroup::loading);
    add_checkpoint_options(command, request, raw);
    add_text(command.usual(), "--restart", request.restart, "checkpoint of this test, to resume it").type_name("FILE");
    add_sensitivity_flag(command, request);
    add_method_options(command, request, raw);
}

OptionSet add_test(OptionSet tool, SolveOptions& options, RawOptions& raw, CommonOptions& common, const TestDescription& test) {
    OptionSet command = tool.add_subcommand(std::string(test.name), std::string(test.help));
    add_text(command, "specimen", options.specimen, "specimen file, - for stdin").required().type_name("FILE");
    add_contact_options(command, raw.contact);
    add_run_options(command, options.request, raw, test);
    add_output_file(command.usual(), options.output, "run file, - for stdout", {".h5"});
    add_flag(command, "--print-program", options.print_program,
             "print the test as a loading program for `graincrack-solve program`, and run nothing");
    add_dry_run(command, common, "print counts, time step, steps, memory and file size, and run nothing");
    return command;
}

OptionSet add_program(OptionSet tool, SolveOptions& options, RawOptions& raw, CommonOptions& common) {
    const TestDescription& test = description_of(TestKind::program);
    OptionSet command = tool.add_subcommand(std::string(test.name), std::string(test.help), program_examples);
    add_text(command, "specimen", options.specimen, "specimen file, - for stdin").required().type_name("FILE");
    add_text(command, "--program", raw.program,
             "loading program: a TOML file, or the name of one of share/programs such as joint-shear; see share/doc/loading.md")
        .required()
        .type_name("FILE|NAME");
    add_contact_options(command, raw.contact);
    add_quantity(command, "--platen-friction", raw.platen_friction, quantity::platen_friction,
                 "friction angle between rock and platens; default: the material's")
        .of(SettingGroup::loading, [&options] { return options.request.loading.platen_friction; });
    add_quantity_or(
        command, "--damping", raw.damping, quantity::damping, "none", 0,
        "damping force as a fraction of the unbalanced force, instead of the value in the program; one of the two is required")
        .of(SettingGroup::loading, [&options] { return options.request.damping; });
    add_method_options(command, options.request, raw);
    add_checkpoint_options(command, options.request, raw);
    add_sensitivity_flag(command, options.request);
    add_text(command.usual(), "--restart", options.request.restart,
             "run made with --save-state from which to start, instead of the program's start_from; or a checkpoint of "
             "this program, to resume it")
        .type_name("FILE");
    add_output_file(command.usual(), options.output, "run file, - for stdout", {".h5"});
    add_dry_run(command, common, "print counts, time step, steps, memory and file size, and run nothing");
    return command;
}

/// A program, its damping, and whether it can do with the masses it is asked to have.
void complete_program(SimulationRequest& request, const RawOptions& raw) {
    request.loading.test = TestKind::program;
    request.program = read_program(loading_programs().find(raw.program));
    const auto damping = std::isnan(raw.damping) ? request.program->damping : std::optional(raw.damping);
    if (!damping) {
        throw UsageError("--damping: missing, and " + request.program->file +
                         " has none; give --damping 0.8 for what is slow, --damping none for waves");
    }
    request.damping = *damping;
    if (request.restart.empty()) request.restart = request.program->start_from;
    if (!request.restart.empty() && !request.program->initial_velocities.empty() && !is_checkpoint(RunReader(request.restart))) {
        throw UsageError(request.program->file +
                         ": [initial] and a run to start from contradict each other; leave out the one or the other");
    }
    if (request.sensitivity && !request.program->platens) {
        throw UsageError("--sensitivity: tells what an axial strength depends on, and " + request.program->file +
                         " has no [platens]; leave it out");
    }
}

/// Scaled masses for what is quasi-static, unless they were chosen; a run that starts from another keeps what that has.
void complete_mass_scaling(SimulationRequest& request, const RawOptions& raw) {
    request.mass_scaling_factor = raw.mass_scaling_factor;
    const std::string why = request.why_dynamic();
    request.mass_scaling = raw.mass_scaling.value_or(why.empty());
    if (!request.restart.empty() && raw.mass_scaling != false && !request.mass_scaling_factor) {
        const double factor = RunReader(request.restart).header().mass_scaling_factor;
        request.mass_scaling = raw.mass_scaling.value_or(factor > 0);
        if (factor > 0) request.mass_scaling_factor = factor;
    }
    if (request.mass_scaling && request.program && !why.empty()) {
        throw UsageError(
            raw.mass_scaling
                ? fmt::format(
                      "--mass-scaling: {} is dynamic ({}), and scaled masses would change its motion; give --mass-scaling none",
                      request.program->file, why)
                : fmt::format("{}: has scaled masses, and {} is dynamic ({}); start from a run made with --mass-scaling none",
                              request.restart, request.program->file, why));
    }
    if (request.mass_scaling_factor && !request.mass_scaling) {
        throw UsageError("--mass-scaling-factor: there is no mass scaling to apply it to; give --mass-scaling selective too");
    }
}

void complete_request(SimulationRequest& request, const RawOptions& raw) {
    apply_contact_options(raw.contact, request);
    complete_rate(request.loading, raw);
    // Rollers are free to roll, as ASTM E399 and ISRM 2014 ask: friction would carry part of the moment as a thrust.
    const bool rolls = description_of(request.loading.test).loading == Loading::bending;
    request.loading.platen_friction = raw.platen_friction.value_or(rolls ? 0 : request.material.platen_friction_angle);
    request.loading.confining_pressure = raw.confining_pressure.value_or(0);
    request.loading.heat = raw.heat.value_or(0);
    if (request.loading.mouth_opening && !request.loading.mouth_gauge) {
        throw UsageError("--mouth-opening: nothing measures it; give --mouth-gauge too, such as --mouth-gauge 20mm");
    }
    if (request.loading.cool && !raw.heat) {
        throw UsageError("--cool: there is nothing to cool; give --heat too, such as --heat 300K, or leave it out");
    }
    if (request.vector_target && !is_available(*request.vector_target)) {
        throw UsageError(fmt::format("--vector: this processor has no {}; auto takes the widest it has, {}",
                                     name_of(*request.vector_target), name_of(widest_vector_target())));
    }
}

/// \throws UsageError if the run would replace the one it starts from
void require_other_output(const SolveOptions& options) {
    std::error_code missing;
    if (std::filesystem::equivalent(options.output, options.request.restart, missing)) {
        throw UsageError(fmt::format("--output {}: is the run to start from; give another name", options.output));
    }
}

}  // namespace

std::optional<SolveOptions> read_solve_options(int argc, char** argv) {
    SolveOptions options;
    RawOptions raw;
    CommonOptions common;
    CommandLine line("graincrack-solve",
                     "Runs laboratory tests on assemblages of grains by the discrete element method with cohesive contacts",
                     common, examples, {is_built_with_mpi() ? "MPI: yes" : "MPI: no"}, [] {
                         return WrittenRows{{}, datasets_of("run")};
                     });
    std::vector<std::pair<OptionSet, TestKind>> tests;
    for (const TestDescription& test : all_tests()) {
        if (test.loading == Loading::program) continue;
        tests.emplace_back(add_test(line.options(), options, raw, common, test), test.kind);
    }
    OptionSet program = add_program(line.options(), options, raw, common);
    if (!line.parse(argc, argv)) return std::nullopt;
    for (const auto& [command, test] : tests) {
        if (command.is_called()) options.request.loading.test = test;
    }
    options.dry_run = common.dry_run;
    options.verbosity = common.verbosity;
    options.configuration = line.effective_configuration();
    if (options.output.empty() && !options.dry_run && !options.print_program) {
        throw UsageError("--output: missing; name the run file with -o FILE, or - for stdout");
    }
    options.material = raw.contact.material;
    complete_request(options.request, raw);
    const bool writes_checkpoints = options.request.checkpoint_interval || raw.walltime;
    if (writes_checkpoints && !options.output.empty() && is_stream(options.output)) {
        throw UsageError(
            fmt::format("{}: a run written to stdout or a device has no name for its checkpoints; give a file such as -o run.h5",
                        raw.walltime ? "--walltime" : "--checkpoint-every"));
    }
    if (raw.walltime) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(*raw.walltime);
        options.request.stops_after = [end](std::size_t /*rows*/) { return std::chrono::steady_clock::now() >= end; };
    }
    if (options.request.sensitivity && !options.request.restart.empty() && !is_checkpoint(RunReader(options.request.restart))) {
        throw UsageError(
            "--sensitivity: repeats the test from its start, and --restart is no checkpoint of it; leave out one of them");
    }
    if (program.is_called()) complete_program(options.request, raw);
    complete_mass_scaling(options.request, raw);
    options.request.settings = line.settings();
    require_other_output(options);
    return options;
}

}  // namespace graincrack
