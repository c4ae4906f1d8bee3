// The commands of graincrack-post, one function each, without the command line.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/ccd/tables.hpp"
#include "post/envelope.hpp"
#include "post/picture/plot_cracks.hpp"
#include "post/table.hpp"
#include "share/progress.hpp"

namespace graincrack {

/// What a call of graincrack-post asks for; each command uses its part.
struct PostOptions {
    std::string command;             ///< "info", "history", "strength", "moduli", "envelope", "fpz", "cracks", "plot"
    std::string picture;             ///< the second word of `plot` or `ccd`
    std::vector<std::string> files;  ///< "-" is stdin
    std::string output;              ///< folder (cracks) or picture (plot)
    std::string material;
    TableFormat format = TableFormat::tsv;
    std::vector<std::string> laboratory;  ///< plot curve: tables of measured curves
    ccd::Options ccd;
    bool summary = false;
    CappedRuns capped_runs = CappedRuns::refuse;
    bool check = false;
    bool digest = false;
    CrackMapOptions crack_map;
    Verbosity verbosity = Verbosity::normal;
};

/// Runs one command; data go to `out`.
/// \throws UsageError, InputError, OutputError
void run_command(const PostOptions& options, std::ostream& out);

/// Versions of the libraries of this tool alone.
std::vector<std::string> post_libraries();

}  // namespace graincrack
