// Counts of micro-cracks by mode and class of contacts.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "post/run/load_curve.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// The contacts of a class, and how many of them cracked.
struct ClassCounts {
    std::string name;  ///< "quartz-mica"
    std::size_t contacts = 0;
    double length = 0;                       ///< m
    std::optional<ModeCounts> at_peak = {};  ///< by the time of the peak; empty for a run without one
    ModeCounts at_end = {};
};
/// Those of a run, and what their cracks are.
struct RunClasses {
    std::string run;         ///< name of its file
    std::string definition;  ///< of its cracks in words
    std::vector<ClassCounts> classes;
    std::optional<ClassCounts> crystals = {};  ///< with cracks within them; `contacts` is the number of all
    [[nodiscard]] double length() const;       ///< of all contacts, m
};

/// \param cracks labelled ones of the whole run \param peak time of the peak, s
std::vector<ClassCounts> count_by_class(const Specimen& specimen, const std::vector<Crack>& cracks,
                                        const std::optional<double>& peak);
/// \param cracks as above, of `label` \param peak its time, s
RunClasses classes_of_run(const std::string& run, const Specimen& specimen, const std::vector<Crack>& cracks,
                          const CrackLabel& label, const std::optional<double>& peak);
/// \throws InputError as `read_cracks`
RunClasses read_classes(const RunReader& run, const CrackLabelChoice& label);

/// Table, one row per class: file, class, contacts, length_m, length_share, tensile_cracks, shear_cracks by the peak,
/// tensile_cracks_at_end, shear_cracks_at_end; for the terminal with the sums of each run, also within and between crystals,
/// and how many crystals have cracks within them.
void write_class_counts(std::ostream& out, const std::vector<RunClasses>& runs, TableFormat format);

/// Contacts (points ÷ 2) up to some time.
struct CrackBalance : ModeCounts {
    double separated = 0;  ///< of both, those without any strength left then
};
/// \param cracks labelled ones
CrackBalance balance_cracks(const std::vector<Crack>& cracks, double time);

}  // namespace graincrack
