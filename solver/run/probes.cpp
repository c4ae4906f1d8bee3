#include "solver/run/probes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "share/base/error.hpp"
#include "solver/setup/regions.hpp"

namespace graincrack {
namespace {

double cross(const Vector2& a, const Vector2& b) { return a.x * b.y - a.y * b.x; }

/// Shares of the corners of a triangle at a point of it.
std::array<double, 3> weights_at(const Assemblage& a, std::int32_t element, const Vector2& p) {
    const auto [n0, n1, n2] = a.element_nodes[element];
    const Vector2 e1 = a.position[n1] - a.position[n0];
    const Vector2 e2 = a.position[n2] - a.position[n0];
    const Vector2 d = p - a.position[n0];
    const double area = cross(e1, e2);
    const double w1 = cross(d, e2) / area;
    const double w2 = cross(e1, d) / area;
    return {1 - w1 - w2, w1, w2};
}

Vector2 centre_of(const Assemblage& a, std::int32_t element) {
    const auto [n0, n1, n2] = a.element_nodes[element];
    return (1.0 / 3) * (a.position[n0] + a.position[n1] + a.position[n2]);
}

/// Σ `of_item(index)` over ascending indices of nodes or elements, by the chunk they belong to.
/// \param range_of (chunk): the indices of a chunk
template <class RangeOf, class OfItem>
auto sum_over_listed(const Part& part, const ChunkShare& chunks, const RangeOf& range_of,
                     const std::vector<std::int32_t>& indices, const OfItem& of_item) {
    return sum_over_chunks(part, chunks, [&](std::int32_t chunk) {
        const Range range = range_of(chunk);
        decltype(of_item(0)) sum{};
        for (auto at = std::lower_bound(indices.begin(), indices.end(), range.begin); at != indices.end() && *at < range.end;
             ++at) {
            sum += of_item(*at);
        }
        return sum;
    });
}

/// |way + change| − |way|, without the loss of digits of a difference.
double elongation(const Vector2& way, const Vector2& change) {
    return dot(change, 2.0 * way + change) / (length(way + change) + length(way));
}

Vector2 mean_displacement(const Assemblage& a, const std::vector<std::int32_t>& nodes, const State& s) {
    const auto nodes_of = [&a](std::int32_t chunk) { return a.node_chunks[chunk].nodes; };
    return (1 / static_cast<double>(nodes.size())) *
           sum_over_listed(a.part, a.part.nodes, nodes_of, nodes, [&](std::int32_t i) { return s.displacement[i]; });
}

Vector2 force_of_control(const Assemblage& a, std::int32_t condition, const PrescribedConditions& prescribed, const State& s) {
    const Vector2 on_nodes = sum_by_nodes(a, prescribed.nodes_of_chunk, [&](std::int32_t i) {
        const PrescribedState::Node& node = s.prescribed.nodes[i];
        return Vector2{prescribed.nodes[i].condition[0] == condition ? node.reaction.x : 0,
                       prescribed.nodes[i].condition[1] == condition ? node.reaction.y : 0};
    });
    return on_nodes + sum_by_nodes(a, prescribed.edges_of_chunk, [&](std::int32_t i) {
               return prescribed.edges[i].condition == condition ? 2.0 * s.prescribed.load[i] : Vector2{};
           });
}

/// Integral of the stress of elements (xx yy xy zz) and their area.
struct StressSum {
    std::array<double, 4> stress{};
    double area = 0;
    using IsSum = void;
};
std::vector<double> mean_stress(const Assemblage& a, const std::vector<std::int32_t>& elements, const State& s) {
    const auto elements_of = [&a](std::int32_t chunk) { return a.element_chunks[chunk]; };
    const StressSum sum = sum_over_listed(a.part, a.part.elements, elements_of, elements, [&](std::int32_t e) {
        StressSum of_element{element_stress(a, static_cast<std::size_t>(e), s), a.element_geometry[e].area};
        for (double& component : of_element.stress) component *= of_element.area;
        return of_element;
    });
    std::vector<double> mean(sum.stress.begin(), sum.stress.end());
    for (double& component : mean) component /= sum.area;
    return mean;
}

/// Integral of strain (xx yy xy) over elements and their area.
struct StrainSum {
    std::array<double, 3> strain{};
    double area = 0;
    using IsSum = void;
};
std::vector<double> mean_strain(const Assemblage& a, const std::vector<std::int32_t>& elements, const State& s) {
    const auto elements_of = [&a](std::int32_t chunk) { return a.element_chunks[chunk]; };
    const StrainSum sum = sum_over_listed(a.part, a.part.elements, elements_of, elements, [&](std::int32_t e) {
        const double area = a.element_geometry[e].area;
        const TriangleState state = cold_element_state(a, static_cast<std::size_t>(e), s);
        return StrainSum{{area * state.exx, area * state.eyy, area * state.exy}, area};
    });
    return {sum.strain[0] / sum.area, sum.strain[1] / sum.area, sum.strain[2] / sum.area};
}

/// The element at a point, where corners of several meet the first; −1 outside of the specimen.
std::int32_t element_at(const Assemblage& a, const Vector2& point) {
    std::int32_t best = -1;
    double inside = -1e-9;  // round-off
    for (std::int32_t e = 0; e < a.n_elements(); ++e) {
        const auto w = weights_at(a, e, point);
        const double least = *std::min_element(w.begin(), w.end());
        if (least > inside) {
            inside = least;
            best = e;
        }
    }
    return best;
}

/// The elements with their centres within a distance from a point.
std::vector<std::int32_t> elements_near(const Assemblage& a, const Vector2& point, double distance) {
    std::vector<std::int32_t> elements;
    for (std::int32_t e = 0; e < a.n_elements(); ++e) {
        if (length(centre_of(a, e) - point) <= distance) elements.push_back(e);
    }
    return elements;
}

ProbeHistory empty_history(const std::string& name, const std::vector<ProbeColumn>& columns) {
    return {name, columns, std::vector<std::vector<double>>(columns.size())};
}

}  // namespace

Probes::Probes(const Program& program, const Assemblage& a, const Specimen& s) {
    for (const BoundaryCondition& condition : program.boundary_conditions) {
        nodes_of_boundary_.push_back(
            content_of_region(condition.region, a, s, program.file + ": boundary." + condition.name).nodes);
        histories_.push_back(empty_history(condition.name, boundary_columns()));
    }
    for (const ProbeRequest& request : program.probes) {
        const std::string where = program.file + ": probe." + request.name;
        if (request.form == ProbeRequest::Form::ring) {
            add_ring(request, a, where);
        } else if (request.form == ProbeRequest::Form::circle) {
            requests_.emplace_back(Circle{elements_near(a, request.centre, request.radius)});
            if (std::get<Circle>(requests_.back()).empty()) {
                throw InputError(where + ": no element has its centre in this circle; a larger one, or one inside, fits");
            }
            histories_.push_back(empty_history(request.name, circle_columns()));
        } else if (request.form == ProbeRequest::Form::gauge) {
            requests_.emplace_back(
                Gauge{{point_at(a, request.centre, where), point_at(a, request.end, where)}, request.end - request.centre});
            histories_.push_back(empty_history(request.name, gauge_columns()));
        } else {
            requests_.emplace_back(point_at(a, request.centre, where));
            histories_.push_back(empty_history(request.name, point_columns()));
        }
    }
}

Probes::Point Probes::point_at(const Assemblage& a, const Vector2& place, const std::string& where) {
    const std::int32_t element = element_at(a, place);
    if (element < 0) throw InputError(where + ": the point lies in no element; one inside of the specimen fits");
    return {a.element_nodes[element], weights_at(a, element, place)};
}

Vector2 Probes::value_at(const Part& part, const Point& point, const std::vector<Vector2>& of_nodes) {
    const std::vector<Vector2> values = values_at(part, {point.nodes.begin(), point.nodes.end()}, of_nodes);
    Vector2 value;
    for (std::size_t k = 0; k < 3; ++k) value += point.weights[k] * values[k];
    return value;
}

void Probes::add_ring(const ProbeRequest& request, const Assemblage& a, const std::string& where) {
    for (std::int64_t i = 0; i < request.points; ++i) {
        const double angle = request.angle(i);
        const Vector2 point = request.centre + request.radius * Vector2{std::cos(angle), std::sin(angle)};
        OnRing on_ring{angle, {}};
        if (request.reach) {
            on_ring.elements = elements_near(a, point, *request.reach);
        } else if (const std::int32_t element = element_at(a, point); element >= 0) {
            on_ring.elements = {element};
        }
        if (on_ring.elements.empty()) {
            throw InputError(fmt::format("{}: no element at {:.4g} degrees; {} fits", where, 180 / std::numbers::pi * angle,
                                         request.reach ? "a larger reach" : "a ring inside of the specimen"));
        }
        requests_.emplace_back(std::move(on_ring));
        histories_.push_back(empty_history(point_of_ring(request.name, static_cast<std::size_t>(i)), ring_columns()));
    }
}

void Probes::push(std::size_t probe, const std::vector<double>& row) {
    for (std::size_t c = 0; c < row.size(); ++c) histories_[probe].values[c].push_back(row[c]);
}

void Probes::record(const Assemblage& a, const Boundary& boundary, const State& s) {
    std::size_t probe = 0;
    for (std::size_t c = 0; c < nodes_of_boundary_.size(); ++c) {
        const Vector2 u = mean_displacement(a, nodes_of_boundary_[c], s);
        const Vector2 force = force_of_control(a, static_cast<std::int32_t>(c), boundary.prescribed, s);
        push(probe++, {u.x, u.y, force.x, force.y});
    }
    for (const auto& request : requests_) {
        if (const auto* const circle = std::get_if<Circle>(&request)) {
            push(probe++, mean_stress(a, *circle, s));
            continue;
        }
        if (const auto* const on_ring = std::get_if<OnRing>(&request)) {
            const std::vector<double> strain = mean_strain(a, on_ring->elements, s);
            std::vector<double> row{on_ring->angle, strain[0], strain[1], strain[2], strain[0] + strain[1]};
            const std::vector<double> stress = mean_stress(a, on_ring->elements, s);
            row.insert(row.end(), stress.begin(), stress.end());
            push(probe++, row);
            continue;
        }
        if (const auto* const gauge = std::get_if<Gauge>(&request)) {
            const auto& [first, second] = gauge->ends;
            push(probe++,
                 {elongation(gauge->way, value_at(a.part, second, s.displacement) - value_at(a.part, first, s.displacement))});
            continue;
        }
        const Point& point = std::get<Point>(request);
        const Vector2 u = value_at(a.part, point, s.displacement);
        const Vector2 v = value_at(a.part, point, s.velocity);
        push(probe++, {u.x, u.y, v.x, v.y});
    }
}

void Probes::restore(const H5Input& checkpoint, std::size_t rows) {
    for (ProbeHistory& history : histories_) {
        const ProbeHistory saved = read_probe(checkpoint, history.name);
        for (std::size_t c = 0; c < history.columns.size(); ++c) {
            const auto at = std::find_if(saved.columns.begin(), saved.columns.end(),
                                         [&](const ProbeColumn& column) { return column.name == history.columns[c].name; });
            if (at == saved.columns.end() || saved.values.front().size() != rows) {
                throw InputError(fmt::format("{}: probe {} lacks the column {}, or its rows are not those of the history",
                                             checkpoint.name(), history.name, history.columns[c].name));
            }
            history.values[c] = saved.values[static_cast<std::size_t>(at - saved.columns.begin())];
        }
    }
}

double Probes::last(const std::string& probe, std::size_t column) const {
    const auto found = std::find_if(histories_.begin(), histories_.end(), [&](const ProbeHistory& h) { return h.name == probe; });
    return found->values[column].back();
}

}  // namespace graincrack
