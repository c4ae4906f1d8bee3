// The command `film`: a test as a film.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command film_command();

}  // namespace graincrack
