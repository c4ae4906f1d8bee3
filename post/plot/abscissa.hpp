// What a picture of the course of a test has along its level axis.
#pragma once

#include <vector>

#include "post/chart/axis.hpp"
#include "post/run/load_curve.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

/// Time spreads what happens at a peak: the platens slow down there, and the strain hardly changes while a specimen breaks.
enum class Abscissa { time, strain };
void add_abscissa(OptionSet set, Abscissa& abscissa);

/// An axis with the values of a run's history on it.
struct Course {
    Axis axis;
    std::vector<double> values;
};
/// Time in ms, or axial strain in %, positive in the sense of the test; time for a run that was not loaded along its axis.
Course course_of(const RunData& run, Abscissa abscissa);

}  // namespace graincrack
