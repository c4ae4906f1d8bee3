// The commands of graincrack-post, one function each, without the command line.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/ccd/tables.hpp"
#include "post/cracks/export.hpp"
#include "post/fit/envelope.hpp"
#include "post/fit/trend.hpp"
#include "post/plot/cracks.hpp"
#include "post/plot/law.hpp"
#include "post/plot/table.hpp"
#include "post/table/table.hpp"
#include "share/progress.hpp"

namespace graincrack {

/// What a call of graincrack-post asks for; each command uses its part.
struct PostOptions {
    std::string command;             ///< "info", "history", "strength", "moduli", "envelope", "trend", "fpz", "cracks", "plot"
    std::string picture;             ///< the second word of `plot` or `ccd`
    std::vector<std::string> files;  ///< "-" is stdin
    std::string files_from;          ///< list of more of them
    std::string output;              ///< folder (cracks) or picture (plot)
    std::string material;
    PlaneCondition plane = PlaneCondition::strain;
    std::optional<FractureEnergyChoice> fracture_energy;
    TableFormat format = TableFormat::tsv;
    std::vector<std::string> laboratory;  ///< plot curve, envelope: tables of measured curves or strengths
    ccd::Options ccd;
    bool follow = false;
    std::string probe;    ///< history: of a program
    bool stages = false;  ///< history: of a program
    bool summary = false;
    CappedRuns capped_runs = CappedRuns::refuse;
    bool check = false;
    bool digest = false;
    CrackMapOptions crack_map;
    CrackExportOptions crack_export;
    LawPlotOptions law;
    TablePlotOptions table_plot;
    TrendOptions trend;
    Verbosity verbosity = Verbosity::normal;
};

/// The file of a command that takes one. \throws UsageError if there are several
const std::string& only_file(const PostOptions& options);
std::vector<RunData> read_runs(const std::vector<std::string>& files);

/// Where remarks beside the data go: stderr, with --quiet nowhere.
std::ostream& remarks(const PostOptions& options);

/// Runs one command; data go to `out`.
/// \throws UsageError, InputError, OutputError
void run_command(const PostOptions& options, std::ostream& out);

/// Versions of the libraries of this tool alone.
std::vector<std::string> post_libraries();

}  // namespace graincrack
