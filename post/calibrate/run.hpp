// Runs of a calibration: those that are wanted, and those that are finished.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "post/calibrate/parameter.hpp"

namespace graincrack::calibrate {

/// A run that a decision needs.
struct WantedRun {
    std::string test;               ///< brazilian, uniaxial, triaxial, tension
    double confining_pressure = 0;  ///< Pa
    std::int64_t seed = 0;          ///< of the specimen
    Point point;
    std::optional<double> max_strain;  ///< of a run with a limit of its own; empty: that of the study
    std::string reason;
    bool notched = false;  ///< a specimen with a notch, for K_IC
};

/// What a finished run is and what it measured, all of it read from the run. SI.
struct FinishedRun {
    std::string test;
    double confining_pressure = 0;
    std::int64_t seed = 0;
    std::array<double, n_parameters> values{};  ///< all parameters, also those that followed from others
    double max_strain = 0;
    double mean_edge = 0;                 ///< of the specimen
    double strength = 0;                  ///< largest stress, positive
    double wall_time = 0;                 ///< s, that it took
    bool has_peak = true;                 ///< the stress fell behind its largest value; else the test ended at its strain limit
    std::optional<double> young_modulus;  ///< of the assemblage, as `moduli` measures it
    std::optional<double> poisson_ratio;
    std::optional<double> predicted_young_modulus;  ///< by the compliance formula
    std::optional<double> predicted_poisson_ratio;
    std::optional<double> crack_initiation;  ///< axial stress, Pa, by count of cracks
    std::optional<double> crack_damage;      ///< axial stress, Pa, at the reversal of volume
    std::optional<double> mode_i_toughness;  ///< Pa √m, of a specimen with a notch
};

/// Finished runs by what they are.
class FinishedRuns {
public:
    /// \param max_strain of runs without a limit of their own
    FinishedRuns(const Material& rock, std::vector<FinishedRun> runs, double max_strain);
    /// The run that is wanted, or nothing.
    [[nodiscard]] const FinishedRun* find(const WantedRun& wanted) const;
    [[nodiscard]] std::size_t size() const { return runs_.size(); }

private:
    using Key = std::tuple<std::string, std::int64_t, std::int64_t>;
    static Key key_of(const std::string& test, double pressure, std::int64_t seed);
    Material rock_;
    std::vector<FinishedRun> runs_;
    std::map<Key, std::vector<std::size_t>> places_;
    double max_strain_ = 0;
};

/// Plane condition of a test: discs in plane stress, all else in plane strain, as the solver's defaults are.
PlaneCondition plane_of(const std::string& test);

/// Whether two wanted runs are the same.
bool same_run(const Material& rock, const WantedRun& a, const WantedRun& b);

}  // namespace graincrack::calibrate
