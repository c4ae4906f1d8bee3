// The command `page`: texts, tables and pictures of a study as one page.
#pragma once

#include "post/options/command.hpp"

namespace graincrack {

Command page_command();

}  // namespace graincrack
