#include "mesher/elements/refined.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "mesher/plane/refined_triangulation.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

/// The edges of cells, each with the cells on both sides.
std::vector<RegionEdge> borders_of(const PlaneCells& cells) {
    std::vector<RegionEdge> borders;
    borders.reserve(cells.edges.size());
    for (const Edge& e : cells.edges) borders.push_back({e[0], e[1], -1, -1});
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        const auto loop = cells.loop(cell);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int from = loop[i];
            const int to = loop[(i + 1) % loop.size()];
            const Edge edge = edge_between(from, to);
            const auto found = std::lower_bound(cells.edges.begin(), cells.edges.end(), edge) - cells.edges.begin();
            RegionEdge& border = borders[static_cast<std::size_t>(found)];
            (from < to ? border.left : border.right) = static_cast<int>(cell);
        }
    }
    return borders;
}

/// Of each point on the boundary the next one, counter-clockwise around the triangles; of others −1.
std::vector<int> next_on_boundary(const RefinedMesh& refined) {
    std::vector<Edge> directed;
    directed.reserve(3 * refined.triangles.size());
    for (const Triangle& t : refined.triangles) {
        for (std::size_t k = 0; k < 3; ++k) directed.push_back({t[k], t[(k + 1) % 3]});
    }
    std::sort(directed.begin(), directed.end());
    std::vector<int> next(refined.points.size(), -1);
    for (const Edge& e : directed) {
        if (!std::binary_search(directed.begin(), directed.end(), Edge{e[1], e[0]})) next[static_cast<std::size_t>(e[0])] = e[1];
    }
    return next;
}

/// Ends of the edges of triangles from each point.
std::vector<std::vector<int>> neighbours_of_points(const RefinedMesh& refined) {
    std::vector<std::vector<int>> neighbours(refined.points.size());
    for (const Triangle& t : refined.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            neighbours[static_cast<std::size_t>(t[k])].push_back(t[(k + 1) % 3]);
            neighbours[static_cast<std::size_t>(t[(k + 1) % 3])].push_back(t[k]);
        }
    }
    return neighbours;
}

/// Sides in the pieces into which points that were added divide them.
std::vector<Side> pieces_of(const std::vector<Side>& sides, const RefinedMesh& refined) {
    const std::vector<int> next = next_on_boundary(refined);
    std::vector<std::vector<int>> neighbours;
    if (!sides.empty() && sides.back().part < 0) neighbours = neighbours_of_points(refined);
    const auto at = [&](int p) { return refined.points[static_cast<std::size_t>(p)]; };
    const auto after = [&](int from, const Side& side) {
        if (side.part >= 0) return next[static_cast<std::size_t>(from)];
        const Point along = at(side.to) - at(from);
        const auto cosine = [&](int q) { return dot(along, unit(at(q) - at(from))); };
        const std::vector<int>& all = neighbours[static_cast<std::size_t>(from)];
        return *std::max_element(all.begin(), all.end(), [&](int p, int q) { return cosine(p) < cosine(q); });
    };
    std::vector<Side> pieces;
    for (const Side& side : sides) {
        for (int from = side.from; from != side.to;) {
            const int to = after(from, side);
            if (to < 0 || pieces.size() > refined.triangles.size() * 3) {
                throw Error(ExitCode::internal, "the triangles do not follow the boundary");
            }
            pieces.push_back({from, to, side.part, side.kind});
            from = to;
        }
    }
    return pieces;
}

/// Numbers of triangles, cell by cell.
std::vector<std::size_t> order_by_cell(const RefinedMesh& refined, std::size_t n_cells) {
    std::vector<std::size_t> start(n_cells + 1, 0);
    for (const int cell : refined.region_of_triangle) ++start[static_cast<std::size_t>(cell) + 1];
    for (std::size_t cell = 0; cell < n_cells; ++cell) start[cell + 1] += start[cell];
    std::vector<std::size_t> order(refined.triangles.size());
    for (std::size_t t = 0; t < order.size(); ++t) order[start[static_cast<std::size_t>(refined.region_of_triangle[t])]++] = t;
    return order;
}

}  // namespace

PlaneMesh refined_mesh(const PlaneCells& cells, Bodies bodies, double element_size,
                       const std::function<double(Point)>& relative_size) {
    Refinement refinement;
    refinement.side = element_size;
    refinement.relative_side = relative_size;
    RefinedMesh refined = refined_triangles(cells.points, borders_of(cells), refinement);

    PlaneMesh mesh;
    std::vector<int> body_with(refined.points.size(), -1);  ///< the last body that has a point
    int last_cell = -1;
    for (const std::size_t t : order_by_cell(refined, cells.size())) {
        const int cell = refined.region_of_triangle[t];
        Triangle triangle = refined.triangles[t];
        // Corners start at the point of lowest index, so that the file does not depend on how a triangle is stored.
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
        if (bodies == Bodies::triangles || cell != last_cell) {
            if (mesh.n_bodies() > 0) mesh.body_start.push_back(static_cast<int>(mesh.body_points.size()));
            mesh.crystal_of_body.push_back(cell);
            mesh.area_of_body.push_back(0);
            last_cell = cell;
        }
        const int body = static_cast<int>(mesh.n_bodies()) - 1;
        for (const int p : triangle) {
            if (std::exchange(body_with[static_cast<std::size_t>(p)], body) != body) mesh.body_points.push_back(p);
        }
        const auto at = [&](std::size_t k) { return refined.points[static_cast<std::size_t>(triangle[k])]; };
        mesh.area_of_body.back() += signed_area(at(0), at(1), at(2));
        mesh.triangles.push_back(triangle);
        mesh.body_of_triangle.push_back(body);
    }
    mesh.body_start.push_back(static_cast<int>(mesh.body_points.size()));
    mesh.sides = pieces_of(cells.sides, refined);
    mesh.points = std::move(refined.points);
    return mesh;
}

}  // namespace graincrack::mesher
