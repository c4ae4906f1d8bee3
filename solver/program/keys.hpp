// The keys of a program's tables and their values, one row each. Programs are read (program_file) and written (program_text) by
// these rows. `Keys` is a table that is read (`TomlTable`) or written (`TomlEntries`).
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "share/base/quantities.hpp"
#include "solver/program/program.hpp"

namespace graincrack::program_keys {

/// The value into which keys are read, or from which they are written.
template <class Keys, class Value>
using Content = std::conditional_t<Keys::reads, Value, const Value>;

constexpr Quantity any(std::string_view name, Dimension dimension) {
    return {name, dimension, -quantity::unbounded, quantity::unbounded, name};
}
constexpr Quantity positive(std::string_view name, Dimension dimension) {
    return {name, dimension, 0, quantity::unbounded, name, true};
}
inline constexpr Quantity coordinate = any("coordinate", Dimension::length);
inline constexpr Quantity duration = positive("duration", Dimension::time);

inline constexpr const char* platen_speed = "platen_speed";
inline constexpr const char* platen_pressure = "platen_pressure";
inline constexpr const char* temperature = "temperature";
inline constexpr const char* presence_of_platens = "platens";
inline constexpr const char* until = "until";
inline constexpr const char* must_end_by = "must_end_by";
inline constexpr Quantity speed_of_platens = any(platen_speed, Dimension::speed);
inline constexpr Quantity pressure_of_platens = any(platen_pressure, Dimension::stress);
/// Keys that identify the tables of platen motions and of the kinds of functions of time.
inline constexpr const char* automatic = "auto";
inline constexpr const char* blocks = "blocks";
inline constexpr std::array<std::pair<const char*, TimeFunction::Kind>, 5> kinds{{{"times", TimeFunction::Kind::table},
                                                                                  {"to", TimeFunction::Kind::ramp},
                                                                                  {"sine", TimeFunction::Kind::sine},
                                                                                  {"ricker", TimeFunction::Kind::ricker},
                                                                                  {"pulse", TimeFunction::Kind::pulse}}};

/// Visits a function of time as a table of its kind. \param quantity of its values
template <class Keys>
void visit(Keys& keys, Content<Keys, TimeFunction>& f, const Quantity& quantity) {
    constexpr double quiet_start = 1.5;  // periods of a wavelet before its peak; it starts at 1e-8 of the peak
    constexpr Quantity frequency = positive("frequency", Dimension::frequency);
    switch (f.kind) {
        case TimeFunction::Kind::table:
            keys.given("times", any("times", Dimension::time), f.times);
            keys.given("values", quantity, f.values);
            break;
        case TimeFunction::Kind::ramp:
            keys.given("to", quantity, f.value);
            keys.needed("over", duration, f.duration, "a ramp needs its duration, such as over = \"1 ms\"");
            break;
        case TimeFunction::Kind::rate:
            keys.given("to", quantity, f.value);
            keys.needed("rate", positive("rate", Dimension::heating_rate), f.rate, "a ramp needs its rate, such as \"1e4 K/s\"");
            break;
        case TimeFunction::Kind::sine: {
            keys.given("sine", quantity, f.value);
            keys.needed("frequency", frequency, f.frequency, "a sine needs its frequency, such as \"10 kHz\"");
            keys.given("phase", any("phase", Dimension::angle), f.phase);
            auto cycles = f.duration > 0 ? std::optional(f.duration * f.frequency) : std::nullopt;
            keys.given("cycles", positive("cycles", Dimension::one), cycles);
            if constexpr (Keys::reads) f.duration = cycles.value_or(0) / f.frequency;
            break;
        }
        case TimeFunction::Kind::ricker:
            keys.given("ricker", quantity, f.value);
            keys.needed("frequency", frequency, f.frequency, "a wavelet needs its frequency, such as \"10 kHz\"");
            if constexpr (Keys::reads) f.peak_time = quiet_start / f.frequency;
            keys.given("at", duration, f.peak_time);
            break;
        case TimeFunction::Kind::pulse:
            keys.given("pulse", quantity, f.value);
            keys.needed("over", duration, f.duration, "a pulse needs its duration, such as over = \"10 us\"");
            break;
        default: break;  // constants and "keep" are not tables
    }
}

/// Calls `act(name, quantity, function, may be free)` with each action of a boundary condition.
template <class AnySettings, class Act>
void visit_settings(AnySettings& settings, Act&& act) {
    for (std::size_t i = 0; i < n_actions; ++i) {
        const auto action = static_cast<Action>(i);
        const Quantity quantity = any(name_of(action), is_velocity(action) ? Dimension::speed : Dimension::stress);
        act(std::string(name_of(action)), quantity, settings[i], is_velocity(action));
    }
}

template <class Keys>
void visit(Keys& keys, Content<Keys, AutomaticRate>& rate) {
    keys.choice(automatic, rate.apart, "together", "apart");
    keys.given("tolerance", quantity::rate_tolerance, rate.tolerance);
    keys.given("share", quantity::rate_share, rate.share);
}

template <class Keys>
void visit(Keys& keys, Content<Keys, AutomaticHeating>& heating) {
    std::string word = automatic;
    keys.needed("to", quantity::temperature, heating.to, "give the temperature to go to, such as to = \"300 K\"");
    keys.given("rate", word);
    keys.given("tolerance", quantity::rate_tolerance, heating.tolerance);
    keys.given("share", quantity::rate_share, heating.share);
}

template <class Keys>
void visit(Keys& keys, Content<Keys, LoadingBlocks>& motion) {
    keys.given(blocks, any(blocks, Dimension::speed), motion.speed);
    keys.given("steps", {"steps", Dimension::one, parts_of_block, 1e9, "steps"}, motion.steps);
    keys.given("rest", quantity::rate_tolerance, motion.rest);
}

template <class Keys>
void visit(Keys& keys, Content<Keys, Region>& region) {
    keys.given("on", region.parts);
    std::optional<std::array<double, 4>> box;
    if (std::isfinite(region.left)) box = {region.left, region.right, region.bottom, region.top};
    constexpr const char* fits = "is no box; [left, right, bottom, top] with left <= right and bottom <= top fits";
    constexpr const char* range = "is no range; [from, to], up to 360 degrees more, fits";
    keys.given("box", coordinate, box, fits);
    keys.given("angles", any("angles", Dimension::angle), region.angles, range);
    keys.given("at", coordinate, region.at, "is no point; [x, y] fits");
    if constexpr (Keys::reads) {
        if (box) {
            region.left = (*box)[0];
            region.right = (*box)[1];
            region.bottom = (*box)[2];
            region.top = (*box)[3];
        }
        if (region.left > region.right || region.bottom > region.top) keys.refuse("box", fits);
        const double width = region.angles ? region.angles->back() - region.angles->front() : 1;
        constexpr double round_off = 1e-12;
        if (!(width > 0 && width <= 2 * std::numbers::pi + round_off)) keys.refuse("angles", range);
        if (region.at && (box || region.angles || !region.parts.empty())) {
            keys.refuse("at", "is one node already; leave out on, box and angles");
        }
    }
}

/// Visits a vector of two components. \param missing the message if it is missing; null: the vector is then 0
template <class Keys>
void visit_vector(Keys& keys, const char* key, const Quantity& quantity, Content<Keys, Vector2>& vector,
                  const char* missing = nullptr) {
    std::optional<std::array<double, 2>> components;
    if (!Keys::reads && (missing != nullptr || vector.x != 0 || vector.y != 0)) components = {vector.x, vector.y};
    keys.given(key, quantity, components, "has not two components; two, x and y, fit");
    if constexpr (Keys::reads) {
        if (components) vector = {(*components)[0], (*components)[1]};
        if (!components && missing != nullptr) keys.refuse(key, missing);
    }
}

template <class Keys>
void visit(Keys& keys, Content<Keys, ProbeRequest>& probe) {
    using Form = ProbeRequest::Form;
    std::optional<std::array<double, 2>> point;
    std::optional<std::array<double, 3>> circle, ring;
    std::optional<std::array<double, 4>> gauge;
    if constexpr (!Keys::reads) {
        if (probe.form == Form::point) point = {probe.centre.x, probe.centre.y};
        if (probe.form == Form::circle) circle = {probe.centre.x, probe.centre.y, probe.radius};
        if (probe.form == Form::ring) ring = {probe.centre.x, probe.centre.y, probe.radius};
        if (probe.form == Form::gauge) gauge = {probe.centre.x, probe.centre.y, probe.end.x, probe.end.y};
    }
    constexpr const char* fits = "is no circle; [x, y, radius] with a radius above 0 fits";
    constexpr const char* fits_gauge = "is no gauge; [x1, y1, x2, y2] of two points apart fits";
    keys.given("point", coordinate, point, "is no point; [x, y] fits");
    keys.given("circle", coordinate, circle, fits);
    keys.given("ring", coordinate, ring, fits);
    keys.given("gauge", coordinate, gauge, fits_gauge);
    if (ring) {
        keys.given("points", {"points", Dimension::one, 1, 1000, "points"}, probe.points);
        keys.given("reach", positive("reach", Dimension::length), probe.reach);
    }
    if constexpr (Keys::reads) {
        if (point.has_value() + circle.has_value() + ring.has_value() + gauge.has_value() != 1) {
            keys.refuse(
                "", "needs one of point = [x, y], circle = [x, y, radius], ring = [x, y, radius] and gauge = [x1, y1, x2, y2]");
        }
        probe.form = gauge ? Form::gauge : ring ? Form::ring : circle ? Form::circle : Form::point;
        if (gauge) {
            point = {(*gauge)[0], (*gauge)[1]};
            probe.end = {(*gauge)[2], (*gauge)[3]};
            if ((*point)[0] == probe.end.x && (*point)[1] == probe.end.y) keys.refuse("gauge", fits_gauge);
        }
        if (ring) circle = ring;
        if (circle && (*circle)[2] <= 0) keys.refuse(ring ? "ring" : "circle", fits);
        probe.centre = circle ? Vector2{(*circle)[0], (*circle)[1]} : Vector2{(*point)[0], (*point)[1]};
        probe.radius = circle ? (*circle)[2] : 0;
    }
}

template <class Keys>
void visit(Keys& keys, Content<Keys, InitialVelocity>& initial) {
    visit(keys, initial.region);
    visit_vector(keys, "velocity", any("velocity", Dimension::speed), initial.velocity,
                 "missing; two components fit, such as [\"0 m/s\", \"-1 m/s\"]");
}

template <class Keys>
void visit(Keys& keys, Content<Keys, ProgramPlatens>& platens) {
    keys.given("bonded", platens.bonded);
    keys.given("max_strain", quantity::max_strain, platens.max_strain);
    keys.given("direction", {"direction", Dimension::angle, 0, std::numbers::pi, "direction"}, platens.direction);
}

template <class Keys>
void visit(Keys& keys, Content<Keys, PlatenFaces>& faces) {
    keys.given("on", faces.parts);
    keys.given("at", coordinate, faces.at);
    if (!faces.at.empty()) {
        keys.needed("width", positive("width", Dimension::length), faces.width,
                    "faces at given places need it, such as \"5 mm\"");
    }
}

/// Visits the ends of a stage apart from the values of columns that end it (`Stage::until`).
template <class Keys>
void visit_until(Keys& keys, Content<Keys, Stage>& stage) {
    auto longest = std::isfinite(stage.longest_time) ? std::optional(stage.longest_time) : std::nullopt;
    keys.given(ended_by_time, duration, longest);
    if constexpr (Keys::reads) stage.longest_time = longest.value_or(quantity::unbounded);
    keys.given(ended_by_rest, {ended_by_rest, Dimension::one, 0, 1, ended_by_rest, true}, stage.rest);
    keys.given(ended_by_peak_drop, quantity::peak_drop, stage.peak_drop);
}

/// Visits the top-level keys.
template <class Keys>
void visit(Keys& keys, Content<Keys, Program>& program) {
    keys.needed("name", program.name, "a program has a name = \"...\"");
    keys.needed("stages", program.order, "name the stages in their order, such as stages = [\"load\", \"unload\"]");
    keys.given("damping", quantity::damping, program.damping, "none");
    visit_vector(keys, "gravity", any("gravity", Dimension::acceleration), program.gravity);
    keys.given("row_every", duration, program.row_interval);
    keys.given("start_from", program.start_from);
}

}  // namespace graincrack::program_keys
