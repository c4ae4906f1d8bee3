// The command `info`: what is in a file, for a person; and its digest.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command info_command();

}  // namespace graincrack
