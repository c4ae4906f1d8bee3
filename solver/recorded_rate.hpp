// Platens at a share of the speeds of another run: what a test gives at half the speed everywhere, limits and floors of the
// automatic rate included.
#pragma once

#include <vector>

#include "share/run_file.hpp"

namespace graincrack {

struct RecordedRate {
    std::vector<double> strain;  ///< of the axial loading, in the sense of the test, ascending
    std::vector<double> speed;   ///< of each platen on the way there, m/s
    double share = 0.5;          ///< of these speeds
    /// Speed of each platen at a strain, m/s; beyond the record the last one.
    [[nodiscard]] double at(double strain_now) const;
};

/// The speeds of a test. \throws InputError naming `name` where its platens never moved towards the end of a test
RecordedRate recorded_rate(const std::string& name, const RunHeader& header, const History& history, double share);

}  // namespace graincrack
