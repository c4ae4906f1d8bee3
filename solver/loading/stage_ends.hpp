// Conditions for the end of a stage. One function of stage_ends.cpp makes each of them, with its name in the record of stages.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/loading/rate_control.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// The data that decide ends: the last row and its stage.
struct StageRow {
    const Feedback& feedback;
    const Rows& rows;
    double begin;             ///< begin of the stage, s
    double functions_end;     ///< end of all its functions, s
    double unbalanced_ratio;  ///< with the least element forces that count
    double pressure_error;    ///< relative error of a servo
    double transit_time;      ///< of a bar wave through the specimen, s
    double cracks_before;     ///< number of contacts whose failure does not count
    bool is_heated;           ///< true if the rock has, or had, a temperature
    double least_load;        ///< smallest axial stress (absolute) at which a failure counts, Pa
};

struct StageEnd {
    std::string name;         ///< name in the record of stages
    std::string memory_name;  ///< name of `memory` in saved states; "" for an end without memory
    double memory = 0;        ///< a number that it stores from row to row
    std::function<bool(const StageRow& row, double& memory)> is_reached;
};

/// The ends of a stage in the order in which they are tested. The stage must outlive them.
/// \param begin the rows up to its begin; null for a stage that resumes with saved memories
std::vector<StageEnd> ends_of(const Stage& stage, const Rows* begin);

/// Largest relative overshoot that is not reported. Chosen by trial.
inline constexpr double trusted_overshoot = 0.02;
/// Distance of the last row beyond the value of the condition that ended a stage, over this value; 0 for other ends and for 0.
double overshoot(const Stage& stage, const std::string& ended_by, const Rows& rows);

/// Number of contacts that have failed so far.
double cracks_in(const History& history);

}  // namespace graincrack
