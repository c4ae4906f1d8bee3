#include "solver/program/program.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace graincrack {
namespace {

bool waves(const ActionFunctions& settings) {
    return std::any_of(settings.begin(), settings.end(), [](const auto& f) { return f && f->is_wave(); });
}

/// Slows a function down to half its rate. \param of_velocity true if its values are velocities
void slow_down(TimeFunction& f, bool of_velocity) {
    f.duration *= 2;
    f.frequency /= 2;
    f.rate /= 2;
    f.peak_time *= 2;
    for (double& time : f.times) time *= 2;
    if (of_velocity) {
        f.value /= 2;
        for (double& value : f.values) value /= 2;
    }
}

void slow_down(ActionFunctions& settings) {
    for (std::size_t i = 0; i < n_actions; ++i) {
        if (settings[i]) slow_down(*settings[i], is_velocity(static_cast<Action>(i)));
    }
}

struct SlowDown {
    void operator()(TimeFunction& speed) const { slow_down(speed, true); }
    void operator()(PressureServo& servo) const { slow_down(servo.pressure, false); }
    void operator()(AutomaticRate& rate) const { rate.share /= 2; }
    void operator()(LoadingBlocks& blocks) const {
        blocks.speed /= 2;
        blocks.rest /= 2;
    }
};

}  // namespace

bool Region::has_angle_of(const Vector2& p) const {
    if (!angles) return true;
    constexpr double turn = 2 * std::numbers::pi;
    constexpr double slack = 1e-9;  // rad; an angle this near to the start of the next range belongs to that
    const double beyond = std::atan2(p.y, p.x) - angles->front() + slack;
    return beyond - turn * std::floor(beyond / turn) < angles->back() - angles->front();
}

Vector2 ProgramPlatens::axis() const {
    if (!direction) return {0, 1};
    constexpr double least = 1e-15;  // smaller components are round-off
    const Vector2 axis{std::cos(*direction), std::sin(*direction)};
    return {std::abs(axis.x) < least ? 0 : axis.x, std::abs(axis.y) < least ? 0 : axis.y};
}

double ProgramPlatens::span() const {
    if (bottom.at.size() != 2 || top.at.size() != 1) return 0;
    return std::abs(bottom.at[1] - bottom.at[0]);
}

double ProbeRequest::angle(std::int64_t point) const {
    return 2 * std::numbers::pi * static_cast<double>(point) / static_cast<double>(points);
}

const Stage& Program::stage(const std::string& stage_name) const {
    return *std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.name == stage_name; });
}

bool Program::has_temperature() const {
    return temperature || std::any_of(stages.begin(), stages.end(), [](const Stage& s) { return s.temperature.has_value(); });
}

double Program::longest_time() const {
    double sum = 0;
    for (const std::string& stage_name : order) sum += stage(stage_name).longest_time;
    return sum;
}

std::string Program::why_dynamic() const {
    if (!initial_velocities.empty()) return "it starts in motion";
    if (temperature && temperature->is_wave()) return "its temperature makes waves";
    for (const Stage& s : stages) {
        if (s.temperature && s.temperature->is_wave()) return "the temperature of stage." + s.name + " makes waves";
    }
    for (const BoundaryCondition& condition : boundary_conditions) {
        if (condition.is_set[0] || condition.is_set[1]) return "boundary." + condition.name + " drives nodes";
        if (waves(condition.start)) return "boundary." + condition.name + " makes waves";
        for (const Stage& s : stages) {
            const auto found = s.settings.find(condition.name);
            if (found != s.settings.end() && waves(found->second)) {
                return "stage." + s.name + "." + condition.name + " makes waves";
            }
        }
    }
    return "";
}

Program at_half_the_rate(Program program) {
    for (BoundaryCondition& condition : program.boundary_conditions) slow_down(condition.start);
    for (Stage& stage : program.stages) {
        stage.longest_time *= 2;
        for (auto& [condition, settings] : stage.settings) slow_down(settings);
        if (stage.temperature) slow_down(*stage.temperature, false);
        if (stage.heating) stage.heating->share /= 2;
        if (stage.platens) std::visit(SlowDown{}, *stage.platens);
    }
    if (program.temperature) slow_down(*program.temperature, false);
    if (program.row_interval) *program.row_interval *= 2;
    return program;
}

const std::vector<ProbeColumn>& boundary_columns() {
    static const std::vector<ProbeColumn> columns{
        {"displacement_x", Dimension::length, "mean displacement along x of its nodes"},
        {"displacement_y", Dimension::length, "mean displacement along y of its nodes"},
        {"force_x", Dimension::force, "force on the specimen along x per metre of thickness, reaction without inertia and loads"},
        {"force_y", Dimension::force, "force on the specimen along y per metre of thickness, reaction without inertia and loads"},
    };
    return columns;
}

const std::vector<ProbeColumn>& point_columns() {
    static const std::vector<ProbeColumn> columns{
        {"displacement_x", Dimension::length, "displacement along x"},
        {"displacement_y", Dimension::length, "displacement along y"},
        {"velocity_x", Dimension::speed, "velocity along x, half a step before"},
        {"velocity_y", Dimension::speed, "velocity along y, half a step before"},
    };
    return columns;
}

const std::vector<ProbeColumn>& circle_columns() {
    static const std::vector<ProbeColumn> columns{
        {"stress_xx", Dimension::stress, "mean stress xx of the elements with their centre in the circle, tension positive"},
        {"stress_yy", Dimension::stress, "mean stress yy of the elements with their centre in the circle, tension positive"},
        {"stress_xy", Dimension::stress, "mean stress xy of the elements with their centre in the circle"},
        {"stress_zz", Dimension::stress, "mean stress zz of the elements with their centre in the circle, tension positive"},
    };
    return columns;
}

const std::vector<ProbeColumn>& ring_columns() {
    static const std::vector<ProbeColumn> columns = [] {
        std::vector<ProbeColumn> of_point{
            {"angle", Dimension::angle, "of the point of the ring, counter-clockwise from x"},
            {"strain_xx", Dimension::one, "mean strain xx of the elements there, elongation positive"},
            {"strain_yy", Dimension::one, "mean strain yy of the elements there, elongation positive"},
            {"strain_xy", Dimension::one, "mean strain xy of the elements there, half the change of the angle"},
            {"volumetric_strain", Dimension::one, "strain xx + yy of the elements there (of the area, in plane stress)"},
        };
        for (ProbeColumn stress : circle_columns()) {
            stress.description =
                "mean stress " + stress.name.substr(stress.name.size() - 2) + " of the elements there, tension positive";
            of_point.push_back(stress);
        }
        return of_point;
    }();
    return columns;
}

const std::vector<ProbeColumn>& gauge_columns() {
    static const std::vector<ProbeColumn> columns{
        {"elongation", Dimension::length, "change of the distance of its two points, positive when they move apart"}};
    return columns;
}

}  // namespace graincrack
