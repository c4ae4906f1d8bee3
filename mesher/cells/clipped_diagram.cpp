#include "mesher/cells/clipped_diagram.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "mesher/plane/power_diagram.hpp"
#include "share/base/error.hpp"

#include "mesher/cells/polygon.hpp"

namespace graincrack::mesher {

namespace {

/// A convex outline, which tells whether points are inside and where segments cross it.
class Clipper {
public:
    explicit Clipper(const ConvexOutline& outline) : outline_(outline), centre_(moments(outline.corners).centroid) {
        inner_radius_ = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Point from = outline.corner(k);
            const Point inwards = left_of(unit(outline.corner(k + 1) - from));
            normals_.push_back(inwards);
            inner_radius_ = std::min(inner_radius_, dot(inwards, centre_ - from));
            reach_ = std::max(reach_, length(from - centre_));
        }
    }

    [[nodiscard]] double depth(std::size_t k, Point p) const { return dot(normals_[k], p - outline_.corner(k)); }

    [[nodiscard]] bool contains(Point p) const {
        const double distance = squared_length(p - centre_);
        // Round-off cannot matter beyond these distances.
        if (distance < 0.99 * inner_radius_ * inner_radius_) return true;
        if (distance > 1.01 * reach_ * reach_) return false;
        for (std::size_t k = 0; k < normals_.size(); ++k) {
            if (!(depth(k, p) > 0)) return false;
        }
        return true;
    }

    /// Fractions of a segment at which it enters and leaves the outline, and the sides that it crosses.
    struct Span {
        double enter = 0, leave = 1;
        std::size_t enter_side = 0, leave_side = 0;
    };
    [[nodiscard]] Span span(Point from, Point to) const {
        Span span;
        for (std::size_t k = 0; k < normals_.size(); ++k) {
            const double start = depth(k, from);
            const double end = depth(k, to);
            if (start > 0 && end > 0) continue;
            if (start <= 0 && end <= 0) {
                span.leave = -1;
                return span;
            }
            const double share = start / (start - end);
            if (end > 0 && share > span.enter) {
                span.enter = share;
                span.enter_side = k;
            }
            if (start > 0 && share < span.leave) {
                span.leave = share;
                span.leave_side = k;
            }
        }
        return span;
    }

    /// The fraction of a side of the outline at the point nearest to a crossing.
    [[nodiscard]] double share_of(std::size_t k, Point p) const {
        const Point from = outline_.corner(k);
        const Point along = outline_.corner(k + 1) - from;
        return std::clamp(dot(p - from, along) / squared_length(along), 0.0, 1.0);
    }

private:
    const ConvexOutline& outline_;
    Point centre_;
    double inner_radius_, reach_ = 0;
    std::vector<Point> normals_;
};

double reach_of(const ConvexOutline& outline) {
    double reach = 0;
    for (const Point p : outline.corners) reach = std::max(reach, length(p));
    return reach;
}

constexpr int corner_offset = std::numeric_limits<int>::min();

/// The number of a corner of the outline in sides of cells.
constexpr int corner_point(std::size_t corner) { return corner_offset + static_cast<int>(corner); }

}  // namespace

ClippedDiagram::ClippedDiagram(const ConvexOutline& outline, std::span<const Point> seeds, std::span<const double> weights)
    : outline_(&outline), n_cells_(seeds.size()) {
    clip(power_diagram(seeds, weights, reach_of(outline)));
    sum_up();
}

void ClippedDiagram::clip(const PowerDiagram& diagram) {
    const Clipper clipper(*outline_);
    n_vertices_ = static_cast<int>(diagram.vertices.size());
    std::vector<char> is_inside;
    is_inside.reserve(diagram.vertices.size());
    for (const Point p : diagram.vertices) is_inside.push_back(clipper.contains(p) ? 1 : 0);

    const auto add_crossing = [&](std::size_t outline_side, Point p, int after, int before) -> const Crossing& {
        const double share = clipper.share_of(outline_side, p);
        const Point from = outline_->corner(outline_side);
        const Point at = from + share * (outline_->corner(outline_side + 1) - from);
        crossings_.push_back({outline_side, share, after, before, static_cast<int>(crossings_.size()), at});
        return crossings_.back();
    };
    sides_.reserve(diagram.sides.size());
    for (const PowerDiagram::Side& side : diagram.sides) {
        const Point from = diagram.vertices[index(side.from)];
        const Point to = diagram.vertices[index(side.to)];
        const bool starts_inside = is_inside[index(side.from)] != 0;
        const bool ends_inside = is_inside[index(side.to)] != 0;
        Side clipped{side.left, side.right, from, to, side.from, side.to};
        if (!starts_inside || !ends_inside) {
            const Clipper::Span span = clipper.span(from, to);
            if (!starts_inside && !ends_inside && !(span.enter < span.leave)) continue;
            if (!starts_inside) {
                const Crossing& crossing = add_crossing(span.enter_side, from + span.enter * (to - from), side.right, side.left);
                clipped.from = crossing.at;
                clipped.from_point = -1 - crossing.number;
            }
            if (!ends_inside) {
                const Crossing& crossing = add_crossing(span.leave_side, from + span.leave * (to - from), side.left, side.right);
                clipped.to = crossing.at;
                clipped.to_point = -1 - crossing.number;
            }
        }
        sides_.push_back(clipped);
    }
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) {
        return a.outline_side != b.outline_side ? a.outline_side < b.outline_side : a.share < b.share;
    });
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
        if (crossings_[i].after != crossings_[(i + 1) % crossings_.size()].before) is_consistent_ = false;
    }
    if (crossings_.empty() && n_cells_ > 1) is_consistent_ = false;
}

template <class Visit>
void ClippedDiagram::for_each_outer_side(const Visit& visit) const {
    const std::size_t n = crossings_.size();
    const std::size_t n_corners = outline_->size();
    using End = std::pair<int, Point>;
    if (n == 0) {
        for (std::size_t k = 0; k < n_corners; ++k) {
            visit(0, End(corner_point(k), outline_->corner(k)), End(corner_point((k + 1) % n_corners), outline_->corner(k + 1)),
                  k);
        }
        return;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Crossing& crossing = crossings_[i];
        const Crossing& next = crossings_[(i + 1) % n];
        End from(-1 - crossing.number, crossing.at);
        const std::size_t last = next.outline_side + (i + 1 == n ? n_corners : 0);
        for (std::size_t k = crossing.outline_side; k < last; ++k) {
            const std::size_t corner = (k + 1) % n_corners;
            const End to(corner_point(corner), outline_->corner(corner));
            visit(crossing.after, from, to, k % n_corners);
            from = to;
        }
        visit(crossing.after, from, End(-1 - next.number, next.at), next.outline_side);
    }
}

void ClippedDiagram::sum_up() {
    areas_.assign(n_cells_, 0);
    centroids_.assign(n_cells_, {});
    const auto add = [&](int cell, Point p, Point q) {
        const double twice = cross(p, q);
        areas_[static_cast<std::size_t>(cell)] += 0.5 * twice;
        Point& sum = centroids_[static_cast<std::size_t>(cell)];
        sum = sum + (twice / 6) * (p + q);
    };
    for (const Side& side : sides_) {
        add(side.left, side.from, side.to);
        add(side.right, side.to, side.from);
    }
    for_each_outer_side([&](int cell, const auto& from, const auto& to, std::size_t) { add(cell, from.second, to.second); });
    for (std::size_t i = 0; i < n_cells_; ++i) {
        if (areas_[i] != 0) centroids_[i] = (1 / areas_[i]) * centroids_[i];
    }
}

PlaneCells ClippedDiagram::cells() const {
    PlaneCells cells;
    cells.points = outline_->corners;
    std::vector<int> point_of_vertex(static_cast<std::size_t>(n_vertices_), -1);
    std::vector<int> point_of_crossing(crossings_.size(), -1);
    const auto point = [&](int number, Point at) {
        if (number < corner_offset / 2) return number - corner_offset;
        int& known = number < 0 ? point_of_crossing[static_cast<std::size_t>(-1 - number)]
                                : point_of_vertex[static_cast<std::size_t>(number)];
        if (known < 0) {
            known = static_cast<int>(cells.points.size());
            cells.points.push_back(at);
        }
        return known;
    };
    std::vector<std::vector<Edge>> sides_of_cell(n_cells_);  // counter-clockwise, in any order
    for (const Side& side : sides_) {
        const int from = point(side.from_point, side.from);
        const int to = point(side.to_point, side.to);
        sides_of_cell[index(side.left)].push_back({from, to});
        sides_of_cell[index(side.right)].push_back({to, from});
        cells.edges.push_back(edge_between(from, to));
    }
    for_each_outer_side([&](int cell, const auto& from, const auto& to, std::size_t outline_side) {
        const int p = point(from.first, from.second);
        const int q = point(to.first, to.second);
        sides_of_cell[static_cast<std::size_t>(cell)].push_back({p, q});
        cells.edges.push_back(edge_between(p, q));
        cells.sides.push_back({p, q, outline_->parts[outline_side], {}});
    });
    std::sort(cells.edges.begin(), cells.edges.end());
    for (std::vector<Edge>& sides : sides_of_cell) {
        for (std::size_t i = 0; i < sides.size(); ++i) {
            cells.corners.push_back(sides[i][0]);
            const auto next = std::find_if(sides.begin() + static_cast<std::ptrdiff_t>(i) + 1, sides.end(),
                                           [&](const Edge& side) { return side[0] == sides[i][1]; });
            if (next != sides.end()) {
                std::swap(sides[i + 1], *next);
            } else if (i + 1 < sides.size()) {
                throw Error(ExitCode::internal, "a cell is not closed");
            }
        }
        cells.start.push_back(static_cast<int>(cells.corners.size()));
    }
    return cells;
}

}  // namespace graincrack::mesher
