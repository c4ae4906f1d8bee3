#include "mesher/seeds/size_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesher/region/region.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr double table_spacing = 0.5;  ///< spacing of the table of graded sizes, over the smallest edge
constexpr double max_table = 4e6;      ///< largest number of entries
constexpr double max_distances = 3e8;  ///< largest number of distances computed for it
constexpr double field_spacing = 0.8;  ///< spacing of the coefficients of z, over the edge: z is correlated to 1/e over 1.5 edges
constexpr double largest_z = 3;        ///< bound: z is a sum of bounded numbers
constexpr double steepest = 0.3;       ///< largest change of size between neighbouring grains; by trial

/// Mean edge of elongated equilateral grains of all directions, over their edge before.
double mean_of_elongated(const Stretch& stretch) {
    constexpr int n = 360;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double angle = std::numbers::pi * (i + 0.5) / n;
        sum += length(stretch.elongated({std::cos(angle), std::sin(angle)}));
    }
    return sum / n;
}

/// Weights of a cubic B-spline for the four coefficients around a place 0 ≤ t < 1 between the second and the third.
std::array<double, 4> spline_weights(double t) {
    const double s = 1 - t;
    return {s * s * s / 6, (3 * t * t * (t - 2) + 4) / 6, (3 * s * s * (s - 2) + 4) / 6, t * t * t / 6};
}

double sum_of_squares(const std::array<double, 4>& w) { return w[0] * w[0] + w[1] * w[1] + w[2] * w[2] + w[3] * w[3]; }

}  // namespace

SizeField::Table::Table(const Box& box, double size, int margin)
    : low(box.low - (margin * size) * Point{1, 1}),
      spacing(size),
      n_x(static_cast<int>(box.width() / size) + 2 + 2 * margin),
      n_y(static_cast<int>(box.height() / size) + 2 + 2 * margin),
      values(static_cast<std::size_t>(n_x) * static_cast<std::size_t>(n_y)) {}

SizeField::SizeField(const Region& region, double edge, const std::optional<Grading>& grading, const Stretch& stretch,
                     double scatter)
    : stretch_(stretch), edge_(edge), scatter_(scatter), resolution_(edge) {
    if (grading) tabulate(region, edge, GradedSize(*grading, region));
}

void SizeField::tabulate(const Region& region, double edge, const GradedSize& size) {
    const Region plane = stretched(region, stretch_, edge);
    const Box box = bounds(plane);
    const double smallest = std::min(1.0, size.smallest());
    const double extent = box.width() * box.height();
    const double finest = std::sqrt(extent / std::min(max_table, max_distances / static_cast<double>(1 + size.n_curves())));
    resolution_ = std::max(table_spacing * smallest * edge, finest);
    graded_ = Table(box, resolution_, 0);
    double n = 0, inverse = 0, inverse_squares = 0;
    for (int y = 0; y < graded_.n_y; ++y) {
        for (int x = 0; x < graded_.n_x; ++x) {
            const Point p = graded_.low + resolution_ * Point{static_cast<double>(x), static_cast<double>(y)};
            const double g = size.at(stretch_.elongated(p));
            graded_.values[graded_.place(x, y)] = g;
            if (!contains(plane, p)) continue;
            n += 1;
            inverse += 1 / g;
            inverse_squares += 1 / (g * g);
        }
    }
    if (n == 0) throw UsageError("--grade: the specimen is too small for graded sizes; give smaller grains");
    const double scale = std::sqrt(inverse_squares / n);
    for (double& g : graded_.values) g *= scale;
    mean_of_inverse_ = inverse / n / scale;
    smallest_grade_ = *std::min_element(graded_.values.begin(), graded_.values.end());
    largest_grade_ = *std::max_element(graded_.values.begin(), graded_.values.end());
    const double change = size.slope() * scale * edge * std::sqrt(stretch_.ratio());
    if (change > steepest) {
        throw UsageError("--grade: sizes would change by " + format_number(change, 3) +
                         " of a mean edge over its length; at most " + format_number(steepest) +
                         " fits; give less different sizes, a larger distance or smaller grains");
    }
}

void SizeField::draw(const Box& box, RandomNumbers& random) {
    field_ = Table(box, field_spacing * edge_, 2);
    for (double& value : field_.values) value = std::numbers::sqrt3 * random.symmetric();
}

double SizeField::interpolated_grade(Point p) const {
    const double x = std::clamp((p.x - graded_.low.x) / graded_.spacing, 0.0, graded_.n_x - 1.0);
    const double y = std::clamp((p.y - graded_.low.y) / graded_.spacing, 0.0, graded_.n_y - 1.0);
    const int i = std::min(static_cast<int>(x), graded_.n_x - 2);
    const int j = std::min(static_cast<int>(y), graded_.n_y - 2);
    const double s = x - i;
    const double t = y - j;
    return (1 - t) * ((1 - s) * graded_.at(i, j) + s * graded_.at(i + 1, j)) +
           t * ((1 - s) * graded_.at(i, j + 1) + s * graded_.at(i + 1, j + 1));
}

double SizeField::scatter_factor(Point p) const {
    const double x = std::clamp((p.x - field_.low.x) / field_.spacing, 1.0, field_.n_x - 2.5);
    const double y = std::clamp((p.y - field_.low.y) / field_.spacing, 1.0, field_.n_y - 2.5);
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const auto w_x = spline_weights(x - i);
    const auto w_y = spline_weights(y - j);
    double z = 0;
    for (int l = 0; l < 4; ++l) {
        double row = 0;
        for (int k = 0; k < 4; ++k) row += w_x[index(k)] * field_.at(i - 1 + k, j - 1 + l);
        z += w_y[index(l)] * row;
    }
    z /= std::sqrt(sum_of_squares(w_x) * sum_of_squares(w_y));
    return std::exp(scatter_ * z + scatter_ * scatter_);
}

double SizeField::smallest() const { return smallest_grade_ * std::exp(-scatter_ * largest_z + scatter_ * scatter_); }

double SizeField::largest() const { return largest_grade_ * std::exp(scatter_ * largest_z + scatter_ * scatter_); }

double SizeField::mean_edge() const {
    return is_uniform() ? 1 : mean_of_inverse_ * mean_edge_of_scatter() * mean_of_elongated(stretch_);
}

double SizeField::mean_edge_of_scatter() const { return std::exp(-scatter_ * scatter_ / 2); }

double SizeField::mean_edge_along_lines() const { return is_scattered() ? std::exp(scatter_ * scatter_ / 2) : 1; }

double spread_of_edges(const std::vector<Point>& points, const std::vector<Edge>& edges, const SizeField& size) {
    double sum = 0, squares = 0;
    for (const Edge& e : edges) {
        const Point p = points[index(e[0])];
        const Point q = points[index(e[1])];
        const double l = length(q - p) / size.graded(midpoint(p, q));
        sum += l;
        squares += l * l;
    }
    const auto n = static_cast<double>(edges.size());
    return std::sqrt(std::max(0.0, squares * n / (sum * sum) - 1));
}

}  // namespace graincrack::mesher
