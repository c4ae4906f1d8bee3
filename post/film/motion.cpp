#include "post/film/motion.hpp"

#include "post/run/run_state.hpp"

namespace graincrack {

Positions between(const Positions& from, const Positions& to, double share) {
    Positions places = from;
    for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t axis = 0; axis < 2; ++axis) places[i][axis] += share * (to[i][axis] - from[i][axis]);
    }
    return places;
}

const Positions& Motion::in_frame(std::size_t index) {
    const auto known = frames_.find(index);
    if (known != frames_.end()) return known->second;
    if (frames_.size() > 1) frames_.erase(index > frames_.begin()->first ? frames_.begin() : std::prev(frames_.end()));
    return frames_[index] = moved_nodes(specimen_, read_frame(run_, specimen_, index), magnification_);
}

Positions Motion::at(const CurvePoint& place) {
    if (place.share == 0) return in_frame(place.row);
    const Positions& from = in_frame(place.row);
    return between(from, in_frame(place.row + 1), place.share);
}

}  // namespace graincrack
