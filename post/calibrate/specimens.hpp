// Specimens of a calibration: their size and grains, and their names.
#pragma once

#include <optional>
#include <string>

#include "post/calibrate/run.hpp"

namespace graincrack::calibrate {

/// The paper's, unless set: rectangles of 80 mm × 160 mm with 1,122 grains, discs of 80 mm with 452.
struct Specimens {
    double width = 0.08;   ///< m
    double height = 0.16;  ///< m
    double diameter = 0.08;
    double grains = 1122;           ///< of a rectangle
    double disc_grains = 452;       ///< of a disc
    std::optional<double> edge;     ///< m: mean edge of the grains, instead of their numbers
    double notch_over_width = 0.4;  ///< length of the notch of specimens for K_IC
    /// Mean edge, m: as it is set, or that of equilateral grains that fill a rectangle.
    [[nodiscard]] double mean_edge() const;
    [[nodiscard]] double notch() const { return notch_over_width * width; }  ///< m
};

/// Name of the specimen that a run needs: "rectangle80x160g1122-s1", "disc80e4-s2", "rectangle80x160g1122n32-s3"; mm, g for a
/// number of grains, e for a mean edge, n for a notch, s for the seed.
std::string specimen_name(const Specimens& specimens, const WantedRun& run);
/// Its options of graincrack-mesh: "disc --diameter 80mm --edge 4mm --seed 2".
std::string mesh_options(const Specimens& specimens, const WantedRun& run);

}  // namespace graincrack::calibrate
