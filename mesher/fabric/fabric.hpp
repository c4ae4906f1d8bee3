// The request for a specimen: a region, flaws, and the fabric of its grains.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesher/fabric/open_boundaries.hpp"
#include "mesher/fabric/phases.hpp"
#include "mesher/fabric/strength_field.hpp"
#include "mesher/plane/stretch.hpp"
#include "mesher/region/grading.hpp"
#include "mesher/region/joint_set.hpp"
#include "mesher/region/region.hpp"
#include "share/base/quantities.hpp"

namespace graincrack::mesher {

/// Division of a region into grains.
enum class Tessellation {
    delaunay,  ///< triangles
    voronoi,   ///< grains are crystals: polygons of elements
    trigon,    ///< the same crystals, whose triangles are grains, so that they can break
};

/// Distribution of the diameters of crystals, as circles of equal area. Both are truncated three standard deviations from the
/// middle, the normal one also at a quarter of the middle.
enum class SizeDistribution { normal, lognormal };

/// The grains of a specimen, their phases, and the strength of their boundaries. Exactly one of `edge` and `grains` is set.
struct Fabric {
    Tessellation tessellation = Tessellation::delaunay;
    /// Mean edge over all grain edges, rim included, m; of crystals the edge of the equilateral triangle of their mean area.
    std::optional<double> edge;
    std::optional<std::int64_t> grains;  ///< exact number of triangles, or of crystals
    /// Coefficient of variation: of triangle edges over their graded size, 0 to 0.35; of equal-area diameters of crystals over
    /// their graded size, 0 to 0.6.
    double spread = 0.1;
    std::optional<SizeDistribution> size_distribution;  ///< crystals; missing: normal
    std::optional<double> element_size;                 ///< crystals: side of elements, m; missing: 0.36 of their edge, graded
    std::optional<double> elements_per_crystal;         ///< crystals: mean number, replaces `element_size`
    int elements_per_edge = 1;                          ///< triangles: each becomes n × n elements
    std::optional<Grading> grading;  ///< grading over the region; it keeps the mean edge (crystals: area) and number
    Elongation elongation;           ///< elongation of grains; the spread is that before it
    PhaseRequest phases;
    StrengthRequest strength;
    OpenBoundaryRequest open;

    [[nodiscard]] bool has_crystals() const { return tessellation != Tessellation::delaunay; }
    [[nodiscard]] double widest_spread() const {
        return has_crystals() ? quantity::size_variation.upper : quantity::largest_spread_of_triangles;
    }
};

struct Request {
    Region region;                     ///< centred on the origin
    std::vector<JointSet> joint_sets;  ///< sets of joints, which are added to the edges of the region
    std::optional<double> notch;       ///< length of a notch of whole grain boundaries across the middle of a rectangle, m
    Fabric fabric;
    std::uint64_t seed = 1;
};

/// Assigns phases to crystals, scattered strengths and open states to the contacts between them, and names contacts within
/// crystals that can break.
/// \param crystal_of_grain the crystal of every grain
/// \param turn angle by which the specimen was rotated from its field of strengths, rad
void give_fabric(Specimen& specimen, std::span<const int> crystal_of_grain, const Fabric& fabric, std::uint64_t seed, double turn,
                 bool can_break);

/// Largest number of elements along an edge of a triangle.
inline constexpr int max_elements_per_edge = 100;

}  // namespace graincrack::mesher
