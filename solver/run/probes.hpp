// Records the probes of a program: motion of points, elongation of gauges, mean stress in circles, strain and stress at the
// points of rings, and motion of and force on the parts with boundary conditions.
#pragma once

#include <array>
#include <cstdint>
#include <variant>
#include <vector>

#include "share/file/probe_file.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

class Probes {
public:
    /// \throws InputError for a point outside of the specimen, or a circle or ring without an element to read
    Probes(const Program& program, const Assemblage& assemblage, const Specimen& specimen);
    /// Adds a row of the state. \pre `measure` has left the forces of this time in it
    void record(const Assemblage& assemblage, const Boundary& boundary, const State& state);
    [[nodiscard]] const std::vector<ProbeHistory>& histories() const { return histories_; }
    /// Takes over the rows of a checkpoint. \param rows their number \throws InputError if it differs
    void restore(const H5Input& checkpoint, std::size_t rows);
    /// The last value of a column.
    [[nodiscard]] double last(const std::string& probe, std::size_t column) const;

private:
    struct Point {
        std::array<std::int32_t, 3> nodes;
        std::array<double, 3> weights;
    };
    struct OnRing {
        double angle;
        std::vector<std::int32_t> elements;
    };
    /// Two points and the vector from the first to the second.
    struct Gauge {
        std::array<Point, 2> ends;
        Vector2 way;
    };
    /// \throws InputError that names `where` if the place lies in no element
    static Point point_at(const Assemblage& assemblage, const Vector2& place, const std::string& where);
    /// A quantity of nodes at a point.
    static Vector2 value_at(const Part& part, const Point& point, const std::vector<Vector2>& of_nodes);
    void add_ring(const ProbeRequest& request, const Assemblage& assemblage, const std::string& where);
    void push(std::size_t probe, const std::vector<double>& row);

    using Circle = std::vector<std::int32_t>;  ///< its elements
    std::vector<std::vector<std::int32_t>> nodes_of_boundary_;
    std::vector<std::variant<Point, Circle, OnRing, Gauge>> requests_;
    std::vector<ProbeHistory> histories_;  ///< boundary conditions, then requests
};

}  // namespace graincrack
