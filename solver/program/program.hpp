// A loading program: which velocities and loads are prescribed, stage after stage, and what is measured. All loading of a
// specimen: read from a file, or made in code for a standard test.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "share/file/probe_file.hpp"
#include "share/file/run_file.hpp"
#include "solver/arithmetic/vector2.hpp"
#include "solver/model/amplitude.hpp"

namespace graincrack {

/// The region in which a boundary condition acts: named parts of the boundary, a range of angles, a box, or what is in all of
/// those that are given; or a single node.
struct Region {
    std::vector<std::string> parts;  ///< none: everywhere
    double left = -std::numeric_limits<double>::infinity(), right = std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity(), top = std::numeric_limits<double>::infinity();  ///< m
    /// From the one up to the other, counter-clockwise from x about the origin, rad: the boundary edges with their middles there.
    std::optional<std::array<double, 2>> angles;
    std::optional<std::array<double, 2>> at;  ///< the node nearest to this point, m
    [[nodiscard]] bool has_angle_of(const Vector2& p) const;
    [[nodiscard]] bool has(const Vector2& p) const { return p.x >= left && p.x <= right && p.y >= bottom && p.y <= top; }
};

/// The quantities that a boundary condition may prescribe.
enum class Action : std::uint8_t { velocity_x, velocity_y, traction_x, traction_y, pressure, shear, count };
inline constexpr std::size_t n_actions = static_cast<std::size_t>(Action::count);
constexpr std::string_view name_of(Action action) {
    constexpr std::array<std::string_view, n_actions> names{"velocity_x", "velocity_y", "traction_x",
                                                            "traction_y", "pressure",   "shear"};
    return names[static_cast<std::size_t>(action)];
}
constexpr bool is_velocity(Action action) { return action <= Action::velocity_y; }

/// New functions of a boundary condition, by action; those that are missing stay as they were.
using ActionFunctions = std::array<std::optional<TimeFunction>, n_actions>;

/// [boundary.NAME]: velocities or loads prescribed to a part of the specimen.
struct BoundaryCondition {
    std::string name;
    Region region;
    ActionFunctions start;                 ///< from the start of the program on; what is missing is free, or 0
    std::array<bool, n_actions> is_set{};  ///< anywhere in the program
};

/// [platens.bottom], [platens.top]: the faces of a platen. Rollers and punches are faces of some width at given places.
struct PlatenFaces {
    std::vector<std::string> parts;  ///< of the boundary that they may meet; none: all
    std::vector<double> at;          ///< middle of each across the direction of the platens, m; none: one, infinitely wide
    double width = 0;                ///< of each, m
    [[nodiscard]] bool empty() const { return parts.empty() && at.empty(); }
};

/// [platens]: two rigid platens that approach or part along a direction.
struct ProgramPlatens {
    bool bonded = false;              ///< they pull as well as push, and do not rub
    double max_strain = 0.05;         ///< approach over the height of the specimen that they may reach
    std::optional<double> direction;  ///< from x, rad; missing: along y
    PlatenFaces bottom, top;          ///< what is bottom moves along the direction, what is top against it
    [[nodiscard]] Vector2 axis() const;
    /// Distance of the outermost lower faces if there are two below and one above, as in bending, m; else 0.
    [[nodiscard]] double span() const;
};

/// Relative load increase per wave transit up to which it is quasi-static while there is damage.
/// \see share/doc/loading.md
inline constexpr double default_rate_tolerance = 3e-3;
/// Unbalanced ratio that counts as rest. Between blocks of 1.5e-4 of strain it falls below within some wave transits.
inline constexpr double default_rest_tolerance = 1e-4;

/// Platens that hold a mean axial pressure by a servo, Pa.
struct PressureServo {
    TimeFunction pressure;
};
/// Platens as fast as the measures of the run allow. \see RateControl
struct AutomaticRate {
    bool apart = false;  ///< they pull
    double tolerance = default_rate_tolerance;
    double share = 1;  ///< of all speeds
};
/// Intervals of equal length that a loading block consists of: the platens start in the first and stop in the last.
inline constexpr int parts_of_block = 5;
/// Platens that move for a number of steps and stand until the specimen is at rest, by turns. \see BlockControl
struct LoadingBlocks {
    double speed = 5e-3;  ///< approach of each platen within a block, m/s; below 0: apart
    std::int64_t steps = 5000;
    double rest = default_rest_tolerance;  ///< unbalanced ratio
};
/// How the platens move: a speed of each, approach positive, as a function of time (m/s), or one of the above.
using PlatenMotion = std::variant<TimeFunction, PressureServo, AutomaticRate, LoadingBlocks>;

/// A temperature gone to as fast as the measures of the run allow. \see HeatingControl
struct AutomaticHeating {
    double to = 0;  ///< K
    double tolerance = default_rate_tolerance;
    double share = 1;  ///< of all rates
};

/// [initial.NAME]: velocity at the start.
struct InitialVelocity {
    Region region;
    Vector2 velocity;  ///< m/s
};

/// [probe.NAME]
struct ProbeRequest {
    enum class Form : std::uint8_t { point, circle, ring, gauge };
    std::string name;
    Form form = Form::point;
    Vector2 centre;               ///< or point, or first point of a gauge, m
    Vector2 end;                  ///< second point of a gauge, m
    double radius = 0;            ///< m
    std::int64_t points = 48;     ///< of a ring, at equal angles from x
    std::optional<double> reach;  ///< from a point of a ring to the centres of the elements read there, m; missing: the one there
    [[nodiscard]] double angle(std::int64_t point) const;  ///< of a point of a ring, rad
};

/// A value that ends a stage when it is reached, from whichever side: a column of the history, or of a probe.
struct Condition {
    std::string probe;       ///< "" for the history
    std::size_t column = 0;  ///< of the history or the probe
    std::string name;        ///< as the file spells it
    double value = 0;
};

/// Names of the ends of a stage but for its conditions, in `until`, in `must_end_by` and in the record of stages.
inline constexpr const char* ended_by_time = "time";
inline constexpr const char* ended_by_rest = "rest";
inline constexpr const char* ended_by_peak_drop = "peak_drop";

/// [stage.NAME]
struct Stage {
    std::string name;
    std::optional<PlatenMotion> platens;              ///< missing: they continue as they did
    std::map<std::string, ActionFunctions> settings;  ///< by boundary condition
    std::optional<TimeFunction> temperature;          ///< of all grains, K above that of the state without stress
    std::optional<AutomaticHeating> heating;          ///< finds the rate of `temperature`
    bool without_platens = false;                     ///< the next stage with platens places them in touch with the specimen
    double longest_time =
        std::numeric_limits<double>::infinity();  ///< s; infinite where only the strain limit of the platens ends it
    std::optional<double> rest;       ///< unbalanced ratio, and relative error of a servo's pressure, below which it is at rest
    std::optional<double> peak_drop;  ///< fall below the stage's highest axial stress since contacts have failed, share of it
    std::vector<Condition> until;
    std::string must_end_by;  ///< the only end that is none too early, "" for any
};

struct Program {
    std::string file;  ///< where it was read from, for messages; of a standard test its name
    std::string name;
    std::string text;                ///< the file as it is
    std::vector<std::string> order;  ///< of stages by name; a name may come again
    std::vector<Stage> stages;
    std::vector<BoundaryCondition> boundary_conditions;
    std::optional<ProgramPlatens> platens;
    std::vector<InitialVelocity> initial_velocities;
    std::vector<ProbeRequest> probes;
    Vector2 gravity;                          ///< m/s²
    std::optional<double> damping;            ///< local; --damping wins
    std::optional<double> row_interval;       ///< between rows of the history, s
    std::optional<TimeFunction> temperature;  ///< from the start of the program on
    std::string start_from;                   ///< run file with a saved state, or ""

    [[nodiscard]] const Stage& stage(const std::string& stage_name) const;
    [[nodiscard]] bool has_temperature() const;  ///< whether it is prescribed anywhere
    /// The longest it can take, s; infinite where the strain limit of the platens ends a stage.
    [[nodiscard]] double longest_time() const;
    /// Why mass scaling would falsify it: it prescribes velocities of nodes, makes waves or starts in motion; "" for a
    /// quasi-static program.
    [[nodiscard]] std::string why_dynamic() const;
};

/// The same program at half the speed: all times are twice as long, all frequencies and prescribed velocities half as high.
Program at_half_the_rate(Program program);

/// Columns of a probe: of every boundary condition, of a point, of a circle, of a point of a ring, of a gauge.
const std::vector<ProbeColumn>& boundary_columns();
const std::vector<ProbeColumn>& point_columns();
const std::vector<ProbeColumn>& circle_columns();
const std::vector<ProbeColumn>& ring_columns();
const std::vector<ProbeColumn>& gauge_columns();

}  // namespace graincrack
