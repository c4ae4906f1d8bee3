#include "post/film/moments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "post/run/run_state.hpp"

namespace graincrack {

CurvePoint place_in(const std::vector<double>& ascending, double value) {
    const auto next = std::upper_bound(ascending.begin(), ascending.end(), value);
    if (next == ascending.begin()) return {0, 0};
    const auto row = static_cast<std::size_t>(next - ascending.begin()) - 1;
    if (next == ascending.end()) return {row, 0};
    return {row, (value - ascending[row]) / (*next - ascending[row])};
}

Passage::Passage(std::vector<double> times, const std::vector<double>& values) : times_(std::move(times)) {
    for (std::size_t row = 0; row < values.size(); ++row) {
        travelled_.push_back(row == 0 ? 0 : travelled_.back() + std::abs(values[row] - values[row - 1]));
    }
}

std::vector<double> film_moments(const Passage& passage, double first, double last, std::size_t count) {
    std::vector<double> times{first};
    const double from = passage.at(first);
    const double step = (passage.at(last) - from) / static_cast<double>(count - 1);
    for (std::size_t i = 1; i + 1 < count; ++i) {
        times.push_back(std::clamp(passage.time_at(from + step * static_cast<double>(i)), times.back(), last));
    }
    times.push_back(last);
    return times;
}

CurvePoint place_between_frames(const std::vector<double>& frame_times, const Passage& passage, double time) {
    const CurvePoint by_time = place_in(frame_times, time);
    if (by_time.share == 0) return by_time;
    const double from = passage.at(frame_times[by_time.row]);
    const double to = passage.at(frame_times[by_time.row + 1]);
    return to > from ? CurvePoint{by_time.row, (passage.at(time) - from) / (to - from)} : by_time;
}

Positions between(const Positions& from, const Positions& to, double share) {
    Positions places = from;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t axis = 0; axis < 2; ++axis) places[i][axis] += share * (to[i][axis] - from[i][axis]);
    }
    return places;
}

Positions Motion::in_frame(std::size_t index) const {
    return moved_nodes(specimen_, read_frame(run_, specimen_, index), magnification_);
}

Positions Motion::at(const CurvePoint& place) {
    const std::size_t next = place.share == 0 ? place.row : place.row + 1;
    std::erase_if(known_, [&](const auto& frame) { return frame.first != place.row && frame.first != next; });
    for (const std::size_t index : {place.row, next}) {
        if (!known_.contains(index)) known_.emplace(index, in_frame(index));
    }
    return between(known_.at(place.row), known_.at(next), place.share);
}

}  // namespace graincrack
