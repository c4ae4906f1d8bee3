#include "post/commands/commands.hpp"

#include <fmt/format.h>
#include <gsl/gsl_version.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>

#include "post/chart/picture.hpp"
#include "post/commands/envelope_table.hpp"
#include "post/commands/fpz_table.hpp"
#include "post/commands/info.hpp"
#include "post/commands/plots.hpp"
#include "post/commands/program_table.hpp"
#include "post/fit/size_effect.hpp"
#include "post/measure/history.hpp"
#include "post/measure/load_curve.hpp"
#include "post/measure/moduli.hpp"
#include "post/measure/strength.hpp"
#include "post/measure/strength_summary.hpp"
#include "post/measure/toughness.hpp"
#include "post/report/report.hpp"
#include "post/table/output_file.hpp"
#include "share/error.hpp"
#include "share/h5_file.hpp"

namespace graincrack {

namespace {

void require_one_stdin(const std::vector<std::string>& files) {
    if (std::count(files.begin(), files.end(), "-") > 1)
        throw UsageError("-: stands for stdin, which holds one file; give it once");
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

void history(const PostOptions& options, std::ostream& out) {
    if (options.follow && (options.stages || !options.probe.empty())) {
        throw UsageError("history --follow: follows the history alone; leave out --probe and --stages");
    }
    if (options.stages) return write_stages(out, RunReader(only_file(options)), options.format);
    if (!options.probe.empty()) return write_probe(out, RunReader(only_file(options)), options.probe, options.format);
    if (!options.follow) return write_history(out, RunReader(only_file(options)), options.format);
    if (only_file(options) == "-") throw UsageError("history --follow: stdin cannot be followed; name a file");
    follow_history(out, only_file(options), options.format);
}

void cracks(const PostOptions& options) {
    CrackExportOptions own = options.crack_export;
    own.format = options.format;
    export_cracks(RunReader(only_file(options)), options.output, own, options.verbosity);
}

void report(const PostOptions& options) {
    write_whole_file(options.output, make_report(options.files, {options.material, options.capped_runs}, options.verbosity));
}

void ccd_command(const PostOptions& options, std::ostream& out) {
    if (options.picture == "design") return ccd::write_design(out, options.ccd, options.format);
    if (options.picture == "fit") return ccd::write_fit(out, only_file(options), options.ccd, options.format);
    ccd::write_solution(out, only_file(options), options.ccd, options.format);
}

}  // namespace

const std::string& only_file(const PostOptions& options) {
    if (options.files.size() == 1) return options.files.front();
    throw UsageError(fmt::format("{}{}{}: takes one file, not {}", options.command, options.picture.empty() ? "" : " ",
                                 options.picture, options.files.size()));
}

std::vector<RunData> read_runs(const std::vector<std::string>& files) {
    std::vector<RunData> runs;
    for (const std::string& file : files) runs.push_back(read_run_data(file));
    return runs;
}

std::ostream& remarks(const PostOptions& options) {
    static std::ostream nowhere(nullptr);
    return options.verbosity == Verbosity::quiet ? nowhere : std::cerr;
}

void run_command(const PostOptions& options, std::ostream& out) {
    require_one_stdin(options.files);
    const std::map<std::string, std::function<void()>> commands{
        {"info", [&] { info(options, out); }},
        {"history", [&] { history(options, out); }},
        {"strength",
         [&] { (options.summary ? write_strength_summary : write_strength_table)(out, options.files, options.format); }},
        {"moduli", [&] { write_moduli_table(out, options.files, options.format); }},
        {"toughness", [&] { write_toughness_table(out, options.files, options.format); }},
        {"envelope", [&] { write_envelope_table(out, options.files, options.format, options.capped_runs, remarks(options)); }},
        {"size-effect", [&] { write_size_effect_table(out, read_runs(options.files), options.format, options.capped_runs); }},
        {"trend", [&] { write_trend_table(out, options.files, options.trend, options.format, remarks(options)); }},
        {"fpz", [&] { write_fpz_table(out, read_material(options.material), options.format); }},
        {"cracks", [&] { cracks(options); }},
        {"ccd", [&] { ccd_command(options, out); }},
        {"report", [&] { report(options); }},
        {"plot", [&] { write_plot(options); }},
    };
    const auto command = commands.find(options.command);
    if (command == commands.end()) throw UsageError(options.command + ": unknown command");
    command->second();
    out.flush();
    if (!out) throw OutputError("stdout: could not be written whole");
}

std::vector<std::string> post_libraries() { return {vtk_library_version(), std::string("GSL ") + GSL_VERSION}; }

}  // namespace graincrack
