// Stress–strain curves of one or several runs, with laboratory curves beside them; with one run also its cracks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// A measured curve: strains as they are drawn (positive in the sense of the test, widening negative), stress in Pa.
struct LaboratoryCurve {
    std::string name;
    std::vector<double> axial_strain;
    std::vector<double> lateral_strain;  ///< empty if not measured
    std::vector<double> stress;
};

/// Reads a table with the columns axial_strain or axial_strain_percent, stress_MPa, and perhaps lateral_strain or
/// lateral_strain_percent (widening negative, as laboratories plot it). \throws InputError
LaboratoryCurve read_laboratory_curve(const std::string& path);

/// Axial stress (positive in the sense of the test; brazilian: 2F/(πtD)) against axial strain to the right and lateral
/// strain to the left, both from platens and rim. A first peak below the largest stress has a triangle, the residual strength a
/// short line. One run: the counts of its micro-cracks on a second scale.
/// \throws InputError if brazilian, tension and compression runs are mixed: their stresses do not mean the same
/// \param definition of the cracks that the histories count, in words \param caveats caveats of the strength, a
/// line each
Drawing draw_curves(const std::vector<RunData>& runs, const std::vector<LaboratoryCurve>& laboratory,
                    const std::string& definition, const std::vector<std::string>& caveats = {}, const PictureStyle& style = {});

Command curve_plot();

}  // namespace graincrack
