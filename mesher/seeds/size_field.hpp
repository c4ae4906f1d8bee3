// Defines the local size of grains: graded over the region, scattered from grain to grain, elongated.
#pragma once

#include <optional>
#include <vector>

#include "mesher/plane/random_numbers.hpp"
#include "mesher/plane/stretch.hpp"
#include "mesher/plane/triangulation.hpp"
#include "mesher/region/grading.hpp"

namespace graincrack::mesher {

/// Relative size of grains at points of the plane in which they are equiaxed: the requested edge there over the edge of as many
/// equal grains of the same total area. A relative size is graded (g, from a table) and scattered by a factor f = exp(σz + σ²),
/// where z is a random field of variance 1 that is correlated over about two grains. The mean of 1/(gf)² over the area is 1, so
/// that sizes do not change the number of grains.
class SizeField {
public:
    /// Has the size 1 everywhere.
    SizeField() = default;
    /// \param edge of equal grains, m
    /// \param scatter standard deviation σ of the logarithm of sizes; no effect before `draw`
    /// \throws UsageError if sizes change too much between neighbouring grains, or the curves of the grading are missing
    SizeField(const Region& region, double edge, const std::optional<Grading>& grading, const Stretch& stretch, double scatter);

    [[nodiscard]] const Stretch& stretch() const { return stretch_; }
    [[nodiscard]] bool is_uniform() const { return !varies() && stretch_.is_identity(); }
    /// True if sizes vary in the plane where grains are equiaxed.
    [[nodiscard]] bool varies() const { return !graded_.empty() || is_scattered(); }
    [[nodiscard]] bool is_scattered() const { return scatter_ > 0; }

    /// Draws the random field z.
    void draw(const Box& box, RandomNumbers& random);
    [[nodiscard]] double scatter() const { return scatter_; }
    void set_scatter(double scatter) { scatter_ = scatter; }

    /// Relative size at a point of the plane where grains are equiaxed, without and with the scatter.
    [[nodiscard]] double graded(Point p) const { return graded_.empty() ? 1 : interpolated_grade(p); }
    [[nodiscard]] double at(Point p) const { return field_.empty() ? graded(p) : graded(p) * scatter_factor(p); }
    /// Bounds of the sizes.
    [[nodiscard]] double smallest() const;
    [[nodiscard]] double largest() const;
    /// Length of a short line of the specimen over the local size, m: as many edges of equal grains fit on it.
    [[nodiscard]] double relative_length(Point from, Point to) const {
        return length(stretch_.equiaxed(to - from)) / at(stretch_.equiaxed(midpoint(from, to)));
    }
    /// Distance over which sizes change, m.
    [[nodiscard]] double resolution() const { return resolution_; }

    /// Expected mean edge of the specimen over the edge of equal grains.
    [[nodiscard]] double mean_edge() const;
    /// Expected mean edge over that without scatter.
    [[nodiscard]] double mean_edge_of_scatter() const;
    /// Expected mean edge along a line over the edge of equal grains, without grading and elongation.
    [[nodiscard]] double mean_edge_along_lines() const;

private:
    struct Table {
        Point low;
        double spacing = 1;
        int n_x = 0, n_y = 0;
        std::vector<double> values;  ///< row by row from below

        Table() = default;
        Table(const Box& box, double size, int margin);
        [[nodiscard]] bool empty() const { return values.empty(); }
        [[nodiscard]] std::size_t place(int x, int y) const { return index(y) * index(n_x) + index(x); }
        [[nodiscard]] double at(int x, int y) const { return values[place(x, y)]; }
    };
    [[nodiscard]] double interpolated_grade(Point p) const;
    [[nodiscard]] double scatter_factor(Point p) const;
    void tabulate(const Region& region, double edge, const GradedSize& size);

    Stretch stretch_;
    double edge_ = 1, scatter_ = 0, resolution_ = 1;
    double mean_of_inverse_ = 1;  ///< mean inverse of the graded sizes, over the area
    double smallest_grade_ = 1, largest_grade_ = 1;
    Table graded_;
    Table field_;  ///< coefficients of z
};

/// Coefficient of variation of edges over their graded sizes, in the plane where grains are equiaxed.
double spread_of_edges(const std::vector<Point>& points, const std::vector<Edge>& edges, const SizeField& size);

}  // namespace graincrack::mesher
