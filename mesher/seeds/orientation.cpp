#include "mesher/seeds/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace graincrack::mesher {

namespace {

constexpr std::size_t n_parts = 8;

constexpr Point complex_product(Point p, Point q) { return {p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x}; }

/// Index of the interval that holds a coordinate, among n equal ones over [−extent/2, extent/2].
std::size_t interval(double coordinate, double extent, std::size_t n) {
    const double place = (coordinate / extent + 0.5) * static_cast<double>(n);
    return std::min(static_cast<std::size_t>(std::max(place, 0.0)), n - 1);
}

std::size_t part_of_disc(const Box& box, Partition partition, Point p) {
    constexpr double turn = 2 * std::numbers::pi;
    const double angle = std::atan2(p.y, p.x);
    if (partition == Partition::blocks) return interval(angle, turn, n_parts);
    if (partition == Partition::turned) return interval(std::remainder(angle + turn / 16, turn), turn, n_parts);
    const bool inner = squared_length(p) < box.width() * box.width() / 8;
    return 2 * interval(angle, turn, n_parts / 2) + (inner ? 1 : 0);
}

std::size_t part_of_grid(const Box& box, Partition partition, Point p) {
    const bool upright = box.height() >= box.width();
    const std::size_t n_long = partition == Partition::blocks ? 4 : partition == Partition::turned ? 2 : 8;
    const std::size_t n_x = upright ? n_parts / n_long : n_long;
    return n_x * interval(p.y, box.height(), n_parts / n_x) + interval(p.x, box.width(), n_x);
}

}  // namespace

Neighbours neighbours_of(std::span<const Edge> edges, std::size_t n_points) {
    Neighbours result;
    result.start.assign(n_points + 1, 0);
    for (const Edge& e : edges) {
        for (const int p : e) ++result.start[index(p) + 1];
    }
    std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
    result.items.resize(2 * edges.size());
    std::vector<int> fill(result.start.begin(), result.start.end() - 1);
    const auto put = [&](int at, int item) {
        result.items[static_cast<std::size_t>(fill[static_cast<std::size_t>(at)]++)] = item;
    };
    for (const Edge& e : edges) {
        put(e[0], e[1]);
        put(e[1], e[0]);
    }
    return result;
}

Point six_fold(Point direction) {
    const double l2 = squared_length(direction);
    if (l2 == 0) return {};
    const Point squared = complex_product(direction, direction);
    const Point sixth = complex_product(complex_product(squared, squared), squared);
    return (1 / (l2 * l2 * l2)) * sixth;
}

double psi6(std::span<const Point> points, std::span<const Edge> edges) {
    Point sum;
    for (const Edge& e : edges) sum = sum + six_fold(points[index(e[1])] - points[index(e[0])]);
    return edges.empty() ? 0.0 : length(sum) / static_cast<double>(edges.size());
}

double largest_psi6_of_parts(const Region& region, Partition partition, std::span<const Point> points,
                             std::span<const Edge> edges, const Stretch& stretch) {
    const auto part_of = is_round(region) ? part_of_disc : part_of_grid;
    const Box box = bounds(region);
    const Point centre = midpoint(box.low, box.high);
    const std::size_t fewest = is_plain(region) ? 0 : edges.size() / (2 * n_parts);
    std::array<Point, n_parts> sums{};
    std::array<std::size_t, n_parts> counts{};
    for (const Edge& e : edges) {
        const Point p = points[index(e[0])];
        const Point q = points[index(e[1])];
        const std::size_t part = part_of(box, partition, midpoint(p, q) - centre);
        sums[part] = sums[part] + six_fold(stretch.equiaxed(q - p));
        ++counts[part];
    }
    double largest = 0;
    for (std::size_t part = 0; part < n_parts; ++part) {
        if (counts[part] > fewest) largest = std::max(largest, length(sums[part]) / static_cast<double>(counts[part]));
    }
    return largest;
}

std::vector<Point> local_orientation(std::span<const Point> points, const Neighbours& neighbours, int n_smoothings) {
    const std::size_t n = points.size();
    std::vector<Point> field(n);
    std::vector<Point> smoothed(n);
    const auto average = [&](std::size_t i, Point sum, double weight, const auto& value) {
        weight += neighbours.start[i + 1] - neighbours.start[i];
        for (int k = neighbours.start[i]; k < neighbours.start[i + 1]; ++k) sum = sum + value(index(neighbours.items[index(k)]));
        return (1 / weight) * sum;
    };
    for (std::size_t i = 0; i < n; ++i) {
        field[i] = average(i, {}, 1e-300, [&](std::size_t j) { return six_fold(points[j] - points[i]); });
    }
    for (int pass = 0; pass < n_smoothings; ++pass) {
        for (std::size_t i = 0; i < n; ++i) smoothed[i] = average(i, field[i], 1, [&](std::size_t j) { return field[j]; });
        field.swap(smoothed);
    }
    return field;
}

}  // namespace graincrack::mesher
