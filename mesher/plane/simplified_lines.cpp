#include "mesher/plane/simplified_lines.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/Stop_above_cost_threshold.h>
#include <CGAL/Polyline_simplification_2/simplify.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "share/base/error.hpp"

namespace graincrack::mesher {

namespace {

namespace simplification = CGAL::Polyline_simplification_2;

/// Length, over the spacing, of a segment after a removal; beyond half of it two segments become one. Chosen by trial.
constexpr double longest = 1.35;
constexpr int rounds_of_moves = 3;  ///< the normals of a moved line differ slightly from those before
constexpr double least_area = 0.3;  ///< area of triangles between lines after a move, over that before

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// A vertex has its line.
using LineVertex = simplification::Vertex_base_2<Kernel, CGAL::Triangulation_vertex_base_with_info_2<const DenseLine*, Kernel>>;
using LineStructure = CGAL::Triangulation_data_structure_2<LineVertex, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Lines = CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, LineStructure, CGAL::No_constraint_intersection_tag>>;
using LineVertexHandle = Lines::Vertex_handle;

Point place(LineVertexHandle vertex) { return {vertex->point().x(), vertex->point().y()}; }

double distance_to_segment(Point p, Point a, Point b) {
    const double t = std::clamp(dot(p - a, b - a) / squared_length(b - a), 0.0, 1.0);
    return length(p - (a + t * (b - a)));
}

/// A part of a line: a vertex with its neighbours.
struct Part {
    LineVertexHandle before;
    LineVertexHandle at;
    LineVertexHandle after;
};

/// Checks the clearance of other lines when a point of a line moves or is removed.
class Surroundings {
public:
    Surroundings(const Lines& lines, const Clearance& clearance)
        : lines_(lines), distance_(clearance.distance), cosine_(std::cos(clearance.angle)) {}

    /// True if a part of a line keeps the clearance from surrounding vertices with these points in place of its own.
    [[nodiscard]] bool are_clear_of(const Part& part, std::span<const Point> points) const {
        for (const LineVertexHandle centre : {part.before, part.at, part.after}) {
            auto vertex = lines_.incident_vertices(centre);
            const auto first = vertex;
            do {
                if (lines_.is_infinite(vertex) || vertex == part.before || vertex == part.at || vertex == part.after) continue;
                // Vertices that the part meets at its ends are compared by angle.
                const bool at_before = are_joined(part.before, vertex);
                const bool at_after = are_joined(part.after, vertex);
                if (at_before && is_sharp(points[0], place(vertex), points[1])) return false;
                if (at_after && is_sharp(points.back(), place(vertex), points[points.size() - 2])) return false;
                for (std::size_t i = 1; i < points.size() && !at_before && !at_after; ++i) {
                    if (distance_to_segment(place(vertex), points[i - 1], points[i]) < distance_) return false;
                }
            } while (++vertex != first);
        }
        return points.size() < 3 || !is_sharp(points[1], points[0], points[2]);
    }

    [[nodiscard]] bool are_joined(LineVertexHandle one, LineVertexHandle other) const {
        Lines::Face_handle face;
        int i = 0;
        return lines_.is_edge(one, other, face, i) && face->is_constrained(i);
    }

    /// Moves the middle of a part unless it makes surrounding triangles bad.
    void move(const Part& part, Point to) const {
        if (!are_clear_of(part, std::array{place(part.before), to, place(part.after)})) return;
        auto face = lines_.incident_faces(part.at);
        const auto first = face;
        do {
            std::array<Point, 3> corners;
            for (int i = 0; i < 3; ++i) corners[index(i)] = place(face->vertex(i));
            const double area = signed_area(corners[0], corners[1], corners[2]);
            corners[index(face->index(part.at))] = to;
            if (lines_.is_infinite(face) || signed_area(corners[0], corners[1], corners[2]) < least_area * area) return;
        } while (++face != first);
        part.at->set_point({to.x, to.y});
    }

private:
    [[nodiscard]] bool is_sharp(Point corner, Point one, Point other) const {
        return dot(unit(one - corner), unit(other - corner)) > cosine_;
    }

    const Lines& lines_;
    double distance_, cosine_;
};

/// Cost of a removal: length of the new segment over the longest, or distance of removed points over the tolerance; none if the
/// line would come too near to another.
struct Cost {
    Clearance clearance;
    template <class Position>
    boost::optional<double> operator()(const Lines& lines, Position at) const {
        Position before = at;
        Position after = at;
        const Part part{*--before, *at, *++after};
        const Surroundings around(lines, clearance);
        const std::array<Point, 2> ends{place(part.before), place(part.after)};
        if (part.before == part.after || around.are_joined(part.before, part.after)) return boost::none;
        if (!around.are_clear_of(part, ends)) return boost::none;
        const DenseLine& line = *part.at->info();
        const double off = std::sqrt(*simplification::Squared_distance_cost()(lines, at));
        return std::max(length(ends[1] - ends[0]) / (longest * line.spacing), off / line.tolerance);
    }
};

/// Moves the points of a line along its normals to the requested area.
void keep_area(const Surroundings& around, const std::vector<LineVertexHandle>& line, const DenseLine& requested) {
    const std::size_t n = line.size() - 1;  // segments
    const std::size_t begin = requested.is_closed ? 0 : 1;
    const auto tangent = [&](std::size_t i) { return place(line[i + 1]) - place(line[i > 0 ? i - 1 : n - 1]); };
    for (int round = 0; round < rounds_of_moves && n > 1; ++round) {
        double missing = requested.doubled_area;
        for (std::size_t i = 1; i < n; ++i) {
            missing -= cross(place(line[i]) - place(line[0]), place(line[i + 1]) - place(line[0]));
        }
        double rate = 0;  // decrease of the area per length when all points move left
        for (std::size_t i = begin; i < n; ++i) rate += length(tangent(i));
        const double distance = std::clamp(-missing / rate, -requested.spacing, requested.spacing);
        std::vector<Point> moved;
        for (std::size_t i = begin; i < n; ++i) moved.push_back(place(line[i]) + distance * left_of(unit(tangent(i))));
        for (std::size_t i = begin; i < n; ++i) {
            around.move({line[i > 0 ? i - 1 : n - 1], line[i], line[i + 1]}, moved[i - begin]);
        }
    }
}

std::vector<Lines::Constraint_id> insert(Lines& all, std::span<const DenseLine> lines) {
    std::vector<Lines::Constraint_id> ids;
    for (const DenseLine& line : lines) {
        std::vector<Kernel::Point_2> points;
        for (const Point p : line.points) points.emplace_back(p.x, p.y);
        try {
            ids.push_back(all.insert_constraint(points.begin(), points.end()));
        } catch (const Lines::Intersection_of_constraints_exception&) {
            throw UsageError("borders of regions cross or touch each other");
        }
        for (auto at = all.vertices_in_constraint_begin(ids.back()); at != all.vertices_in_constraint_end(ids.back()); ++at) {
            (*at)->info() = &line;
        }
    }
    return ids;
}

}  // namespace

std::vector<std::vector<Point>> simplified_lines(std::span<const DenseLine> lines, const Clearance& clearance) {
    Lines all;
    const std::vector<Lines::Constraint_id> ids = insert(all, lines);
    // Simplifying all lines at once would order equal costs by memory addresses, so that calls would differ.
    for (const Lines::Constraint_id& id : ids) {
        simplification::simplify(all, id, Cost{clearance}, simplification::Stop_above_cost_threshold(1));
    }
    std::vector<std::vector<LineVertexHandle>> left;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        left.emplace_back(all.vertices_in_constraint_begin(ids[i]), all.vertices_in_constraint_end(ids[i]));
        keep_area(Surroundings(all, clearance), left.back(), lines[i]);
    }
    std::vector<std::vector<Point>> simple(left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        for (const LineVertexHandle vertex : left[i]) simple[i].push_back(place(vertex));
    }
    return simple;
}

}  // namespace graincrack::mesher
