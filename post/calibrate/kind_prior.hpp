// Surfaces of a kind of rock over the parameters of a calibration.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "post/calibrate/local_surface.hpp"
#include "post/calibrate/study.hpp"
#include "post/kind/kind_surface.hpp"

namespace graincrack::calibrate {

/// What a kind says of the responses of a rock whose contacts some parameters change.
class KindPrior {
public:
    /// \param kind null: there is none
    KindPrior(std::shared_ptr<const KindSurface> kind, const Material& rock, const std::vector<Parameter>& parameters,
              const Study& study);

    /// Why the kind does not tell all fitted targets; "" if it does.
    [[nodiscard]] std::string lacks(const std::vector<Target>& targets) const;
    /// Empty if the kind has no model of the target, or none of its specimen.
    [[nodiscard]] std::optional<LocalSurface> surface(const Target& target) const;
    /// The limits of parameters within which the kind is known. \pre `lacks` nothing
    [[nodiscard]] const Box& box() const { return box_; }
    /// True if a coordinate at an edge of the box could go on, were the kind known there.
    [[nodiscard]] bool ends_at(const DesignPoint& point) const;

private:
    struct Changed;
    [[nodiscard]] const KindModel* model(const Target& target) const;

    std::shared_ptr<const KindSurface> kind_;
    const Study& study_;
    std::shared_ptr<Changed> changed_;
    std::string unknown_;  ///< the first parameter that the kind does not know
    Box box_;
    Box limits_;
    KindCoordinates first_;  ///< of the first guess
};

}  // namespace graincrack::calibrate
