#include "solver/loading/block_control.hpp"

#include <fmt/format.h>

#include "share/base/error.hpp"

namespace graincrack {

double BlockControl::next(double unbalanced_ratio, double duration) {
    if (part_ == parts_of_block && unbalanced_ratio < tolerance_) {
        part_ = 0;
        stands_ = 0;
    }
    if (part_ < parts_of_block) {
        ++part_;
        return part_ < parts_of_block ? speed_ : 0;
    }
    stands_ += duration;
    if (stands_ > give_up_) {
        throw NumericalError(fmt::format(
            "no equilibrium between two blocks: after {:.3g} s the unbalanced ratio is {:.2e}, not below {:.2e}; use more "
            "--damping, a larger --rate-tolerance or --rate auto",
            stands_, unbalanced_ratio, tolerance_));
    }
    return 0;
}

}  // namespace graincrack
