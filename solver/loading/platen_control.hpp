// Controls the motion of the platens: by a function of time, by a servo that holds an axial pressure, at the automatic rate, or
// in blocks with rest between them.
#pragma once

#include <cstdint>

#include "share/file/specimen.hpp"
#include "solver/loading/rate_control.hpp"
#include "solver/model/amplitude.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Speed of each platen at both ends of an interval, positive for approach, m/s. It is linear in between.
struct PlatenSpeeds {
    double begin = 0;
    double end = 0;
};

class PlatenControl {
public:
    PlatenControl(const Specimen& specimen, const Rock& rock, const ProgramPlatens& platens);

    /// Sets the motion of a stage from `time` (s) on. A ramp of the speed starts at the present speed. A ramp of the pressure
    /// starts at the present target of the servo or, if there was none, at the present pressure.
    void set(const PlatenMotion& motion, double time);
    /// Takes over the speed (m/s) and the mean compression (Pa) at the end of another run.
    void take_over(double speed, double mean_compression);
    /// Returns the speeds over the next `duration` seconds. \throws NumericalError if a block does not come to rest
    PlatenSpeeds next(const Feedback& feedback, double duration);

    /// Returns the steps to the next row of the history for the automatic rate, for blocks and for stages that only the strain
    /// limit ends. In these steps the platens move by 1/8000 of their travel to the limit, which resolves a brittle peak, but
    /// for half a transit at most. In blocks they are one part of the block.
    [[nodiscard]] std::int64_t interval_steps(double time_step) const;
    /// True if `interval_steps` decides whatever the program says of rows.
    [[nodiscard]] bool paces_rows() const;
    /// Upper bound of the time to the strain limit, s.
    [[nodiscard]] double longest_time() const;

    [[nodiscard]] double speed() const { return speed_; }                        ///< of each, approach positive, m/s
    [[nodiscard]] double transit_time() const { return transit_time_; }          ///< of a bar wave through the specimen, s
    [[nodiscard]] double mean_compression() const { return mean_compression_; }  ///< over about a transit, Pa
    [[nodiscard]] double mean_speed(double time) const;                          ///< since the motion was set, m/s
    /// Time after which the function of a motion is constant, s.
    [[nodiscard]] double function_end() const;
    /// Relative difference of the mean compression from the target of the servo; 0 without a servo.
    [[nodiscard]] double pressure_error(double time) const;

    /// Axial stress from which on the rules of the rate apply, Pa; 0 in bending.
    [[nodiscard]] double load_stress() const;
    /// Axial stress up to which a specimen with earlier cracks may settle between the platens, Pa.
    [[nodiscard]] double settling_stress() const;

    /// Calls `visit(name, member)` with every member that changes, apart from the motion.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("platens.from", self.amplitude_.function.from);
        visit("platens.start", self.amplitude_.start);
        visit("platens.speed", self.speed_);
        visit("platens.mean_compression", self.mean_compression_);
        visit("platens.strain", self.strain_);
        RateControl::visit_state(self.rate_, visit);
        BlockControl::visit_state(self.blocks_, visit);
    }

private:
    template <class Motion>
    [[nodiscard]] const Motion* as() const {
        return std::get_if<Motion>(&motion_);
    }
    /// Axial stress from which on the rules of the rate apply, over the tensile strength.
    [[nodiscard]] double least_load(bool apart) const;
    [[nodiscard]] RateScales rate_scales(bool apart) const;
    [[nodiscard]] double servo_speed(double time, double duration) const;
    [[nodiscard]] double final_speed() const;  ///< of a function of time, m/s
    [[nodiscard]] double slowest_speed(double strain) const;

    double height_;
    double area_;
    double transit_time_;  ///< of a bar wave through the specimen, s
    bool has_end_faces_;
    bool is_bonded_;
    double span_;  ///< of a test in bending, m; else 0
    Rock rock_;
    double max_strain_;  ///< approach of the platens over height that ends a run
    PlatenMotion motion_ = TimeFunction{};
    Amplitude amplitude_;  ///< speed, or pressure with a servo
    double speed_ = 0;
    double mean_compression_ = 0;
    double strain_ = 0;  ///< approach over height since the motion was set, positive in its sense
    RateControl rate_;
    BlockControl blocks_;
};

}  // namespace graincrack
