// Counts of micro-cracks by mode and class of contacts over the loading.
#pragma once

#include <array>
#include <ostream>
#include <string>
#include <vector>

#include "post/cracks/crack_label.hpp"
#include "post/measure/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// Contacts (points ÷ 2) with tensile and with shear cracks.
struct ModeCounts {
    double tensile = 0;
    double shear = 0;
    void add(const Crack& crack) { (crack.mode == CrackMode::tensile ? tensile : shear) += 0.5; }
    ModeCounts& operator+=(const ModeCounts& other) {
        tensile += other.tensile;
        shear += other.shear;
        return *this;
    }
};

/// Cracks of a log by a label, up to a time (s).
ModeCounts count_modes(const std::vector<Crack>& log, const CrackLabel& label, double time);

/// Columns of tables of runs, behind those of `tensile_cracks` and `shear_cracks`: the counts by the other `table_labels`.
const std::vector<std::string>& label_columns();
/// Their entries at a time (s).
std::vector<Cell> label_cells(const std::vector<Crack>& log, CrackEvent event, double time);

/// Replaces the counts of a history by those of some labelled cracks.
void count_in_history(std::vector<Crack> cracks, History& history);

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
