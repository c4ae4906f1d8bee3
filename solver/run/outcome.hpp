// Finds the results of a finished test from its header and history.
#pragma once

#include <cstddef>
#include <string>

#include "share/file/run_file.hpp"

namespace graincrack {

/// The result of a test that is not written to a file.
struct TestOutcome {
    RunHeader header;
    History history;
};

/// Returns 1 for tension, −1 for compression. A program has the sign of its larger stress.
double sign_of_strength(const RunSettings& header, const History& history);

/// Row of the largest axial stress in the sense of the test. \pre the history has rows
std::size_t peak_row(const RunSettings& header, const History& history);

/// Time of the strength or, for a test that did not fail, of the largest stress, s. It is 0 without rows.
double peak_time(const RunHeader& header, const History& history);

/// The strength that a test measures, over its axial stress. The axial stress of a Brazilian test is the load over D t.
double factor_of_strength(const RunSettings& header);
/// An axial stress as this strength, "8.03 MPa", or as the load in bending, "4.2 kN/m". \param width of the specimen, m
std::string load_text(const RunSettings& header, double axial_stress, double width);

/// Sets the members of the header of a finished test that follow from its history: the peak, the difference of the platen forces
/// before it, the load and the work of damping, and the confining pressure since `isotropic_end_time`.
/// \param width of the specimen, m \pre the history has rows from `isotropic_end_time` on
void complete_header(const History& history, double width, RunHeader& header);

}  // namespace graincrack
