// How fast the platens may move (share/doc/loading.md): as fast as the run's own measures say that it stays quasi-static.
//
// Three measures are kept below a tolerance T:
//
//   inertia            √(12 K/U) of kinetic over stored energy. In a bar between platens that approach at a speed v each, it is
//                      2 v/(c ε), what the load rises by, relative to itself, while a wave runs through (K = m v²/6,
//                      U = ½ E ε² V, c = √(E/ρ)). K is of the masses as they are
//   unbalanced ratio   Σ|unbalanced force| / Σ|element force|
//   force difference   of the platens over their mean
//
// and a fourth, the load that damping carries, below `max_damping_load`. While no contact is near failure (`near_failure`) the
// first two may reach 0.1. The strain rises by at most 6 % of itself in a transit, by 1.5 % once contacts are near failure.
// Temperature ramps follow the same rules (`HeatingControl`), with the change of temperature in place of the strain.
//
// Pure: measures in, speed out. The logarithm of the speed follows what the measures allow, at a limited rate.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

#include "share/file/run_file.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Measures of the last row.
struct Feedback {
    double time = 0;               ///< s
    double axial_strain = 0;       ///< of the platens, tension positive
    double axial_compression = 0;  ///< mean of the platens, Pa
    double unbalanced_ratio = 0;   ///< as in the history
    double kinetic_energy = 0;     ///< of the masses as they are, J
    double stored_energy = 0;      ///< J
    double force_difference = 0;   ///< of the platens, over their mean
    double damping_load = 0;       ///< load that damping carries, over that of the platens
    double near_failure = 0;       ///< how far failure involves the section, 0 to 1
    double element_force = 0;      ///< Σ |force of the elements on a node|, N
};

/// All rows so far.
struct Rows {
    const History& history;
    std::function<double(const std::string& probe, std::size_t column)> probe;  ///< the last value of a column of a probe
};

/// The specimen as a bar between platens.
struct RateScales {
    double height = 0;        ///< m
    double transit_time = 0;  ///< of a bar wave through it, s
    double min_strain = 0;    ///< below it there is no load to speak of yet: a speed must begin somewhere
    double min_energy = 0;    ///< stored then, J
};

class RateControl {
public:
    /// \param fraction of all that the measures may reach and of the slowest and fastest speed: half of it is half the speed
    RateControl(double tolerance, const RateScales& scales, double fraction = 1)
        : tolerance_(tolerance), scales_(scales), fraction_(fraction) {}
    /// Speed of each platen at the end of the next `duration` seconds, m/s. \param strain platen travel over height since axial
    /// loading began, in the sense of the test
    double next(const Feedback& feedback, double strain, double duration);
    /// The slowest the platens ever go at a strain, m/s: a twentieth of what the tolerance means there in an elastic bar.
    /// \param allowed what counts of the tolerance
    [[nodiscard]] double min_speed(double strain, double allowed) const;
    /// The first two measures may reach this where failure involves so much of the section.
    [[nodiscard]] double allowed(double near_failure) const;
    /// The fastest the platens ever go at a strain where failure involves so much of the section, m/s.
    [[nodiscard]] double max_speed(double strain, double near_failure) const;
    /// Calls `visit(name, member)` with all that changes: a test that resumes needs it.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("rate.near_failure", self.near_failure_);
        visit("rate.inertia", self.inertia_);
        visit("rate.unbalanced_ratio", self.unbalanced_ratio_);
        visit("rate.force_difference", self.force_difference_);
        visit("rate.speed", self.speed_);
    }

private:
    double tolerance_;
    RateScales scales_;
    double fraction_;
    double near_failure_ = 0;  ///< the largest so far: the speed does not rise again once damage has begun
    double inertia_ = 0;       ///< this and the next two: means over about a transit
    double unbalanced_ratio_ = 0;
    double force_difference_ = 0;
    double speed_ = 0;
};

/// What a change of the temperature does to a specimen whose minerals expand differently.
struct HeatingScales {
    double transit_time = 0;  ///< of a bar wave through it, s
    double least_change = 0;  ///< below it there is no stress to speak of yet, K
    double least_force = 0;   ///< Σ |force of the elements on a node| then, N
    double least_energy = 1;  ///< stored then, J
    /// The unbalanced ratio over at least these forces: where one mineral expands freely there is no other force than that of
    /// waves.
    [[nodiscard]] double loaded(const Feedback& now) const {
        return now.unbalanced_ratio * std::min(1.0, now.element_force / least_force);
    }
    /// The change whose stress a free specimen has that stores so much, K.
    [[nodiscard]] double change(double stored_energy) const {
        return least_change * std::sqrt(std::max(stored_energy, 0.0) / least_energy);
    }
};

/// How fast a temperature may change. Its change θ since the ramp began, or the one whose stress the specimen has already if that
/// is more, gives thermal stress a relative rise of θ̇/θ: per wave transit it may reach what the first two measures of
/// `RateControl` may, and no more than strain may. The unbalanced ratio slows it down, but for forces of waves alone
/// (`HeatingScales::loaded`). Kinetic energy tells nothing: free expansion is motion without stress.
class HeatingControl {
public:
    HeatingControl(double tolerance, const HeatingScales& scales, double fraction = 1)
        : tolerance_(tolerance), scales_(scales), fraction_(fraction) {}
    /// Rate during the next `duration` seconds, absolute, K/s. \param change since the ramp began \param left of the way, K
    double next(const Feedback& feedback, double change, double left, double duration);
    /// The fastest it ever changes where failure involves so much of the specimen, and the slowest, K/s.
    [[nodiscard]] double max_rate(double change, double near_failure) const;
    [[nodiscard]] double min_rate(double change) const;
    /// About what a change takes where minerals crack, s.
    [[nodiscard]] double usual_time(double change) const;
    /// Calls `visit(name, member)` with all that changes.
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

/// Travel of the platens in a block over their speed and the duration of the block: they accelerate in the first interval and
/// decelerate in the last.
inline constexpr double moving_fraction_of_block = 1 - 1.0 / parts_of_block;

/// Loading in blocks: the platens move for a number of steps, then stand until the specimen is at rest, then move again
/// (Kazerani & Zhao 2014, §4: blocks of some 5,000 steps, each followed by cycling to quasi-static equilibrium).
class BlockControl {
public:
    /// \param speed of each platen within a block, m/s
    /// \param tolerance unbalanced ratio below which the specimen is at rest
    /// \param give_up how long it may take to get there, s
    BlockControl(double speed, double tolerance, double give_up) : speed_(speed), tolerance_(tolerance), give_up_(give_up) {}
    /// Speed of each platen at the end of the next part, which takes `duration` seconds, m/s.
    /// \throws NumericalError if the specimen does not come to rest
    double next(double unbalanced_ratio, double duration);
    /// Calls `visit(name, member)` with all that changes.
    template <class Self, class Visit>
    static void visit_state(Self& self, Visit&& visit) {
        visit("block.part", self.part_);
        visit("block.stands", self.stands_);
    }

private:
    double speed_;
    double tolerance_;
    double give_up_;
    int part_ = 0;       ///< of the block; `parts_of_block`: the platens stand
    double stands_ = 0;  ///< for how long, s
};

}  // namespace graincrack
