// The curves of the contact laws (Fig 2), and the potential from which the paper derives the thickness of a contact (Fig 11).
#pragma once

#include <string>
#include <vector>

#include "post/chart/drawing.hpp"
#include "post/chart/picture_style.hpp"
#include "post/options/command.hpp"
#include "share/rock/material.hpp"
#include "solver/law/table.hpp"

namespace graincrack {

/// Which curves of the laws are drawn.
struct LawPlotOptions {
    std::vector<std::string> laws;  ///< names; empty: all
    std::string coupling = "full";
    double normal_stress = 20e6;                          ///< compression under which a contact is sheared, Pa
    std::string own = std::string(name_of(default_law));  ///< of the material, whose curve is black
};

/// Below one another, on a wide page side by side: traction against opening, with an unloading half-way down; the same near the
/// peak; shear traction against
/// sliding of an open contact (δn = 0) and of one under compression, solid and dashed. \throws UsageError for an unknown law
Drawing draw_laws(const ContactParameters& contact, const std::string& title, const LawPlotOptions& options,
                  const PictureStyle& style = {});

/// P(z)/X = a [(ζ/z)^n − (ζ/z)^m] (Eqs 20–22) and its slope for the pairs (m, n) of Table 9's corners and middle, with b.
Drawing draw_lennard_jones(const PictureStyle& style = {});

Command law_plot();
Command lennard_jones_plot();

}  // namespace graincrack
