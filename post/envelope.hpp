// Failure envelopes of a set of compression tests: Mohr–Coulomb and Hoek–Brown with 95 % intervals.
#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "post/hoek_brown.hpp"
#include "post/table.hpp"

namespace graincrack {

struct Envelope {
    Estimate cohesion;        ///< C = a/(2√b), Pa
    Estimate friction_angle;  ///< sin φ = (b − 1)/(b + 1), rad
    double r_squared = 0;     ///< of the straight line σ1 = a + b σ3
    std::optional<HoekBrown> hoek_brown;
};

/// Fits both envelopes. The interval of φ is that of the slope b, through which it is monotone; the interval of C is
/// linearised (C and φ stand in one line, so their errors are not independent).
///
/// \param confining σ3, Pa \param strength peak σ1, Pa; equally long
/// \throws InputError unless there are strengths at two or more confining pressures
Envelope fit_envelope(std::span<const double> confining, std::span<const double> strength);

/// What `envelope` does with a run that the strain cap ended: its largest stress is no peak, and a line through such
/// values depends on where the tests were told to end.
enum class CappedRuns { refuse, accept };

/// Writes the table `envelope`, one row for the set of runs. If capped runs are accepted, their number stands in the row
/// and a line on `notes` says so.
/// \throws InputError for a run without a peak: one that the strain cap ended, unless accepted, or that was stopped; for a run
/// that is no compression test, or that differs from the first in law, plane condition,
///         rock or contact parameters: one envelope is the envelope of one material
void write_envelope_table(std::ostream& out, const std::vector<std::string>& runs, TableFormat format, CappedRuns capped_runs,
                          std::ostream& notes);

}  // namespace graincrack
