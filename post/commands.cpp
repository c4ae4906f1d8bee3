#include "post/commands.hpp"

#include <fmt/format.h>
#include <gsl/gsl_version.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

#include "post/cracks/crack_map.hpp"
#include "post/envelope_table.hpp"
#include "post/fpz_table.hpp"
#include "post/info.hpp"
#include "post/load_curve.hpp"
#include "post/moduli.hpp"
#include "post/picture/picture.hpp"
#include "post/picture/plot_curve.hpp"
#include "post/picture/plot_envelope.hpp"
#include "post/picture/plot_size_effect.hpp"
#include "post/picture/plot_specimen.hpp"
#include "post/picture/plot_surface.hpp"
#include "post/size_effect.hpp"
#include "post/strength.hpp"
#include "post/strength_summary.hpp"
#include "share/error.hpp"
#include "share/h5_file.hpp"

namespace graincrack {

namespace {

void require_one_stdin(const std::vector<std::string>& files) {
    if (std::count(files.begin(), files.end(), "-") > 1)
        throw UsageError("-: stands for stdin, which holds one file; give it once");
}

const std::string& only_file(const PostOptions& options) {
    if (options.files.size() == 1) return options.files.front();
    throw UsageError(fmt::format("{} {}: takes one file, not {}", options.command, options.picture, options.files.size()));
}

void info(const PostOptions& options, std::ostream& out) {
    for (const std::string& file : options.files) {
        if (options.digest) {
            write_digest(out, file, options.check);
        } else {
            write_info(out, file, options.check);
        }
    }
}

std::vector<RunData> read_runs(const std::vector<std::string>& files) {
    std::vector<RunData> runs;
    for (const std::string& file : files) runs.push_back(read_run_data(file));
    return runs;
}

Drawing picture_of(const PostOptions& options) {
    if (options.picture == "specimen") return draw_specimen(read_specimen(H5Input(only_file(options))));
    if (options.picture == "cracks") return draw_cracks(RunReader(only_file(options)), options.crack_map);
    if (options.picture == "curve") {
        std::vector<LaboratoryCurve> laboratory;
        for (const std::string& file : options.laboratory) laboratory.push_back(read_laboratory_curve(file));
        return draw_curves(read_runs(options.files), laboratory);
    }
    if (options.picture == "envelope") {
        const std::vector<RunData> runs = read_runs(options.files);
        return draw_envelope(collect_envelope_tests(runs, options.capped_runs), runs.front().header.material);
    }
    if (options.picture == "size-effect") return draw_size_effect(collect_sizes(read_runs(options.files), options.capped_runs));
    if (options.picture == "surface") return draw_surface(ccd::solve_problem(only_file(options), options.ccd));
    throw UsageError("plot " + options.picture + ": unknown");
}

void plot(const PostOptions& options) {
    require_picture_name(options.output);
    write_picture(picture_of(options), options.output);
}

void ccd_command(const PostOptions& options, std::ostream& out) {
    if (options.picture == "design") return ccd::write_design(out, options.ccd, options.format);
    if (options.picture == "fit") return ccd::write_fit(out, only_file(options), options.ccd, options.format);
    ccd::write_solution(out, only_file(options), options.ccd, options.format);
}

}  // namespace

void run_command(const PostOptions& options, std::ostream& out) {
    require_one_stdin(options.files);
    const std::map<std::string, std::function<void()>> commands{
        {"info", [&] { info(options, out); }},
        {"history", [&] { write_history(out, RunReader(only_file(options)), options.format); }},
        {"strength",
         [&] { (options.summary ? write_strength_summary : write_strength_table)(out, options.files, options.format); }},
        {"moduli", [&] { write_moduli_table(out, options.files, options.format); }},
        {"envelope", [&] { write_envelope_table(out, options.files, options.format, options.capped_runs, std::cerr); }},
        {"size-effect", [&] { write_size_effect_table(out, read_runs(options.files), options.format, options.capped_runs); }},
        {"fpz", [&] { write_fpz_table(out, read_material(options.material), options.format); }},
        {"cracks", [&] { export_crack_map(RunReader(only_file(options)), options.output, options.verbosity); }},
        {"ccd", [&] { ccd_command(options, out); }},
        {"plot", [&] { plot(options); }},
    };
    const auto command = commands.find(options.command);
    if (command == commands.end()) throw UsageError(options.command + ": unknown command");
    command->second();
    out.flush();
    if (!out) throw OutputError("stdout: could not be written whole");
}

std::vector<std::string> post_libraries() { return {vtk_library_version(), std::string("GSL ") + GSL_VERSION}; }

}  // namespace graincrack
