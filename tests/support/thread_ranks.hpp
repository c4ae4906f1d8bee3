// Ranks that are threads of one process. They take turns: one runs until it has to wait for another, so that what is global to a
// process, as the HDF5 library, is never called by two at a time, and every run has the same order.
#pragma once

#include <functional>

#include "solver/ranks/messages.hpp"
#include "solver/ranks/ranks.hpp"

namespace graincrack::test {

/// Runs `body` on `n` ranks and ends with them. An exception of one ends the others where they next wait in
/// vain; that of the lowest rank is thrown.
/// \throws std::logic_error if ranks wait for each other, make other collective calls than the first one, or leave a message that
/// nobody has received
void on_thread_ranks(int n, const std::function<void(const Ranks&)>& body);

}  // namespace graincrack::test
