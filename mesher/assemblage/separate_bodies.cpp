#include "mesher/assemblage/separate_bodies.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

constexpr int none = -1;

/// A side of a triangle on the outside of its body.
struct OuterSide {
    int from;  ///< points
    int to;
    int side;       ///< 3 · element + its corner at `from`
    int facing;     ///< the side of another body, or `none` on the boundary
    int neighbour;  ///< body of that side, or `none`
    int place;      ///< position along the boundary of the body
};

class Builder {
public:
    Builder(const PlaneMesh& mesh, std::vector<int>* crystal_of_grain) : mesh_(mesh), crystal_of_grain_(crystal_of_grain) {
        for (const Side& side : mesh.sides) {
            if (side.part >= 0 || side.kind == FlawKind{}) continue;
            kinds_.push_back({{std::min(side.from, side.to), std::max(side.from, side.to)}, side.kind});
            if (!side.kind.contact_class.empty()) specimen_.flaw_names.push_back(side.kind.contact_class);
        }
        std::sort(kinds_.begin(), kinds_.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
        std::vector<std::string>& names = specimen_.flaw_names;
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
    }

    Specimen build() {
        add_grains();
        sort_sides();
        add_contacts();
        add_boundary();
        return std::move(specimen_);
    }

private:
    void add_grains() {
        const std::size_t n_bodies = mesh_.n_bodies();
        std::vector<Point> centres(n_bodies);
        std::vector<std::size_t> first_triangle(n_bodies + 1, 0);
        for (const int body : mesh_.body_of_triangle) ++first_triangle[index(body) + 1];
        for (std::size_t b = 0; b < n_bodies; ++b) {
            first_triangle[b + 1] += first_triangle[b];
            Point sum;
            const int n = mesh_.body_start[b + 1] - mesh_.body_start[b];
            for (const int p : points_of(b)) sum = sum + mesh_.points[index(p)];
            centres[b] = (1.0 / n) * sum;
        }
        specimen_.node_position.reserve(mesh_.body_points.size());
        specimen_.element_nodes.reserve(mesh_.triangles.size());
        specimen_.element_grain.reserve(mesh_.triangles.size());
        triangles_.reserve(mesh_.triangles.size());
        std::vector<std::int32_t> node_at(mesh_.points.size());  // of the current grain
        for (const int body : hilbert_order(centres)) {
            const auto b = index(body);
            for (const int p : points_of(b)) {
                const Point position = mesh_.points[index(p)];
                node_at[index(p)] = static_cast<std::int32_t>(specimen_.node_position.size());
                specimen_.node_position.push_back({position.x, position.y});
            }
            for (std::size_t t = first_triangle[b]; t < first_triangle[b + 1]; ++t) {
                const Triangle& triangle = mesh_.triangles[t];
                triangles_.push_back(triangle);
                specimen_.element_nodes.push_back(
                    {node_at[index(triangle[0])], node_at[index(triangle[1])], node_at[index(triangle[2])]});
                specimen_.element_grain.push_back(static_cast<std::int32_t>(specimen_.grain_phase.size()));
            }
            if (crystal_of_grain_ != nullptr) crystal_of_grain_->push_back(mesh_.crystal_of_body[b]);
            specimen_.grain_phase.push_back(0);
            specimen_.grain_area.push_back(mesh_.area_of_body[b]);
        }
    }

    [[nodiscard]] std::span<const int> points_of(std::size_t body) const {
        return {mesh_.body_points.data() + mesh_.body_start[body], mesh_.body_points.data() + mesh_.body_start[body + 1]};
    }

    /// Sorts the sides of all triangles by their first points (compressed list).
    void sort_sides() {
        start_.assign(mesh_.points.size() + 1, 0);
        for (const Triangle& t : triangles_) {
            for (const int p : t) ++start_[index(p) + 1];
        }
        for (std::size_t p = 0; p < mesh_.points.size(); ++p) start_[p + 1] += start_[p];
        sides_.resize(3 * triangles_.size());
        std::vector<int> fill(start_.begin(), start_.end() - 1);
        for (int side = 0; side < static_cast<int>(sides_.size()); ++side) {
            sides_[static_cast<std::size_t>(fill[index(from(side))]++)] = side;
        }
    }

    [[nodiscard]] int from(int side) const { return triangles_[index(side / 3)][index(side % 3)]; }
    [[nodiscard]] int to(int side) const { return triangles_[index(side / 3)][index((side + 1) % 3)]; }
    [[nodiscard]] std::int32_t body(int side) const { return specimen_.element_grain[index(side / 3)]; }
    /// Node of a side at its start (0) or its end (1).
    [[nodiscard]] std::int32_t node(int side, int end) const {
        return specimen_.element_nodes[index(side / 3)][index((side % 3 + end) % 3)];
    }

    /// The side from one point to another, or `none`.
    [[nodiscard]] int side_from(int from_point, int to_point) const {
        const auto p = index(from_point);
        for (int k = start_[p]; k < start_[p + 1]; ++k) {
            const int side = sides_[index(k)];
            if (to(side) == to_point) return side;
        }
        return none;
    }

    void add_contacts() {
        specimen_.contact_nodes.reserve(sides_.size() / 2);
        std::int32_t boundary = none;
        std::vector<OuterSide> outer;
        const int n_sides = static_cast<int>(sides_.size());
        for (int side = 0; side < n_sides;) {
            const std::int32_t a = body(side);
            outer.clear();
            for (; side < n_sides && body(side) == a; ++side) {
                const int facing = side_from(to(side), from(side));
                const int neighbour = facing == none ? none : body(facing);
                if (neighbour != a) outer.push_back({from(side), to(side), side, facing, neighbour, 0});
                if (facing == none) ++n_boundary_;
            }
            order_along_boundary(outer);
            outer.erase(std::remove_if(outer.begin(), outer.end(), [&](const OuterSide& s) { return s.neighbour < a; }),
                        outer.end());
            std::sort(outer.begin(), outer.end(), [](const OuterSide& l, const OuterSide& r) {
                return l.neighbour != r.neighbour ? l.neighbour < r.neighbour : l.place < r.place;
            });
            for (std::size_t i = 0; i < outer.size(); ++i) {
                const OuterSide& s = outer[i];
                if (i == 0 || s.neighbour != outer[i - 1].neighbour || s.from != outer[i - 1].to) ++boundary;
                // The side of b has the opposite direction.
                specimen_.contact_nodes.push_back({node(s.side, 0), node(s.side, 1), node(s.facing, 1), node(s.facing, 0)});
                specimen_.contact_grain_boundary.push_back(boundary);
                const FlawKind kind = kind_of(s.from, s.to);
                specimen_.contact_kind.push_back(static_cast<std::uint8_t>(kind.start));
                if (!specimen_.flaw_names.empty()) specimen_.contact_flaw.push_back(number_of(kind.contact_class));
            }
        }
    }

    /// Orders the outer sides of a body so that each begins at the end of the previous one, starting where its neighbour changes.
    static void order_along_boundary(std::vector<OuterSide>& outer) {
        for (std::size_t i = 0; i + 1 < outer.size(); ++i) {
            const auto next = std::find_if(outer.begin() + static_cast<std::ptrdiff_t>(i) + 1, outer.end(),
                                           [&](const OuterSide& s) { return s.from == outer[i].to; });
            if (next != outer.end()) std::swap(outer[i + 1], *next);
        }
        if (!outer.empty() && outer.back().to == outer.front().from && outer.back().neighbour == outer.front().neighbour) {
            const auto change = std::find_if(outer.begin(), outer.end(),
                                             [&](const OuterSide& s) { return s.neighbour != outer.front().neighbour; });
            if (change != outer.end()) std::rotate(outer.begin(), change, outer.end());
        }
        int place = 0;
        for (OuterSide& s : outer) s.place = place++;
    }

    [[nodiscard]] FlawKind kind_of(int p, int q) const {
        const Edge edge{std::min(p, q), std::max(p, q)};
        const auto found = std::lower_bound(kinds_.begin(), kinds_.end(), edge,
                                            [](const auto& each, const Edge& requested) { return each.first < requested; });
        return found != kinds_.end() && found->first == edge ? found->second : FlawKind{};
    }

    /// Number of a class of flaws, from 1; 0 without a class.
    [[nodiscard]] std::uint8_t number_of(const std::string& flaw_class) const {
        if (flaw_class.empty()) return 0;
        const std::vector<std::string>& names = specimen_.flaw_names;
        return static_cast<std::uint8_t>(std::lower_bound(names.begin(), names.end(), flaw_class) - names.begin() + 1);
    }

    void add_boundary() {
        for (const Side& s : mesh_.sides) {
            const int inside = side_from(s.from, s.to);
            if (inside == none) throw Error(ExitCode::internal, "the mesh does not follow its region");
            if (s.part < 0) continue;
            specimen_.boundary_edges.push_back({node(inside, 0), node(inside, 1)});
            specimen_.boundary_part.push_back(static_cast<std::uint8_t>(s.part));
        }
        if (specimen_.boundary_edges.size() != n_boundary_) throw Error(ExitCode::internal, "the mesh ends inside of its region");
    }

    const PlaneMesh& mesh_;
    std::vector<int>* crystal_of_grain_;
    std::vector<std::pair<Edge, FlawKind>> kinds_;  ///< kinds of prescribed sides other than plain grain boundaries, ascending
    std::vector<Triangle> triangles_;               ///< in the order of the elements
    std::vector<int> start_;
    std::vector<int> sides_;
    std::size_t n_boundary_ = 0;  ///< number of sides that face none
    Specimen specimen_;
};

}  // namespace

Specimen separate_bodies(const PlaneMesh& mesh, std::vector<int>* crystal_of_grain) {
    return Builder(mesh, crystal_of_grain).build();
}

}  // namespace graincrack::mesher
