// The data of one run for a report, read in a single pass over its file, and means over runs that differ in their seeds only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/cracks/crack_counts.hpp"
#include "post/laboratory/comparison.hpp"
#include "post/measure/brazilian.hpp"

namespace graincrack {

/// The provenance that a file records, as names and values.
using ProvenanceEntries = std::vector<std::pair<std::string, std::string>>;

struct TestReport : MeasuredRun {
    std::vector<std::string> class_names;  ///< names of contact classes, in the order of `RunSettings::fabric`
    std::vector<Caveat> caveats;           ///< caveats of the strength
    CrackBalance at_peak;                  ///< crack counts at the strength, by the label of the page
    CrackBalance at_end;
    std::string crack_definition;             ///< the label in words
    std::vector<SensitivityRow> sensitivity;  ///< empty for a run without --sensitivity
    double contact_zone_length = 0;           ///< m
    ProvenanceEntries provenance;
    std::string material;  ///< its name on the command line; "" if the file does not have it
};

/// Evaluates a run for the report. \param label of its cracks \throws InputError if it cannot be read or evaluated
TestReport read_test_report(const RunReader& run, const CrackLabelChoice& label = {});

/// A cell with mean, standard deviation and, on a second line, the 95 % interval of the mean: "132.4 (4.8)\n124.8 to 140".
/// \param factor from SI to the unit of the table
std::string mean_cell(const Sample& sample, double factor);

/// A table with one row per group: strength, moduli, strain at the peak and crack thresholds as means with their intervals.
std::string group_table(const std::vector<SeedGroup>& groups);

}  // namespace graincrack
