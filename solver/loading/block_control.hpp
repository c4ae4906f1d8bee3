// Loading in blocks: the platens move for a number of steps, then stand until the specimen is at rest, then move again
// (Kazerani & Zhao 2014, §4: blocks of some 5,000 steps, each followed by cycling to quasi-static equilibrium).
#pragma once

#include "solver/program/program.hpp"

namespace graincrack {

/// Travel of the platens in a block over their speed and the duration of the block: they accelerate in the first interval and
/// decelerate in the last.
inline constexpr double moving_fraction_of_block = 1 - 1.0 / parts_of_block;

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
