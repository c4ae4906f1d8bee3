#include "mesher/assemblage_builder.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "share/error.hpp"

namespace graincrack::mesher {

namespace {

/// One side of a grain: from corner `side` to the next, counter-clockwise.
struct GrainSide {
    std::int32_t grain;
    int side;
};

/// The lattice of nodes inside a grain divided n × n: node (i, j) lies i steps along side 0 and j along side 2 reversed.
class GrainLattice {
public:
    explicit GrainLattice(int n) : n_(n) {}
    [[nodiscard]] std::int32_t n_nodes() const { return (n_ + 1) * (n_ + 2) / 2; }
    [[nodiscard]] std::int32_t node(int i, int j) const { return j * (n_ + 1) - j * (j - 1) / 2 + i; }
    /// Node k = 0 … n along a side, counter-clockwise.
    [[nodiscard]] std::int32_t node_on_side(int side, int k) const {
        if (side == 0) return node(k, 0);
        return side == 1 ? node(n_ - k, k) : node(0, n_ - k);
    }

private:
    int n_;
};

class Builder {
public:
    Builder(const Outline& outline, const PlaneMesh& mesh, int n) : outline_(outline), points_(mesh.points), n_(n), lattice_(n) {
        order_grains(mesh.triangles);
        sort_sides();
    }

    void add_grains(Specimen& s) const {
        for (std::size_t g = 0; g < grains_.size(); ++g) {
            const auto first = static_cast<std::int32_t>(s.node_position.size());
            for (int j = 0; j <= n_; ++j) {
                for (int i = 0; i + j <= n_; ++i) s.node_position.push_back(position(grains_[g], i, j));
            }
            const auto add = [&](int i0, int j0, int i1, int j1, int i2, int j2) {
                s.element_nodes.push_back(
                    {first + lattice_.node(i0, j0), first + lattice_.node(i1, j1), first + lattice_.node(i2, j2)});
                s.element_grain.push_back(static_cast<std::int32_t>(g));
            };
            for (int j = 0; j < n_; ++j) {
                for (int i = 0; i + j < n_; ++i) {
                    add(i, j, i + 1, j, i, j + 1);
                    if (i + j + 1 < n_) add(i + 1, j, i + 1, j + 1, i, j + 1);
                }
            }
            s.grain_phase.push_back(0);
            s.grain_area.push_back(signed_area(corner(g, 0), corner(g, 1), corner(g, 2)));
        }
    }

    void add_contacts(Specimen& s) const {
        std::int32_t boundary = 0;
        std::vector<std::pair<GrainSide, int>> later;  // neighbours of a with a larger index, and the side of a
        for (std::size_t a = 0; a < grains_.size(); ++a) {
            later.clear();
            for (int side = 0; side < 3; ++side) {
                const GrainSide other = facing(a, side);
                if (other.grain > static_cast<std::int32_t>(a)) later.emplace_back(other, side);
            }
            std::sort(later.begin(), later.end(), [](const auto& l, const auto& r) { return l.first.grain < r.first.grain; });
            for (const auto& [other, side] : later)
                add_grain_boundary(s, {static_cast<std::int32_t>(a), side}, other, boundary++);
        }
    }

    void add_boundary(Specimen& s) const {
        const std::size_t n_points = outline_.points.size();
        for (std::size_t p = 0; p < n_points; ++p) {
            const auto from = static_cast<int>(p);
            const auto to = static_cast<int>((p + 1) % n_points);
            const GrainSide inside = side_from(from, to);
            if (inside.grain < 0) throw Error(ExitCode::internal, "the mesh does not follow its outline");
            for (int k = 0; k < n_; ++k) {
                s.boundary_edges.push_back({node(inside, k), node(inside, k + 1)});
                s.boundary_part.push_back(static_cast<std::uint8_t>(outline_.parts[p]));
            }
        }
    }

private:
    void order_grains(const std::vector<Triangle>& triangles) {
        std::vector<Point> centroids(triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            Point sum;
            for (const int p : triangles[t]) sum = sum + points_[static_cast<std::size_t>(p)];
            centroids[t] = (1.0 / 3) * sum;
        }
        for (const int t : hilbert_order(centroids)) {
            Triangle corners = triangles[static_cast<std::size_t>(t)];
            // Corners start at the point of lowest index, so that the file does not depend on how the triangulation stores a
            // triangle.
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
            grains_.push_back(corners);
        }
    }

    /// Sides of all grains by the point they start from (compressed list).
    void sort_sides() {
        start_.assign(points_.size() + 1, 0);
        for (const Triangle& g : grains_) {
            for (const int p : g) ++start_[static_cast<std::size_t>(p) + 1];
        }
        for (std::size_t p = 0; p < points_.size(); ++p) start_[p + 1] += start_[p];
        sides_.resize(3 * grains_.size());
        std::vector<int> fill(start_.begin(), start_.end() - 1);
        for (std::size_t g = 0; g < grains_.size(); ++g) {
            for (int side = 0; side < 3; ++side) {
                const auto p = static_cast<std::size_t>(grains_[g][static_cast<std::size_t>(side)]);
                sides_[static_cast<std::size_t>(fill[p]++)] = {static_cast<std::int32_t>(g), side};
            }
        }
    }

    /// The side that runs from one point to another; grain −1 if there is none.
    [[nodiscard]] GrainSide side_from(int from, int to) const {
        const auto p = static_cast<std::size_t>(from);
        for (int k = start_[p]; k < start_[p + 1]; ++k) {
            const GrainSide side = sides_[static_cast<std::size_t>(k)];
            if (grains_[static_cast<std::size_t>(side.grain)][static_cast<std::size_t>((side.side + 1) % 3)] == to) return side;
        }
        return {-1, 0};
    }

    [[nodiscard]] GrainSide facing(std::size_t grain, int side) const {
        const Triangle& corners = grains_[grain];
        return side_from(corners[static_cast<std::size_t>((side + 1) % 3)], corners[static_cast<std::size_t>(side)]);
    }

    [[nodiscard]] Point corner(std::size_t grain, std::size_t k) const {
        return points_[static_cast<std::size_t>(grains_[grain][k])];
    }

    [[nodiscard]] std::int32_t node(GrainSide side, int k) const {
        return side.grain * lattice_.n_nodes() + lattice_.node_on_side(side.side, k);
    }

    void add_grain_boundary(Specimen& s, GrainSide a, GrainSide b, std::int32_t boundary) const {
        for (int k = 0; k < n_; ++k) {  // the side of b has the opposite direction
            s.contact_nodes.push_back({node(a, k), node(a, k + 1), node(b, n_ - k), node(b, n_ - k - 1)});
            s.contact_grain_boundary.push_back(boundary);
            s.contact_kind.push_back(static_cast<std::uint8_t>(ContactKind::grain_boundary));
        }
    }

    /// Point k of n between two points; bit for bit the same when the two points are exchanged.
    [[nodiscard]] Point on_edge(int from, int to, int k) const {
        if (from > to) {
            std::swap(from, to);
            k = n_ - k;
        }
        const Point p = points_[static_cast<std::size_t>(from)];
        const Point q = points_[static_cast<std::size_t>(to)];
        if (k == 0 || k == n_) return k == 0 ? p : q;
        return p + (static_cast<double>(k) / n_) * (q - p);
    }

    [[nodiscard]] std::array<double, 2> position(const Triangle& corners, int i, int j) const {
        Point p;
        if (j == 0) {
            p = on_edge(corners[0], corners[1], i);
        } else if (i == 0) {
            p = on_edge(corners[0], corners[2], j);
        } else if (i + j == n_) {
            p = on_edge(corners[1], corners[2], j);
        } else {
            const Point origin = points_[static_cast<std::size_t>(corners[0])];
            p = origin + (static_cast<double>(i) / n_) * (points_[static_cast<std::size_t>(corners[1])] - origin) +
                (static_cast<double>(j) / n_) * (points_[static_cast<std::size_t>(corners[2])] - origin);
        }
        return {p.x, p.y};
    }

    const Outline& outline_;
    const std::vector<Point>& points_;
    int n_;
    GrainLattice lattice_;
    std::vector<Triangle> grains_;
    std::vector<int> start_;
    std::vector<GrainSide> sides_;
};

}  // namespace

AssemblageCounts assemblage_counts(std::int64_t n_grains, std::int64_t n_boundary, int elements_per_edge) {
    const std::int64_t n = elements_per_edge;
    return {n_grains, n_grains * (n + 1) * (n + 2) / 2, n_grains * n * n, (3 * n_grains - n_boundary) / 2 * n, n_boundary * n};
}

std::int64_t uncompressed_size(const AssemblageCounts& counts) {
    const std::int64_t per_node = 16 + 24;                       // position, VTKHDF point
    const std::int64_t per_element = 3 * 4 + 4 + 3 * 8 + 8 + 1;  // nodes, grain, connectivity, offset, type
    const std::int64_t per_grain = 1 + 8;                        // phase, area
    const std::int64_t per_contact = 4 * 4 + 4 + 1;              // nodes, grain boundary, kind
    const std::int64_t per_boundary_edge = 2 * 4 + 1;            // nodes, part
    return counts.nodes * per_node + counts.elements * per_element + counts.grains * per_grain + counts.contacts * per_contact +
           counts.boundary_edges * per_boundary_edge;
}

Specimen build_assemblage(const Shape& shape, const Outline& outline, const PlaneMesh& mesh, int elements_per_edge) {
    const auto counts = assemblage_counts(static_cast<std::int64_t>(mesh.triangles.size()),
                                          static_cast<std::int64_t>(outline.points.size()), elements_per_edge);
    if (std::max(counts.nodes, counts.elements) > std::numeric_limits<std::int32_t>::max()) {
        throw UsageError("the specimen would have more than 2^31 - 1 nodes; choose a larger edge or fewer --elements-per-edge");
    }
    Specimen specimen;
    specimen.shape = shape.name();
    specimen.width = shape.width;
    specimen.height = shape.height;
    specimen.tessellation = "delaunay";
    specimen.elements_per_edge = elements_per_edge;
    specimen.loading_arc = outline.loading_arc;
    specimen.node_position.reserve(static_cast<std::size_t>(counts.nodes));
    specimen.element_nodes.reserve(static_cast<std::size_t>(counts.elements));
    specimen.element_grain.reserve(static_cast<std::size_t>(counts.elements));
    specimen.contact_nodes.reserve(static_cast<std::size_t>(counts.contacts));
    const Builder builder(outline, mesh, elements_per_edge);
    builder.add_grains(specimen);
    builder.add_contacts(specimen);
    builder.add_boundary(specimen);
    return specimen;
}

}  // namespace graincrack::mesher
