// Which moments of a test a film shows, where each lies between the rows of a history and between the frames of a run, and where
// the nodes are then.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "post/chart/map_view.hpp"
#include "post/run/load_curve.hpp"

namespace graincrack {

/// The position of a value in values that never fall: between the last that is not above it and the next; before all in row 0,
/// behind all in the last row. \pre there are values
CurvePoint place_in(const std::vector<double>& ascending, double value);

/// How far a test has come along a quantity: the sum of its changes, so that cycles count both ways.
class Passage {
public:
    /// \param times of the rows, ascending \param values of the quantity in them
    Passage(std::vector<double> times, const std::vector<double>& values);
    [[nodiscard]] double at(double time) const { return place_in(times_, time).of(travelled_); }
    /// The last time at which the test had come so far.
    [[nodiscard]] double time_at(double travelled) const { return place_in(travelled_, travelled).of(times_); }

private:
    std::vector<double> times_;
    std::vector<double> travelled_;
};

/// `count` times in even steps of the passage, from `first` to `last`. \pre count > 1
std::vector<double> film_moments(const Passage& passage, double first, double last, std::size_t count);

/// The frame before a time, and the share of the passage from it to the next that is over then. \pre there are frames
CurvePoint place_between_frames(const std::vector<double>& frame_times, const Passage& passage, double time);

/// Places a share of the way from some to others. \pre as many of both
Positions between(const Positions& from, const Positions& to, double share);

/// Reads frames as they are needed, and keeps the two about the last place.
class Motion {
public:
    Motion(const RunReader& run, const Specimen& specimen, double magnification)
        : run_(run), specimen_(specimen), magnification_(magnification) {}
    /// \param place of the frame before, and the share of the way to the next \throws InputError as `read_frame`
    Positions at(const CurvePoint& place);
    [[nodiscard]] Positions in_frame(std::size_t index) const;

private:
    const RunReader& run_;
    const Specimen& specimen_;
    double magnification_;
    std::map<std::size_t, Positions> known_;
};

}  // namespace graincrack
