#include "post/commands/calibrate.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "post/calibrate/folder.hpp"
#include "post/option_parts.hpp"
#include "share/error.hpp"

namespace graincrack {

namespace {

struct Options {};

void write(const Options&, const Call& call) {
    using calibrate::Ending;
    const calibrate::Decision decision = calibrate::calibrate_folder(call.file());
    if (decision.ending == Ending::wanted) {
        fmt::print(call.out, "{}/wanted.tsv\n", call.file());
        fmt::print(call.diagnostics(), "graincrack-post: calibrate: {} runs are wanted: {}\n", decision.wanted.size(),
                   decision.reason);
        return;
    }
    if (decision.ending == Ending::calibrated) {
        fmt::print(call.out, "{}/calibrated.toml\n", call.file());
        return;
    }
    throw NumericalError(fmt::format("calibrate: {}: {}: {}; {}/report.md has every step", call.file(),
                                     calibrate::label_of(decision.ending), decision.reason, call.file()));
}

}  // namespace

Command calibrate_command() {
    return make_command<Options>(
        "calibrate", "the next runs of a calibration, or the calibrated material; runs nothing itself",
        {"results/my-rock", "results/my-rock --quiet"},
        FileArguments{"folder",
                      "folder with material.toml ([laboratory], [study]) and strength.tsv, moduli.tsv of the finished runs"},
        [](CLI::App&, Options&) {}, &write);
}

}  // namespace graincrack
