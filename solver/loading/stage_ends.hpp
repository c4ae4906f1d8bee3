// Ends of a stage. Each is made in one function of stage_ends.cpp, which says when it is reached and how the record of stages
// names it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/loading/rate_control.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// What ends are decided by: the last row and its stage.
struct StageRow {
    const Feedback& feedback;
    const Rows& rows;
    double begin;             ///< of the stage, s
    double functions_end;     ///< of all functions that run in it, s
    double unbalanced_ratio;  ///< over the least forces that count
    double pressure_error;    ///< of a servo
    double transit_time;      ///< of a bar wave through the specimen, s
    double cracks_before;     ///< contacts whose failure does not count
    bool is_heated;           ///< the rock has, or had, a temperature
    double least_load;        ///< axial stress from which on a failure counts, absolute, Pa
};

struct StageEnd {
    std::string name;         ///< in the record of stages
    std::string memory_name;  ///< in saved states; "" for an end that remembers nothing
    double memory = 0;        ///< what it remembers from row to row
    std::function<bool(const StageRow& row, double& memory)> is_reached;
};

/// The ends of a stage that outlives them, in the order in which they are asked.
/// \param begin the rows up to its begin; null for a stage that resumes with saved memories
std::vector<StageEnd> ends_of(const Stage& stage, const Rows* begin);

/// What a stage may go beyond the value that ends it, of that value, without a word.
inline constexpr double trusted_overshoot = 0.02;
/// How far the last row is beyond the value of the condition that ended a stage, of that value; 0 for other ends and for 0.
double overshoot(const Stage& stage, const std::string& ended_by, const Rows& rows);

/// Contacts that have failed so far.
double cracks_in(const History& history);

}  // namespace graincrack
