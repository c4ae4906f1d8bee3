// Properties of a rock on specimens beside those of its laboratory (the paper's Table 8): one row a property.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "post/fit/envelope.hpp"
#include "post/kind/kind_surface.hpp"
#include "post/run/load_curve.hpp"
#include "post/table/table.hpp"
#include "share/rock/material.hpp"

namespace graincrack {

/// A row: a property in the unit of its name. Empty: unknown, or it does not apply.
struct PropertyRow {
    std::string name;               ///< "young_modulus_GPa"
    double confining_pressure = 0;  ///< of σ1, Pa
    std::optional<double> laboratory = std::nullopt;
    std::optional<double> published = std::nullopt;  ///< of the paper's model, for the paper's rock
    Estimate ours = {};
    std::optional<double> deviation = std::nullopt;  ///< over specimens; of C and φ over seeds with tests at all pressures
    std::size_t specimens = 0;
    /// Those that did not fail: not among the specimens, unless the largest stress is taken as the strength.
    std::optional<std::size_t> without_peak = std::nullopt;
    bool is_mean = false;                               ///< of a sample of specimens; else from a fit through all of them
    std::optional<KindPrediction> kind = std::nullopt;  ///< of a new specimen, by the surface of the kind of rock

    /// 100 (ours/laboratory − 1)
    [[nodiscard]] std::optional<double> off_laboratory_percent() const;
    /// Half of the 95 % interval over our value.
    [[nodiscard]] std::optional<double> half_interval_percent() const;
    /// Specimens, at least three, whose mean has a 95 % half interval of 3 %, with the deviation of these.
    [[nodiscard]] std::optional<double> specimens_for_3_percent() const;
};

/// E and ν (chord to half the peak) of the uniaxial tests, tensile strengths, σ1 at each pressure, and C, φ and b of the line
/// through them, also by the stress at first yield. The laboratory's σ1 under pressure is that of its line σ1 = 2C√b + b σ3. What
/// the runs do not give is left out, as are fits through a single pressure. \throws InputError as require_comparable and
/// collect_envelope_tests
std::vector<PropertyRow> measure_properties(const std::vector<RunData>& runs, const Material& material,
                                            const EnvelopeOptions& options);

/// What the surface of its kind says of new specimens of a material, in the rows of its properties, and behind them in rows
/// without runs: σ1 at the pressures of the rows, of [targets] and of the laboratory, else at 8 and 20 MPa. \return why it says
/// nothing; "" if it does \throws InputError for a broken table or [targets]
std::string add_predictions(std::vector<PropertyRow>& properties, IncompleteMaterial material);

/// Table property, laboratory, published, ours, low, high, deviation, specimens, without_peak, off_laboratory_percent,
/// half_interval_percent, specimens_for_3_percent, kind_median, kind_50_low, kind_50_high, kind_95_low, kind_95_high.
void write_properties(std::ostream& out, const std::vector<PropertyRow>& properties, TableFormat format);

}  // namespace graincrack
