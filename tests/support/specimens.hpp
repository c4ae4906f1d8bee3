// Small specimens with known answers, built by hand so that solver tests need no mesher.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "share/file/specimen.hpp"

namespace graincrack::test {

using Point = std::array<double, 2>;
using Triangle = std::array<int, 3>;

/// A specimen whose grains are the given counter-clockwise triangles; edges shared by two triangles become contacts. Boundary
/// edges on the bounding box are named bottom, right, top, left; others rim.
Specimen specimen_of_triangles(const std::vector<Point>& points, const std::vector<Triangle>& triangles);
/// The same with several triangles to a grain: `grain[i]` is the grain of triangle i, ascending from 0.
Specimen specimen_of_grains(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                            const std::vector<int>& grain);

/// Rectangle about the origin in nx × ny cells of two triangles with the diagonals all one way.
Specimen one_diagonal_grid(int nx, int ny, double width, double height);
/// A column of such cells, each of which is a grain.
Specimen one_diagonal_column(int ny, double width, double height);
/// The grid with the diagonals alternating (union jack).
Specimen union_jack_grid(int nx, int ny, double width, double height);
/// Rectangle with inner points moved by up to `jitter` of a cell, in a fixed pattern without direction.
Specimen jittered_grid(int nx, int ny, double width, double height, double jitter);
/// Parallelogram about the origin of 2 nx ny equilateral triangles, rows along x.
Specimen equilateral_lattice(int nx, int ny, double edge);
/// Rectangle about the origin in nx × ny cells of four triangles about their centre; cell (i, j) is of grain `grain_of(i, j)`,
/// grains being numbered from 0 without gaps.
Specimen crossed_blocks(int nx, int ny, double width, double height, const std::function<int(int, int)>& grain_of);

/// Rectangle with a straight joint, broken from the start, through its centre and from side to side at `angle` (rad) from x: nx
/// edges along the joint, ny rows of cells of two triangles on either side of it. Each triangle is a grain, or each of the two
/// blocks one grain.
enum class Blocks { of_one_grain, of_grains };
Specimen jointed_rectangle(int nx, int ny, double width, double height, double angle, Blocks blocks);

/// Predicate of a region: true for its points (x, y), m.
using Region = std::function<bool(double, double)>;
/// Makes pre-existing cracks of the contacts whose ends lie in a region.
void break_contacts(Specimen& specimen, const Region& region);
/// Makes free boundary (part rim) of both sides of the contacts whose ends lie in a region.
void cut_contacts(Specimen& specimen, const Region& region);
/// Names the boundary edges whose ends lie in a region. \return the number of the new part
std::uint8_t name_boundary(Specimen& specimen, const std::string& name, const Region& region);
/// The same specimen turned by `angle` (rad) about the origin.
Specimen rotated(Specimen specimen, double angle);

/// Gives every node that elements, contacts and edges name another number. \param number_of (node): the new one
template <class NumberOf>
void renumber_nodes(Specimen& s, const NumberOf& number_of) {
    const auto renumber = [&](auto& rows) {
        for (auto& row : rows) {
            for (std::int32_t& node : row) node = number_of(node);
        }
    };
    renumber(s.element_nodes);
    renumber(s.contact_nodes);
    renumber(s.boundary_edges);
}

}  // namespace graincrack::test
