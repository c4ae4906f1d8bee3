// Polygonal crystals of a region, divided into elements.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mesher/cells/cell_areas.hpp"
#include "mesher/elements/plane_mesh.hpp"
#include "mesher/plane/stretch.hpp"
#include "mesher/region/grading.hpp"
#include "mesher/region/region.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Requested polygons.
struct PolygonRequest {
    std::size_t n = 2;
    double spread = 0.1;  ///< coefficient of variation of the equal-area diameters over their graded size
    SizeDistribution distribution = SizeDistribution::normal;
    double element_size = 0;          ///< side of the elements, m
    bool are_elements_graded = true;  ///< whether that side is graded as crystals are
    Bodies bodies = Bodies::cells;
    std::optional<Grading> grading = {};
    SizeField size = {};  ///< of the grading, over `equilateral_edge`
    Elongation elongation = {};
    std::uint64_t seed = 1;
};

/// What came out.
struct PolygonStatistics {
    std::size_t n_crystals = 0;
    double mean_diameter = 0;       ///< of circles of the areas of crystals, m
    double diameter_variation = 0;  ///< of these over their graded size
    /// Mean diameter in the first and the last eighth of the way over which sizes are graded, and the wanted one, m; 0: none.
    std::array<double, 2> graded_diameter{};
    std::array<double, 2> wanted_diameter{};
    double largest_area_error = 0;  ///< over the wanted area
    Elongation elongation = {};     ///< measured
    std::size_t n_short_edges = 0;  ///< that were removed
    std::size_t n_edges_left = 0;   ///< that are short, but could not be removed
};

struct PolygonMesh {
    PlaneMesh mesh;
    double loading_arc = 0;  ///< as of `Seeds`
    PolygonStatistics statistics;
};

/// Edge of the equilateral triangle that has the area of a polygon on average, m.
double equilateral_edge(const Region& region, double n_polygons);

/// Makes the polygons of a region: cells of wanted areas, without short edges, divided into elements. What the removal of short
/// edges does to areas is undone by small moves of the cells' points, which then move to where elements are better. Elongated
/// cells are made in the plane in which they are equiaxed. Of graded crystals the wanted areas follow from the size where they
/// come to lie (`GradedAreas`).
///
/// \param region whose prescribed edges fit (`fitted_edges`): they become sides of crystals
/// \throws UsageError if walls leave no room; Interrupted on a signal
PolygonMesh polygon_mesh(const Region& region, const PolygonRequest& request, const std::function<void(double)>& progress = {});

}  // namespace graincrack::mesher
