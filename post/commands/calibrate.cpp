#include "post/commands/commands.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>

#include "post/calibrate/folder.hpp"
#include "post/chart/picture.hpp"
#include "post/options/command.hpp"
#include "post/plot/heat_map.hpp"
#include "share/base/error.hpp"
#include "share/options/option_set.hpp"

namespace graincrack {

namespace {

struct CalibrateOptions {
    std::string material;
    std::vector<std::string> settings;
};

/// Response by response, a row each. \pre each response has all parameters
void write_heat_map(const std::string& file, const std::vector<calibrate::Sensitivity>& all) {
    std::vector<std::string> rows;
    std::vector<std::string> columns;
    std::vector<std::vector<HeatCell>> cells;
    for (const calibrate::Sensitivity& s : all) {
        if (rows.empty() || rows.back() != s.response) {
            rows.push_back(s.response);
            cells.emplace_back();
        }
        if (rows.size() == 1) {
            const std::size_t table = s.parameter.find("contact.") == 0 ? 8 : 0;
            columns.push_back(s.parameter.substr(table));
            std::replace(columns.back().begin(), columns.back().end(), '_', ' ');
        }
        cells.back().push_back({s.exponent.value, fmt::format("{:.2f}", s.exponent.value), !s.is_significant()});
    }
    write_picture(draw_heat_map("d ln response / d ln parameter; white: the 95 % interval contains 0", rows, columns, cells, 1),
                  file);
}

void write_decision(const CalibrateOptions& options, const Call& call) {
    using calibrate::Ending;
    const std::string& folder = call.file();
    const auto [decision, requested_time, sensitivities] =
        calibrate::calibrate_folder(folder, options.material, options.settings, call.diagnostics());
    if (!sensitivities.empty()) write_heat_map(folder + "/identify.png", sensitivities);
    if (decision.ending == Ending::requested) {
        fmt::print(call.out, "{}/wanted.tsv\n", folder);
        const std::size_t n = decision.requested.size();
        const std::string time =
            requested_time > 0 ? fmt::format(" (about {:.2g} min of one processor)", requested_time / 60) : "";
        fmt::print(call.diagnostics(), "graincrack-post: calibrate: {} {} wanted{}: {}\n", n, n == 1 ? "run is" : "runs are",
                   time, decision.reason);
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
        },
        &write_decision);
}

}  // namespace graincrack
