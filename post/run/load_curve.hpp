// The stress–strain curve of a test with signs in the sense of its loading, and the points that all tables take from it.
//
// Here, unlike in files, stress and axial strain are positive in the sense of the test: compression for uniaxial,
// triaxial, brazilian and bend, tension for tension. For brazilian the stress is 2 F/(π t D) (Eq 18), t = 1 m, F the mean of
// the two platen forces; for bend the nominal bending stress of a beam, 3 F S/(2 t H²), or F/(t D) of a half-disc; for the
// others it is the axial stress of the history.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "post/run/crack_label.hpp"
#include "share/file/peak.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// Attributes of the specimen that tables need, without its arrays; NaN for those that the file does not hold.
struct SpecimenSummary {
    double width = 0;   ///< m
    double height = 0;  ///< m
    std::int64_t seed = 0;
    std::int64_t grains = 0;
    double mean_edge = 0;  ///< m
    std::string shape = {};
    bool is_cracked = false;  ///< there are pre-existing cracks; open boundaries are none
    std::size_t holes = 0;
    double area = 0;  ///< of all grains, m²
    std::string tessellation = {};
    std::int64_t crystals = 0;        ///< grains, or what several of them are
    double grain_diameter = 0;        ///< mean of the crystals' equal-area diameters, m
    double elements_per_crystal = 0;  ///< mean
    bool has_strength_factors = false;
    std::map<std::string, double> phases = {};  ///< fractions of the area
    Settings settings = {};                     ///< by which it was made
};
SpecimenSummary specimen_summary(const H5Input& file);

/// A finished test without its frames and its crack log.
struct RunData {
    std::string name;  ///< file, for messages and tables
    RunHeader header;
    History history;
    SpecimenSummary specimen;
    double wall_time = 0;              ///< s
    std::string specimen_digest = {};  ///< of the file of its specimen; "" if unknown
    std::string program = {};          ///< text of a loading program; "" of a standard test
    /// Contacts that failed by each row, by the event of the run, where `history` counts by another one.
    std::vector<double> failed = {};
};
/// \param path a run file or "-" \throws InputError
RunData read_run_data(const std::string& path);
/// The same for each of several, in their order.
std::vector<RunData> read_runs(const std::vector<std::string>& paths);
/// \param label of the cracks that the history then counts; the file itself counts points past their peak, by the sign of the
///        opening
RunData run_data(const RunReader& run, const CrackLabelChoice& label = {});

struct LoadCurve {
    std::vector<double> axial_strain;    ///< platen approach over height
    std::vector<double> lateral_strain;  ///< elongation positive, in every test
    std::vector<double> gauge_axial_strain;
    std::vector<double> gauge_lateral_strain;
    std::vector<double> stress;         ///< Pa
    std::vector<double> failed;         ///< contacts
    std::size_t start = 0;              ///< row at which axial loading begins: 0, or the end of the isotropic stage
    std::size_t largest = 0;            ///< row of the largest stress from `start` on
    std::optional<Peak> strength = {};  ///< by `find_strength`; empty for a test that did not fail
    /// Row of the strength, or of the largest stress of a test that did not fail. What stands beside a strength is of this row.
    std::size_t peak = 0;
    [[nodiscard]] double start_stress() const { return stress[start]; }
    /// The strength, which is of the smoothed curve, or the largest stress of a test that did not fail.
    [[nodiscard]] double peak_stress() const { return strength ? strength->stress : stress[peak]; }
    /// Stress of a row; up to the peak no more than the strength, so that pictures, thresholds and tables have one peak.
    [[nodiscard]] double shown_stress(std::size_t row) const {
        return row > peak ? stress[row] : std::min(stress[row], peak_stress());
    }
    /// True if the stress exceeds the strength later.
    [[nodiscard]] bool exceeds_strength() const { return peak < largest; }
    /// "peak", or of a test that did not fail "largest stress".
    [[nodiscard]] const char* peak_name() const { return strength ? "peak" : "largest stress"; }
    /// Its rows from `start` on.
    [[nodiscard]] CurveColumns loaded() const;
};

/// \throws InputError if the history is too short, or never loads the specimen in the sense of its test
LoadCurve load_curve(const RunData& run);
/// Empty for a run that was never loaded along its axis, such as a program of other motions.
std::optional<LoadCurve> load_curve_if_any(const RunData& run);

/// What goes along in each row of the history of a test of any kind: two quantities with their names, in their units.
struct LoadCourse {
    std::string across, across_unit;  ///< "axial strain", "%"
    std::string up, up_unit;          ///< "axial stress", "MPa"
    std::vector<double> x, y;
};
/// The load curve; of a run that was not loaded along its axis force over displacement of that boundary of its program, along x
/// or y, whose ranges of both have the largest product; without any axial stress over time.
LoadCourse load_course(const RunReader& run, const RunData& data);

/// The row of the history in which a time (s) is reached; the last if it is later. \pre it has rows
std::size_t row_at(const History& history, double time);

/// A point between two rows: share 0 is `row`, share 1 is `row + 1`.
struct CurvePoint {
    std::size_t row = 0;
    double share = 0;
    [[nodiscard]] double of(const std::vector<double>& column) const;
};
/// The point where the stress, before the peak, first reaches a share of its way from `start` to the peak. \pre 0 < share ≤ 1
CurvePoint share_of_peak(const LoadCurve& curve, double share);
inline CurvePoint half_peak(const LoadCurve& curve) { return share_of_peak(curve, 0.5); }
/// Rows [begin, end) between two such points; the rows on either side are included, so that there are two at least.
struct RowRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};
RowRange rows_between(const LoadCurve& curve, double low_share, double high_share);

/// Stress at first yield, Pa: where, after half the peak and no later than the peak, the platen strain first exceeds the
/// chord from the start to half the peak, prolonged, by 0.01 % strain. Empty if it never does (brittle failure).
std::optional<double> first_yield(const LoadCurve& curve);
inline constexpr double yield_offset = 1e-4;

/// Stress where the platen strain first reaches a strain, before or after the peak, Pa. Empty if the test ended before.
std::optional<double> stress_at_strain(const LoadCurve& curve, double strain);

/// The name of the stress of a load curve: "axial stress", "2F/(πtD)", "3FS/(2tH²)" of a beam in bending, "F/(tD)" of a
/// half-disc.
std::string stress_name(const RunData& run);

/// Uniaxial or triaxial.
bool is_compression(const RunSettings& header);

/// The fall behind the largest stress, as a share of it, over which brittleness is measured: that which ends the test, at most
/// 0.3.
double decisive_drop(const RunSettings& header);

/// "drop" if the test failed; "cap" if it was stopped at the strain limit before that, "" if otherwise.
std::string peak_kind(const RunHeader& header, bool has_failed);

}  // namespace graincrack
