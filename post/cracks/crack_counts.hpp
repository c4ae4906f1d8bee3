// Counts of micro-cracks by mode and pair of minerals over the loading.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "post/measure/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Contacts (points ÷ 2) failed in tension and in shear.
struct ModeCounts {
    double tensile = 0;
    double shear = 0;
    void add(const Crack& crack) { (crack.mode == CrackMode::tensile ? tensile : shear) += 0.5; }
};

/// Counts of all cracks and for each pair of minerals ("feldspar-quartz", names in alphabetical order) at moments.
struct CrackCounts {
    struct Moment {
        double time = 0;  ///< s
        double axial_strain = 0;
        double stress = 0;  ///< Pa
        bool is_peak = false;
        ModeCounts all;
        std::vector<ModeCounts> by_pair;
    };
    std::vector<std::string> pairs;  ///< those with contacts in the specimen
    std::vector<Moment> moments;
};

/// At `n_moments` + 1 evenly spaced axial strains of the test, and at the peak.
CrackCounts count_cracks(const RunData& run, const LoadCurve& curve, const Specimen& specimen, std::vector<Crack> cracks,
                         std::size_t n_moments = 100);

/// Table: time_s, axial_strain, stress_MPa, is_peak, tensile_cracks, shear_cracks, then for each pair
/// tensile_cracks_PAIR, shear_cracks_PAIR.
void write_crack_counts(std::ostream& out, const CrackCounts& counts, TableFormat format);

}  // namespace graincrack
