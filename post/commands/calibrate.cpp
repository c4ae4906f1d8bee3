#include "post/commands/calibrate.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <filesystem>

#include "post/calibrate/folder.hpp"
#include "post/option_parts.hpp"
#include "share/command_line.hpp"
#include "share/error.hpp"

namespace graincrack {

namespace {

struct Options {
    std::string material;
    std::vector<std::string> settings;
};

void write(const Options& options, const Call& call) {
    using calibrate::Ending;
    const calibrate::Decision decision =
        calibrate::calibrate_folder(call.file(), options.material, options.settings, call.diagnostics());
    if (decision.ending == Ending::wanted) {
        fmt::print(call.out, "{}/wanted.tsv\n", call.file());
        const std::size_t n = decision.wanted.size();
        const std::string time =
            decision.wanted_time > 0 ? fmt::format(" (about {:.2g} min of one processor)", decision.wanted_time / 60) : "";
        fmt::print(call.diagnostics(), "graincrack-post: calibrate: {} {} wanted{}: {}\n", n, n == 1 ? "run is" : "runs are",
                   time, decision.reason);
        return;
    }
    if (decision.ending == Ending::calibrated) {
        fmt::print(call.out, "{}/calibrated.toml\n", call.file());
        return;
    }
    throw NumericalError(
        fmt::format("calibrate: {}: {}: {}; {}/report.md has every step{}", call.file(), calibrate::label_of(decision.ending),
                    decision.reason, call.file(),
                    std::filesystem::exists(call.file() + "/nearest.toml") ? ", nearest.toml the nearest point" : ""));
}

}  // namespace

Command calibrate_command() {
    return make_command<Options>(
        "calibrate", "the next runs of a calibration, or the calibrated material; runs nothing itself",
        {"results/my-rock", "results/my-rock --material augig-granite --set max_discs=40"},
        FileArguments{"folder", "folder with strength.tsv, moduli.tsv, toughness.tsv of the finished runs"},
        [](CLI::App& app, Options& options) {
            app.add_option("--material", options.material,
                           "material with [laboratory] and [study]: a name of share/materials or a TOML file (default: "
                           "FOLDER/material.toml)")
                ->type_name("FILE");
            add_names(app, "--set", options.settings, "KEY=VALUE", "a key of [study] with another value; may be given again");
        },
        &write);
}

}  // namespace graincrack
