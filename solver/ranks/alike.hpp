// What all ranks of a run must have alike before its first step: options, files, the program itself.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "share/file/settings.hpp"
#include "solver/ranks/ranks.hpp"

namespace graincrack {

/// A name and a value: "--rate-tolerance" and "0.006", "the specimen" and a digest of its content.
using Fact = std::pair<std::string, std::string>;
using Facts = std::vector<Fact>;

/// Settings with 15 digits. \param before each name
Facts facts_of(const Settings& settings, const std::string& before);

/// Prepares a run on every rank. \param prepare returns what must be alike; alone its result does not matter
/// \throws UsageError on all ranks that names the first difference, or what some of them cannot do; what `prepare` throws where
/// it throws the same on all
void prepare_alike(const Ranks& ranks, const std::function<Facts()>& prepare);

}  // namespace graincrack
