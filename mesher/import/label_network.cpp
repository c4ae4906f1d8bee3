#include "mesher/import/label_network.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mesher/plane/simplified_lines.hpp"

namespace graincrack::mesher {

namespace {

constexpr Clearance needed{0.5, 20 * std::numbers::pi / 180};
/// Width of the low-pass filter (standard deviation along the line) over the side of elements, and its bounds in pixels: below,
/// pixel steps would stay; above, only curvature would be lost. Chosen by trial; not varied since.
constexpr double width_of_element = 1.0 / 3;
constexpr double least_width = 1;
constexpr double most_width = 4;
constexpr double squared_step = 0.75;  ///< mean squared distance of neighbouring middles of pixel sides, over directions
/// Largest shift of smoothed points from these middles, pixels: lines through middles are at least 0.7 apart, and 0.5 from nodes.
constexpr double farthest = 0.3;
constexpr double least_sides = 6;             ///< approximate sides of a closed line
constexpr double tolerance_of_element = 0.3;  ///< distance of removed points over the element side or line; by trial
constexpr double least_tolerance = 0.75;      ///< pixels

/// Averages points except the first and the last with their neighbours, repeatedly.
void smooth(std::vector<Point>& points, bool is_closed, double width) {
    const std::vector<Point> dense = points;
    const std::size_t n = points.size() - 1;
    const auto rounds = static_cast<int>(std::ceil(2 * width * width / squared_step));
    for (int round = 0; round < rounds; ++round) {
        std::vector<Point> next = points;
        for (std::size_t i = is_closed ? 0 : 1; i < n; ++i) {
            const Point average = 0.25 * points[i > 0 ? i - 1 : n - 1] + 0.5 * points[i] + 0.25 * points[i + 1];
            const Point move = average - dense[i];
            next[i] = dense[i] + std::min(1.0, farthest / std::max(length(move), 1e-9)) * move;
        }
        if (is_closed) next.back() = next.front();
        points = next;
    }
}

/// The smoothed middles of the pixel sides between nodes; only the nodes for the outline, which is straight.
DenseLine dense_line(const BoundaryChain& chain, const std::vector<Point>& nodes, double element) {
    const std::vector<Point>& path = chain.path;
    const std::size_t n_sides = chain.closed() ? path.size() : path.size() - 1;
    std::vector<Point> corners = path;
    DenseLine line;
    line.is_closed = chain.closed();
    if (!line.is_closed) {
        corners.front() = nodes[index(chain.from)];
        corners.back() = nodes[index(chain.to)];
        line.points.push_back(corners.front());
    }
    for (std::size_t i = 0; i < n_sides && !chain.on_outline(); ++i) {
        line.points.push_back(midpoint(path[i], path[(i + 1) % path.size()]));
    }
    line.points.push_back(line.is_closed ? line.points.front() : corners.back());
    const auto size = static_cast<double>(n_sides);
    line.spacing = line.points.front() == line.points.back() ? std::min(element, size / least_sides) : element;
    line.tolerance = std::max(least_tolerance, tolerance_of_element * std::min(element, size));
    smooth(line.points, line.is_closed, std::clamp(width_of_element * element, least_width, most_width));
    for (std::size_t i = 1; i < corners.size(); ++i) {
        line.doubled_area += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    }
    return line;
}

}  // namespace

LabelNetwork label_network(const LabelBoundaries& boundaries, double element) {
    std::vector<DenseLine> lines;
    for (const BoundaryChain& chain : boundaries.chains) lines.push_back(dense_line(chain, boundaries.nodes, element));
    const std::vector<std::vector<Point>> simple = simplified_lines(lines, needed);
    LabelNetwork network;
    network.points = boundaries.nodes;
    for (std::size_t c = 0; c < simple.size(); ++c) {
        const BoundaryChain& chain = boundaries.chains[c];
        const auto first = static_cast<int>(network.points.size());
        network.points.insert(network.points.end(), simple[c].begin() + (chain.closed() ? 0 : 1), simple[c].end() - 1);
        int from = chain.closed() ? first : chain.from;
        const auto add = [&](int to) {
            network.segments.push_back({from, to, chain.left, chain.right});
            from = to;
        };
        for (int i = chain.closed() ? first + 1 : first; i < static_cast<int>(network.points.size()); ++i) add(i);
        add(chain.closed() ? first : chain.to);
    }
    return network;
}

}  // namespace graincrack::mesher
