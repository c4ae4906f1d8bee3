// Strengths without and with confining pressure as surfaces over cc and φc: central composite designs, the place where both
// targets are met, and its interval.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "post/ccd/model.hpp"
#include "post/fit/statistics.hpp"

namespace graincrack::calibrate {

/// A place: cc in Pa, φc in rad.
using Place = std::array<double, 2>;

/// A design about a centre: cc by a factor, φc by an amount, at −1 and +1.
struct Frame {
    Place centre{};
    double factor = 1.35;  ///< cc at +1 over cc at the centre
    double angle = 0;      ///< rad
    [[nodiscard]] std::vector<double> coded(const Place& place) const;
    [[nodiscard]] Place place(const std::vector<double>& coded) const;
};

/// The places of a rotatable central composite design with centre runs, `scale` times as wide as the frame. Each has a specimen
/// of its own.
std::vector<Place> design_places(const Frame& frame, double scale, std::size_t centre_runs);

/// One specimen at one place: its strengths over their targets.
struct SurfacePoint {
    Place place{};
    std::array<double, 2> over_target{};  ///< without pressure, with pressure
};

struct SurfaceSolution {
    Place place{};                       ///< where both are met; else the most desirable place of the design
    bool met = false;                    ///< both within the design
    std::array<double, 2> expected{};    ///< strengths over their targets there, by the surfaces
    std::array<Estimate, 2> interval{};  ///< of cc and φc, 95 %
    std::array<std::optional<double>, 2> lack_of_fit_p{};
};

/// Full quadratics in ln cc and φc through the strengths, by regression; the root of both nearest to the centre; and, where it
/// lies outside the design, the most desirable place inside. \throws InputError if there are too few points
SurfaceSolution solve_surfaces(const Frame& frame, const std::vector<SurfacePoint>& points);

/// The place where both targets are met, from the means of specimens at one place and the slopes of the surfaces there. The
/// interval has the scatter of these means alone, and that of the slopes over the way to the root: designs led to the place, so
/// that their own scatter says nothing more about it. \param points of the designs \param replicates two or more at one place
SurfaceSolution correct_by_replicates(const Frame& frame, const std::vector<SurfacePoint>& points,
                                      const std::vector<SurfacePoint>& replicates);

}  // namespace graincrack::calibrate
