// Counts of micro-cracks by mode and class of contacts over the loading.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "post/run/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Counts of all cracks and for each class of contacts at moments.
struct CrackCounts {
    struct Moment {
        double time = 0;  ///< s
        double axial_strain = 0;
        double stress = 0;  ///< Pa
        bool is_peak = false;
        ModeCounts all;
        std::vector<ModeCounts> by_class;
    };
    std::vector<std::string> classes;  ///< those with contacts in the specimen
    std::vector<Moment> moments;
};

/// At `n_moments` + 1 evenly spaced axial strains of the test, and at the peak.
CrackCounts count_cracks(const RunData& run, const LoadCurve& curve, const Specimen& specimen, std::vector<Crack> cracks,
                         std::size_t n_moments = 100);
/// The same at every row of the history.
CrackCounts count_cracks_by_row(const RunData& run, const LoadCurve& curve, const Specimen& specimen, std::vector<Crack> cracks);

/// Table: time_s, axial_strain, stress_MPa, is_peak, tensile_cracks, shear_cracks, then for each class
/// tensile_cracks_CLASS, shear_cracks_CLASS.
void write_crack_counts(std::ostream& out, const CrackCounts& counts, TableFormat format);

}  // namespace graincrack
