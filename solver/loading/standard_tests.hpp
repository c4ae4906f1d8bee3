// The four laboratory tests as data: platens, membrane, and how both move in time.
#pragma once

#include <cstdint>

#include "share/material.hpp"
#include "share/specimen.hpp"
#include "solver/loading/block_control.hpp"
#include "solver/loading/rate_control.hpp"
#include "solver/model/boundary.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

/// What the loading needs to know of the specimen's answer.
struct LoadingFeedback {
    double time = 0;
    double axial_compression = 0;  ///< mean of the platens, Pa
    double unbalanced_ratio = 0;
    RateMeasures rate = {};  ///< but for the strain, which the loading knows
};

struct LoadingLength {
    std::int64_t steps = 0;
    std::size_t rows = 0;  ///< of the history
};

/// Moves platens and pressure from batch to batch: isotropic stage first where there is a pressure, then the platens at
/// constant speed after a smooth start, at the speed that the run's measures allow, or in blocks.
class Loading {
public:
    Loading(const LoadingRequest& request, const Specimen& specimen, const Rock& rock, PlaneCondition plane);
    /// Steps of the next batch, of which each is a row of the history: as many as move the platens by the 8000th part of the way
    /// to the strain cap, enough to resolve a brittle peak; of a block a part.
    [[nodiscard]] std::int64_t interval_steps(double time_step) const;
    /// The longest way to the strain cap, without an isotropic stage and without rest between blocks.
    [[nodiscard]] LoadingLength longest(double time_step) const;
    /// Loading of the next `duration` seconds.
    /// \throws NumericalError if the isotropic stage does not settle, or a block does not come to rest
    IntervalLoading next(const LoadingFeedback& feedback, double duration);
    [[nodiscard]] bool is_isotropic() const { return isotropic_; }
    [[nodiscard]] double isotropic_end_time() const { return isotropic_end_time_; }
    /// Mean speed of each platen since the axial loading began, m/s.
    [[nodiscard]] double mean_speed(double time) const;
    [[nodiscard]] double platen_speed() const { return speed_; }  ///< at the end of the last batch, approach positive, m/s
    /// Calls `visit(name, member)` with all that changes.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("isotropic", self.isotropic_);
        visit("isotropic_end_time", self.isotropic_end_time_);
        visit("mean_compression", self.mean_compression_);
        visit("start_time", self.start_time_);
        visit("start_speed", self.start_speed_);
        visit("speed", self.speed_);
        visit("axial_strain", self.axial_strain_);
        RateControl::visit_state(self.control_, visit);
        BlockControl::visit_state(self.blocks_, visit);
    }

private:
    [[nodiscard]] double target_pressure(double time) const;
    [[nodiscard]] double slowest_speed(double strain) const;
    double isotropic_speed(const LoadingFeedback& feedback, double duration) const;
    double axial_speed(const LoadingFeedback& feedback, double duration);

    LoadingRequest request_;
    double height_;
    double transit_time_;          ///< of a bar wave through the specimen, s
    double young_modulus_;         ///< of the rock, Pa
    double isotropic_compliance_;  ///< axial strain per isotropic pressure, 1/Pa
    double ramp_time_ = 0;         ///< of the pressure, s
    bool isotropic_ = false;
    double isotropic_end_time_ = 0;
    double mean_compression_ = 0;  ///< over about a transit, Pa
    double start_time_ = 0;        ///< of the axial loading, s
    double start_speed_ = 0;
    double speed_ = 0;
    double axial_strain_ = 0;  ///< of the axial loading, in the sense of the test
    RateControl control_;
    BlockControl blocks_;
};

}  // namespace graincrack
