// Requested areas of polygonal cells, which may be graded.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "mesher/fabric/fabric.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "mesher/seeds/size_field.hpp"

namespace graincrack::mesher {

/// Error of areas, over the requested ones, at which iterations end.
inline constexpr double allowed_area_error = 1e-8;

/// Returns random areas of `n` cells with the sum `total` (m²). The coefficient of variation of their diameters (standard
/// deviation over mean) is exactly `spread`, or the largest possible one if so few cells allow less.
std::vector<double> requested_areas(std::size_t n, double total, double spread, SizeDistribution distribution,
                                    RandomNumbers& random);

/// Coefficient of variation of the diameters of circles with given areas.
double diameter_variation(const std::vector<double>& areas);

/// Areas of cells by place: drawn areas times the square of the graded size there, scaled so that the cells of each part of the
/// plane fill it. Without variation of size they are the drawn areas, bit for bit.
class GradedAreas {
public:
    /// Uses one size everywhere.
    GradedAreas(std::vector<double> drawn) : drawn_(std::move(drawn)) {}
    /// \param drawn areas, m², whose sum in each part is the area of the part \param size must outlive this
    /// \param part_of_cell [cells]; empty: all cells are in one part
    GradedAreas(std::vector<double> drawn, const SizeField& size, std::vector<std::size_t> part_of_cell = {});

    [[nodiscard]] std::size_t size() const { return drawn_.size(); }
    [[nodiscard]] bool are_graded() const { return size_ != nullptr; }
    /// Areas of the cells at places [cells], m².
    [[nodiscard]] std::vector<double> at(const std::vector<Point>& places) const;

    /// Returns a random place with the density of graded cells, which is one over the square of their size.
    /// \param draw returns random places of equal density
    template <class Draw>
    [[nodiscard]] Point random_place(const Draw& draw, RandomNumbers& random) const {
        while (true) {
            const Point place = draw();
            if (!are_graded() || random.uniform() * rarity_at(place) < 1) return place;
        }
    }

private:
    /// The square of the size at a place over that of the smallest size.
    [[nodiscard]] double rarity_at(Point place) const {
        const double ratio = size_->graded(place) / size_->smallest();
        return ratio * ratio;
    }

    std::vector<double> drawn_;
    const SizeField* size_ = nullptr;
    std::vector<std::size_t> part_of_cell_;
    std::vector<double> part_areas_;
};

}  // namespace graincrack::mesher
