// Divides a region into cells, which become grains: triangles or crystals.
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

/// Numbers that follow from a request before points are placed.
struct MeshPlan {
    Region region;                   ///< region with the prescribed edges that the mesh follows
    std::int64_t n_grains = 0;       ///< number of triangles or crystals
    int n_boundary = 0;              ///< triangles: number of boundary points and edges
    std::size_t n_inner = 0;         ///< triangles: number of inner points, with those of prescribed edges
    double edge = 0;                 ///< expected mean edge, m
    double equal_edge = 0;           ///< edge of as many equal grains, m
    SizeField size;                  ///< relative size of grains, over `equal_edge`
    double element_size = 0;         ///< size of elements of crystals, m
    std::vector<Remark> warnings{};  ///< about prescribed edges: moved ends, sets without joints
};

/// Measures of the cells, in the plane where they are equiaxed.
struct MeshReport {
    double spread = 0;         ///< coefficient of variation over the graded size: of edges of triangles, of diameters of crystals
    double min_angle = 0;      ///< triangles: smallest angle, rad; 0: not measured (plain region of one size)
    double psi6_of_parts = 0;  ///< triangles: largest |⟨e^(6iθ)⟩| in eight equal parts, over all partitions
    int attempts = 0;          ///< triangles: number of meshes until one has no preferred direction
    double mean_diameter = 0;  ///< crystals: mean diameter of circles of their areas, m
    double largest_area_error = 0;   ///< crystals: largest area error, over the requested area
    std::size_t n_short_edges = 0;   ///< crystals: number of removed short edges
    std::size_t n_edges_left = 0;    ///< crystals: number of short edges that could not be removed
    std::size_t n_flaws = 0;         ///< number of pieces of prescribed edges inside
    double flaw_length = 0;          ///< their length, m
    std::vector<Remark> warnings{};  ///< warnings of the plan
};

/// Cells of a region.
struct TessellatedRegion {
    MeshPlan plan;  ///< plan that the cells follow
    PlaneCells cells;
    double loading_arc = 0;     ///< see `Seeds`
    MeshStatistics statistics;  ///< triangles: all; crystals: elongation only
    MeshReport report;
};

/// Checks the common conditions of triangles and crystals, refuses options of the other kind, then plans the cells.
/// \throws UsageError naming the option if a size, edge, number, spread or subdivision allows no mesh, a flaw has no room, or the
///         fabric does not fit
MeshPlan plan_mesh(const Request& request);

/// Divides the region of a plan into cells (`triangles`, `crystals`). \throws UsageError; Interrupted on a signal
TessellatedRegion tessellate(const Request& request, MeshPlan plan, const ProgressCallback& progress = {});

/// Edge of the equilateral triangle with the mean area of a grain, m.
double equilateral_edge(const Region& region, double n_grains);
/// Adds the joints of sets to the edges of a plan's region, and fits all edges to the grains (`fitted_edges`).
void add_edges(const Request& request, MeshPlan& plan);
/// Checks that round boundaries are not small for the grains, and that grains have room between a round hole and other loops.
void check_walls(const Request& request, const MeshPlan& plan);

}  // namespace graincrack::mesher
