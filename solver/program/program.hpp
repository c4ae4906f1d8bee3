// A loading program prescribes velocities and loads stage by stage, and the quantities to be measured. All loading of a specimen
// is a program, read from a file or made in code for a standard test.
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

/// The region on which a boundary condition acts: the intersection of the given named parts of the boundary, range of angles and
/// box; or a single node.
struct Region {
    std::vector<std::string> parts;  ///< empty: everywhere
    double left = -std::numeric_limits<double>::infinity(), right = std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity(), top = std::numeric_limits<double>::infinity();  ///< m
    /// Range of polar angles about the origin, counter-clockwise from x, rad, in which boundary edges have their middles.
    std::optional<std::array<double, 2>> angles;
    std::optional<std::array<double, 2>> at;  ///< the region is the node nearest to this point, m
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

/// New functions of a boundary condition, by action; missing ones do not change.
using ActionFunctions = std::array<std::optional<TimeFunction>, n_actions>;

/// [boundary.NAME]: velocities or loads prescribed to a part of the specimen.
struct BoundaryCondition {
    std::string name;
    Region region;
    ActionFunctions start;                 ///< from the start of the program on; a missing velocity is free, a missing load 0
    std::array<bool, n_actions> is_set{};  ///< true if set anywhere in the program
};

/// [platens.bottom], [platens.top]: the faces of a platen. Rollers and punches are faces of some width at given places.
struct PlatenFaces {
    std::vector<std::string> parts;  ///< parts of the boundary that they may meet; empty: all
    std::vector<double> at;          ///< middles of the faces across the platens' direction, m; empty: one infinite face
    double width = 0;                ///< width of each face, m
    [[nodiscard]] bool empty() const { return parts.empty() && at.empty(); }
};

/// [platens]: two rigid platens that approach or part along a direction.
struct ProgramPlatens {
    bool bonded = false;              ///< they also pull, and have no friction
    double max_strain = 0.05;         ///< largest approach of the platens, over the height of the specimen
    std::optional<double> direction;  ///< angle of the loading direction from x, rad; missing: along y
    PlatenFaces bottom, top;          ///< the bottom moves along the direction, the top against it
    [[nodiscard]] Vector2 axis() const;
    /// Distance of the outermost lower faces if two are below and one above, as in bending, m; otherwise 0.
    [[nodiscard]] double span() const;
};

/// Largest relative load increase per wave transit that counts as quasi-static while there is damage.
/// \see share/doc/loading.md for the measurements
inline constexpr double default_rate_tolerance = 3e-3;
/// Unbalanced ratio that counts as rest, reached some wave transits after a block of 1.5e-4 of strain. Chosen by trial.
inline constexpr double default_rest_tolerance = 1e-4;

/// Platens that hold a mean axial pressure (Pa) by a servo.
struct PressureServo {
    TimeFunction pressure;
};
/// Platens that move as fast as the measures of the run allow. \see RateControl
struct AutomaticRate {
    bool apart = false;  ///< true for tension
    double tolerance = default_rate_tolerance;
    double share = 1;  ///< factor on all speeds
};
/// Number of equal intervals in a loading block: the platens start in the first and stop in the last.
inline constexpr int parts_of_block = 5;
/// Platens that alternately move for a number of steps and stand until the specimen is at rest. \see BlockControl
struct LoadingBlocks {
    double speed = 5e-3;  ///< approach of each platen within a block, m/s; negative: apart
    std::int64_t steps = 5000;
    double rest = default_rest_tolerance;  ///< unbalanced ratio
};
/// Motion of the platens: the speed of each as a function of time (m/s, positive for approach), or one of the above.
using PlatenMotion = std::variant<TimeFunction, PressureServo, AutomaticRate, LoadingBlocks>;

/// A target temperature, reached as fast as the measures of the run allow. \see HeatingControl
struct AutomaticHeating {
    double to = 0;  ///< target, K
    double tolerance = default_rate_tolerance;
    double share = 1;  ///< factor on all rates
};

/// [initial.NAME]: initial velocity of a region.
struct InitialVelocity {
    Region region;
    Vector2 velocity;  ///< m/s
};

/// [probe.NAME]: a measured place.
struct ProbeRequest {
    enum class Form : std::uint8_t { point, circle, ring, gauge };
    std::string name;
    Form form = Form::point;
    Vector2 centre;               ///< centre of a circle or ring, point, or first point of a gauge, m
    Vector2 end;                  ///< second point of a gauge, m
    double radius = 0;            ///< m
    std::int64_t points = 48;     ///< number of points of a ring, at equal angles from x
    std::optional<double> reach;  ///< reach of a point of a ring to the element centres read, m; missing: its element
    [[nodiscard]] double angle(std::int64_t point) const;  ///< angle of a point of a ring, rad
};

/// A value of a column of the history, or of a probe, that ends a stage when it is reached from either side.
struct Condition {
    std::string probe;       ///< "" for the history
    std::size_t column = 0;  ///< column number in the history or the probe
    std::string name;        ///< name as spelt in the file
    double value = 0;
};

/// Names of the ends of a stage other than conditions, in `until`, in `must_end_by` and in the record of stages.
inline constexpr const char* ended_by_time = "time";
inline constexpr const char* ended_by_rest = "rest";
inline constexpr const char* ended_by_peak_drop = "peak_drop";

/// [stage.NAME]: a stage of loading.
struct Stage {
    std::string name;
    std::optional<PlatenMotion> platens;              ///< missing: their motion continues
    std::map<std::string, ActionFunctions> settings;  ///< new functions by boundary condition
    std::optional<TimeFunction> temperature;          ///< temperature of all grains, K above the stress-free state
    std::optional<AutomaticHeating> heating;          ///< controls the rate of `temperature`
    bool without_platens = false;                     ///< true: no platens; the next stage with platens places them in contact
    double longest_time =
        std::numeric_limits<double>::infinity();  ///< s; infinite if only the strain limit of the platens ends the stage
    std::optional<double> rest;       ///< unbalanced ratio and relative error of the servo's pressure that count as rest
    std::optional<double> peak_drop;  ///< fall below the stage's largest axial stress since contacts have failed, as a fraction
    std::vector<Condition> until;
    std::string must_end_by;  ///< the only end that is not premature; "" for any
};

struct Program {
    std::string file;  ///< file name for messages; the name of a standard test
    std::string name;
    std::string text;                ///< content of the file
    std::vector<std::string> order;  ///< names of stages in order; a name may occur repeatedly
    std::vector<Stage> stages;
    std::vector<BoundaryCondition> boundary_conditions;
    std::optional<ProgramPlatens> platens;
    std::vector<InitialVelocity> initial_velocities;
    std::vector<ProbeRequest> probes;
    Vector2 gravity;                          ///< m/s²
    std::optional<double> damping;            ///< local damping; --damping overrides it
    std::optional<double> row_interval;       ///< time between rows of the history, s
    std::optional<TimeFunction> temperature;  ///< initial function of temperature
    std::string start_from;                   ///< run file with a saved state, or ""

    [[nodiscard]] const Stage& stage(const std::string& stage_name) const;
    [[nodiscard]] bool has_temperature() const;  ///< true if it is prescribed anywhere
    /// Longest possible duration, s; infinite if the strain limit of the platens ends a stage.
    [[nodiscard]] double longest_time() const;
    /// Returns why mass scaling would falsify the program: it prescribes velocities of nodes, makes waves or starts in motion. It
    /// returns "" for a quasi-static program.
    [[nodiscard]] std::string why_dynamic() const;
};

/// Returns the program at half the rate: all times are twice as long, all frequencies and prescribed velocities half as high.
Program at_half_the_rate(Program program);

/// Columns of a probe: of every boundary condition, a point, a circle, a point of a ring, a gauge.
const std::vector<ProbeColumn>& boundary_columns();
const std::vector<ProbeColumn>& point_columns();
const std::vector<ProbeColumn>& circle_columns();
const std::vector<ProbeColumn>& ring_columns();
const std::vector<ProbeColumn>& gauge_columns();

}  // namespace graincrack
