#include "mesher/import/clean_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "share/base/error.hpp"
#include "share/base/union_find.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr double same_place = 1e-9;  ///< over the extent: as contacts of a specimen must conform
constexpr double on_side = 1e-6;     ///< distance of a point from a side over the side's length: far below any angle of a grain

std::string position_text(Point p) { return fmt::format("({}, {})", format_number(p.x, 6), format_number(p.y, 6)); }

struct Extent {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void add(Point p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    [[nodiscard]] double size() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// Squares of a grid of a given width, each with what was put into it.
class Squares {
public:
    Squares(Point low, double width) : low_(low), width_(width) {}
    [[nodiscard]] std::int64_t column(double x) const { return static_cast<std::int64_t>(std::floor((x - low_.x) / width_)); }
    [[nodiscard]] std::int64_t row(double y) const { return static_cast<std::int64_t>(std::floor((y - low_.y) / width_)); }
    std::vector<int>& at(std::int64_t column, std::int64_t row) { return squares_[key(column, row)]; }
    [[nodiscard]] const std::vector<int>* find(std::int64_t column, std::int64_t row) const {
        const auto found = squares_.find(key(column, row));
        return found == squares_.end() ? nullptr : &found->second;
    }

private:
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        return static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15U ^ static_cast<std::uint64_t>(row);
    }
    Point low_;
    double width_;
    std::unordered_map<std::uint64_t, std::vector<int>> squares_;
};

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
    [[nodiscard]] Point at(int p) const { return mesh_.points[static_cast<std::size_t>(p)]; }
    void note(const std::string& text) { mesh_.notes.push_back(text); }

    /// Gives points new numbers; a line with a point of number −1 is left out.
    void renumber(const std::vector<int>& number, std::vector<Point> points) {
        const auto of = [&](int p) { return number[static_cast<std::size_t>(p)]; };
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
            for (const int p : t) number[static_cast<std::size_t>(p)] = 0;
        }
        std::vector<Point> points;
        for (std::size_t p = 0; p < number.size(); ++p) {
            if (number[p] < 0) continue;
            number[p] = static_cast<int>(points.size());
            points.push_back(mesh_.points[p]);
            extent_.add(points.back());
        }
        if (points.size() < mesh_.points.size()) {
            const std::size_t n = mesh_.points.size() - points.size();
            note(fmt::format("{} that no corner of a triangle lies at {} left out",
                             n == 1 ? "1 point" : fmt::format("{} points", n), n == 1 ? "was" : "were"));
        }
        renumber(number, std::move(points));
        if (!(extent_.size() > 0) || !std::isfinite(extent_.size())) fail("all points lie at one place, or too far apart");
    }

    /// Points at one place become the first of them.
    void join_points() {
        const double tolerance = same_place * extent_.size();
        Squares squares(extent_.low, 2 * tolerance);
        std::vector<int> number(mesh_.points.size());
        std::vector<Point> points;
        for (std::size_t p = 0; p < number.size(); ++p) {
            const Point here = mesh_.points[p];
            int same = -1;
            for (const std::int64_t column : {squares.column(here.x - tolerance), squares.column(here.x + tolerance)}) {
                for (const std::int64_t row : {squares.row(here.y - tolerance), squares.row(here.y + tolerance)}) {
                    const std::vector<int>* others = squares.find(column, row);
                    if (others == nullptr || same >= 0) continue;
                    for (const int q : *others) {
                        if (length(points[static_cast<std::size_t>(q)] - here) <= tolerance) same = q;
                    }
                }
            }
            number[p] = same >= 0 ? same : static_cast<int>(points.size());
            if (same >= 0) continue;
            squares.at(squares.column(here.x), squares.row(here.y)).push_back(number[p]);
            points.push_back(here);
        }
        if (points.size() == mesh_.points.size()) return;
        note(
            fmt::format("{} of {} points lie where others do and were joined with them; sides that were apart there are grain "
                        "boundaries now (lines of the name crack make broken ones)",
                        mesh_.points.size() - points.size(), mesh_.points.size()));
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

    /// Grains of several pieces, and the order of triangles.
    void make_pieces() {
        const std::size_t n = mesh_.triangles.size();
        struct Half {
            Edge edge;
            int triangle;
        };
        std::vector<Half> halves;
        halves.reserve(3 * n);
        for (std::size_t t = 0; t < n; ++t) {
            const Triangle& c = mesh_.triangles[t];
            for (std::size_t k = 0; k < 3; ++k) {
                const int p = c[k];
                const int q = c[(k + 1) % 3];
                halves.push_back({edge_between(p, q), static_cast<int>(t)});
            }
        }
        std::sort(halves.begin(), halves.end(),
                  [](const Half& l, const Half& r) { return l.edge != r.edge ? l.edge < r.edge : l.triangle < r.triangle; });
        UnionFind pieces(n);
        const auto grain = [&](int t) { return mesh_.grain_of_triangle[static_cast<std::size_t>(t)]; };
        for (std::size_t i = 1; i < halves.size(); ++i) {
            if (halves[i].edge == halves[i - 1].edge && grain(halves[i].triangle) == grain(halves[i - 1].triangle)) {
                pieces.join(static_cast<std::size_t>(halves[i].triangle), static_cast<std::size_t>(halves[i - 1].triangle));
            }
        }
        // Grains in their order, their pieces in that of their first triangles.
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
            const auto of = static_cast<std::size_t>(mesh_.grain_of_triangle[order[i]]);
            if (is_new) {
                if (i > 0 && of == static_cast<std::size_t>(mesh_.grain_of_triangle[order[i - 1]])) ++n_split;
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

    /// A side may belong to two triangles, in opposite directions.
    void check_overlap() {
        std::vector<Edge> sides;
        sides.reserve(3 * mesh_.triangles.size());
        for (const Triangle& t : mesh_.triangles) {
            for (std::size_t k = 0; k < 3; ++k) sides.push_back({t[k], t[(k + 1) % 3]});
        }
        std::sort(sides.begin(), sides.end());
        const auto twice = std::adjacent_find(sides.begin(), sides.end());
        if (twice != sides.end()) {
            fail(fmt::format("two triangles overlap: both have the side from {} to {} with themselves on its left",
                             position_text(at((*twice)[0])), position_text(at((*twice)[1]))));
        }
    }

    /// Open sides must not cross, nor hold points that are not their ends: there neighbours do not conform.
    void check_boundary() {
        const std::vector<OpenSide> sides = open_sides(mesh_.triangles);
        // Squares a quarter of the width that as many squares as sides would have: few sides lie in one, few squares hold one
        // side.
        Squares squares(extent_.low, extent_.size() / (4 * std::sqrt(static_cast<double>(sides.size()) + 1)));
        const auto each_square = [&](const OpenSide& s, const auto& visit) {
            const Point p = at(s.from);
            const Point q = at(s.to);
            for (std::int64_t column = squares.column(std::min(p.x, q.x)); column <= squares.column(std::max(p.x, q.x));
                 ++column) {
                for (std::int64_t row = squares.row(std::min(p.y, q.y)); row <= squares.row(std::max(p.y, q.y)); ++row) {
                    visit(column, row);
                }
            }
        };
        for (std::size_t i = 0; i < sides.size(); ++i) {
            each_square(sides[i], [&](std::int64_t column, std::int64_t row) {
                std::vector<int>& others = squares.at(column, row);
                for (const int j : others) check_pair(sides[i], sides[static_cast<std::size_t>(j)]);
                others.push_back(static_cast<int>(i));
            });
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
    Extent extent_;
};

}  // namespace

void clean(ImportedMesh& mesh, const std::string& name) { Cleaner(mesh, name).run(); }

std::vector<OpenSide> open_sides(const std::vector<Triangle>& triangles) {
    struct Half {
        Edge edge;
        std::size_t side;  ///< 3 triangle + its corner
    };
    std::vector<Half> halves;
    halves.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int p = triangles[t][k];
            const int q = triangles[t][(k + 1) % 3];
            halves.push_back({edge_between(p, q), 3 * t + k});
        }
    }
    std::sort(halves.begin(), halves.end(),
              [](const Half& l, const Half& r) { return l.edge != r.edge ? l.edge < r.edge : l.side < r.side; });
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        const bool has_before = i > 0 && halves[i - 1].edge == halves[i].edge;
        const bool has_after = i + 1 < halves.size() && halves[i + 1].edge == halves[i].edge;
        if (!has_before && !has_after) open.push_back(halves[i].side);
    }
    std::sort(open.begin(), open.end());
    std::vector<OpenSide> sides;
    for (const std::size_t s : open) sides.push_back({triangles[s / 3][s % 3], triangles[s / 3][(s + 1) % 3]});
    return sides;
}

}  // namespace graincrack::mesher
