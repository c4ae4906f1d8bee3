#include "post/commands/commands.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <string>
#include <vector>

#include "post/calibrate/folder.hpp"
#include "post/options/command.hpp"
#include "share/base/error.hpp"
#include "share/base/events.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

struct CalibrateOptions {
    std::string material;
    std::vector<std::string> settings;
    std::size_t jobs = 1;
};

/// "50 s", "24 min", "1.9 h".
std::string duration_text(double seconds) {
    if (seconds < 99.5) return fmt::format("{:.0f} s", seconds);
    return seconds < 5970 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

void write_decision(const CalibrateOptions& options, const Call& call) {
    using calibrate::Ending;
    const std::string& folder = call.file();
    const auto [decision, requested_time] =
        calibrate::calibrate_folder(folder, options.material, options.settings, call.diagnostics());
    if (decision.ending == Ending::requested) {
        fmt::print(call.out, "{}/wanted.tsv\n", folder);
        const std::size_t n = decision.requested.size();
        const double by_the_clock = requested_time / static_cast<double>(std::min<std::size_t>(options.jobs, n));
        const std::string time = requested_time > 0 ? fmt::format(" (about {} one after another, {} by the clock)",
                                                                  duration_text(requested_time), duration_text(by_the_clock))
                                                    : "";
        say(call.diagnostics(), fmt::format("graincrack-post: calibrate: {} {} wanted{}: {}", n, n == 1 ? "run is" : "runs are",
                                            time, decision.reason));
        return;
    }
    if (decision.ending == Ending::calibrated) {
        fmt::print(call.out, "{}/calibrated.toml\n", folder);
        return;
    }
    throw NumericalError(fmt::format("calibrate: {}: {}: {}; next: {}; {}/report.md has every step{}", folder,
                                     calibrate::label_of(decision.ending), decision.reason, decision.next, folder,
                                     decision.point.empty() ? "" : ", nearest.toml has the nearest point"));
}

}  // namespace

Command calibrate_command() {
    return make_command<CalibrateOptions>(
        "calibrate", "the next runs of a calibration, or the calibrated material; starts no runs itself",
        {"results/my-rock", "results/my-rock --material augig-granite --set zooms=2"},
        FileArguments{"folder", "folder with strength.tsv, moduli.tsv and toughness.tsv of the finished runs"},
        [](OptionSet set, CalibrateOptions& options) {
            add_text(set, "--material", options.material,
                     "material with [targets], [parameters] and [study], or with [laboratory] alone: a name of "
                     "share/materials or a TOML file; default: FOLDER/material.toml")
                .type_name("FILE");
            add_texts(set, "--set", options.settings, "KEY=VALUE", "new value of a key of [study]; may be given again");
            add_integer<std::size_t>(set, "--jobs", options.jobs, "runs side by side, by which the time is estimated", 1, 10000);
        },
        &write_decision);
}

}  // namespace graincrack
