// How the result of a test moves with what should not matter: the group /sensitivity of a run that was asked for it.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "share/h5_file.hpp"

namespace graincrack {

/// A test with one thing changed. The first row of a table is the test as it is.
struct SensitivityRow {
    std::string changed;           ///< "as it is", "half the rate", …
    double peak_axial_stress = 0;  ///< as in the header, Pa; NaN if the test could not be run so
    double strain_at_peak = 0;     ///< platen travel over height, positive
    /// From the peak to the end of the test, stress over strain, Pa; NaN if the test did not end by a fall.
    double post_peak_slope = std::numeric_limits<double>::quiet_NaN();
    double tensile_cracks = 0;  ///< contacts at the peak, of the test's own length where they were divided
    double shear_cracks = 0;
};

void write_sensitivity(H5Output& file, const std::vector<SensitivityRow>& rows);
/// Empty if the run was not asked for it.
std::vector<SensitivityRow> read_sensitivity(const H5Input& file);

}  // namespace graincrack
