#include "mesher/elements/lattice.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

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
    [[nodiscard]] Point at(int p) const { return mesh_.points[static_cast<std::size_t>(p)]; }

    void add_points_of_edges() {
        if (n_ == 1) return;
        for (const Edge& e : cells_.edges) {
            for (int k = 1; k < n_; ++k) mesh_.points.push_back(at(e[0]) + (static_cast<double>(k) / n_) * (at(e[1]) - at(e[0])));
        }
    }

    /// Index of an edge; not needed if it is not divided.
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
        // Corners start at the point of lowest index, so that the file does not depend on how the triangulation stores a
        // triangle.
        std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
        const std::array<int, 3> edges{edge_of(c[0], c[1]), edge_of(c[1], c[2]), edge_of(c[0], c[2])};
        const auto first = mesh_.body_points.size();
        // Point (i, j) lies i steps from corner 0 to corner 1 and j steps to corner 2.
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
    int n_;
    int n_corners_;
    PlaneMesh mesh_;
};

}  // namespace

PlaneMesh lattice_mesh(PlaneCells cells, int n) {
    const std::int64_t per_cell = std::max<std::int64_t>((n + 1LL) * (n + 2LL) / 2, 1LL * n * n);
    if (static_cast<std::int64_t>(cells.size()) * per_cell > std::numeric_limits<std::int32_t>::max()) {
        throw UsageError("the specimen would have more than 2^31 - 1 nodes; choose a larger edge or fewer --elements-per-edge");
    }
    return LatticeBuilder(std::move(cells), n).build();
}

}  // namespace graincrack::mesher
