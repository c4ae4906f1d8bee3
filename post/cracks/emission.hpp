// Acoustic emission: micro-cracks that form near each other in space and time are one event.
#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// The largest distance in space and time of two crack points of one event.
struct EmissionWindow {
    double distance = 0;  ///< m
    double time = 0;      ///< s
};
/// Returns two mean edges, and the time in which a crack runs this distance at half the speed of shear waves √(G/ρ) (after
/// Hazzard & Young 2000). \param mean_edge m
EmissionWindow default_window(const Rock& rock, double mean_edge);

struct EmissionEvent {
    double time = 0;                   ///< of the first crack point, s
    double duration = 0;               ///< s
    std::array<double, 2> position{};  ///< mean position of the points, m
    double contacts = 0;               ///< half of the number of points
    double tensile_share = 0;          ///< fraction of tensile points
    double length = 0;                 ///< m
    double energy = 0;                 ///< fracture energy of the points until the end of the run, J per metre of thickness
    /// Two-dimensional moment Σ G L √(δn² + δs²) over the points, with jumps at the event of their label, N·m per m of thickness.
    double moment = 0;
    /// Magnitude (2/3) log10(moment/(N·m)) − 6.07 (Hanks & Kanamori 1979) for 1 m thickness; comparable within one model only.
    [[nodiscard]] double magnitude() const;
};

/// Returns events in the order of their first points. Points are chained: each lies within the window of another of its event.
std::vector<EmissionEvent> find_events(std::vector<Crack> cracks, const Rock& rock, const EmissionWindow& window);

/// Gutenberg–Richter slope of the magnitudes from the completeness on: b = log10(e)/(mean − completeness) ± b/√n (Aki 1965).
struct GutenbergRichter {
    double b = 0;
    double error = 0;
    double completeness = 0;
    std::size_t events = 0;  ///< number of events at or above the completeness
    /// Largest difference between the fraction of events up to a magnitude and the exponential distribution with this slope.
    double distance = 0;
    /// The distance that one in twenty samples exceeds from the exponential distribution with their own mean (Stephens 1974).
    [[nodiscard]] double distance_by_chance() const;
    [[nodiscard]] bool follows_line() const { return distance <= distance_by_chance(); }
};
/// The magnitudes of the events that have a moment.
std::vector<double> magnitudes_of(const std::vector<EmissionEvent>& events);
/// The magnitude at which events are most frequent, in bins of 0.1 (maximum curvature). \pre magnitudes is not empty
double completeness_of(const std::vector<double>& magnitudes);
/// Fits the slope. Empty with fewer than 10 events from the completeness on, for which the standard error is about b/3 or more.
std::optional<GutenbergRichter> fit_gutenberg_richter(const std::vector<double>& magnitudes, double completeness);

/// Writes a table with the columns event, time_s, duration_s, x_mm, y_mm, contacts, tensile_share, length_mm, energy_J,
/// moment_N_m, magnitude.
void write_events(std::ostream& out, const std::vector<EmissionEvent>& events, TableFormat format);

}  // namespace graincrack
