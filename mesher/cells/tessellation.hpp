// A region divided into cells, which become grains: triangles or crystals.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesher/cells/plane_cells.hpp"
#include "mesher/fabric/fabric.hpp"
#include "mesher/seeds/relaxation.hpp"
#include "mesher/seeds/size_field.hpp"
#include "share/base/events.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

/// Numbers that follow from a request before any point is placed.
struct MeshPlan {
    Region region;                   ///< with the prescribed edges that the mesh follows
    std::int64_t n_grains = 0;       ///< or crystals
    int n_boundary = 0;              ///< boundary points, and edges, of triangles
    std::size_t n_inner = 0;         ///< inner points, those of prescribed edges included, of triangles
    double edge = 0;                 ///< expected mean edge, m
    double equal_edge = 0;           ///< of as many equal grains, m
    SizeField size;                  ///< of grains, over `equal_edge`
    double element_size = 0;         ///< of crystals, m
    std::vector<Remark> warnings{};  ///< on prescribed edges: ends that were moved, sets without joints
};

/// Cells as they came out, measured in the plane where they are equiaxed.
struct MeshReport {
    double spread = 0;         ///< coefficient of variation over the graded size: of edges of triangles, of diameters of crystals
    double min_angle = 0;      ///< of triangles, rad; 0: not measured, of a plain region with one size
    double psi6_of_parts = 0;  ///< of triangles: largest |⟨e^(6iθ)⟩| in eight equal parts, over all partitions
    int attempts = 0;          ///< number of meshes of triangles made until one had no preferred direction
    double mean_diameter = 0;  ///< of circles of the areas of crystals, m
    double largest_area_error = 0;   ///< of crystals, over the requested area
    std::size_t n_short_edges = 0;   ///< of crystals that were removed
    std::size_t n_edges_left = 0;    ///< that are short, but could not be removed
    std::size_t n_flaws = 0;         ///< pieces of prescribed edges inside
    double flaw_length = 0;          ///< of them, m
    std::vector<Remark> warnings{};  ///< those of the plan
};

/// Cells of a region.
struct TessellatedRegion {
    MeshPlan plan;  ///< which their number and edges follow
    PlaneCells cells;
    double loading_arc = 0;     ///< as of `Seeds`
    MeshStatistics statistics;  ///< of triangles; of crystals elongation alone
    MeshReport report;
};

/// Checks what triangles and crystals have in common, and that no option is given that they do not have, then plans either.
/// \throws UsageError naming the option if a size, edge, number, spread or subdivision allows no mesh, a flaw has no room, or the
///         fabric does not fit
MeshPlan plan_mesh(const Request& request);

/// Divides the region of a plan into cells (`triangles`, `crystals`). \throws UsageError; Interrupted on a signal
TessellatedRegion tessellate(const Request& request, MeshPlan plan, const ProgressCallback& progress = {});

/// Edge of the equilateral triangle that has the area of a grain on average, m.
double equilateral_edge(const Region& region, double n_grains);
/// Adds the joints of sets to the edges of a plan's region, and fits all of them to the grains.
void add_edges(const Request& request, MeshPlan& plan);
/// Round boundaries must not be small for the grains, which must have room between a round hole and the boundary or another.
void check_walls(const Request& request, const MeshPlan& plan);

}  // namespace graincrack::mesher
