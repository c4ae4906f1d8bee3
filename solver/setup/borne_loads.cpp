#include "solver/setup/borne_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "share/base/error.hpp"
#include "solver/setup/regions.hpp"
#include "solver/step/prescribed.hpp"

namespace graincrack {
namespace {

/// Force components along x and y, N/m, and the moment about the origin over the size of the specimen, N/m.
using Resultant = std::array<double, 3>;
Resultant resultant_of(const Vector2& force, const Vector2& at, double size) {
    return {force.x, force.y, (at.x * force.y - at.y * force.x) / size};
}
double product(const Resultant& a, const Resultant& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void add_multiple(Resultant& sum, double factor, const Resultant& other) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] += factor * other[i];
}
double magnitude(const Resultant& r) { return std::sqrt(product(r, r)); }

/// The value of a function after its end.
double value_after(const TimeFunction& f, double before) {
    if (f.kind == TimeFunction::Kind::table) return f.values.back();
    return f.kind == TimeFunction::Kind::constant || f.kind == TimeFunction::Kind::ramp ? f.value : before;
}

/// Orthonormal basis of the resultants that prescribed nodes can bear.
std::vector<Resultant> borne_by(const PrescribedConditions& prescribed, const std::vector<double>& values, const Assemblage& a,
                                double size) {
    constexpr double least_part = 1e-6;  // smallest independent part of a unit resultant
    std::vector<Resultant> borne;
    for (const PrescribedNode& node : prescribed.nodes) {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            if (node.amplitude[axis] == no_amplitude || std::isnan(values[node.amplitude[axis]])) continue;
            const Vector2 direction = axis == 0 ? Vector2{1, 0} : Vector2{0, 1};
            Resultant further = resultant_of(direction, a.position[node.node], size);
            for (const Resultant& other : borne) add_multiple(further, -product(further, other), other);
            const double rest = magnitude(further);
            if (rest < least_part) continue;
            for (double& component : further) component /= rest;
            borne.push_back(further);
        }
    }
    return borne;
}

void require_borne(const Assemblage& a, const PrescribedConditions& prescribed, const std::vector<double>& values,
                   const std::string& where) {
    if (prescribed.edges.empty()) return;
    StepLoading loading;
    loading.amplitudes = values;
    double size = 0;
    for (const LoadedEdge& edge : prescribed.edges) size = std::max(size, length(a.position[edge.nodes[0]]));
    Resultant sum{};
    double magnitudes = 0;
    for (const LoadedEdge& edge : prescribed.edges) {
        const Vector2& from = a.position[edge.nodes[0]];
        const Vector2& to = a.position[edge.nodes[1]];
        const Vector2 load = 2 * load_of_edge(edge, to - from, loading).on_end;
        add_multiple(sum, 1, resultant_of(load, 0.5 * (from + to), size));
        magnitudes += length(load);
    }
    for (const Resultant& borne : borne_by(prescribed, values, a, size)) add_multiple(sum, -product(sum, borne), borne);
    if (magnitude(sum) <= tolerated_resultant * magnitudes) return;
    const auto shown = [&](double value) { return std::abs(value) > 1e-9 * magnitudes ? value : 0; };
    throw InputError(fmt::format(
        "{}: nothing bears a force of {:.3g} N/m along x and {:.3g} N/m along y and a moment of {:.3g} N of its loads, more than "
        "{} % of their sum; balance them, or hold nodes, such as [boundary.foot] at = [x, y], velocity_x = 0, velocity_y = 0",
        where, shown(sum[0]), shown(sum[1]), size * shown(sum[2]), 100 * tolerated_resultant));
}

}  // namespace

void require_borne_loads(const Assemblage& a, const PrescribedConditions& prescribed, const Program& program) {
    const AmplitudeNumbers numbers = number_amplitudes(program);
    std::vector<double> values;
    const auto set = [&](std::size_t condition, const ActionFunctions& functions) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            if (!functions[i]) continue;
            double& value = values[numbers[condition][i]];
            value = value_after(*functions[i], value);
        }
    };
    for (const auto& of_condition : numbers) {
        for (std::size_t i = 0; i < n_actions; ++i) {
            if (of_condition[i] != no_amplitude) values.push_back(is_velocity(static_cast<Action>(i)) ? NAN : 0);
        }
    }
    for (std::size_t c = 0; c < numbers.size(); ++c) set(c, program.boundary_conditions[c].start);
    for (const std::string& name : program.order) {
        const Stage& stage = program.stage(name);
        for (std::size_t c = 0; c < numbers.size(); ++c) {
            const auto settings = stage.settings.find(program.boundary_conditions[c].name);
            if (settings != stage.settings.end()) set(c, settings->second);
        }
        if (program.platens && !stage.without_platens) continue;
        require_borne(a, prescribed, values, fmt::format("{}: stage.{}", program.file, name));
    }
}

}  // namespace graincrack
