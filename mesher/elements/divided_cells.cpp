#include "mesher/elements/divided_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mesher/cells/polygon.hpp"
#include "mesher/elements/divided_polygon.hpp"
#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr double most_points = 10e6;

/// The points that divide each edge of cells.
class DividedEdges {
public:
    /// \param size_at side of elements at a place, m
    DividedEdges(const PlaneCells& cells, const std::function<double(Point)>& size_at)
        : cells_(cells), first_{static_cast<int>(cells.points.size())} {
        const auto pieces = [&](const Edge& e) {
            const Point from = cells_.points[index(e[0])];
            const Point to = cells_.points[index(e[1])];
            return length(to - from) / size_at(midpoint(from, to));
        };
        double n_points = static_cast<double>(cells.points.size());
        for (const Edge& e : cells.edges) n_points += std::floor(pieces(e) + 0.5);
        check_points(n_points);
        for (const Edge& e : cells.edges) {
            const int n_pieces = std::max(1, static_cast<int>(std::lround(pieces(e))));
            first_.push_back(first_.back() + n_pieces - 1);
        }
    }

    static void check_points(double n) {
        if (!(n <= most_points)) {
            throw UsageError("more than " + std::to_string(static_cast<int>(most_points)) + " points are needed");
        }
    }

    /// All points: those of cells, then those that divide their edges.
    [[nodiscard]] std::vector<Point> points() const {
        std::vector<Point> points = cells_.points;
        points.reserve(static_cast<std::size_t>(first_.back()));
        for (std::size_t i = 0; i < cells_.edges.size(); ++i) {
            const Point from = points[index(cells_.edges[i][0])];
            const Point along = points[index(cells_.edges[i][1])] - from;
            const int n_pieces = first_[i + 1] - first_[i] + 1;
            for (int k = 1; k < n_pieces; ++k) points.push_back(from + (static_cast<double>(k) / n_pieces) * along);
        }
        return points;
    }

    /// Appends the start of an edge and its inner points, in the direction from `from` to `to`.
    void append(int from, int to, std::vector<int>& loop) const {
        const Edge edge = edge_between(from, to);
        const auto found = std::lower_bound(cells_.edges.begin(), cells_.edges.end(), edge);
        if (found == cells_.edges.end() || *found != edge) {
            throw Error(ExitCode::internal, "a side of the boundary is no edge of a cell");
        }
        const auto i = static_cast<std::size_t>(found - cells_.edges.begin());
        loop.push_back(from);
        const int n = first_[i + 1] - first_[i];
        for (int k = 0; k < n; ++k) loop.push_back(from < to ? first_[i] + k : first_[i + 1] - 1 - k);
    }

private:
    const PlaneCells& cells_;
    std::vector<int> first_;  ///< [edges + 1] number of the first point between the ends of each
};

/// Sides divided like their edges.
std::vector<Side> pieces_of(const std::vector<Side>& sides, const DividedEdges& edges) {
    std::vector<Side> pieces;
    std::vector<int> line;
    for (const Side& side : sides) {
        line.clear();
        edges.append(side.from, side.to, line);
        line.push_back(side.to);
        for (std::size_t i = 0; i + 1 < line.size(); ++i) pieces.push_back({line[i], line[i + 1], side.part, side.kind});
    }
    return pieces;
}

/// A triangle starting at its point of lowest index, so that the file does not depend on the storage of a triangulation.
Triangle from_lowest(Triangle triangle) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    return triangle;
}

class LatticeBuilder {
public:
    LatticeBuilder(PlaneCells cells, int n)
        : cells_(std::move(cells)), n_(n), n_corners_(static_cast<int>(cells_.points.size())) {
        mesh_.points = std::move(cells_.points);
    }

    PlaneMesh build() {
        add_points_of_edges();
        for (std::size_t cell = 0; cell < cells_.size(); ++cell) add_cell(static_cast<int>(cell));
        for (const Side& side : cells_.sides) {
            const int edge = edge_of(side.from, side.to);
            for (int k = 0; k < n_; ++k) {
                mesh_.sides.push_back(
                    {on_edge(edge, side.from, side.to, k), on_edge(edge, side.from, side.to, k + 1), side.part, side.kind});
            }
        }
        return std::move(mesh_);
    }

private:
    [[nodiscard]] Point at(int p) const { return mesh_.points[index(p)]; }

    void add_points_of_edges() {
        if (n_ == 1) return;
        for (const Edge& e : cells_.edges) {
            for (int k = 1; k < n_; ++k) mesh_.points.push_back(at(e[0]) + (static_cast<double>(k) / n_) * (at(e[1]) - at(e[0])));
        }
    }

    /// Index of an edge; unused if edges are not divided.
    [[nodiscard]] int edge_of(int from, int to) const {
        if (n_ == 1) return 0;
        const Edge edge = edge_between(from, to);
        return static_cast<int>(std::lower_bound(cells_.edges.begin(), cells_.edges.end(), edge) - cells_.edges.begin());
    }

    /// Point k = 0 … n of an edge.
    [[nodiscard]] int on_edge(int edge, int from, int to, int k) const {
        if (k == 0 || k == n_) return k == 0 ? from : to;
        return n_corners_ + edge * (n_ - 1) + (from < to ? k : n_ - k) - 1;
    }

    void add_cell(int cell) {
        Triangle c;
        std::copy_n(cells_.loop(static_cast<std::size_t>(cell)).begin(), 3, c.begin());
        c = from_lowest(c);
        const std::array<int, 3> edges{edge_of(c[0], c[1]), edge_of(c[1], c[2]), edge_of(c[0], c[2])};
        const auto first = mesh_.body_points.size();
        // Point (i, j) lies i steps from corner 0 towards corner 1 and j steps towards corner 2.
        for (int j = 0; j <= n_; ++j) {
            for (int i = 0; i + j <= n_; ++i) mesh_.body_points.push_back(point(c, edges, i, j));
        }
        mesh_.body_start.push_back(static_cast<int>(mesh_.body_points.size()));
        const auto node = [&](int i, int j) {
            return mesh_.body_points[first + static_cast<std::size_t>(j * (n_ + 1) - j * (j - 1) / 2 + i)];
        };
        const auto add = [&](const Triangle& triangle) {
            mesh_.triangles.push_back(triangle);
            mesh_.body_of_triangle.push_back(cell);
        };
        for (int j = 0; j < n_; ++j) {
            for (int i = 0; i + j < n_; ++i) {
                add({node(i, j), node(i + 1, j), node(i, j + 1)});
                if (i + j + 1 < n_) add({node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
            }
        }
        mesh_.crystal_of_body.push_back(cell);
        mesh_.area_of_body.push_back(signed_area(at(c[0]), at(c[1]), at(c[2])));
    }

    int point(const Triangle& c, const std::array<int, 3>& edges, int i, int j) {
        if (j == 0) return on_edge(edges[0], c[0], c[1], i);
        if (i == 0) return on_edge(edges[2], c[0], c[2], j);
        if (i + j == n_) return on_edge(edges[1], c[1], c[2], j);
        const Point origin = at(c[0]);
        mesh_.points.push_back(origin + (static_cast<double>(i) / n_) * (at(c[1]) - origin) +
                               (static_cast<double>(j) / n_) * (at(c[2]) - origin));
        return static_cast<int>(mesh_.points.size()) - 1;
    }

    PlaneCells cells_;
    int n_, n_corners_;
    PlaneMesh mesh_;
};

}  // namespace

PlaneMesh divided_cells(const PlaneCells& cells, Bodies bodies, double element_size,
                        const std::function<double(Point)>& relative_size) {
    const auto size_at = [&](Point p) { return relative_size ? element_size * relative_size(p) : element_size; };
    const DividedEdges edges(cells, size_at);
    PlaneMesh mesh;
    mesh.points = edges.points();
    std::vector<int> loop;
    std::vector<Point> boundary;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        loop.clear();
        boundary.clear();
        const auto corners = cells.loop(cell);
        for (std::size_t i = 0; i < corners.size(); ++i) edges.append(corners[i], corners[(i + 1) % corners.size()], loop);
        for (const int p : loop) boundary.push_back(mesh.points[index(p)]);
        const DividedPolygon divided = divided_polygon(boundary, size_at(moments(corners_of(cells, cell)).centroid));
        for (const Point p : divided.inner) {
            loop.push_back(static_cast<int>(mesh.points.size()));
            mesh.points.push_back(p);
        }
        DividedEdges::check_points(static_cast<double>(mesh.points.size()));
        for (const Triangle& t : divided.triangles) {
            const bool is_new = bodies == Bodies::triangles || &t == divided.triangles.data();
            if (is_new) mesh.crystal_of_body.push_back(static_cast<int>(cell));
            mesh.triangles.push_back(from_lowest({loop[index(t[0])], loop[index(t[1])], loop[index(t[2])]}));
            mesh.body_of_triangle.push_back(static_cast<int>(mesh.n_bodies()) - 1);
        }
    }
    mesh.complete_bodies();
    mesh.sides = pieces_of(cells.sides, edges);
    return mesh;
}

PlaneMesh lattice_mesh(PlaneCells cells, int n) {
    const std::int64_t per_cell = std::max<std::int64_t>((n + 1LL) * (n + 2LL) / 2, 1LL * n * n);
    if (static_cast<std::int64_t>(cells.size()) * per_cell > std::numeric_limits<std::int32_t>::max()) {
        throw UsageError("the specimen would have more than 2^31 - 1 nodes; choose a larger edge or fewer --elements-per-edge");
    }
    return LatticeBuilder(std::move(cells), n).build();
}

}  // namespace graincrack::mesher
