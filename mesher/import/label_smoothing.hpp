// A boundary of pixels as a smooth line with points at distances of the size of elements.
#pragma once

#include <cstddef>
#include <vector>

#include "mesher/import/label_boundaries.hpp"
#include "mesher/plane/geometry.hpp"

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

}  // namespace graincrack::mesher
