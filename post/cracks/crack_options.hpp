// Options of commands that show micro-cracks.
#pragma once

#include <string>
#include <vector>

#include "post/cracks/export.hpp"
#include "post/options/command.hpp"
#include "post/run/crack_label.hpp"

namespace graincrack {

/// --crack-event failed|half-damaged|broken, --crack-mode traction|sign: what counts as a micro-crack, and which are tensile.
void add_crack_label(OptionSet set, CrackLabelChoice& label);
/// --class PAIR, which may be given again: what a picture of cracks is limited to.
void add_classes(OptionSet set, std::vector<std::string>& classes);
/// --event-distance, --event-time: the window of an acoustic event.
void add_events(OptionSet set, EventOptions& options);

}  // namespace graincrack
