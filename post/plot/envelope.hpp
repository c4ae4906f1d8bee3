// Mohr circles of a set of tests with the envelopes fitted to them.
#pragma once

#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/fit/envelope.hpp"
#include "post/options/command.hpp"

namespace graincrack {

/// Measured strengths, Pa.
struct LaboratoryStrengths {
    std::string name;
    std::vector<double> confining;
    std::vector<double> strength;  ///< peak σ1
};
/// Columns confining_pressure_MPa and strength_MPa. \throws InputError
LaboratoryStrengths read_laboratory_strengths(const std::string& path);

/// Half circles of all tests, a colour a confining pressure; tension by its circle from −σt to 0, brazilian by that of the
/// disc's centre, from −σt to 3σt. Mohr–Coulomb as a line, Hoek–Brown (compression only) as a dashed curve; measured
/// strengths as dashed circles.
Drawing draw_envelope(const EnvelopeTests& tests, const std::string& title,
                      const std::vector<LaboratoryStrengths>& laboratory = {}, const PictureStyle& style = {});

Command envelope_plot();

}  // namespace graincrack
