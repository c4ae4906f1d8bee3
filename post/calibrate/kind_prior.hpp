// The response surfaces of a rock type, as functions of the parameters of a calibration.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/local_surface.hpp"
#include "post/calibrate/study.hpp"
#include "post/kind/kind_surface.hpp"

namespace graincrack::calibrate {

/// The prior that a rock type gives for the responses of a rock whose contacts some parameters change.
class KindPrior {
public:
    /// \param kind surface of the rock type; null if there is none
    KindPrior(std::shared_ptr<const KindSurface> kind, const Material& rock, const std::vector<Parameter>& parameters,
              const Study& study);

    /// Says why the rock type does not predict all fitted targets; "" if it does.
    [[nodiscard]] std::string lacks(const std::vector<Target>& targets) const;
    /// The surface of a target; empty if the rock type has no model of it for the specimens of the study.
    [[nodiscard]] std::optional<LocalSurface> surface(const Target& target) const;
    /// The parameters within the design of the rock type. \pre `lacks` is ""
    [[nodiscard]] const Box& box() const { return box_; }
    /// True if a coordinate lies at an edge of the box that the design sets, not the limits of the parameter.
    [[nodiscard]] bool ends_at(const DesignPoint& point) const;

private:
    struct Changed;
    [[nodiscard]] const KindModel* model(const Target& target) const;

    std::shared_ptr<const KindSurface> kind_;
    const Study& study_;
    std::shared_ptr<Changed> changed_;
    std::string unknown_;  ///< the first parameter that the surface does not have
    Box box_;
    Box limits_;
    KindCoordinates first_;  ///< coordinates of the first guess
};

}  // namespace graincrack::calibrate
