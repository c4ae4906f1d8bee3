// Reads and writes program files in strict TOML (share/doc/loading.md).
#include "solver/program/program_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/base/toml_table.hpp"
#include "solver/program/keys.hpp"

namespace graincrack {
namespace {

using program_keys::visit;

void check_time_table(const TomlTable& table, const TimeFunction& f) {
    if (f.values.size() != f.times.size() || f.times.empty()) {
        table.refuse("values", "needs as many values as there are times, and at least one");
    }
    if (std::adjacent_find(f.times.begin(), f.times.end(), [](double a, double b) { return a >= b; }) != f.times.end()) {
        table.refuse("times", "must ascend");
    }
}

/// Reads a function written as a table. The stage sets its start value.
TimeFunction read_function_table(TomlTable table, const Quantity& quantity) {
    const auto& kinds = program_keys::kinds;
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return table.has(kind.first); });
    if (found == kinds.end()) {
        table.refuse("",
                     "is no function of time; {to, over}, {times, values}, {sine, frequency}, {ricker, frequency}, "
                     "{pulse, over} or one value fits");
    }
    TimeFunction f;
    f.kind = found->second;
    const bool has_rate = quantity.dimension == Dimension::temperature && table.has("rate");
    if (f.kind == TimeFunction::Kind::ramp && has_rate) f.kind = TimeFunction::Kind::rate;
    visit(table, f, quantity);
    if (f.kind == TimeFunction::Kind::table) check_time_table(table, f);
    table.refuse_others();
    return f;
}

/// Reads a value, "keep", "free" if allowed (NaN), or a table.
std::optional<TimeFunction> read_function(TomlTable& table, const std::string& key, const Quantity& quantity, bool may_be_free) {
    if (!table.has_value(key)) {
        auto function = table.table(key);
        return function ? std::optional(read_function_table(*function, quantity)) : std::nullopt;
    }
    TimeFunction f;
    if (table.is_word(key, "keep")) {
        f.kind = TimeFunction::Kind::keep;
    } else if (may_be_free && table.is_word(key, "free")) {
        f.value = std::nan("");
    } else {
        table.given(key, quantity, f.value);
    }
    return f;
}

/// Reads a table that has the keys of one value only.
template <class Value>
Value read_table(TomlTable table) {
    Value value;
    visit(table, value);
    table.refuse_others();
    return value;
}

/// Reads the motion of the platens in a stage. \throws InputError also if two motions are given
std::optional<PlatenMotion> read_platen_motion(TomlTable& table) {
    using namespace program_keys;
    const bool has_pressure = table.has(platen_pressure);
    if (has_pressure && table.has(platen_speed)) {
        table.refuse(platen_pressure, "the platens have a speed already; give one of the two");
    }
    if (has_pressure) return PressureServo{*read_function(table, platen_pressure, pressure_of_platens, false)};
    const auto speed = table.has_value(platen_speed) ? std::nullopt : table.table(platen_speed);
    if (speed && speed->has(automatic)) return read_table<AutomaticRate>(*speed);
    if (speed && speed->has(program_keys::blocks)) {
        const auto blocks = read_table<LoadingBlocks>(*speed);
        if (blocks.speed == 0) speed->refuse("", "needs a speed other than 0");
        return blocks;
    }
    const auto function = read_function(table, platen_speed, speed_of_platens, false);
    return function ? std::optional<PlatenMotion>(*function) : std::nullopt;
}

/// True if the platens reach their strain limit without further settings.
bool moves_on(const std::optional<PlatenMotion>& motion) {
    if (!motion || std::holds_alternative<PressureServo>(*motion)) return false;
    const auto* const function = std::get_if<TimeFunction>(&*motion);
    return function == nullptr || (function->kind == TimeFunction::Kind::constant && function->value != 0) ||
           (function->kind == TimeFunction::Kind::ramp && function->value != 0);
}

ActionFunctions read_functions(TomlTable& table) {
    ActionFunctions settings;
    program_keys::visit_settings(settings,
                                 [&](const std::string& name, const Quantity& quantity, auto& function, bool may_be_free) {
                                     function = read_function(table, name, quantity, may_be_free);
                                 });
    return settings;
}

/// Limits the length of names of probes, stages and boundaries: run files have them, those of stages for each occurrence.
void require_short_name(const TomlTable& table) {
    constexpr std::size_t longest = 1000;
    if (table.name().size() <= longest) return;
    table.refuse("", fmt::format("has a name of more than {} bytes; give a shorter one", longest));
}

/// Calls `read(table)` with each table [group.NAME], if there is any.
template <class Read>
void for_each_table(TomlTable& file, const std::string& group, Read&& read) {
    if (auto tables = file.table(group)) {
        for (TomlTable& table : tables->tables()) {
            require_short_name(table);
            read(table);
            table.refuse_others();
        }
        tables->refuse_others();
    }
}

BoundaryCondition read_boundary_condition(TomlTable& table) {
    BoundaryCondition condition;
    condition.name = table.name();
    visit(table, condition.region);
    const auto is_given = [&](const char* key) { return table.has(key); };
    if (constexpr std::array keys{"on", "box", "angles", "at"}; std::none_of(keys.begin(), keys.end(), is_given)) {
        table.refuse("",
                     "nowhere; give on = \"a part of the boundary\", angles = [from, to], at = [x, y] or box = [left, right, "
                     "bottom, top]");
    }
    condition.start = read_functions(table);
    return condition;
}

ProbeRequest read_probe(const Program& program, TomlTable& table) {
    ProbeRequest probe;
    probe.name = table.name();
    visit(table, probe);
    if (std::any_of(program.boundary_conditions.begin(), program.boundary_conditions.end(),
                    [&](const BoundaryCondition& c) { return c.name == probe.name; })) {
        table.refuse("", "there is a boundary of this name, which is a probe already; give it another name");
    }
    return probe;
}

const std::vector<ProbeColumn>* columns_of(const Program& program, const std::string& probe) {
    for (const BoundaryCondition& condition : program.boundary_conditions) {
        if (condition.name == probe) return &boundary_columns();
    }
    for (const ProbeRequest& request : program.probes) {
        if (request.name != probe || request.form == ProbeRequest::Form::ring) continue;
        if (request.form == ProbeRequest::Form::gauge) return &gauge_columns();
        return request.form == ProbeRequest::Form::circle ? &circle_columns() : &point_columns();
    }
    return nullptr;
}

/// Reads a key of `until` that names a column, with the value that ends the stage.
void read_condition(TomlTable& table, const std::string& key, Dimension dimension, Condition condition, Stage& stage) {
    std::optional<double> value;
    table.given(key, program_keys::any(key, dimension), value);
    if (value) {
        condition.value = *value;
        stage.until.push_back(condition);
    }
}

void read_probe_conditions(const Program& program, TomlTable table, Stage& stage) {
    const std::vector<ProbeColumn>* columns = columns_of(program, table.name());
    if (columns == nullptr) table.refuse("", "there is no probe and no boundary of this name");
    for (std::size_t i = 0; i < columns->size(); ++i) {
        const ProbeColumn& column = (*columns)[i];
        read_condition(table, column.name, column.dimension, {table.name(), i, table.name() + "." + column.name}, stage);
    }
    table.refuse_others();
}

void read_until(const Program& program, TomlTable table, Stage& stage) {
    program_keys::visit_until(table, stage);
    if (std::isinf(stage.longest_time) && !moves_on(stage.platens)) {
        table.refuse(
            "time",
            "missing; a stage in which the platens do not move on up to max_strain needs a longest time, such as \"1 ms\"");
    }
    for (std::size_t i = 0; i < history_datasets.size(); ++i) {
        const std::string name(history_datasets[i].name);
        if (name != "time" && name != "step") read_condition(table, name, history_datasets[i].dimension, {"", i, name}, stage);
    }
    for (const TomlTable& probe : table.tables()) read_probe_conditions(program, probe, stage);
    table.refuse_others();
}

/// Reads the temperature of a stage: a function of time, or { to, rate = "auto" }.
void read_temperature(TomlTable& table, Stage& stage) {
    if (!table.has(program_keys::temperature)) return;
    auto own = table.has_value(program_keys::temperature) ? std::nullopt : table.table(program_keys::temperature);
    if (!own || !own->is_word("rate", program_keys::automatic)) {
        stage.temperature = read_function(table, program_keys::temperature, quantity::temperature, false);
        return;
    }
    stage.heating = read_table<AutomaticHeating>(*own);
    stage.temperature.emplace().kind = TimeFunction::Kind::rate;
    stage.temperature->value = stage.heating->to;
}

/// Reads whether a stage has no platens. \throws InputError if it moves them, or follows a stage that had them
void read_absence(const Program& program, TomlTable& table, Stage& stage) {
    if (!table.has(program_keys::presence_of_platens)) return;
    table.choice(program_keys::presence_of_platens, stage.without_platens, "present", "absent");
    if (!stage.without_platens) return;
    if (!program.platens) table.refuse(program_keys::presence_of_platens, "the program has none; leave it out");
    if (stage.platens) table.refuse(program_keys::presence_of_platens, "the stage moves them; leave out the one or the other");
}

Stage read_stage(Program& program, TomlTable& table) {
    Stage stage;
    stage.name = table.name();
    stage.platens = read_platen_motion(table);
    if (!program.platens && stage.platens) table.refuse("", "there are no platens to move; add a table [platens]");
    read_temperature(table, stage);
    read_absence(program, table, stage);
    for (BoundaryCondition& condition : program.boundary_conditions) {
        if (auto own = table.table(condition.name)) {
            const ActionFunctions settings = read_functions(*own);
            own->refuse_others();
            stage.settings[condition.name] = settings;
        }
    }
    read_until(program,
               table.needed_table(program_keys::until, "every stage needs until = { time = \"...\" }, and may have other ends"),
               stage);
    table.given(program_keys::must_end_by, stage.must_end_by);
    const auto is_end = [&](const Condition& c) { return c.name == stage.must_end_by; };
    const bool has_end = stage.must_end_by.empty() || (stage.must_end_by == ended_by_rest && stage.rest) ||
                         (stage.must_end_by == ended_by_peak_drop && stage.peak_drop) ||
                         std::any_of(stage.until.begin(), stage.until.end(), is_end);
    if (!has_end) table.refuse(program_keys::must_end_by, "is none of the ends in until; one of them other than time fits");
    table.refuse_others();
    return stage;
}

void read_stages(TomlTable& file, Program& program) {
    TomlTable stages = file.needed_table("stage", "describe each stage by a table [stage.NAME]");
    for (const std::string& name : program.order) {
        if (!stages.table(name)) file.refuse("stages", fmt::format("there is no table [stage.{}]", name));
    }
    for (TomlTable& table : stages.tables()) {
        require_short_name(table);
        if (std::find(program.order.begin(), program.order.end(), table.name()) == program.order.end()) {
            table.refuse("", "is in no place of stages; add it there, or remove it");
        }
        program.stages.push_back(read_stage(program, table));
    }
    stages.refuse_others();
    const auto has_platens = [&](const std::string& name) { return !program.stage(name).without_platens; };
    const auto first = std::find_if(program.order.begin(), program.order.end(), has_platens);
    const auto gone = std::find_if_not(first, program.order.end(), has_platens);
    if (gone == program.order.end()) return;
    throw InputError(
        fmt::format("{}: stage.{}: platens: are there already in stage.{}; they may be absent before that stage only",
                    program.file, *gone, *first));
}

/// Records the actions of each condition that are named anywhere.
void record_actions(Program& program) {
    for (BoundaryCondition& condition : program.boundary_conditions) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            condition.is_set[i] = condition.start[i].has_value();
            for (const Stage& stage : program.stages) {
                const auto found = stage.settings.find(condition.name);
                condition.is_set[i] = condition.is_set[i] || (found != stage.settings.end() && found->second[i]);
            }
        }
        if (std::none_of(condition.is_set.begin(), condition.is_set.end(), [](bool set) { return set; })) {
            throw InputError(
                fmt::format("{}: boundary.{}: does nothing; give it a velocity_x, velocity_y, traction_x, traction_y, "
                            "pressure or shear, here or in a stage",
                            program.file, condition.name));
        }
    }
}

void read_platens(TomlTable& file, Program& program) {
    if (auto table = file.table("platens")) {
        program.platens.emplace();
        visit(*table, *program.platens);
        for (auto& [name, faces] : {std::pair("bottom", &program.platens->bottom), std::pair("top", &program.platens->top)}) {
            auto side = table->table(name);
            if (!side) continue;
            visit(*side, *faces);
            side->refuse_others();
        }
        table->refuse_others();
    }
}

// --- writing ---------------------------------------------------------------------------------------------------------------

/// Number in the form of a TOML float.
std::string toml_number(double value) {
    const std::string text = fmt::format("{}", value);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// A table that is written key by key, with all digits of numbers in SI units; empty values are not written.
class TomlEntries {
public:
    void add(const std::string& key, const std::string& value) { entries_.push_back(fmt::format("{} = {}", key, value)); }

    static constexpr bool reads = false;
    void given(const std::string& key, const std::string& value) {
        if (!value.empty()) add(key, toml_string(value));
    }
    void given(const std::string& key, const std::vector<std::string>& values) { add_list(key, values, toml_string); }
    void given(const std::string& key, bool value) { add(key, value ? "true" : "false"); }
    void given(const std::string& key, const Quantity& /*of*/, double value) { add(key, toml_number(value)); }
    void given(const std::string& key, const Quantity& /*of*/, std::int64_t value) { add(key, std::to_string(value)); }
    void given(const std::string& key, const Quantity& /*of*/, const std::optional<double>& value, const char* none = nullptr) {
        if (value) add(key, *value == 0 && none != nullptr ? toml_string(none) : toml_number(*value));
    }
    void given(const std::string& key, const Quantity& /*of*/, const std::vector<double>& values) {
        add_list(key, values, toml_number);
    }
    template <std::size_t N>
    void given(const std::string& key, const Quantity& of, const std::optional<std::array<double, N>>& value,
               const char* /*fits*/) {
        if (value) given(key, of, std::vector<double>(value->begin(), value->end()));
    }
    void choice(const std::string& key, bool value, const std::string& word_of_false, const std::string& word_of_true) {
        given(key, value ? word_of_true : word_of_false);
    }
    template <class Value>
    void needed(const std::string& key, const Value& value, const std::string& /*what*/) {
        given(key, value);
    }
    void needed(const std::string& key, const Quantity& of, double value, const std::string& /*what*/) { given(key, of, value); }

    /// The keys as lines, each with the prefix `before`.
    [[nodiscard]] std::string lines(const std::string& before = "") const {
        std::string lines;
        for (const std::string& entry : entries_) lines += before + entry + '\n';
        return lines;
    }
    [[nodiscard]] std::string inline_table() const { return fmt::format("{{ {} }}", fmt::join(entries_, ", ")); }

private:
    template <class Item, class Text>
    void add_list(const std::string& key, const std::vector<Item>& items, const Text& text_of) {
        std::vector<std::string> texts;
        for (const Item& item : items) texts.push_back(text_of(item));
        if (!items.empty()) add(key, fmt::format("[{}]", fmt::join(texts, ", ")));
    }

    std::vector<std::string> entries_;  ///< "key = value"
};

/// Writes the keys of a value as an inline table.
template <class... Value>
std::string inline_table(const Value&... value) {
    TomlEntries entries;
    visit(entries, value...);
    return entries.inline_table();
}
/// Writes the keys of a value as lines.
template <class... Value>
std::string lines(const Value&... value) {
    TomlEntries entries;
    visit(entries, value...);
    return entries.lines();
}

std::string function_text(const TimeFunction& f, const Quantity& quantity) {
    switch (f.kind) {
        case TimeFunction::Kind::constant: return std::isnan(f.value) ? "\"free\"" : toml_number(f.value);
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

std::string function_lines(const std::string& before, const ActionFunctions& settings) {
    TomlEntries entries;
    program_keys::visit_settings(settings, [&](const std::string& name, const Quantity& quantity, const auto& function, bool) {
        if (function) entries.add(name, function_text(*function, quantity));
    });
    return entries.lines(before);
}

std::string stage_text(const Stage& stage) {
    std::string text = fmt::format("\n[stage.{}]\n", toml_key(stage.name));
    for (const auto& [condition, settings] : stage.settings) text += function_lines(toml_key(condition) + ".", settings);
    TomlEntries entries;
    if (stage.platens) std::visit(AddMotion{entries}, *stage.platens);
    if (stage.without_platens) entries.given(program_keys::presence_of_platens, std::string("absent"));
    if (stage.heating) {
        entries.add(program_keys::temperature, inline_table(*stage.heating));
    } else if (stage.temperature) {
        entries.add(program_keys::temperature, function_text(*stage.temperature, quantity::temperature));
    }
    TomlEntries until;
    program_keys::visit_until(until, stage);
    for (const Condition& condition : stage.until) until.add(condition.name, toml_number(condition.value));
    entries.add(program_keys::until, until.inline_table());
    entries.given(program_keys::must_end_by, stage.must_end_by);
    return text + entries.lines();
}

}  // namespace

Program parse_program(const std::string& text, const std::string& name) {
    TomlTable file(parse_toml(text, name));
    Program program;
    program.file = name;
    program.text = text;
    visit(file, program);
    if (file.has(program_keys::temperature)) {
        program.temperature = read_function(file, program_keys::temperature, quantity::temperature, false);
    }
    read_platens(file, program);
    for_each_table(file, "boundary",
                   [&](TomlTable& table) { program.boundary_conditions.push_back(read_boundary_condition(table)); });
    for_each_table(file, "probe", [&](TomlTable& table) { program.probes.push_back(read_probe(program, table)); });
    for_each_table(file, "initial", [&](TomlTable& table) { visit(table, program.initial_velocities.emplace_back()); });
    read_stages(file, program);
    file.refuse_others();
    record_actions(program);
    return program;
}

Program read_program(const std::string& file) { return parse_program(text_of_toml(file), file); }

std::string program_text(const Program& program) {
    std::string text = lines(program);
    if (program.temperature) {
        text += fmt::format("{} = {}\n", program_keys::temperature, function_text(*program.temperature, quantity::temperature));
    }
    if (program.platens) {
        text += "\n[platens]\n" + lines(*program.platens);
        if (!program.platens->bottom.empty()) text += "\n[platens.bottom]\n" + lines(program.platens->bottom);
        if (!program.platens->top.empty()) text += "\n[platens.top]\n" + lines(program.platens->top);
    }
    for (const BoundaryCondition& condition : program.boundary_conditions) {
        text += fmt::format("\n[boundary.{}]\n{}{}", toml_key(condition.name), lines(condition.region),
                            function_lines("", condition.start));
    }
    for (const ProbeRequest& probe : program.probes) text += fmt::format("\n[probe.{}]\n{}", toml_key(probe.name), lines(probe));
    for (std::size_t i = 0; i < program.initial_velocities.size(); ++i) {
        text += fmt::format("\n[initial.{}]\n{}", i, lines(program.initial_velocities[i]));
    }
    for (const Stage& stage : program.stages) text += stage_text(stage);
    return text;
}

}  // namespace graincrack
