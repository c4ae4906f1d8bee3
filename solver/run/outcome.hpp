// The results of a finished test, found from its header and history alone.
#pragma once

#include <cstddef>
#include <string>

#include "share/file/run_file.hpp"

namespace graincrack {

/// A test that was run and not written.
struct TestOutcome {
    RunHeader header;
    History history;
};

/// 1 where a test pulls, −1 where it presses; a program does what it does more.
double sign_of_strength(const RunSettings& header, const History& history);

/// Row of the largest axial stress in the sense of the test. \pre the history has rows
std::size_t peak_row(const RunSettings& header, const History& history);

/// When a test had its strength; of one that has not failed its largest stress, s. 0 without rows.
double peak_time(const RunHeader& header, const History& history);

/// The quantity that a test is made for, over its axial stress: a Brazilian test has the load over D t as that.
double factor_of_strength(const RunSettings& header);
/// An axial stress as that quantity: "8.03 MPa", of bending the load, "4.2 kN/m". \param width of the specimen, m
std::string load_text(const RunSettings& header, double axial_stress, double width);

/// Sets what the header of a finished test takes from its history: the peak, the difference of the platen forces before it, the
/// load and the work of damping, and the confining pressure since `isotropic_end_time`.
/// \param width of the specimen, m \pre the history has rows from that time on
void complete_header(const History& history, double width, RunHeader& header);

}  // namespace graincrack
