// Probes in a run file: the group /probes/NAME has columns with one row for each row of the history.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "share/base/quantities.hpp"

namespace graincrack {

class H5Input;
class H5Output;

/// A column of a probe, the dataset /probes/NAME/name.
struct ProbeColumn {
    std::string name;
    Dimension dimension;
    std::string description;
};

/// Record of a probe; its columns are as long as those of the history.
struct ProbeHistory {
    std::string name;
    std::vector<ProbeColumn> columns;
    std::vector<std::vector<double>> values;  ///< by column
};

/// Name of the probe of a point of a ring: "gauges.007" of the ring gauges.
std::string point_of_ring(const std::string& ring, std::size_t point);

/// Appends rows [first, …) of every probe.
void append_probes(H5Output& file, const std::vector<ProbeHistory>& probes, std::size_t first);

/// Names of the probes of a run, sorted; none in a run without a program.
std::vector<std::string> probe_names(const H5Input& file);
/// Reads a probe. \throws InputError if there is none of this name, listing the probes
ProbeHistory read_probe(const H5Input& file, const std::string& name);

}  // namespace graincrack
