// The command line of graincrack-post.
#pragma once

#include <ostream>

namespace graincrack {

/// Reads the command line and runs the command it names; data go to `out`. --help, --version and --print-config are answered on
/// stdout instead. \throws UsageError, InputError, OutputError
void run_command_line(int argc, const char* const* argv, std::ostream& out);

}  // namespace graincrack
