#include "solver/run/frame_output.hpp"

#include <cmath>

#include "solver/run/measure.hpp"

namespace graincrack {

FrameOutput::FrameOutput(int wanted, double first_interval, RunWriter& writer)
    : wanted_(wanted), interval_(first_interval), writer_(writer) {}

void FrameOutput::regular(double strain, const Assemblage& a, const ContactLaw& law, const State& state) {
    if (wanted_ == 0 || strain < next_) {
        return;
    }
    writer_.add_frame(make_frame(a, law, state), false);
    ++regular_;
    if (regular_ >= 2 * wanted_) {
        writer_.thin_frames();
        regular_ = (regular_ + 1) / 2;
        interval_ *= 2;
    }
    next_ = interval_ * (std::floor(strain / interval_) + 1);
}

void FrameOutput::peak(bool is_highest, bool has_fallen, const Assemblage& a, const ContactLaw& law, const State& state) {
    if (wanted_ == 0) {
        return;
    }
    if (is_highest) {
        peak_ = make_frame(a, law, state);
    } else if (has_fallen && peak_) {
        writer_.add_frame(*peak_, true);
        peak_.reset();
    }
}

void FrameOutput::last(const Assemblage& a, const ContactLaw& law, const State& state) {
    if (peak_ && peak_->step < state.step) {
        writer_.add_frame(*peak_, true);
    }
    writer_.add_frame(make_frame(a, law, state), true);
}

}  // namespace graincrack
