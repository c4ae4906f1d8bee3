// Boundary conditions of a step as data: rigid platens with Coulomb friction, and what else is prescribed. Nothing here knows
// which test is running.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "solver/model/amplitude.hpp"
#include "solver/model/assemblage.hpp"
#include "solver/model/prescribed.hpp"

namespace graincrack {

inline constexpr std::size_t bottom_platen = 0;
inline constexpr std::size_t top_platen = 1;

/// Across the axis of a platen: towards +x, or towards +y where the axis is that of x.
constexpr Vector2 across(const Vector2& axis) { return axis.y > 0 ? Vector2{axis.y, -axis.x} : Vector2{-axis.y, axis.x}; }

/// The flat face of a rigid platen. Rollers and punches are platens of finite width, several of which may move together.
struct Platen {
    std::size_t motion = top_platen;  ///< the one of the two motions that it follows: `bottom_platen` or `top_platen`
    Vector2 axis{0, 1};               ///< unit vector along which it moves; the same for all platens of a boundary
    double side = 1;                  ///< +1: the specimen lies towards −axis (top), −1: towards +axis (bottom)
    double position = 0;              ///< of its face along the axis at the start, m
    /// Extent of the face across the axis, m; what lies outside at the start does not meet it.
    double left = -std::numeric_limits<double>::infinity(), right = std::numeric_limits<double>::infinity();
    std::vector<std::uint8_t> parts = {};  ///< of the boundary that it may meet; none: all, and what is inside
    double normal_stiffness = 0;           ///< penalty, Pa/m
    double shear_stiffness = 0;            ///< Pa/m; 0 for a smooth platen
    double tan_friction = 0;
    bool bonded = false;  ///< pulls as well as pushes
};
/// A node that may meet a platen, and its friction spring.
struct PlatenPoint {
    std::int32_t node = 0;
    std::int32_t platen = 0;
    double tributary = 0;      ///< length of platen it stands for, m
    double gap = 0;            ///< penetration at the start (≤ 0: apart), m; −∞ where its platen is absent
    double anchor = 0;         ///< displacement across the axis from which the friction spring is stretched, m
    double shear = 0;          ///< of the friction spring at the last update, N
    bool on_boundary = false;  ///< its node ends a boundary edge, or meets the platen at the start
    [[nodiscard]] bool is_absent() const { return gap == -std::numeric_limits<double>::infinity(); }
};

/// The response of a platen to a point.
struct PlatenResponse {
    Vector2 force;        ///< on the node, N
    double anchor = 0;    ///< new
    double shear = 0;     ///< new
    double friction = 0;  ///< dissipated since the last update, J
    double stored = 0;    ///< in the penalty springs, J
};
/// How far a point is inside a platen, m; below 0: apart.
/// \param u displacement of the node, m
/// \param platen_displacement of the platen along its axis, m
inline double platen_penetration(const Platen& platen, const PlatenPoint& point, const Vector2& u, double platen_displacement) {
    return point.gap + platen.side * (dot(platen.axis, u) - platen_displacement);
}
inline PlatenResponse platen_response(const Platen& platen, const PlatenPoint& point, const Vector2& u,
                                      double platen_displacement) {
    const double penetration = platen_penetration(platen, point, u, platen_displacement);
    const Vector2 tangent = across(platen.axis);
    const double along = dot(tangent, u);
    if (penetration <= 0 && (!platen.bonded || point.is_absent())) return {{}, along, 0, 0, 0};
    const double kn = platen.normal_stiffness * point.tributary;
    const double ks = platen.shear_stiffness * point.tributary;
    const double pressure = kn * penetration;
    PlatenResponse r{-platen.side * pressure * platen.axis, along, 0, 0, 0.5 * kn * penetration * penetration};
    if (ks > 0 && pressure > 0) {
        const double trial = ks * (along - point.anchor);
        const double limit = pressure * platen.tan_friction;
        r.shear = std::clamp(trial, -limit, limit);
        r.force += -r.shear * tangent;
        r.stored += 0.5 * r.shear * r.shear / ks;
        if (r.shear == trial) {
            r.anchor = point.anchor;
        } else {
            r.anchor = along - r.shear / ks;
            r.friction = 0.5 * (point.shear + r.shear) * (r.anchor - point.anchor);
        }
    }
    return r;
}

/// Boundary data of a run, sorted by node; ranges by chunk of nodes.
struct Boundary {
    std::vector<Platen> platens;
    std::vector<PlatenPoint> platen_points;
    std::vector<Range> platen_points_of_chunk;
    PrescribedConditions prescribed;
};

/// Motion of the platens and values of the amplitudes over one step.
struct StepLoading {
    Vector2 platen_axis{0, 1};                    ///< of the boundary's platens
    std::array<double, 2> platen_displacement{};  ///< of the two motions along it, now, m
    std::array<double, 2> increment_before{};     ///< of the step that led here, m
    std::array<double, 2> increment_after{};      ///< of the step that leads on, m
    std::vector<double> amplitudes;               ///< velocities of the step that leads on, loads now
    double temperature = 0;                       ///< now, K above that of the state without stress
};

/// Loading over an interval of steps: the speeds change linearly from its first step to its last.
struct IntervalLoading {
    std::array<double, 2> velocity_begin{};  ///< of the platens along their axis, m/s
    std::array<double, 2> velocity_end{};
    const std::vector<Amplitude>* amplitudes = nullptr;  ///< of the prescribed conditions, if there are any
    std::int32_t temperature = no_amplitude;             ///< that of the temperature; none: it stays as it is
};

/// Platens with the nodes that may meet them (within `reach` of the face); nothing else is prescribed.
Boundary make_boundary(const Assemblage& assemblage, const Specimen& specimen, const std::vector<Platen>& platens, double reach);

}  // namespace graincrack
