// graincrack-solve: a laboratory test on a specimen of grains.
//
//     graincrack-solve uniaxial specimen.h5 --material augig-granite -o uniaxial.h5
//     graincrack-mesh disc --diameter 80mm --grains 452 -o - | graincrack-solve brazilian - --material augig-granite -o
//     brazilian.h5
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>

#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/base/sha256.hpp"
#include "share/base/units.hpp"
#include "share/file/h5_file.hpp"
#include "share/file/specimen_measures.hpp"
#include "solver/program/program_file.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/ranks/alike.hpp"
#include "solver/restart/checkpoint.hpp"
#include "solver/run/plan.hpp"
#include "solver/run/simulation.hpp"
#include "solver/setup/setup.hpp"
#include "solver/solve_options.hpp"

namespace {

using namespace graincrack;

void print_plan(const SimulationPlan& plan) {
    constexpr double assumed_ns_per_grain_step = 50;  // one thread, contacts failing; 30 to 110 by processor
    fmt::print("grains\t{}\nelements\t{}\nnodes\t{}\ncontacts\t{}\n", plan.grains, plan.elements, plan.nodes, plan.contacts);
    fmt::print("mass_scaling_factor\t{:.4g}\nstable_time_step_s\t{:.4g}\ntime_step_s\t{:.4g}\nmax_steps\t{}\n",
               plan.mass_scaling_factor, plan.stable_time_step, plan.time_step, plan.max_steps);
    fmt::print("threads\t{}\nbalance_of_nodes\t{:.3f}\nbalance_of_forces\t{:.3f}\n", plan.balance.threads, plan.balance.nodes,
               plan.balance.forces);
    fmt::print("memory_MB\t{:.4g}\nfile_size_at_most_MB\t{:.4g}\n", plan.memory * 1e-6, plan.file_size * 1e-6);
    const auto seconds = [&](std::int64_t steps) {
        return static_cast<double>(steps) * static_cast<double>(plan.grains) * assumed_ns_per_grain_step * 1e-9;
    };
    if (plan.usual_steps > 0) {
        fmt::print("usual_steps\t{}\nestimated_time_s\t{:.2g}\n", plan.usual_steps, seconds(plan.usual_steps));
    }
    fmt::print("estimated_time_at_most_s\t{:.0f}\n", seconds(plan.max_steps));
}

/// Prints the program that `graincrack-solve program` runs as this very test.
void print_program(const SolveOptions& options, const Specimen& specimen) {
    Program program = program_of(options.request, specimen);
    program.damping = options.request.damping;
    fmt::print(
        "# The {} test that graincrack-solve makes of {}. With the same contact, platen and method options this runs it:\n"
        "#\n"
        "#   graincrack-solve program {} --program FILE.toml --material {} --plane {}{} -o run.h5\n{}",
        name_of(options.request.loading.test), options.specimen, options.specimen, options.request.material.name,
        name_of(options.request.plane),
        description_of(options.request.loading.test).loading == Loading::bending ? " --platen-friction 0" : "",
        program_text(program));
}

/// The strength a test is made for (brazilian: from load over D t), or the largest stress of one that did not fail; of bending
/// the largest load.
std::string strength_of(const SimulationSummary& s, double width) {
    const RunHeader& h = s.header;
    if (h.peak_axial_stress <= 0) return "";
    const std::string failed = s.strength ? "" : "did not fail: ";
    if (h.loading() == Loading::bending) {
        return fmt::format("{}largest load {} at a span of {:.4g} mm (plane {}); ", failed,
                           load_text(h, h.peak_axial_stress, width), h.span * 1e3, name_of(h.plane));
    }
    const bool is_first_peak = s.strength && h.loading() == Loading::compression;
    return fmt::format("{}{} {} ({}plane {}); ", failed, s.strength ? "strength" : "largest stress",
                       load_text(h, s.strength.value_or(h.peak_axial_stress), width), is_first_peak ? "first peak, " : "",
                       name_of(h.plane));
}

/// Error of the energy balance over the largest stored energy up to which a run is beyond doubt.
constexpr double trusted_residual = 0.005;

/// The result, what tells whether to trust it, and where it is; then what is wrong.
void print_summary(std::ostream& out, const SimulationSummary& s, const Specimen& specimen, const std::string& output) {
    const RunHeader& h = s.header;
    add_to_outcome("stop_reason", h.stop_reason);
    if (s.strength && h.loading() != Loading::bending) add_to_outcome("strength", factor_of_strength(h) * *s.strength);
    if (h.heat != 0 && h.loading() != Loading::program) {
        say(out, fmt::format("{}: {} before axial loading, with {} cracks", h.test, h.heat_label(), std::ceil(s.cracks_before)));
    }
    if (h.heat != 0 && h.mass_scaling_factor > 0) {
        say(out,
            fmt::format("{}: note: on heating some 6 % more contacts crack with scaled masses; --mass-scaling none avoids it",
                        h.test));
    }
    say(out, fmt::format("{}: ended by {}; {}cracks: {} tensile, {} shear", h.test, h.stop_reason, strength_of(s, specimen.width),
                         std::ceil(s.cracks.tensile), std::ceil(s.cracks.shear)));
    say(out,
        fmt::format("{}: energy balance error {:.2e} of the stored energy; platen forces differ by {:.2f} %; damping carried "
                    "{:.2f} % of the load before the peak",
                    h.test, h.energy_balance_error, 100 * h.platen_force_difference, 100 * h.damping_load));
    if (output != "-") say(out, fmt::format("{}: written to {} after {:.1f} s", h.test, output, s.wall_time));
    if (s.ranks.threads_at_work < s.ranks.balance.threads - 0.05) {
        say(out, fmt::format("{}: {:.1f} of {} threads worked, as others used the processors", h.test, s.ranks.threads_at_work,
                             s.ranks.balance.threads));
    }
    const std::string few = h.loading() == Loading::program ? "" : note_on_few_crystals(specimen);
    const auto caution = [&](const std::string& code, const std::string& text) { warn(out, h.test, {text, code}, output); };
    if (!few.empty()) caution("few_crystals", few);
    if (h.damping_load > trusted_damping_load) {
        caution("damping_load",
                fmt::format(
                    "damping carries {:.1f} % of the load before the peak, more than {:.0f} %; the strength is too high by "
                    "that fraction, where grains slide by several times as much: use a smaller --rate-tolerance, a slower --rate "
                    "or --damping-form combined",
                    100 * h.damping_load, 100 * trusted_damping_load));
    }
    if (!s.equilibrium_warning.empty()) caution("equilibrium", s.equilibrium_warning);
    for (const std::string& text : s.overshoots) caution("overshoot", text);
    if (h.energy_balance_error > trusted_residual) {
        caution("energy_balance",
                fmt::format("the error of the energy balance is {:.1f} % of the stored energy, more than {:.1f} %: do not "
                            "rely on results after that time (`history`, energy_balance_error), or use another --contact-law, "
                            "--mass-scaling none or a slower --rate",
                            100 * h.energy_balance_error, 100 * trusted_residual));
    }
}

void print_details(std::ostream& out, const SimulationSummary& s) {
    const RunHeader& h = s.header;
    const std::string scaling = h.mass_scaling_factor > 0 ? fmt::format(" (mass scaling {:.3g})", h.mass_scaling_factor) : "";
    say(out, fmt::format("{}: {} steps of {:.3g} s{}, {:.1f} ns per grain and step; damping absorbed {:.1f} % of the work",
                         h.test, h.steps, h.time_step, scaling, s.ns_per_grain_step, 100 * h.damping_share));
    if (s.ranks.balance.threads > 1) {
        say(out, fmt::format("{}: {} threads: the busiest has {:.2f} times the mean work on nodes, {:.2f} times on forces",
                             h.test, s.ranks.balance.threads, s.ranks.balance.nodes, s.ranks.balance.forces));
    }
}

/// The messages between the ranks of a run.
void print_ranks(std::ostream& out, const SimulationSummary& s) {
    const RankSummary& r = s.ranks;
    say(out,
        fmt::format("{}: {} ranks: {} ghost nodes of {} at most, {} {}, {:.1f} kB and {:.1f} messages a step and rank, {:.1f} % "
                    "of the time waited",
                    s.header.test, r.ranks, r.ghost_nodes, r.own_nodes, r.neighbours,
                    r.neighbours == 1 ? "neighbour" : "neighbours", r.bytes_a_step * 1e-3, r.messages_a_step, 100 * r.waited));
}

/// Says so where the fracture energy in sliding leaves no softening.
void print_sudden_loss(std::ostream& out, const SimulationRequest& request) {
    const ContactLaw law = make_contact_law(request.contact, request.law);
    if (description_of(law.variant).reads(&ContactParameters::mode_ii_fracture_energy) && !law.softens_in_shear) {
        say(out, fmt::format(
                     "{}: note: G_II, {:.4g} J/m2, does not exceed the {:.4g} J/m2 that a closed contact absorbs up to its peak: "
                     "its cohesion is lost at once",
                     name_of(request.loading.test), law.g2, contact_law::energy_to_sliding_peak(law)));
    }
}

/// The table of a run with --sensitivity: values of the test as it is, then changes.
void print_sensitivity(std::FILE* out, const std::vector<SensitivityRow>& rows) {
    fmt::print(out,
               "changed\tpeak_stress_MPa\tstrain_at_peak\tpost_peak_slope_GPa\ttensile_cracks\tshear_cracks\tpeak_change_percent"
               "\tstrain_change_percent\tslope_change_percent\ttensile_cracks_change\tshear_cracks_change\n");
    const auto cell = [](double value, int digits) {
        return std::isfinite(value) ? format_number(value, digits) : std::string();
    };
    const SensitivityRow& own = rows.front();
    for (const SensitivityRow& row : rows) {
        fmt::print(out, "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", row.changed, cell(row.peak_axial_stress * 1e-6, 5),
                   cell(row.strain_at_peak, 5), cell(row.post_peak_slope * 1e-9, 4), cell(row.tensile_cracks, 6),
                   cell(row.shear_cracks, 6), cell(100 * (row.peak_axial_stress / own.peak_axial_stress - 1), 3),
                   cell(100 * (row.strain_at_peak / own.strain_at_peak - 1), 3),
                   cell(100 * (row.post_peak_slope / own.post_peak_slope - 1), 3),
                   cell(row.tensile_cracks - own.tensile_cracks, 4), cell(row.shear_cracks - own.shear_cracks, 4));
    }
}

/// The specimen. What comes from a pipe, comes to the first rank.
H5Input open_specimen(const std::string& path, const Ranks& ranks) {
    if (path != "-" || ranks.is_alone()) return H5Input(path, "specimen");
    std::vector<char> image;
    if (ranks.is_first()) image.assign(std::istreambuf_iterator<char>(std::cin), {});
    return H5Input::from_image(ranks.concatenate(image), "stdin", "specimen");
}

std::string content(const std::string& digest) { return "content " + digest.substr(0, 12); }

/// What decides the course of a run, but for the specimen. Threads and vector units do not.
Facts facts_of(const std::optional<SolveOptions>& options) {
    if (!options) return {{"--help, --version or --print-config", "given"}};
    const SimulationRequest& request = options->request;
    Facts facts = facts_of(request.settings, "--");
    facts.emplace_back("the command", name_of(request.loading.test));
    facts.emplace_back("--plane", name_of(request.plane));
    facts.emplace_back("--contact-law", name_of(request.law));
    facts.emplace_back("--program", request.program ? content(sha256_of(request.program->text)) : "");
    facts.emplace_back("--restart", request.restart.empty() ? "" : content(H5Input(request.restart).digest()));
    facts.emplace_back("the specimen", options->specimen == "-" ? "stdin" : "a file");
    facts.emplace_back("the version of the program", project_version() + " " + project_commit());
    return facts;
}

int solve(int argc, char** argv, const Ranks& ranks) {
    std::optional<SolveOptions> options;
    prepare_alike(ranks, [&] {
        options = read_solve_options(argc, argv);
        return ranks.is_alone() ? Facts{} : facts_of(options);
    });
    if (!options) return 0;
    options->request.ranks = &ranks;
    std::ostream& out = diagnostics(options->verbosity);
    write_notes(out, "graincrack-solve", options->request.material);
    catch_stop_signals();
    catch_checkpoint_signal();
    std::optional<H5Input> opened;
    Specimen specimen;
    std::string digest;
    prepare_alike(ranks, [&]() -> Facts {
        opened = open_specimen(options->specimen, ranks);
        specimen = read_specimen(*opened);
        require_shape(options->request.loading.test, specimen, opened->name());
        require_same_phases(options->request.material, specimen.phase_names);
        digest = opened->digest();
        Facts facts{{"the specimen", content(digest)}};
        if (ranks.is_alone()) return facts;
        const MaterialSettings values = material_settings(options->request, specimen);
        for (Fact& fact : facts_of(material_values(values), "material: ")) facts.push_back(std::move(fact));
        return facts;
    });
    if (options->print_program) {
        print_program(*options, specimen);
        return 0;
    }
    if (options->dry_run) {
        print_plan(plan_simulation(specimen, options->request));
        return 0;
    }
    Provenance provenance;
    provenance.tool = "graincrack-solve";
    provenance.command_line.assign(argv, argv + argc);
    provenance.configuration = options->configuration;
    provenance.material = options->material;
    provenance.input_digest = digest;
    const SimulationSummary summary = simulate(specimen, options->request, options->output, options->verbosity, provenance);
    print_summary(out, summary, specimen, options->output);
    if (options->verbosity == Verbosity::verbose) {
        print_details(out, summary);
        print_sudden_loss(out, options->request);
        if (!ranks.is_alone()) print_ranks(out, summary);
    }
    if (options->request.sensitivity) print_sensitivity(options->output == "-" ? stderr : stdout, summary.sensitivity);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    graincrack::Ranks ranks;
    const int code = graincrack::run_tool("graincrack-solve", [&] {
        ranks = graincrack::Ranks(graincrack::messages_of_launcher());
        return solve(argc, argv, ranks);
    });
    ranks.end(code);
    return code;
}
