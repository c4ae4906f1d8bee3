#include "post/cracks/crack_options.hpp"

#include <optional>
#include <utility>

#include "post/options/command.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

constexpr Quantity event_distance{"event_distance", Dimension::length, 0, 1e3, "distance within an acoustic event"};
constexpr Quantity event_time{"event_time", Dimension::time, 0, 1e6, "time within an acoustic event"};

}  // namespace

void add_crack_label(OptionSet set, CrackLabelChoice& label) {
    std::vector<std::pair<std::string, std::optional<CrackEvent>>> events;
    for (const CrackEvent event : all_crack_events) events.emplace_back(name_of(event), event);
    add_choice<std::optional<CrackEvent>>(set, "--crack-event", label.event, events,
                                          "when a contact point counts as a micro-crack: it passed its peak (failed), less than "
                                          "50 % (half-damaged) or less than 10 % (broken) of its cohesion is left; default: "
                                          "half-damaged for laws with friction in addition to cohesion, failed for others");
    add_choice<CrackModeRule>(set, "--crack-mode", label.mode,
                              {{"traction", CrackModeRule::traction}, {"sign", CrackModeRule::sign}},
                              "when a micro-crack is tensile: it passed its peak open and with more tensile than shear traction "
                              "(traction), or it was open at the event (sign)");
}

void add_classes(OptionSet set, std::vector<std::string>& classes) {
    add_texts(
        set, "--class", classes, "PAIR",
        "only contacts between two phases, such as quartz-mica, in either order; may be given again; default: all contacts");
}

void add_events(OptionSet set, EventOptions& options) {
    add_quantity(set, "--event-distance", options.distance, event_distance,
                 "crack points within this distance belong to one acoustic event; default: two mean edges");
    add_quantity(
        set, "--event-time", options.time, event_time,
        "crack points within this time belong to one acoustic event; default: that distance at half the speed of shear waves");
}

}  // namespace graincrack
