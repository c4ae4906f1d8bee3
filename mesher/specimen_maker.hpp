// Makes a specimen from a request: the interface of the mesher.
#pragma once

#include <cstdint>
#include <optional>

#include "mesher/assemblage/size_statistics.hpp"
#include "mesher/elements/polygons.hpp"
#include "mesher/fabric/open_boundaries.hpp"
#include "mesher/fabric/phases.hpp"
#include "mesher/fabric/strength_field.hpp"
#include "mesher/region/grading.hpp"
#include "mesher/region/joint_set.hpp"
#include "mesher/region/shapes.hpp"
#include "mesher/seeds/relaxation.hpp"
#include "share/base/quantities.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// How a region is divided into grains.
enum class Tessellation {
    delaunay,  ///< triangles
    voronoi,   ///< polygons of elements, which are grains
    trigon,    ///< the same polygons, which are crystals; their triangles are grains
};

/// Requested properties of a specimen. Exactly one of `edge` and `grains` is set.
struct SpecimenRequest {
    Region region;                     ///< centred on the origin
    std::vector<JointSet> joint_sets;  ///< whose joints are added to the edges of the region
    Tessellation tessellation = Tessellation::delaunay;
    /// Mean edge over all grain edges, rim included; of polygons that of the equilateral triangle of their mean area, m.
    std::optional<double> edge;
    std::optional<std::int64_t> grains;  ///< exact number of grains, or of polygons
    /// Coefficient of variation of the edges over their graded size, 0 to 0.35; of the equal-area diameters of polygons
    /// over theirs, 0 to 0.6.
    double spread = 0.1;
    std::optional<SizeDistribution> size_distribution;  ///< of polygons; none: normal
    std::optional<double> element_size;                 ///< side of the elements of polygons, m; none: 0.36 of their edge, graded
    std::optional<double> elements_per_crystal;         ///< mean number of elements of a polygon, in place of `element_size`
    std::optional<Grading>
        grading;                  ///< over the region; the mean edge (of polygons area) and the number of grains are as without
    Elongation elongation;        ///< of the grains; the spread is that of the grains before they are elongated
    std::optional<double> notch;  ///< length of a notch of whole grain boundaries across the middle of a rectangle, m
    std::uint64_t seed = 1;
    int elements_per_edge = 1;  ///< each grain becomes n × n constant-strain triangles
    PhaseRequest phases;
    StrengthRequest strength;
    OpenBoundaryRequest open;
};

/// Largest number of diameters along which a disc can be loaded.
inline constexpr int max_diameters = 36;
/// Largest spread that the mesher can reach.
inline constexpr double max_spread = quantity::largest_spread_of_triangles;
/// Largest spread of polygons.
inline constexpr double max_spread_of_polygons = quantity::size_variation.upper;
/// Side of the elements of polygons over their edge, unless given: about seven elements a polygon, eight at a spread of 0.6.
inline constexpr double element_over_edge = 0.36;
/// Largest elongation of grains.
inline constexpr double max_elongation = 4;
/// Largest number of elements along a grain edge.
inline constexpr int max_elements_per_edge = 100;
/// A mesh counts as free of a preferred direction if |⟨e^(6iθ)⟩| is below these bounds, in the whole mesh and in each of eight
/// equal parts, for every `Partition`; of elongated grains in the plane where they are equiaxed.
inline constexpr double max_psi6 = 0.15;
inline constexpr double max_psi6_of_parts = 0.30;
/// With holes, flaws or sizes that differ, a mesh with a smaller angle, rad (8°), is made again from other random numbers too; of
/// elongated grains in the plane where they are equiaxed.
inline constexpr double smallest_angle = 0.14;

/// Numbers that follow from a request before any point is placed.
struct MeshPlan {
    Region region;              ///< with the prescribed edges that the mesh follows
    std::int64_t n_grains = 0;  ///< or polygons
    int n_boundary = 0;         ///< boundary points, and edges
    std::size_t n_inner = 0;    ///< inner points, those of prescribed edges included
    double edge = 0;            ///< expected mean edge, m
    double equal_edge = 0;      ///< of as many equal grains, m
    SizeField size;             ///< of grains, over `equal_edge`
    double element_size = 0;    ///< of polygons, m
};

/// Checks a request and plans its numbers. A mesh of n grains (triangles) with b boundary points and h holes has
/// (n + 2 − 2h − b)/2 inner points, so b and n are both even or both odd. Of polygons the number, the edge and the size of
/// elements are planned.
/// \throws UsageError naming the option if a size, edge, number, spread or subdivision allows no mesh, a flaw has no room, or the
///         fabric does not fit
MeshPlan plan_mesh(const SpecimenRequest& request);

/// Result of the attempts to make a mesh.
struct MeshReport {
    SizeStatistics sizes;
    double psi6_of_parts = 0;  ///< largest |⟨e^(6iθ)⟩| in eight equal parts, over all partitions
    std::size_t n_flaws = 0;   ///< pieces of prescribed edges inside
    double flaw_length = 0;    ///< of them, m
    int attempts = 0;          ///< number of meshes made until one had no preferred direction
    PolygonStatistics polygons;
};

/// Makes the specimen: region → seeds → cells → elements → bodies → fabric; seeds are relaxed in the plane where grains are
/// equiaxed. The same request gives the same specimen, bit for
/// bit.
///
/// A mesh whose psi6 is above the bounds is made again from other random numbers, up to 100 times, with holes and flaws 40; the
/// best mesh is kept. If an edge is requested, the number of grains is corrected until the mean edge is within 0.5 %, or as near
/// as whole grains allow. Polygons are made once: region → cells → elements → bodies → fabric.
/// \param report filled unless null \throws UsageError as `plan_mesh`; Interrupted on a signal
Specimen make_specimen(const SpecimenRequest& request, const ProgressCallback& progress = {}, MeshReport* report = nullptr);

}  // namespace graincrack::mesher
