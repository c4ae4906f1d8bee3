// Grades grain sizes over a region.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// Relative sizes, linear along x or y from the lower to the upper end of the region, or in the distance from curves.
struct Grading {
    enum class Kind { along_x, along_y, towards_flaws, towards_boundary, towards_holes } kind = Kind::along_y;
    double from = 1;      ///< relative edge at the lower end, or at the curves
    double to = 1;        ///< relative edge at the upper end, or at `distance` from the curves and beyond
    double distance = 0;  ///< m; for the kinds towards something

    [[nodiscard]] bool is_along() const { return kind == Kind::along_x || kind == Kind::along_y; }
};

/// Name of a kind: "along x", "towards flaws".
std::string name_of(Grading::Kind kind);
/// Reads "along=y,from=0.5,to=2" or "towards=flaws,from=0.4,distance=10mm". \throws UsageError naming `name`
Grading parse_grading(std::string_view text, const std::string& name);

/// The relative size at points of a region.
class GradedSize {
public:
    /// \throws UsageError if the region lacks the curves towards which sizes are graded
    GradedSize(const Grading& grading, const Region& region);

    /// Fraction of the distance between the places of the sizes `from` and `to`, 0 to 1.
    [[nodiscard]] double fraction(Point p) const;
    [[nodiscard]] double at(Point p) const { return grading_.from + (grading_.to - grading_.from) * fraction(p); }
    [[nodiscard]] double smallest() const { return std::min(grading_.from, grading_.to); }
    /// Largest change of the relative size over a length, 1/m.
    [[nodiscard]] double slope() const;
    [[nodiscard]] std::size_t n_curves() const { return curves_.size(); }

private:
    Grading grading_;
    Box box_;
    std::vector<Curve> curves_;
};

}  // namespace graincrack::mesher
