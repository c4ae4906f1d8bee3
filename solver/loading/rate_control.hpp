// Sets the speed of the platens (share/doc/loading.md) to the largest at which measures of the run show it to be quasi-static.
//
// The control keeps three measures below a tolerance T:
//
//   inertia            √(12 K/U) of kinetic energy K and stored energy U. In a bar between platens that approach at a speed v
//                      each, it equals 2 v/(c ε), the relative rise of the load while a wave runs through the bar (K = m v²/6,
//                      U = ½ E ε² V, c = √(E/ρ)). K is computed with the unscaled masses
//   unbalanced ratio   Σ|unbalanced force| / Σ|element force|
//   force difference   of the platens over their mean
//
// and the load that damping carries below `max_damping_load`. The first two may reach T/f, at most 0.1, where `near_failure` is
// f; so may the force difference while f is below 0.1, but for bending. The strain rises by at most 6 % of itself in a wave
// transit, and by at most 1.5 % once contacts are near failure; the limit of the damping load falls by the same rule. Temperature
// ramps follow the same rules (`HeatingControl`), with the change of temperature in place of the strain.
//
// The control is a pure function from measures to speed: the logarithm of the speed follows the measures at a limited rate.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

#include "share/file/run_file.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Measures of the last row of the history.
struct Feedback {
    double time = 0;               ///< s
    double axial_strain = 0;       ///< of the platens, tension positive
    double axial_compression = 0;  ///< mean of the platens, Pa
    double unbalanced_ratio = 0;   ///< as in the history
    double kinetic_energy = 0;     ///< of the unscaled masses, J
    double stored_energy = 0;      ///< J
    double force_difference = 0;   ///< of the platens, over their mean
    double damping_load = 0;       ///< load that damping carries, over that of the platens
    double near_failure = 0;       ///< how far failure involves the section, 0 to 1
    double element_force = 0;      ///< Σ |force of the elements on a node|, N
};

/// All rows of the history so far, and of the probes.
struct Rows {
    const History& history;
    std::function<double(const std::string& probe, std::size_t column)> probe;  ///< the last value of a column of a probe
};

/// The specimen as a bar between platens.
struct RateScales {
    double height = 0;        ///< m
    double transit_time = 0;  ///< of a bar wave through it, s
    double min_strain = 0;    ///< lower bound of the strain in all rules, so that a test can start from no load
    double min_energy = 0;    ///< stored energy at `min_strain`, J
    bool bends = false;       ///< a beam, of which a few contacts fail before the peak
};

/// The automatic rate of the platens.
class RateControl {
public:
    /// \param tolerance T \param fraction factor of all limits of measures and speeds; one half halves the speed throughout
    RateControl(double tolerance, const RateScales& scales, double fraction = 1)
        : tolerance_(tolerance), scales_(scales), fraction_(fraction) {}
    /// Returns the speed of each platen at the end of the next `duration` seconds, m/s. \param strain platen travel over height
    /// since axial loading began, in the sense of the test
    double next(const Feedback& feedback, double strain, double duration);
    /// Lower bound of the speed at a strain, m/s: a twentieth of the speed that the tolerance allows there in an elastic bar.
    /// \param allowed limit of the first two measures
    [[nodiscard]] double min_speed(double strain, double allowed) const;
    /// Limit of the first two measures at a value of `graincrack::near_failure`.
    [[nodiscard]] double allowed(double near_failure) const;
    /// Upper bound of the speed at a strain and a value of `graincrack::near_failure`, m/s.
    [[nodiscard]] double max_speed(double strain, double near_failure) const;
    /// Calls `visit(name, member)` with every member that changes; a test that resumes restores them.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("rate.near_failure", self.near_failure_);
        visit("rate.highest_load", self.highest_load_);
        visit("rate.inertia", self.inertia_);
        visit("rate.unbalanced_ratio", self.unbalanced_ratio_);
        visit("rate.force_difference", self.force_difference_);
        visit("rate.speed", self.speed_);
    }

private:
    double tolerance_;
    RateScales scales_;
    double fraction_;
    double near_failure_ = 0;  ///< the largest so far; it fades behind a peak
    double highest_load_ = 0;  ///< axial stress, absolute, Pa
    double inertia_ = 0;       ///< this and the next two: means over about a transit
    double unbalanced_ratio_ = 0;
    double force_difference_ = 0;
    double speed_ = 0;
};

/// Scales of thermal stress in a specimen whose minerals expand differently.
struct HeatingScales {
    double transit_time = 0;  ///< of a bar wave through it, s
    double least_change = 0;  ///< lower bound of the change in all rules, as thermal stress is negligible below it, K
    double least_force = 0;   ///< Σ |force of the elements on a node| at `least_change`, N
    double least_energy = 1;  ///< stored energy at `least_change`, J
    /// The unbalanced ratio with element forces of at least `least_force`: a mineral that expands freely has forces of waves
    /// only.
    [[nodiscard]] double loaded(const Feedback& now) const {
        return now.unbalanced_ratio * std::min(1.0, now.element_force / least_force);
    }
    /// The change of temperature whose stress stores this energy in a free specimen, K.
    [[nodiscard]] double change(double stored_energy) const {
        return least_change * std::sqrt(std::max(stored_energy, 0.0) / least_energy);
    }
};

/// The automatic rate of a temperature. Let θ be its change since the ramp began or, if larger, the change whose stress the
/// specimen has already. Thermal stress then rises relatively by θ̇/θ. In a wave transit this rise is at most the limit of the
/// first two measures of `RateControl`, and at most the largest relative rise of the strain. The unbalanced ratio
/// (`HeatingScales::loaded`) slows the change down. Kinetic energy is no measure here: free expansion moves without stress.
class HeatingControl {
public:
    HeatingControl(double tolerance, const HeatingScales& scales, double fraction = 1)
        : tolerance_(tolerance), scales_(scales), fraction_(fraction) {}
    /// Returns the absolute rate during the next `duration` seconds, K/s. \param change since the ramp began, K \param left
    /// remaining change, K
    double next(const Feedback& feedback, double change, double left, double duration);
    /// Upper bound of the rate at a value of `graincrack::near_failure`, and its lower bound, K/s.
    [[nodiscard]] double max_rate(double change, double near_failure) const;
    [[nodiscard]] double min_rate(double change) const;
    /// Estimates the time of a change while minerals crack, s.
    [[nodiscard]] double usual_time(double change) const;
    /// Calls `visit(name, member)` with every member that changes.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("heating.near_failure", self.near_failure_);
        visit("heating.unbalanced_ratio", self.unbalanced_ratio_);
        visit("heating.rate", self.rate_);
    }

private:
    double tolerance_;
    HeatingScales scales_;
    double fraction_;
    double near_failure_ = 0;      ///< the largest so far
    double unbalanced_ratio_ = 0;  ///< mean over about a transit
    double rate_ = 0;              ///< before the end is near, K/s
};

/// Travel of the platens in a block over the product of their speed and the duration of the block. The platens accelerate in the
/// first interval and decelerate in the last.
inline constexpr double moving_fraction_of_block = 1 - 1.0 / parts_of_block;

/// Loading in blocks: the platens move for a number of steps, then stand until the specimen is at rest, then move again
/// (Kazerani & Zhao 2014, §4: blocks of some 5,000 steps, each followed by cycling to quasi-static equilibrium).
class BlockControl {
public:
    /// \param speed of each platen within a block, m/s
    /// \param tolerance unbalanced ratio below which the specimen is at rest
    /// \param give_up longest time that it may take to come to rest, s
    BlockControl(double speed, double tolerance, double give_up) : speed_(speed), tolerance_(tolerance), give_up_(give_up) {}
    /// Returns the speed of each platen at the end of the next part, which takes `duration` seconds, m/s.
    /// \throws NumericalError if the specimen does not come to rest
    double next(double unbalanced_ratio, double duration);
    /// Calls `visit(name, member)` with every member that changes.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("block.part", self.part_);
        visit("block.stands", self.stands_);
    }

private:
    double speed_;
    double tolerance_;
    double give_up_;
    int part_ = 0;       ///< of the block; at `parts_of_block` the platens stand
    double stands_ = 0;  ///< time for which they have stood, s
};

}  // namespace graincrack
