// What is requested of a specimen: a region, flaws, and the fabric of its grains.
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

/// How a region is divided into grains.
enum class Tessellation {
    delaunay,  ///< triangles
    voronoi,   ///< crystals: polygons of elements, which are grains
    trigon,    ///< the same crystals; their triangles are grains, so that they can break
};

/// Distribution of the diameters of crystals, which are those of circles of equal area. Both are cut off three standard
/// deviations from their middle, the normal one also at a quarter of it.
enum class SizeDistribution { normal, lognormal };

/// The grains of a specimen, their phases, and the strength of their boundaries. Exactly one of `edge` and `grains` is set.
struct Fabric {
    Tessellation tessellation = Tessellation::delaunay;
    /// Mean edge over all grain edges, rim included; of crystals that of the equilateral triangle of their mean area, m.
    std::optional<double> edge;
    std::optional<std::int64_t> grains;  ///< exact number of triangles, or of crystals
    /// Coefficient of variation of the edges of triangles over their graded size, 0 to 0.35; of the equal-area diameters of
    /// crystals over theirs, 0 to 0.6.
    double spread = 0.1;
    std::optional<SizeDistribution> size_distribution;  ///< of crystals; none: normal
    std::optional<double> element_size;                 ///< side of the elements of crystals, m; none: 0.36 of their edge, graded
    std::optional<double> elements_per_crystal;         ///< mean number, in place of `element_size`
    int elements_per_edge = 1;                          ///< each triangle becomes n × n elements
    std::optional<Grading>
        grading;            ///< over the region; the mean edge (of crystals area) and the number of grains are as without
    Elongation elongation;  ///< of the grains; the spread is that of the grains before they are elongated
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
    std::vector<JointSet> joint_sets;  ///< whose joints are added to the edges of the region
    std::optional<double> notch;       ///< length of a notch of whole grain boundaries across the middle of a rectangle, m
    Fabric fabric;
    std::uint64_t seed = 1;
};

/// Gives crystals phases, the contacts between them scattered strengths and open boundaries, and names the contacts within
/// crystals that break.
/// \param crystal_of_grain the crystal of every grain
/// \param turn angle by which the specimen was turned from where its field of strengths is, rad
void give_fabric(Specimen& specimen, std::span<const int> crystal_of_grain, const Fabric& fabric, std::uint64_t seed, double turn,
                 bool can_break);

/// Largest number of elements along an edge of a triangle.
inline constexpr int max_elements_per_edge = 100;

}  // namespace graincrack::mesher
