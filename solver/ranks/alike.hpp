// Checks that all ranks of a run agree on options, files and the program version before the first step.
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

/// Settings as text with 15 digits. \param before prefix of each name
Facts facts_of(const Settings& settings, const std::string& before);

/// Prepares a run on every rank. \param prepare returns the facts that must agree; a single rank ignores them
/// \throws UsageError on all ranks, naming the first difference or the failure of some ranks; an exception that `prepare` throws
/// alike on all ranks
void prepare_alike(const Ranks& ranks, const std::function<Facts()>& prepare);

}  // namespace graincrack
