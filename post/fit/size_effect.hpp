// Strength against grain size: a power law with its interval, beside the exponents of theory and, for its rock, of the paper.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/measure/strength.hpp"
#include "post/run/load_curve.hpp"
#include "post/statistics/statistics.hpp"
#include "post/table/table.hpp"

namespace graincrack {

/// strength = coefficient · (dp/1 mm)^exponent
struct PowerLaw {
    Estimate exponent;
    double coefficient = 0;  ///< Pa: the strength at a mean edge of 1 mm
    Line logarithms;         ///< through ln(edge/mm) and ln(strength/Pa)
    /// The mean strength at an edge (m) with its 95 % interval, Pa.
    [[nodiscard]] Estimate strength_at(double edge) const;
};
/// Straight line through logarithms: relative errors of equal size. Every run counts once, so the weight of a size is its number
/// of seeds. Empty unless there are two different edges. \param edge m \param strength Pa
std::optional<PowerLaw> fit_power_law(const std::vector<double>& edge, const std::vector<double>& strength);

/// σt ∝ dp^½ at fixed contact parameters (paper, Eq 44).
inline constexpr double theory_exponent = 0.5;
/// The exponent the paper finds for σt of Augig granite (Fig 10).
inline constexpr double paper_exponent = 0.39;

/// Runs of one test at one confining pressure.
struct SizeSeries {
    std::string test;
    double confining_pressure = 0;      ///< Pa
    std::vector<double> edge;           ///< m
    std::vector<double> strength;       ///< Pa
    std::vector<std::string> left_out;  ///< runs without a strength: their names and the reason
    std::size_t at_strain_limit = 0;    ///< runs stopped at the strain limit, whose largest stress stands for a peak
    double contact_zone_length = 0;     ///< (9π/32) Ẽ Gf/tc², m
    bool of_paper = false;              ///< the rock is that of the paper
    /// The exponent to compare with; empty for another rock or test than the paper's.
    [[nodiscard]] std::optional<double> exponent_of_paper() const {
        return of_paper && test == "brazilian" ? std::optional(paper_exponent) : std::nullopt;
    }
};
/// Mean edges of seeds of one size differ by up to a percent; scatter of 4 % in the strengths over this ratio of edges is an
/// exponent of 0.2, half of the exponent of a typical size effect.
inline constexpr double min_edge_ratio = 1.2;
/// Runs without a strength are left out. \throws InputError for runs of different materials or of unknown mean edge, for a series
/// of one size, and as `strength_for_fit`
std::vector<SizeSeries> collect_sizes(const std::vector<RunData>& runs, const EnvelopeOptions& options);

/// A row a series. `diagnostics` gets a line for each run that was left out, and one if the largest
/// stress of some stands for a peak.
void write_size_effect_table(std::ostream& out, const std::vector<RunData>& runs, TableFormat format,
                             const EnvelopeOptions& options, std::ostream& diagnostics);

}  // namespace graincrack
