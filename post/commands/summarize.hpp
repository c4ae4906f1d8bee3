// The command `summarize`: statistics of the rows of tables by groups.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command summarize_command();

}  // namespace graincrack
