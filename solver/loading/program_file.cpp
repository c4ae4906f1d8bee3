// The program's file: TOML, strict. share/doc/programs.md describes it.
#include "solver/loading/program_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>

#include "share/base/error.hpp"
#include "share/base/units.hpp"
#include "solver/loading/block_control.hpp"
#include "solver/loading/toml_table.hpp"

namespace graincrack {
namespace {

constexpr double infinite = quantity::unbounded;

Quantity any(std::string_view name, Dimension dimension) { return {name, dimension, -infinite, infinite, name}; }
Quantity positive(std::string_view name, Dimension dimension) { return {name, dimension, 0, infinite, name, true}; }
const Quantity coordinate = any("coordinate", Dimension::length);
const Quantity duration = positive("duration", Dimension::time);
const Quantity a_frequency = positive("frequency", Dimension::frequency);

Quantity quantity_of(Action action) { return any(name_of(action), is_velocity(action) ? Dimension::speed : Dimension::stress); }

/// Two components, x and y.
std::optional<Vector2> read_vector(TomlTable& table, const std::string& key, const Quantity& quantity) {
    const auto values = table.quantities(key, quantity);
    if (values && values->size() != 2) table.refuse(key, fmt::format("has {} components; two, x and y, fit", values->size()));
    return values ? std::optional<Vector2>({(*values)[0], (*values)[1]}) : std::nullopt;
}

Region read_region(TomlTable& table) {
    Region region;
    region.parts = table.texts("on").value_or(std::vector<std::string>{});
    if (const auto box = table.quantities("box", coordinate)) {
        if (box->size() != 4 || (*box)[0] > (*box)[1] || (*box)[2] > (*box)[3]) {
            table.refuse("box", "is no box; [left, right, bottom, top] with left <= right and bottom <= top fits");
        }
        region = {region.parts, (*box)[0], (*box)[1], (*box)[2], (*box)[3]};
    }
    return region;
}

TimeFunction read_time_table(TomlTable& table, const Quantity& quantity) {
    TimeFunction f;
    f.kind = TimeFunction::Kind::table;
    f.times = *table.quantities("times", any("times", Dimension::time));
    const auto values = table.quantities("values", quantity);
    if (!values || values->size() != f.times.size() || f.times.empty()) {
        table.refuse("values", "needs as many values as there are times, and at least one");
    }
    f.values = *values;
    if (std::adjacent_find(f.times.begin(), f.times.end(), [](double a, double b) { return a >= b; }) != f.times.end()) {
        table.refuse("times", "must ascend");
    }
    return f;
}

/// A function written as a table. What `from` is, only the stage knows.
TimeFunction read_function_table(TomlTable table, const Quantity& quantity) {
    TimeFunction f;
    if (table.has("times")) {
        f = read_time_table(table, quantity);
    } else if (const auto end = table.quantity("to", quantity)) {
        f.kind = TimeFunction::Kind::ramp;
        f.value = *end;
        f.duration = table.needed_quantity("over", duration, "a ramp needs its duration, such as over = \"1 ms\"");
    } else if (const auto amplitude = table.quantity("sine", quantity)) {
        f.kind = TimeFunction::Kind::sine;
        f.value = *amplitude;
        f.frequency = table.needed_quantity("frequency", a_frequency, "a sine needs its frequency, such as \"10 kHz\"");
        f.phase = table.quantity("phase", any("phase", Dimension::angle)).value_or(0);
        f.duration = table.quantity("cycles", positive("cycles", Dimension::one)).value_or(0) / f.frequency;
    } else if (const auto peak = table.quantity("ricker", quantity)) {
        f.kind = TimeFunction::Kind::ricker;
        f.value = *peak;
        f.frequency = table.needed_quantity("frequency", a_frequency, "a wavelet needs its frequency, such as \"10 kHz\"");
        constexpr double quiet_start = 1.5;  // periods: there the wavelet has 1e-8 of its peak
        f.peak_time = table.quantity("at", duration).value_or(quiet_start / f.frequency);
    } else if (const auto height = table.quantity("pulse", quantity)) {
        f.kind = TimeFunction::Kind::pulse;
        f.value = *height;
        f.duration = table.needed_quantity("over", duration, "a pulse needs its duration, such as over = \"10 us\"");
    } else {
        table.refuse("",
                     "is no function of time; {to, over}, {times, values}, {sine, frequency}, {ricker, frequency}, "
                     "{pulse, over} or one value fits");
    }
    table.refuse_others();
    return f;
}

/// A value, "keep", "free" where that makes sense (NaN), or a table.
std::optional<TimeFunction> read_function(TomlTable& table, const std::string& key, const Quantity& quantity, bool may_be_free) {
    if (!table.has_value(key)) {
        auto function = table.table(key);
        return function ? std::optional(read_function_table(*function, quantity)) : std::nullopt;
    }
    TimeFunction f;
    if (table.is_word(key, "keep")) {
        f.kind = TimeFunction::Kind::keep;
        return f;
    }
    f.value = may_be_free ? *table.quantity_or(key, "free", std::nan(""), quantity) : *table.quantity(key, quantity);
    return f;
}

/// { auto = "together", tolerance = 0.003, share = 1 }
AutomaticRate read_automatic_rate(TomlTable table) {
    AutomaticRate rate;
    rate.apart = table.is_word("auto", "apart");
    if (!rate.apart && !table.is_word("auto", "together")) {
        table.refuse("auto", "is no direction; \"together\" or \"apart\" fits");
    }
    rate.tolerance = table.quantity("tolerance", quantity::rate_tolerance).value_or(rate.tolerance);
    rate.share = table.quantity("share", quantity::rate_share).value_or(rate.share);
    table.refuse_others();
    return rate;
}

/// { blocks = "5 mm/s", steps = 5000, rest = 1e-4 }
LoadingBlocks read_blocks(TomlTable table) {
    LoadingBlocks blocks;
    blocks.speed = *table.quantity("blocks", any("blocks", Dimension::speed));
    const double steps = table.quantity("steps", {"steps", Dimension::one, parts_of_block, 1e9, "steps"})
                             .value_or(static_cast<double>(blocks.steps));
    if (blocks.speed == 0 || steps != std::floor(steps)) {
        table.refuse("", "needs a speed other than 0 and a whole number of steps");
    }
    blocks.steps = static_cast<std::int64_t>(steps);
    blocks.rest = table.quantity("rest", quantity::rate_tolerance).value_or(blocks.rest);
    table.refuse_others();
    return blocks;
}

/// How a stage moves the platens. \throws InputError also for two ways
std::optional<PlatenMotion> read_platen_motion(TomlTable& table) {
    const bool has_pressure = table.has("platen_pressure");
    if (has_pressure && table.has("platen_speed")) {
        table.refuse("platen_pressure", "the platens have a speed already; give one of the two");
    }
    if (has_pressure) {
        return PressureServo{*read_function(table, "platen_pressure", any("platen_pressure", Dimension::stress), false)};
    }
    auto speed = table.has_value("platen_speed") ? std::nullopt : table.table("platen_speed");
    if (speed && speed->has("auto")) return read_automatic_rate(*speed);
    if (speed && speed->has("blocks")) return read_blocks(*speed);
    const auto function = read_function(table, "platen_speed", any("platen_speed", Dimension::speed), false);
    return function ? std::optional<PlatenMotion>(*function) : std::nullopt;
}

/// Whether the platens come to their strain limit by themselves.
bool moves_on(const std::optional<PlatenMotion>& motion) {
    if (!motion || std::holds_alternative<PressureServo>(*motion)) return false;
    const auto* const function = std::get_if<TimeFunction>(&*motion);
    return function == nullptr || (function->kind == TimeFunction::Kind::constant && function->value != 0) ||
           (function->kind == TimeFunction::Kind::ramp && function->value != 0);
}

Settings read_settings(TomlTable& table) {
    Settings settings;
    for (std::size_t i = 0; i < n_actions; ++i) {
        const auto action = static_cast<Action>(i);
        settings[i] = read_function(table, std::string(name_of(action)), quantity_of(action), is_velocity(action));
    }
    return settings;
}

void read_boundary_conditions(TomlTable& file, Program& program) {
    auto boundary = file.table("boundary");
    if (!boundary) return;
    for (TomlTable& table : boundary->tables()) {
        BoundaryCondition condition;
        condition.name = table.name();
        condition.region = read_region(table);
        if (!table.has("on") && !table.has("box")) {
            table.refuse("", "nowhere; give on = \"a part of the boundary\" or box = [left, right, bottom, top]");
        }
        condition.start = read_settings(table);
        table.refuse_others();
        program.boundary_conditions.push_back(condition);
    }
    boundary->refuse_others();
}

void read_probes(TomlTable& file, Program& program) {
    auto probes = file.table("probe");
    if (!probes) return;
    for (TomlTable& table : probes->tables()) {
        ProbeRequest probe;
        probe.name = table.name();
        const auto point = read_vector(table, "point", coordinate);
        const auto circle = table.quantities("circle", coordinate);
        if (point.has_value() == circle.has_value()) table.refuse("", "needs either point = [x, y] or circle = [x, y, radius]");
        if (circle && (circle->size() != 3 || (*circle)[2] <= 0)) {
            table.refuse("circle", "is no circle; [x, y, radius] with a radius above 0 fits");
        }
        probe.is_circle = circle.has_value();
        probe.centre = circle ? Vector2{(*circle)[0], (*circle)[1]} : *point;
        probe.radius = circle ? (*circle)[2] : 0;
        table.refuse_others();
        program.probes.push_back(probe);
        if (std::any_of(program.boundary_conditions.begin(), program.boundary_conditions.end(),
                        [&](const BoundaryCondition& c) { return c.name == probe.name; })) {
            table.refuse("", "there is a boundary of this name, which is a probe already; give it another name");
        }
    }
    probes->refuse_others();
}

const std::vector<ProbeColumn>* columns_of(const Program& program, const std::string& probe) {
    for (const BoundaryCondition& condition : program.boundary_conditions) {
        if (condition.name == probe) return &boundary_columns();
    }
    for (const ProbeRequest& request : program.probes) {
        if (request.name == probe) return request.is_circle ? &circle_columns() : &point_columns();
    }
    return nullptr;
}

void read_probe_conditions(const Program& program, TomlTable table, Stage& stage) {
    const std::vector<ProbeColumn>* columns = columns_of(program, table.name());
    if (columns == nullptr) table.refuse("", "there is no probe and no boundary of this name");
    for (std::size_t i = 0; i < columns->size(); ++i) {
        const ProbeColumn& column = (*columns)[i];
        if (const auto value = table.quantity(column.name, any(column.name, column.dimension))) {
            stage.until.push_back({table.name(), i, table.name() + "." + column.name, *value});
        }
    }
    table.refuse_others();
}

void read_until(const Program& program, TomlTable table, Stage& stage) {
    stage.longest_time = infinite;
    if (table.has("time") || !moves_on(stage.platens)) {
        stage.longest_time = table.needed_quantity(
            "time", duration,
            "a stage in which the platens do not move on up to max_strain needs a longest time, such as \"1 ms\"");
    }
    stage.rest = table.quantity("rest", {"rest", Dimension::one, 0, 1, "rest", true});
    stage.peak_drop = table.quantity("peak_drop", quantity::peak_drop);
    for (std::size_t i = 0; i < history_datasets.size(); ++i) {
        const std::string name(history_datasets[i].name);
        if (name == "time" || name == "step") continue;
        if (const auto value = table.quantity(name, any(name, history_datasets[i].dimension))) {
            stage.until.push_back({"", i, name, *value});
        }
    }
    for (const TomlTable& probe : table.tables()) read_probe_conditions(program, probe, stage);
    table.refuse_others();
}

Stage read_stage(Program& program, TomlTable& table) {
    Stage stage;
    stage.name = table.name();
    stage.platens = read_platen_motion(table);
    if (!program.platens && stage.platens) table.refuse("", "there are no platens to move; add a table [platens]");
    for (BoundaryCondition& condition : program.boundary_conditions) {
        if (auto own = table.table(condition.name)) {
            const Settings settings = read_settings(*own);
            own->refuse_others();
            stage.settings[condition.name] = settings;
        }
    }
    read_until(program, table.needed_table("until", "every stage needs until = { time = \"...\" }, and may have other ends"),
               stage);
    stage.must_end_by = table.text("must_end_by").value_or("");
    const auto is_end = [&](const Condition& c) { return c.name == stage.must_end_by; };
    const bool has_end = stage.must_end_by.empty() || (stage.must_end_by == ended_by_rest && stage.rest) ||
                         (stage.must_end_by == "peak_drop" && stage.peak_drop) ||
                         std::any_of(stage.until.begin(), stage.until.end(), is_end);
    if (!has_end) table.refuse("must_end_by", "is none of the ends in until; one of them other than time fits");
    table.refuse_others();
    return stage;
}

void read_stages(TomlTable& file, Program& program) {
    const auto order = file.texts("stages");
    if (!order || order->empty()) {
        file.refuse("stages", "missing; name the stages in their order, such as stages = [\"load\", \"unload\"]");
    }
    program.order = *order;
    TomlTable stages = file.needed_table("stage", "describe each stage by a table [stage.NAME]");
    for (const std::string& name : program.order) {
        if (!stages.table(name)) file.refuse("stages", fmt::format("there is no table [stage.{}]", name));
    }
    for (TomlTable& table : stages.tables()) {
        if (std::find(order->begin(), order->end(), table.name()) == order->end()) {
            table.refuse("", "is in no place of stages; add it there, or remove it");
        }
        program.stages.push_back(read_stage(program, table));
    }
    stages.refuse_others();
}

/// Which actions of each condition are named anywhere.
void note_actions(Program& program) {
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
                fmt::format("{}: boundary.{}: does nothing; give it a velocity_x, velocity_y, traction_x, traction_y "
                            "or pressure, here or in a stage",
                            program.file, condition.name));
        }
    }
}

void read_initial(TomlTable& file, Program& program) {
    auto initial = file.table("initial");
    if (!initial) return;
    for (TomlTable& table : initial->tables()) {
        const Region region = read_region(table);
        const auto velocity = read_vector(table, "velocity", any("velocity", Dimension::speed));
        if (!velocity) table.refuse("velocity", "missing; two components fit, such as [\"0 m/s\", \"-1 m/s\"]");
        table.refuse_others();
        program.initial_velocities.push_back({region, *velocity});
    }
    initial->refuse_others();
}

void read_platens(TomlTable& file, Program& program) {
    auto table = file.table("platens");
    if (!table) return;
    ProgramPlatens platens;
    platens.bonded = table->flag("bonded").value_or(table->flag("glued").value_or(false));  // `glued` is the former name
    platens.max_strain = table->quantity("max_strain", quantity::max_strain).value_or(platens.max_strain);
    table->refuse_others();
    program.platens = platens;
}

}  // namespace

Program parse_program(const std::string& text, const std::string& name) {
    TomlTable file(parse_toml(text, name));
    Program program;
    program.file = name;
    program.text = text;
    program.name = file.needed_text("name", "a program has a name = \"...\"");
    program.gravity = read_vector(file, "gravity", any("gravity", Dimension::acceleration)).value_or(Vector2{});
    program.damping = file.quantity_or("damping", "none", 0, quantity::damping);
    program.row_interval = file.quantity("row_every", duration);
    program.start_from = file.text("start_from").value_or("");
    read_platens(file, program);
    read_boundary_conditions(file, program);
    read_probes(file, program);
    read_initial(file, program);
    read_stages(file, program);
    file.refuse_others();
    note_actions(program);
    return program;
}

Program read_program(const std::string& file) {
    (void)read_toml(file);  // says why it cannot be read
    std::ifstream stream(file, std::ios::binary);
    return parse_program({std::istreambuf_iterator<char>(stream), {}}, file);
}

}  // namespace graincrack
