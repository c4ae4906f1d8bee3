// The measures of the specimen that the loading takes after each row of the history.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "share/file/run_file.hpp"

namespace graincrack {

/// Measures of the last row.
struct Feedback {
    double time = 0;               ///< s
    double axial_strain = 0;       ///< of the platens, tension positive
    double axial_compression = 0;  ///< mean of the platens, Pa
    double unbalanced_ratio = 0;   ///< as in the history
    double kinetic_energy = 0;     ///< of the masses as they are, J
    double stored_energy = 0;      ///< J
    double force_difference = 0;   ///< of the platens, over their mean
    double damping_load = 0;       ///< load that damping carries, over that of the platens
    double near_failure = 0;       ///< how far failure involves the section, 0 to 1
};

/// All rows so far.
struct Rows {
    const History& history;
    std::function<double(const std::string& probe, std::size_t column)> probe;  ///< the last value of a column of a probe
};

}  // namespace graincrack
