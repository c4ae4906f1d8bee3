// The data of one run that a report uses, read in a single pass over its file; runs that differ by the seed of their specimens
// alone, and their means.
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
    std::vector<std::string> class_names;  ///< of the contacts, in the order of `RunSettings::fabric`
    std::vector<Caveat> caveats;           ///< caveats of the strength
    CrackBalance at_peak;                  ///< by the label of the page, at the strength
    CrackBalance at_end;
    std::string crack_definition;             ///< that label in words
    std::vector<SensitivityRow> sensitivity;  ///< empty unless the run was made with --sensitivity
    double contact_zone_length = 0;           ///< m
    ProvenanceEntries provenance;
    std::string material;  ///< as the command line named it; "" if the file does not say
};

/// Evaluates a run for the report. \param label of its cracks \throws InputError if it cannot be read or evaluated
TestReport read_test_report(const RunReader& run, const CrackLabelChoice& label = {});

/// "132.4 (4.8)\n124.8 to 140": mean, standard deviation and, on a line of its own, the 95 % interval of the mean. \param
/// factor from SI to the unit of the table
std::string mean_cell(const Sample& sample, double factor);

/// A row for each group: strength, moduli, strain at the peak and crack thresholds as means with their intervals.
std::string group_table(const std::vector<SeedGroup>& groups);

}  // namespace graincrack
