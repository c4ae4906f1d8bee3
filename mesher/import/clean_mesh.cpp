#include "mesher/import/clean_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/union_find.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr double same_place = 1e-9;  ///< over the extent, as required of contacts
/// Unit vector along which sides and points are sorted: few points of any lattice share a position along it.
constexpr Point oblique{0.8506508083520400, 0.5257311121191336};
constexpr double on_side = 1e-6;  ///< distance of a point from a side over its length: far below any angle of a grain

std::string position_text(Point p) { return fmt::format("({}, {})", format_number(p.x, 6), format_number(p.y, 6)); }

/// Sides of triangles from corner to corner, ascending, each with its triangle on the left.
using Sides = std::vector<std::pair<Edge, std::size_t>>;

Sides sides_of(const std::vector<Triangle>& triangles) {
    Sides sides;
    sides.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) sides.push_back({{triangles[t][k], triangles[t][(k + 1) % 3]}, t});
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

/// The triangle on the right of a side; empty if there is none.
std::optional<std::size_t> triangle_beyond(const Sides& sides, const Edge& side) {
    const Edge turned{side[1], side[0]};
    const auto found = std::lower_bound(sides.begin(), sides.end(), std::pair(turned, std::size_t{0}));
    return found != sides.end() && found->first == turned ? std::optional(found->second) : std::nullopt;
}

class Cleaner {
public:
    Cleaner(ImportedMesh& mesh, const std::string& name) : mesh_(mesh), name_(name) {}

    void run() {
        keep_used_points();
        join_points();
        turn_triangles();
        make_pieces();
        check_overlap();
        check_boundary();
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw InputError(name_ + ": " + message); }
    [[nodiscard]] Point at(int p) const { return mesh_.points[index(p)]; }
    void note(const Remark& remark) { mesh_.notes.push_back(remark); }

    /// Renumbers points; lines with a point of number −1 are removed.
    void renumber(const std::vector<int>& number, std::vector<Point> points) {
        const auto of = [&](int p) { return number[index(p)]; };
        for (Triangle& t : mesh_.triangles) t = {of(t[0]), of(t[1]), of(t[2])};
        std::vector<NamedLine> lines;
        for (NamedLine& line : mesh_.lines) {
            if (of(line.from) >= 0 && of(line.to) >= 0) lines.push_back({of(line.from), of(line.to), std::move(line.name)});
        }
        mesh_.lines = std::move(lines);
        mesh_.points = std::move(points);
    }

    void keep_used_points() {
        std::vector<int> number(mesh_.points.size(), -1);
        for (const Triangle& t : mesh_.triangles) {
            for (const int p : t) number[index(p)] = 0;
        }
        std::vector<Point> points;
        for (std::size_t p = 0; p < number.size(); ++p) {
            if (number[p] < 0) continue;
            number[p] = static_cast<int>(points.size());
            points.push_back(mesh_.points[p]);
        }
        const Box box = box_of(points);
        extent_ = std::max(box.width(), box.height());
        if (points.size() < mesh_.points.size()) {
            const std::size_t n = mesh_.points.size() - points.size();
            note(fmt::format("{} that no corner of a triangle lies at {} left out",
                             n == 1 ? "1 point" : fmt::format("{} points", n), n == 1 ? "was" : "were"));
        }
        renumber(number, std::move(points));
        if (!(extent_ > 0) || !std::isfinite(extent_)) fail("all points lie at one place, or too far apart");
    }

    /// Joins points at one place to the first of them.
    void join_points() {
        const double tolerance = same_place * extent_;
        std::vector<std::size_t> order(mesh_.points.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::vector<std::size_t> first = order;
        std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) {
            return std::pair(dot(mesh_.points[p], oblique), p) < std::pair(dot(mesh_.points[q], oblique), q);
        });
        for (std::size_t i = 0; i < order.size(); ++i) {
            for (std::size_t k = i + 1; k < order.size(); ++k) {
                const Point off = mesh_.points[order[k]] - mesh_.points[order[i]];
                if (dot(off, oblique) > tolerance) break;
                if (length(off) > tolerance) continue;
                first[order[i]] = first[order[k]] = std::min(first[order[i]], first[order[k]]);
            }
        }
        std::vector<int> number(mesh_.points.size());
        std::vector<Point> points;
        for (std::size_t p = 0; p < number.size(); ++p) {
            number[p] = first[p] < p ? number[first[p]] : static_cast<int>(points.size());
            if (first[p] == p) points.push_back(mesh_.points[p]);
        }
        if (points.size() == mesh_.points.size()) return;
        note({fmt::format("{} of {} points lie where others do and were joined with them; sides that were apart there are grain "
                          "boundaries now (lines of the name crack make broken ones)",
                          mesh_.points.size() - points.size(), mesh_.points.size()),
              "joined_points"});
        renumber(number, std::move(points));
    }

    void turn_triangles() {
        std::size_t n_turned = 0;
        for (Triangle& t : mesh_.triangles) {
            const double area = signed_area(at(t[0]), at(t[1]), at(t[2]));
            const double longest =
                std::max({length(at(t[1]) - at(t[0])), length(at(t[2]) - at(t[1])), length(at(t[0]) - at(t[2]))});
            if (!(std::abs(area) > on_side * longest * longest / 2)) {
                fail(fmt::format("a triangle at {} has no area", position_text(at(t[0]))));
            }
            if (area > 0) continue;
            std::swap(t[1], t[2]);
            ++n_turned;
        }
        if (n_turned > 0) {
            note(fmt::format("{} of {} triangles were clockwise and were turned", n_turned, mesh_.triangles.size()));
        }
    }

    /// Splits grains into pieces and sorts triangles.
    void make_pieces() {
        const std::size_t n = mesh_.triangles.size();
        const Sides sides = sides_of(mesh_.triangles);
        UnionFind pieces(n);
        for (const auto& [side, t] : sides) {
            const auto other = triangle_beyond(sides, side);
            if (other && mesh_.grain_of_triangle[t] == mesh_.grain_of_triangle[*other]) pieces.join(t, *other);
        }
        // Grains keep their order; their pieces follow the order of their first triangles.
        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::vector<std::size_t> piece(n);
        for (std::size_t t = 0; t < n; ++t) piece[t] = pieces.find(t);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t l, std::size_t r) {
            const int a = mesh_.grain_of_triangle[l];
            const int b = mesh_.grain_of_triangle[r];
            return a != b ? a < b : piece[l] < piece[r];
        });
        std::vector<Triangle> triangles;
        std::vector<int> grains;
        std::vector<std::string> phases;
        std::size_t n_split = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const bool is_new = i == 0 || piece[order[i]] != piece[order[i - 1]];
            const auto of = index(mesh_.grain_of_triangle[order[i]]);
            if (is_new) {
                if (i > 0 && of == index(mesh_.grain_of_triangle[order[i - 1]])) ++n_split;
                phases.push_back(mesh_.phase_of_grain[of]);
            }
            triangles.push_back(mesh_.triangles[order[i]]);
            grains.push_back(static_cast<int>(phases.size()) - 1);
        }
        if (n_split > 0) {
            note(fmt::format("grains of several pieces: {} further {} of its own", n_split,
                             n_split == 1 ? "piece is a grain" : "pieces are each a grain"));
        }
        mesh_.triangles = std::move(triangles);
        mesh_.grain_of_triangle = std::move(grains);
        mesh_.phase_of_grain = std::move(phases);
    }

    /// Checks that a side belongs to at most two triangles, in opposite directions.
    void check_overlap() {
        const Sides sides = sides_of(mesh_.triangles);
        const auto twice =
            std::adjacent_find(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
        if (twice == sides.end()) return;
        fail(fmt::format("two triangles overlap: both have the side from {} to {} with themselves on its left",
                         position_text(at(twice->first[0])), position_text(at(twice->first[1]))));
    }

    /// Checks that open sides do not cross or contain other points, where neighbours would not conform.
    void check_boundary() {
        std::vector<OpenSide> sides = open_sides(mesh_.triangles);
        const auto along = [&](const OpenSide& s) { return std::minmax({dot(at(s.from), oblique), dot(at(s.to), oblique)}); };
        const auto across = [&](const OpenSide& s) {
            return std::minmax({cross(oblique, at(s.from)), cross(oblique, at(s.to))});
        };
        const auto low = [&](const OpenSide& s) { return along(s).first; };
        std::sort(sides.begin(), sides.end(), [&](const OpenSide& s, const OpenSide& t) { return low(s) < low(t); });
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const auto [bottom, top] = across(sides[i]);
            const double high = along(sides[i]).second;
            for (std::size_t k = i + 1; k < sides.size() && low(sides[k]) <= high; ++k) {
                const auto [below, above] = across(sides[k]);
                if (below <= top && above >= bottom) check_pair(sides[i], sides[k]);
            }
        }
    }

    void check_pair(const OpenSide& s, const OpenSide& t) const {
        for (const auto& [side, other] : {std::pair{s, t}, std::pair{t, s}}) {
            for (const int p : {other.from, other.to}) {
                if (p != side.from && p != side.to && lies_on(p, side)) {
                    fail(fmt::format(
                        "the mesh does not conform: the point {} lies on the side from {} to {} without being its end",
                        position_text(at(p)), position_text(at(side.from)), position_text(at(side.to))));
                }
            }
        }
        const auto side_of = [&](const OpenSide& side, int p) { return signed_area(at(side.from), at(side.to), at(p)); };
        if (side_of(s, t.from) * side_of(s, t.to) < 0 && side_of(t, s.from) * side_of(t, s.to) < 0) {
            fail(fmt::format("the mesh overlaps itself: the sides from {} to {} and from {} to {} cross",
                             position_text(at(s.from)), position_text(at(s.to)), position_text(at(t.from)),
                             position_text(at(t.to))));
        }
    }

    [[nodiscard]] bool lies_on(int p, const OpenSide& side) const {
        const Point along = at(side.to) - at(side.from);
        const Point to = at(p) - at(side.from);
        const double size = squared_length(along);
        return dot(along, to) > 0 && dot(along, to) < size && std::abs(cross(along, to)) <= on_side * size;
    }

    ImportedMesh& mesh_;
    const std::string& name_;
    double extent_ = 0;
};

}  // namespace

void clean(ImportedMesh& mesh, const std::string& name) { Cleaner(mesh, name).run(); }

std::vector<OpenSide> open_sides(const std::vector<Triangle>& triangles) {
    const Sides sides = sides_of(triangles);
    std::vector<OpenSide> open;
    for (const Triangle& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge side{t[k], t[(k + 1) % 3]};
            if (!triangle_beyond(sides, side)) open.push_back({side[0], side[1]});
        }
    }
    return open;
}

}  // namespace graincrack::mesher
