// Design points in the space of the free parameters, boxes of them, and designs that fill a box.
//
// A design point has a coordinate for each parameter, 0 in the middle and ±1 at the edges of the first box, so that its
// coordinates stay the same when a box moves or becomes smaller.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace graincrack::calibrate {

using DesignPoint = Eigen::VectorXd;

struct Box {
    DesignPoint centre;
    DesignPoint half;  ///< of the widths

    [[nodiscard]] Eigen::Index size() const { return centre.size(); }
    /// Coordinates that are ±1 at the edges of this box.
    [[nodiscard]] DesignPoint local(const DesignPoint& point) const { return (point - centre).cwiseQuotient(half); }
    [[nodiscard]] bool contains(const DesignPoint& point) const { return local(point).lpNorm<Eigen::Infinity>() <= 1 + 1e-9; }
    [[nodiscard]] DesignPoint nearest(const DesignPoint& point) const {
        return point.cwiseMax(centre - half).cwiseMin(centre + half);
    }
    /// The box about another centre, so many times as wide, moved or cut where it would leave the limits.
    [[nodiscard]] Box about(const DesignPoint& at, double times, const Box& limits) const;
};

/// The box that both corners span.
Box box_between(const DesignPoint& low, const DesignPoint& high);
/// The smallest box that holds two boxes.
Box hull(const Box& a, const Box& b);

/// Points first, first + 1, … of the sequence of Sobol' in a box. They fill it evenly, however many there are.
/// \pre at most 40 parameters
std::vector<DesignPoint> sobol_points(const Box& box, std::size_t first, std::size_t n);

}  // namespace graincrack::calibrate
