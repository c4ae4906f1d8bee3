// What all ranks of a run must have alike before its first step: options, files, the program itself.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/ranks/ranks.hpp"

namespace graincrack {

/// Names and values: "--rate-tolerance" and "0.006", "the specimen" and a digest of its content.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// The options of an effective configuration (`CommandLine::effective_configuration`). \param left_out by their keys, "threads"
Facts facts_of_configuration(const std::string& configuration, const std::vector<std::string_view>& left_out);

/// Prepares a run on every rank. \param prepare returns what must be alike; alone its result does not matter
/// \throws UsageError on all ranks that names the first difference, or what some of them cannot do; what `prepare` throws where
/// it throws the same on all
void prepare_alike(const Ranks& ranks, const std::function<Facts()>& prepare);

}  // namespace graincrack
