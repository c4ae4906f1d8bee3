#include "solver/program/program_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/program/keys.hpp"
#include "solver/program/toml_entries.hpp"

namespace graincrack {
namespace {

using program_keys::visit;

/// The keys of a value, as an inline table.
template <class... Value>
std::string inline_table(const Value&... value) {
    TomlEntries entries;
    visit(entries, value...);
    return entries.inline_table();
}
/// The same, as lines.
template <class... Value>
std::string lines(const Value&... value) {
    TomlEntries entries;
    visit(entries, value...);
    return entries.lines();
}

std::string function_text(const TimeFunction& f, const Quantity& quantity) {
    switch (f.kind) {
        case TimeFunction::Kind::constant: return std::isnan(f.value) ? "\"free\"" : toml::number(f.value);
        case TimeFunction::Kind::keep: return "\"keep\"";
        default: return inline_table(f, quantity);
    }
}

struct AddMotion {
    TomlEntries& entries;
    void operator()(const TimeFunction& speed) const {
        entries.add(program_keys::platen_speed, function_text(speed, program_keys::speed_of_platens));
    }
    void operator()(const PressureServo& servo) const {
        entries.add(program_keys::platen_pressure, function_text(servo.pressure, program_keys::pressure_of_platens));
    }
    template <class Motion>
    void operator()(const Motion& motion) const {
        entries.add(program_keys::platen_speed, inline_table(motion));
    }
};

std::string settings_lines(const std::string& before, const Settings& settings) {
    TomlEntries entries;
    program_keys::visit_settings(settings, [&](const std::string& name, const Quantity& quantity, const auto& function, bool) {
        if (function) entries.add(name, function_text(*function, quantity));
    });
    return entries.lines(before);
}

std::string stage_text(const Stage& stage) {
    std::string text = fmt::format("\n[stage.{}]\n", toml::key(stage.name));
    for (const auto& [condition, settings] : stage.settings) text += settings_lines(toml::key(condition) + ".", settings);
    TomlEntries entries;
    if (stage.platens) std::visit(AddMotion{entries}, *stage.platens);
    TomlEntries until;
    program_keys::visit_until(until, stage);
    for (const Condition& condition : stage.until) until.add(condition.name, toml::number(condition.value));
    entries.add(program_keys::until, until.inline_table());
    entries.given(program_keys::must_end_by, stage.must_end_by);
    return text + entries.lines();
}

}  // namespace

std::string program_text(const Program& program) {
    std::string text = lines(program);
    if (program.platens) {
        text += "\n[platens]\n" + lines(*program.platens);
        if (!program.platens->bottom.empty()) text += "\n[platens.bottom]\n" + lines(program.platens->bottom);
        if (!program.platens->top.empty()) text += "\n[platens.top]\n" + lines(program.platens->top);
    }
    for (const BoundaryCondition& condition : program.boundary_conditions) {
        text += fmt::format("\n[boundary.{}]\n{}{}", toml::key(condition.name), lines(condition.region),
                            settings_lines("", condition.start));
    }
    for (const ProbeRequest& probe : program.probes) text += fmt::format("\n[probe.{}]\n{}", toml::key(probe.name), lines(probe));
    for (std::size_t i = 0; i < program.initial_velocities.size(); ++i) {
        text += fmt::format("\n[initial.{}]\n{}", i, lines(program.initial_velocities[i]));
    }
    for (const Stage& stage : program.stages) text += stage_text(stage);
    return text;
}

}  // namespace graincrack
