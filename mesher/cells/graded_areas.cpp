#include "mesher/cells/graded_areas.hpp"

#include <algorithm>
#include <utility>

namespace graincrack::mesher {

namespace {

double square_of(double value) { return value * value; }

}  // namespace

GradedAreas::GradedAreas(std::vector<double> drawn, const SizeField& size, std::vector<std::size_t> part_of_cell)
    : drawn_(std::move(drawn)), size_(size.varies() ? &size : nullptr), part_of_cell_(std::move(part_of_cell)) {
    if (part_of_cell_.empty()) part_of_cell_.assign(drawn_.size(), 0);
    const std::size_t n_parts = 1 + *std::max_element(part_of_cell_.begin(), part_of_cell_.end());
    part_areas_.assign(n_parts, 0);
    for (std::size_t cell = 0; cell < drawn_.size(); ++cell) part_areas_[part_of_cell_[cell]] += drawn_[cell];
}

std::vector<double> GradedAreas::at(const std::vector<Point>& places) const {
    if (!are_graded()) return drawn_;
    std::vector<double> areas = drawn_;
    std::vector<double> sums(part_areas_.size(), 0);
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
        areas[cell] *= square_of(size_->graded(places[cell]));
        sums[part_of_cell_[cell]] += areas[cell];
    }
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
        areas[cell] *= part_areas_[part_of_cell_[cell]] / sums[part_of_cell_[cell]];
    }
    return areas;
}

}  // namespace graincrack::mesher
