// Number of processors available to a run.
#pragma once

namespace graincrack {

/// Processors this process may use: its affinity, and the quota of its control group if that is less.
int available_processors();

}  // namespace graincrack
