// All boundaries of a picture as segments that do not cross.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/refined_triangulation.hpp"
#include "mesher/plane/triangulation.hpp"

namespace graincrack::mesher {

/// A chain that was smoothed, and the points that were taken of it. Its dense points are the middles of the sides of pixels (on
/// the outline of the picture the corners of pixels); the smooth line stays within `farthest` of them. The line through all dense
/// points where they were before crosses no other such line, so that ever finer chains end in what cannot cross.
class SmoothChain {
public:
    static constexpr double farthest = 0.75;  ///< pixels

    /// \param from, to the places of its nodes, of no meaning for a closed chain
    /// \param spacing requested between points, pixels
    SmoothChain(const BoundaryChain& chain, Point from, Point to, double spacing);

    /// The points taken, with both nodes; of a closed chain each once.
    [[nodiscard]] std::size_t size() const { return taken_.size(); }
    [[nodiscard]] Point point(std::size_t i) const { return smooth_[taken_[i]]; }
    [[nodiscard]] std::size_t n_segments() const { return closed_ ? size() : size() - 1; }

    /// Takes another point on a segment; where there is none left, moves its ends and their neighbours to where they were before
    /// smoothing. Segments are given by their first points, ascending.
    /// \return whether anything changed
    bool refine(const std::vector<std::size_t>& segments);

private:
    void make_smooth(double width);
    void take(double spacing);
    void keep_area();
    void move_along_normals();
    bool restore(std::size_t i);
    [[nodiscard]] std::size_t least_points() const;

    bool closed_;
    std::vector<Point> dense_;    ///< before smoothing
    std::vector<Point> fair_;     ///< the same points after it
    std::vector<Point> smooth_;   ///< these moved so that the points taken keep the area
    std::vector<bool> restored_;  ///< points that are where they were before smoothing
    double spacing_;
    double requested_area_ = 0;  ///< twice that between the corners of pixels and the chord, or inside
    std::vector<std::size_t> taken_;
};

/// Points and segments with the pieces on both sides, lengths in pixels.
struct LabelNetwork {
    std::vector<Point> points;
    std::vector<RegionEdge> segments;
    int refined_chains = 0;  ///< chains that needed finer segments
};

/// Smooths the boundaries and divides them. Where two come closer than 0.5 pixels, cross, or meet at less than 20°, they are
/// divided more finely, down to the middles of the sides of pixels; so are segments more than three times as long as one that
/// they meet. \param spacing requested between points, pixels
LabelNetwork label_network(const LabelBoundaries& boundaries, double spacing);

/// What segments need of each other.
struct Clearance {
    double distance = 0;  ///< between segments without a common point, in the unit of the points
    double angle = 0;     ///< between segments that share a point, rad, below π/2
};

/// The segments, ascending, that need more of a distance from another, or of an angle with it. Two that cross are always among
/// them: the distance is far above the rounding of its computation.
std::vector<std::size_t> crowded_segments(std::span<const Point> points, std::span<const Edge> segments,
                                          const Clearance& clearance);

}  // namespace graincrack::mesher
