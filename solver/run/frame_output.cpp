#include "solver/run/frame_output.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/run/frame.hpp"

namespace graincrack {

FrameOutput::FrameOutput(int wanted, double first_interval, RunWriter* writer)
    : wanted_(wanted), interval_(first_interval), writer_(writer) {}

void FrameOutput::resume(const FrameProgress& progress, const RunReader& checkpoint) {
    if (wanted_ == 0) return;
    next_ = progress.next;
    interval_ = progress.interval;
    regular_ = progress.regular;
    for (std::size_t i = 0; i < progress.roles.size(); ++i) {
        if (progress.roles[i] == FrameRole::peak_so_far) {
            peak_ = checkpoint.frame(i);
        } else if (progress.roles[i] != FrameRole::present && writer_ != nullptr) {
            writer_->add_frame(checkpoint.frame(i), progress.roles[i]);
        }
    }
    thin_if_too_many();
}

FrameProgress FrameOutput::save(const Assemblage& a, const ContactLaws& laws, const State& state, RunWriter* checkpoint) const {
    const std::optional<Frame> peak = peak_ ? std::optional(whole_frame(a, *peak_)) : std::nullopt;
    const Frame present = whole_frame(a, make_frame(a, laws, state));
    if (checkpoint == nullptr) return {};
    checkpoint->add_frames(*writer_);
    if (peak) checkpoint->add_frame(*peak, FrameRole::peak_so_far);
    checkpoint->add_frame(present, FrameRole::present);
    return {next_, interval_, regular_, checkpoint->frame_roles()};
}

void FrameOutput::add(const Assemblage& a, Frame own, FrameRole role) {
    const Frame frame = whole_frame(a, std::move(own));
    if (writer_ != nullptr) writer_->add_frame(frame, role);
}

void FrameOutput::thin_if_too_many() {
    while (regular_ >= 2 * wanted_) {
        if (writer_ != nullptr) writer_->thin_frames();
        regular_ = (regular_ + 1) / 2;
        interval_ *= 2;
    }
}

bool FrameOutput::regular(double strain, const Assemblage& a, const ContactLaws& laws, const State& state) {
    if (wanted_ == 0 || strain < next_) return false;
    add(a, make_frame(a, laws, state), FrameRole::regular);
    ++regular_;
    thin_if_too_many();
    next_ = interval_ * (std::floor(strain / interval_) + 1);
    return true;
}

bool FrameOutput::peak(bool is_highest, bool has_fallen, const Assemblage& a, const ContactLaws& laws, const State& state) {
    if (wanted_ == 0) return false;
    if (is_highest) {
        peak_ = make_frame(a, laws, state);
        return false;
    }
    const bool is_final = has_fallen && peak_;
    if (is_final) {
        add(a, *peak_, FrameRole::kept);
        peak_.reset();
    }
    return is_final;
}

void FrameOutput::last(const Assemblage& a, const ContactLaws& laws, const State& state) {
    if (peak_ && peak_->step < state.step) add(a, *peak_, FrameRole::kept);
    add(a, make_frame(a, laws, state), FrameRole::kept);
}

}  // namespace graincrack
