#include "tests/support/specimens.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace graincrack::test {
namespace {

std::vector<Point> grid_points(int nx, int ny, double width, double height, double jitter) {
    std::vector<Point> points;
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            const bool inner = i > 0 && j > 0 && i < nx && j < ny;
            const double dx = inner ? jitter * std::sin(12.9898 * i + 78.233 * j) : 0;
            const double dy = inner ? jitter * std::sin(39.425 * i + 11.135 * j) : 0;
            points.push_back({width * ((i + dx) / nx - 0.5), height * ((j + dy) / ny - 0.5)});
        }
    }
    return points;
}

/// \param falls whether the diagonal of a cell is the falling one
std::vector<Triangle> grid_triangles(int nx, int ny, const std::function<bool(int, int)>& falls) {
    std::vector<Triangle> triangles;
    const auto at = [nx](int i, int j) { return j * (nx + 1) + i; };
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const bool is_falling = falls(i, j);
            triangles.push_back({at(i, j), at(i + 1, j), is_falling ? at(i, j + 1) : at(i + 1, j + 1)});
            triangles.push_back({is_falling ? at(i + 1, j) : at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return triangles;
}
bool always(int, int) { return true; }
bool never(int, int) { return false; }
bool alternately(int i, int j) { return (i + j) % 2 == 1; }

double area(const Point& a, const Point& b, const Point& c) {
    return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
}

/// An edge of a grain's outline: its shared points and its own nodes.
struct Side {
    int grain;
    std::int32_t first;
    std::int32_t second;
};

BoundaryPart part_of(const Specimen& s, const Point& p, const Point& q) {
    const double small = 1e-9 * (s.width + s.height);
    const auto both = [&](std::size_t axis, double value) {
        return std::abs(p[axis] - value) < small && std::abs(q[axis] - value) < small;
    };
    if (both(1, -s.height / 2)) return BoundaryPart::bottom;
    if (both(0, s.width / 2)) return BoundaryPart::right;
    if (both(1, s.height / 2)) return BoundaryPart::top;
    return both(0, -s.width / 2) ? BoundaryPart::left : BoundaryPart::rim;
}

void add_sides(Specimen& s, const std::map<std::pair<int, int>, std::vector<Side>>& sides) {
    double edges = 0;
    for (const auto& [key, both] : sides) {
        const Side& a = both.front().grain < both.back().grain ? both.front() : both.back();
        const Side& b = both.front().grain < both.back().grain ? both.back() : both.front();
        const Point& p = s.node_position[a.first];
        const Point& q = s.node_position[a.second];
        edges += std::hypot(p[0] - q[0], p[1] - q[1]);
        if (both.size() == 2) {
            s.contact_nodes.push_back({a.first, a.second, b.second, b.first});
            s.contact_grain_boundary.push_back(static_cast<std::int32_t>(s.contact_grain_boundary.size()));
            s.contact_kind.push_back(static_cast<std::uint8_t>(ContactKind::grain_boundary));
        } else {
            s.boundary_edges.push_back({a.first, a.second});
            s.boundary_part.push_back(static_cast<std::uint8_t>(part_of(s, p, q)));
        }
    }
    s.statistics.mean_edge = edges / static_cast<double>(sides.size());
}

}  // namespace

Specimen specimen_of_grains(const std::vector<Point>& points, const std::vector<Triangle>& triangles,
                            const std::vector<int>& grain) {
    Specimen s;
    s.shape = "rectangle";
    s.tessellation = "test";
    const auto [left, right] =
        std::minmax_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a[0] < b[0]; });
    const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [](const Point& a, const Point& b) { return a[1] < b[1]; });
    s.width = (*right)[0] - (*left)[0];
    s.height = (*high)[1] - (*low)[1];
    s.grain_phase.assign(static_cast<std::size_t>(grain.back()) + 1, 0);
    s.grain_area.assign(s.grain_phase.size(), 0.0);
    std::map<std::pair<int, int>, std::int32_t> node;  // of (grain, point)
    std::map<std::pair<int, int>, std::vector<Side>> sides;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        std::array<std::int32_t, 3> nodes{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [at, is_new] =
                node.try_emplace({grain[t], triangles[t][k]}, static_cast<std::int32_t>(s.node_position.size()));
            if (is_new) s.node_position.push_back(points[triangles[t][k]]);
            nodes[k] = at->second;
        }
        s.element_nodes.push_back(nodes);
        s.element_grain.push_back(grain[t]);
        s.grain_area[grain[t]] += area(points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto key = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
            sides[key].push_back({grain[t], nodes[k], nodes[(k + 1) % 3]});
        }
    }
    std::erase_if(sides,
                  [](const auto& item) { return item.second.size() == 2 && item.second[0].grain == item.second[1].grain; });
    add_sides(s, sides);
    return s;
}

Specimen specimen_of_triangles(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
    std::vector<int> grain(triangles.size());
    std::iota(grain.begin(), grain.end(), 0);
    return specimen_of_grains(points, triangles, grain);
}

Specimen one_diagonal_grid(int nx, int ny, double width, double height) {
    return specimen_of_triangles(grid_points(nx, ny, width, height, 0), grid_triangles(nx, ny, never));
}
Specimen one_diagonal_column(int ny, double width, double height) {
    std::vector<int> grain;
    for (int j = 0; j < ny; ++j) grain.insert(grain.end(), 2, j);
    return specimen_of_grains(grid_points(1, ny, width, height, 0), grid_triangles(1, ny, never), grain);
}
Specimen union_jack_grid(int nx, int ny, double width, double height) {
    return specimen_of_triangles(grid_points(nx, ny, width, height, 0), grid_triangles(nx, ny, alternately));
}
Specimen jittered_grid(int nx, int ny, double width, double height, double jitter) {
    return specimen_of_triangles(grid_points(nx, ny, width, height, jitter), grid_triangles(nx, ny, alternately));
}

Specimen equilateral_lattice(int nx, int ny, double edge) {
    std::vector<Point> points = grid_points(nx, ny, nx * edge, ny * edge * std::sqrt(0.75), 0);
    for (Point& p : points) p[0] += p[1] / std::sqrt(3.0);
    return specimen_of_triangles(points, grid_triangles(nx, ny, always));
}

Specimen crossed_blocks(int nx, int ny, double width, double height, const std::function<int(int, int)>& grain_of) {
    std::vector<Point> points = grid_points(nx, ny, width, height, 0);
    std::map<int, std::vector<std::pair<int, int>>> cells;
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) cells[grain_of(i, j)].emplace_back(i, j);
    }
    std::vector<Triangle> triangles;
    std::vector<int> grain;
    for (const auto& [number, list] : cells) {
        for (const auto& [i, j] : list) {
            const std::array<int, 4> corner{j * (nx + 1) + i, j * (nx + 1) + i + 1, (j + 1) * (nx + 1) + i + 1,
                                            (j + 1) * (nx + 1) + i};
            const auto centre = static_cast<int>(points.size());
            points.push_back({width * ((i + 0.5) / nx - 0.5), height * ((j + 0.5) / ny - 0.5)});
            for (std::size_t k = 0; k < 4; ++k) {
                triangles.push_back({corner[k], corner[(k + 1) % 4], centre});
                grain.push_back(number);
            }
        }
    }
    return specimen_of_grains(points, triangles, grain);
}

namespace {

/// Two triangles of a quadrilateral a b c d, cut along its shorter diagonal.
std::array<Triangle, 2> cut_quadrilateral(const std::vector<Point>& points, int a, int b, int c, int d) {
    const auto distance = [&](int i, int j) { return std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]); };
    if (distance(a, c) < distance(b, d)) return {Triangle{a, b, c}, Triangle{a, c, d}};
    return {Triangle{a, b, d}, Triangle{b, c, d}};
}

}  // namespace

Specimen jointed_rectangle(int nx, int ny, double width, double height, double angle, Blocks blocks) {
    constexpr double jitter = 0.15;
    const double slope = std::tan(angle);
    std::vector<Point> points = grid_points(nx, 2 * ny, width, height, jitter);
    for (int j = 0; j <= 2 * ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            Point& p = points[j * (nx + 1) + i];
            if (j == ny) p = {width * (static_cast<double>(i) / nx - 0.5), 0};
            p[1] += (1 - 2 * std::abs(p[1]) / height) * slope * p[0];  // rows bend from the joint to the platens
        }
    }
    std::vector<Triangle> triangles;
    std::vector<int> grain;
    for (int j = 0; j < 2 * ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int corner = j * (nx + 1) + i;
            for (const Triangle& t : cut_quadrilateral(points, corner, corner + 1, corner + nx + 2, corner + nx + 1)) {
                triangles.push_back(t);
                grain.push_back(blocks == Blocks::of_grains ? static_cast<int>(grain.size()) : (j < ny ? 0 : 1));
            }
        }
    }
    Specimen s = specimen_of_grains(points, triangles, grain);
    break_contacts(s, [slope, height](double x, double y) { return std::abs(y - slope * x) < 1e-9 * height; });
    return s;
}

namespace {

bool both_within(const Specimen& s, std::int32_t i, std::int32_t j, const Region& region) {
    const Point& p = s.node_position[static_cast<std::size_t>(i)];
    const Point& q = s.node_position[static_cast<std::size_t>(j)];
    return region(p[0], p[1]) && region(q[0], q[1]);
}

}  // namespace

void break_contacts(Specimen& s, const Region& region) {
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        if (both_within(s, s.contact_nodes[c][0], s.contact_nodes[c][1], region)) {
            s.contact_kind[c] = static_cast<std::uint8_t>(ContactKind::pre_existing_crack);
        }
    }
}

void cut_contacts(Specimen& s, const Region& region) {
    std::size_t kept = 0;
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto [a1, a2, b1, b2] = s.contact_nodes[c];
        if (both_within(s, a1, a2, region)) {
            s.boundary_edges.push_back({a1, a2});
            s.boundary_edges.push_back({b2, b1});
            s.boundary_part.insert(s.boundary_part.end(), 2, static_cast<std::uint8_t>(BoundaryPart::rim));
        } else {
            s.contact_nodes[kept] = s.contact_nodes[c];
            s.contact_kind[kept] = s.contact_kind[c];
            s.contact_grain_boundary[kept] = static_cast<std::int32_t>(kept);
            ++kept;
        }
    }
    s.contact_nodes.resize(kept);
    s.contact_kind.resize(kept);
    s.contact_grain_boundary.resize(kept);
}

std::uint8_t name_boundary(Specimen& s, const std::string& name, const Region& region) {
    const auto part = static_cast<std::uint8_t>(s.part_names.size());
    s.part_names.push_back(name);
    for (std::size_t e = 0; e < s.n_boundary_edges(); ++e) {
        if (both_within(s, s.boundary_edges[e][0], s.boundary_edges[e][1], region)) s.boundary_part[e] = part;
    }
    return part;
}

Specimen rotated(Specimen s, double angle) {
    for (auto& p : s.node_position) {
        p = {std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1]};
    }
    return s;
}

}  // namespace graincrack::test
