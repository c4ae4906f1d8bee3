#include "solver/loading/program_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace graincrack {
namespace {

/// With all its digits, and as TOML writes what is no whole number.
std::string number(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) out += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return out + "\"";
}

/// A name as a key: bare where TOML allows it.
std::string key(const std::string& name) {
    const bool is_bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
    return is_bare ? name : quoted(name);
}

std::string list(const std::vector<std::string>& items) { return fmt::format("[{}]", fmt::join(items, ", ")); }

std::string quoted_list(const std::vector<std::string>& texts) {
    std::vector<std::string> items;
    std::transform(texts.begin(), texts.end(), std::back_inserter(items), quoted);
    return list(items);
}

std::string number_list(const std::vector<double>& values) {
    std::vector<std::string> items;
    std::transform(values.begin(), values.end(), std::back_inserter(items), number);
    return list(items);
}

/// { first = …, second = … }
using Entries = std::vector<std::pair<std::string, std::string>>;
std::string inline_table(const Entries& entries) {
    std::vector<std::string> items;
    for (const auto& [key, value] : entries) items.push_back(key + " = " + value);
    return fmt::format("{{ {} }}", fmt::join(items, ", "));
}

std::string function_text(const TimeFunction& f) {
    switch (f.kind) {
        case TimeFunction::Kind::constant: return std::isnan(f.value) ? "\"free\"" : number(f.value);
        case TimeFunction::Kind::keep: return "\"keep\"";
        case TimeFunction::Kind::ramp: return inline_table({{"to", number(f.value)}, {"over", number(f.duration)}});
        case TimeFunction::Kind::table: return inline_table({{"times", number_list(f.times)}, {"values", number_list(f.values)}});
        case TimeFunction::Kind::sine: {
            Entries entries{{"sine", number(f.value)}, {"frequency", number(f.frequency)}, {"phase", number(f.phase)}};
            if (f.duration > 0) entries.emplace_back("cycles", number(f.duration * f.frequency));
            return inline_table(entries);
        }
        case TimeFunction::Kind::ricker:
            return inline_table({{"ricker", number(f.value)}, {"frequency", number(f.frequency)}, {"at", number(f.peak_time)}});
        case TimeFunction::Kind::pulse: return inline_table({{"pulse", number(f.value)}, {"over", number(f.duration)}});
    }
    return "";
}

struct MotionLine {
    std::string operator()(const TimeFunction& speed) const { return "platen_speed = " + function_text(speed); }
    std::string operator()(const PressureServo& servo) const { return "platen_pressure = " + function_text(servo.pressure); }
    std::string operator()(const AutomaticRate& rate) const {
        return "platen_speed = " + inline_table({{"auto", rate.apart ? "\"apart\"" : "\"together\""},
                                                 {"tolerance", number(rate.tolerance)},
                                                 {"share", number(rate.share)}});
    }
    std::string operator()(const LoadingBlocks& blocks) const {
        return "platen_speed = " +
               inline_table(
                   {{"blocks", number(blocks.speed)}, {"steps", fmt::format("{}", blocks.steps)}, {"rest", number(blocks.rest)}});
    }
};

std::string region_lines(const Region& region) {
    std::string lines;
    if (!region.parts.empty()) lines += "on = " + quoted_list(region.parts) + "\n";
    if (std::isfinite(region.left)) {
        lines += "box = " + number_list({region.left, region.right, region.bottom, region.top}) + "\n";
    }
    return lines;
}

std::string settings_lines(const std::string& before, const Settings& settings) {
    std::string lines;
    for (std::size_t i = 0; i < n_actions; ++i) {
        if (settings[i]) {
            lines += fmt::format("{}{} = {}\n", before, name_of(static_cast<Action>(i)), function_text(*settings[i]));
        }
    }
    return lines;
}

std::string until_line(const Stage& stage) {
    Entries entries;
    if (std::isfinite(stage.longest_time)) entries.emplace_back("time", number(stage.longest_time));
    if (stage.rest) entries.emplace_back("rest", number(*stage.rest));
    if (stage.peak_drop) entries.emplace_back("peak_drop", number(*stage.peak_drop));
    for (const Condition& condition : stage.until) entries.emplace_back(condition.name, number(condition.value));
    return "until = " + inline_table(entries) + "\n";
}

std::string stage_text(const Stage& stage) {
    std::string text = fmt::format("\n[stage.{}]\n", key(stage.name));
    for (const auto& [condition, settings] : stage.settings) text += settings_lines(key(condition) + ".", settings);
    if (stage.platens) text += std::visit(MotionLine{}, *stage.platens) + "\n";
    text += until_line(stage);
    return stage.must_end_by.empty() ? text : text + "must_end_by = " + quoted(stage.must_end_by) + "\n";
}

std::string top_lines(const Program& program) {
    std::string text = fmt::format("name = {}\nstages = {}\n", quoted(program.name), quoted_list(program.order));
    if (program.damping) text += "damping = " + (*program.damping == 0 ? "\"none\"" : number(*program.damping)) + "\n";
    if (program.gravity.x != 0 || program.gravity.y != 0) {
        text += "gravity = " + number_list({program.gravity.x, program.gravity.y}) + "\n";
    }
    if (program.row_interval) text += "row_every = " + number(*program.row_interval) + "\n";
    if (!program.start_from.empty()) text += "start_from = " + quoted(program.start_from) + "\n";
    return text;
}

}  // namespace

std::string program_text(const Program& program) {
    std::string text = top_lines(program);
    if (program.platens) {
        text += fmt::format("\n[platens]\nbonded = {}\nmax_strain = {}\n", program.platens->bonded,
                            number(program.platens->max_strain));
    }
    for (const BoundaryCondition& condition : program.boundary_conditions) {
        text += fmt::format("\n[boundary.{}]\n{}{}", key(condition.name), region_lines(condition.region),
                            settings_lines("", condition.start));
    }
    for (const ProbeRequest& probe : program.probes) {
        text += fmt::format("\n[probe.{}]\n{} = {}\n", key(probe.name), probe.is_circle ? "circle" : "point",
                            probe.is_circle ? number_list({probe.centre.x, probe.centre.y, probe.radius})
                                            : number_list({probe.centre.x, probe.centre.y}));
    }
    for (std::size_t i = 0; i < program.initial_velocities.size(); ++i) {
        const InitialVelocity& initial = program.initial_velocities[i];
        text += fmt::format("\n[initial.{}]\n{}velocity = {}\n", i, region_lines(initial.region),
                            number_list({initial.velocity.x, initial.velocity.y}));
    }
    for (const Stage& stage : program.stages) text += stage_text(stage);
    return text;
}

}  // namespace graincrack
