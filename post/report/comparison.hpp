// The two columns of a report: what was fitted, what was predicted.
#pragma once

#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/report/test_report.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// The envelope of the compression tests of one grain size.
struct SizedEnvelope {
    std::string size;  ///< "edge 5 mm"; empty if all runs are of one size
    EnvelopeTests tests;
    Envelope envelope;
};

/// Fitted: what [fitted] of the material names. Predicted: everything else. One column if the material has no [fitted].
/// Each with mean, standard deviation, 95 % interval and, if a material is given, the laboratory's value.
/// Each grain size has rows of its own. \param envelopes of the grain sizes that have one
std::string comparison_columns(const std::vector<TestReport>& tests, const std::vector<SizedEnvelope>& envelopes,
                               const std::optional<Material>& material);

}  // namespace graincrack
