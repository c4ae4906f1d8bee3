// Sensitivity of a test's result to rate, time step, damping, mass scaling and mesh: the group /sensitivity of a run made with
// --sensitivity.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "share/file/h5_file.hpp"

namespace graincrack {

/// Result of a test with one setting changed. The first row of a table is the original test.
struct SensitivityRow {
    std::string changed;           ///< "as it is", "half the rate", …
    double peak_axial_stress = 0;  ///< as in the header, Pa; NaN if the test cannot be run with this setting
    double strain_at_peak = 0;     ///< platen travel over height, positive
    /// Slope from the peak to the end of the test, stress over strain, Pa; NaN unless the drop below the peak ended the test.
    double post_peak_slope = std::numeric_limits<double>::quiet_NaN();
    double tensile_cracks = 0;  ///< failed contacts at the peak; with a finer mesh, scaled to contacts of the original mesh
    double shear_cracks = 0;
};

void write_sensitivity(H5Output& file, const std::vector<SensitivityRow>& rows);
/// Reads the rows; empty for a run without --sensitivity.
std::vector<SensitivityRow> read_sensitivity(const H5Input& file);

}  // namespace graincrack
