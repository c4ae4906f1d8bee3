// Acoustic emission: micro-cracks that fail near each other in space and time are one event.
#pragma once

#include <optional>
#include <ostream>
#include <vector>

#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"
#include "share/file/run_file.hpp"

namespace graincrack {

/// When two crack points belong to one event.
struct EmissionWindow {
    double distance = 0;  ///< m
    double time = 0;      ///< s
};
/// Two mean edges, and the time in which a crack runs so far at half the speed of shear waves √(G/ρ) (after Hazzard & Young
/// 2000).
EmissionWindow default_window(const Rock& rock, double mean_edge);

struct EmissionEvent {
    double time = 0;                   ///< of the first crack point, s
    double duration = 0;               ///< s
    std::array<double, 2> position{};  ///< mean of the points, m
    double contacts = 0;               ///< points ÷ 2
    double tensile_share = 0;          ///< of the points
    double length = 0;                 ///< m
    double energy = 0;                 ///< fracture energy of the points until the end of the run, J per metre of thickness
    /// Σ G L √(δn² + δs²) over the points with their jump at the event of their label: a two-dimensional moment, N·m per metre of
    /// thickness.
    double moment = 0;
    /// (2/3) log10(moment/(N·m)) − 6.07 (Hanks & Kanamori 1979) for a metre of thickness: values are comparable within one model
    /// only.
    [[nodiscard]] double magnitude() const;
};

/// Events in the order of their first points. Points are chained: each lies within the window of another point of its event.
std::vector<EmissionEvent> find_events(std::vector<Crack> cracks, const Rock& rock, const EmissionWindow& window);

/// Gutenberg–Richter slope of magnitudes from a completeness on: b = log10(e)/(mean − completeness), standard error b/√n
/// (Aki 1965).
struct GutenbergRichter {
    double b = 0;
    double error = 0;
    double completeness = 0;
    std::size_t events = 0;  ///< at or above the completeness
    /// Largest distance between the share of events up to a magnitude and that of the exponential distribution with this slope.
    double distance = 0;
    /// The distance that one in twenty samples of an exponential distribution exceeds, whose mean is their own (Stephens 1974).
    [[nodiscard]] double distance_by_chance() const;
    [[nodiscard]] bool follows_line() const { return distance <= distance_by_chance(); }
};
/// Those of the events that have a moment.
std::vector<double> magnitudes_of(const std::vector<EmissionEvent>& events);
/// The magnitude at which events are most frequent, in bins of 0.1 (maximum curvature). \pre magnitudes is not empty
double completeness_of(const std::vector<double>& magnitudes);
/// Empty with fewer than 10 events from the completeness on: the standard error would be a third of b or more.
std::optional<GutenbergRichter> fit_gutenberg_richter(const std::vector<double>& magnitudes, double completeness);

/// Table: event, time_s, duration_s, x_mm, y_mm, contacts, tensile_share, length_mm, energy_J, moment_N_m, magnitude.
void write_events(std::ostream& out, const std::vector<EmissionEvent>& events, TableFormat format);

}  // namespace graincrack
