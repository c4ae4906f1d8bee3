// The properties of the runs of a report beside those of the laboratory.
#pragma once

#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/report/laboratory.hpp"
#include "post/report/test_report.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// The envelope of the compression tests of one grain size.
struct SizedEnvelope {
    std::string size;  ///< "edge 5 mm"; empty if all runs are of one size
    EnvelopeTests tests;
    Envelope envelope;
};

/// The property of a target, SI; empty if the run is of another test or does not have it.
std::optional<double> value_of(const MeasuredRun& test, const calibrate::Target& target);

/// The agreement of computed values with the laboratory's.
enum class Agreement {
    unknown,    ///< nothing to compare, or no deviation of the laboratory's value
    within,     ///< the whole 95 % interval of the mean is within the deviation
    outside,    ///< it is beyond the deviation
    undecided,  ///< neither, or there is no interval
};
std::string name_of(Agreement agreement);
Agreement agreement_of(const calibrate::Target& target, const Estimate& computed);
/// "within", "outside", "not decided (3 runs)", "not decided by one run"
std::string verdict_of(Agreement agreement, std::size_t runs);

/// The table property, laboratory, computed, difference, agreement, origin; a row for each group of runs that has the property.
/// Properties of the laboratory without a test among the runs are "not tested". Below, other definitions of crack initiation, and
/// [fitted] of the material. \param envelopes of the grain sizes that have one \param caveats paragraphs for below the table
std::string comparison(const std::vector<SeedGroup>& groups, const std::vector<SizedEnvelope>& envelopes,
                       const std::optional<Material>& material, const std::string& caveats = "");

}  // namespace graincrack
