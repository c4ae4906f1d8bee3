// The results of a finished test, found from its header and history alone.
#pragma once

#include <cstddef>

#include "share/file/run_file.hpp"

namespace graincrack {

/// A test that was run and not written.
struct TestOutcome {
    RunHeader header;
    History history;
};

/// 1 where a test pulls, −1 where it presses; a program does what it does more.
double sign_of_strength(const RunHeader& header, const History& history);

/// Row of the largest axial stress in the sense of the test. \pre the history has rows
std::size_t peak_row(const RunHeader& header, const History& history);

/// Largest difference of the platen forces over their mean, before the peak while the mean exceeds half of it.
/// \param width of the specimen, m
double platen_force_difference(const RunHeader& header, const History& history, double width);

/// Mean of the damping load over the travel of the platens from nine tenths of the strain at the peak to the peak.
double damping_load_at_peak(const RunHeader& header, const History& history);

/// Energy that damping has absorbed at the end, over the external work; 0 without any.
double damping_share(const History& history);

/// Confining pressure that was achieved.
struct Confinement {
    double mean = 0;       ///< over the rows, Pa
    double deviation = 0;  ///< standard deviation, Pa
};
/// \param begin first time that counts, s \pre the history has rows from it on
Confinement achieved_confinement(const History& history, double begin);

/// Sets what the header of a finished test takes from its history. \param width of the specimen, m
void complete_header(const History& history, double width, RunHeader& header);

}  // namespace graincrack
