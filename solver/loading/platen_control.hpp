// How the platens move: by a function of time, by a servo that holds an axial pressure, as fast as the measures of the run allow,
// or in blocks with rest between them.
#pragma once

#include <cstdint>

#include "share/file/specimen.hpp"
#include "solver/loading/rate_control.hpp"
#include "solver/model/amplitude.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Speed of each platen at both ends of an interval, approach positive, m/s; linear between.
struct PlatenSpeeds {
    double begin = 0;
    double end = 0;
};

class PlatenControl {
public:
    PlatenControl(const Specimen& specimen, const Rock& rock, const ProgramPlatens& platens);

    /// A stage's motion, from `time` on. A ramp of the speed starts at the present speed; one of the pressure at what the servo
    /// aims at or, without a servo so far, at the present pressure.
    void set(const PlatenMotion& motion, double time);
    /// Takes over what another run left.
    void take_over(double speed, double mean_compression);
    /// Speeds over the next `duration` seconds. \throws NumericalError if a block does not come to rest
    PlatenSpeeds next(const Feedback& feedback, double duration);

    /// Steps to the next row of the history where the measures or blocks decide, or where only the strain limit ends a stage:
    /// as many as move the platens by the 8000th part of the travel to it, enough to resolve a brittle peak; at most half a
    /// transit; of a block a part.
    [[nodiscard]] std::int64_t interval_steps(double time_step) const;
    /// True if `interval_steps` decides in any case.
    [[nodiscard]] bool paces_rows() const;
    /// The longest it takes to the strain limit, s.
    [[nodiscard]] double longest_time() const;

    [[nodiscard]] double speed() const { return speed_; }                        ///< of each, approach positive, m/s
    [[nodiscard]] double transit_time() const { return transit_time_; }          ///< of a bar wave through the specimen, s
    [[nodiscard]] double mean_compression() const { return mean_compression_; }  ///< over about a transit, Pa
    [[nodiscard]] double mean_speed(double time) const;                          ///< since the motion was set, m/s
    /// Time from which on the function of a motion changes no more, s.
    [[nodiscard]] double function_end() const;
    /// Difference of the mean compression from what a servo aims at, over that; 0 without a servo.
    [[nodiscard]] double pressure_error(double time) const;

    /// Axial stress from which on it is a load for the rate, Pa; 0 in bending.
    [[nodiscard]] double load_stress() const;
    /// Axial stress up to which a specimen that cracked before may settle between the platens, Pa.
    [[nodiscard]] double settling_stress() const;

    /// Calls `visit(name, member)` with all that changes besides the motion.
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
    /// Axial stress from which on it is a load for the rate, of the tensile strength.
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
    double span_;  ///< of a test in bending, else 0
    Rock rock_;
    double max_strain_;  ///< approach of the platens over height that ends a run
    PlatenMotion motion_ = TimeFunction{};
    Amplitude amplitude_;  ///< speed, or pressure with a servo
    double speed_ = 0;
    double mean_compression_ = 0;
    double strain_ = 0;  ///< approach over height since the motion was set, in its sense
    RateControl rate_;
    BlockControl blocks_;
};

}  // namespace graincrack
