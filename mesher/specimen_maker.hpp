// The mesher's one call: from a wish to a specimen.
#pragma once

#include <cstdint>
#include <optional>

#include "mesher/assemblage_builder.hpp"
#include "mesher/point_relaxation.hpp"
#include "mesher/shape.hpp"
#include "share/specimen.hpp"

namespace graincrack::mesher {

/// What is wanted. Exactly one of `edge` and `grains` is set.
struct SpecimenRequest {
    Shape shape;
    std::optional<double> edge;          ///< mean edge over all grain edges, rim included, m
    std::optional<std::int64_t> grains;  ///< exact number of grains
    double spread = 0.1;                 ///< coefficient of variation of the edges, 0 to 0.3
    std::optional<double> notch;         ///< length of a notch across the middle of a rectangle, m
    std::uint64_t seed = 1;
    int elements_per_edge = 1;  ///< each grain becomes n × n constant-strain triangles
};

/// Most diameters that a disc can be loaded along.
inline constexpr int max_diameters = 36;
/// Largest spread the mesher can make.
inline constexpr double max_spread = 0.3;
/// Largest number of elements along a grain edge.
inline constexpr int max_elements_per_edge = 100;
/// A mesh has no preferred direction if |⟨e^(6iθ)⟩| stays below these, as a whole and in each of eight equal parts, whichever
/// `Partition` makes them.
inline constexpr double max_psi6 = 0.15;
inline constexpr double max_psi6_of_parts = 0.30;

/// Numbers that follow from a request before any point is placed.
struct MeshPlan {
    std::int64_t n_grains = 0;
    int n_boundary = 0;       ///< boundary points, and edges
    std::size_t n_inner = 0;  ///< inner points
    double edge = 0;          ///< expected mean edge, m
};

/// Checks a request and plans its numbers. A mesh of n grains (triangles) with b boundary points has (n + 2 − b)/2 inner
/// points, so b and n are both even or both odd.
/// \throws UsageError naming the option: a size, edge, number, spread or division that makes no mesh
MeshPlan plan_mesh(const SpecimenRequest& request);

/// How the wish was met.
struct MeshReport {
    double psi6_of_parts = 0;  ///< largest in eight equal parts, cut in three ways (`Partition`)
    int attempts = 0;          ///< meshes made until one had no preferred direction
};

/// Makes the specimen. The same request gives the same specimen, bit by bit.
///
/// Meshes whose psi6 is above the bounds are made again from further random numbers, up to 100 times; the best one is kept.
/// With a wanted edge the number of grains is corrected until the mean is within 0.5 %, or as near as whole grains allow.
/// \param report filled if given
/// \throws UsageError as `plan_mesh`; Interrupted on a signal
Specimen make_specimen(const SpecimenRequest& request, const ProgressCallback& progress = {}, MeshReport* report = nullptr);

}  // namespace graincrack::mesher
