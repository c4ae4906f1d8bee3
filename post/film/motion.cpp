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
