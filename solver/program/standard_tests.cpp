#include "solver/program/standard_tests.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "share/base/error.hpp"
#include "share/base/units.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {
namespace {

// Times are in transits of a bar wave through the specimen. They were chosen by trial and not varied since.

/// Time in which the platens reach a fixed speed, and shortest rise time of the pressure then.
constexpr double start_transits = 10;
/// Rise time of the pressure if the rate is not fixed: slow enough that no contact fails meanwhile.
constexpr double pressure_transits = 40;
/// Longest time in which the isotropic stage comes to rest.
constexpr double give_up_transits = 200;
/// Unbalanced ratio, and relative error of the axial pressure, that count as rest after the isotropic stage and heating.
constexpr double isotropic_rest = 2e-3;
/// Longest time of a temperature change, times tolerance and share: at the slowest rate, from 0.1 K (where marble begins to be
/// stressed) to 480 K.
constexpr double longest_heating_transits = 200;

constexpr const char* membrane_name = "membrane";

TimeFunction ramp(double value, double duration) {
    TimeFunction f;
    f.kind = TimeFunction::Kind::ramp;
    f.value = value;
    f.duration = duration;
    return f;
}

/// Rise time of the confining pressure, s. At a fixed rate the platens then need as long for the same axial stress in an elastic
/// bar.
double pressure_rise_time(const LoadingRequest& request, double height, const Rock& rock, double transit_time) {
    if (request.rate != RateKind::fixed) return pressure_transits * transit_time;
    const double as_fast_as_the_test = request.confining_pressure / rock.young_modulus * height / (2 * request.platen_speed);
    return std::max(start_transits * transit_time, as_fast_as_the_test);
}

BoundaryCondition membrane() {
    BoundaryCondition condition;
    condition.name = membrane_name;
    condition.region.parts = {"left", "right"};
    condition.is_set[static_cast<std::size_t>(Action::pressure)] = true;
    return condition;
}

Stage isotropic(double pressure, double ramp_time, double transit_time) {
    Stage stage;
    stage.name = isotropic_stage;
    stage.platens = PressureServo{ramp(pressure, ramp_time)};
    stage.settings[membrane_name][static_cast<std::size_t>(Action::pressure)] = ramp(pressure, ramp_time);
    stage.longest_time = ramp_time + give_up_transits * transit_time;
    stage.rest = isotropic_rest;
    stage.must_end_by = ended_by_rest;
    return stage;
}

Stage heating(const char* name, double to, const LoadingRequest& request, double transit_time) {
    Stage stage;
    stage.name = name;
    stage.heating = {to, request.heating_tolerance(), request.rate_share};
    stage.temperature.emplace().kind = TimeFunction::Kind::rate;
    stage.temperature->value = to;
    stage.without_platens = true;
    stage.longest_time =
        transit_time * (give_up_transits + longest_heating_transits / (stage.heating->tolerance * stage.heating->share));
    stage.rest = isotropic_rest;
    stage.must_end_by = ended_by_rest;
    return stage;
}

PlatenMotion axial_motion(const LoadingRequest& request, double transit_time) {
    const bool apart = description_of(request.test).loading == Loading::tension;
    const double speed = apart ? -request.platen_speed : request.platen_speed;
    if (request.rate == RateKind::automatic) return AutomaticRate{apart, request.automatic_tolerance(), request.rate_share};
    if (request.rate == RateKind::blocks) return LoadingBlocks{speed, request.block_steps, request.rest_tolerance};
    return ramp(speed, start_transits * transit_time);
}

/// The boundary node nearest to a place.
std::array<double, 2> boundary_node_near(double x, double y, const Specimen& s) {
    const auto distance = [&](const std::array<double, 2>& p) { return std::hypot(p[0] - x, p[1] - y); };
    std::array<double, 2> nearest{std::numeric_limits<double>::infinity(), 0};
    for (const auto& edge : s.boundary_edges) {
        const auto& start = s.node_position[static_cast<std::size_t>(edge[0])];
        if (distance(start) < distance(nearest)) nearest = start;
    }
    return nearest;
}

double mean_boundary_edge(const Specimen& s) {
    double length = 0;
    for (const auto& edge : s.boundary_edges) {
        const auto& from = s.node_position[static_cast<std::size_t>(edge[0])];
        const auto& to = s.node_position[static_cast<std::size_t>(edge[1])];
        length += std::hypot(to[0] - from[0], to[1] - from[1]);
    }
    return length / static_cast<double>(s.n_boundary_edges());
}

/// Adds two rollers below and one above in the middle.
void add_rollers(const LoadingRequest& request, const Specimen& s, ProgramPlatens& platens) {
    const double span = request.span.value_or(usual_span(s));
    const double width = request.roller_width.value_or(mean_boundary_edge(s));
    const auto millimetres = [](double value) { return format_number(1e3 * value, 4) + " mm"; };
    if (3 * width > s.width) {
        throw UsageError(fmt::format("--roller-width: three rollers {} wide have no room on a {} of {}; at most {} fits",
                                     millimetres(width), s.shape, millimetres(s.width), millimetres(s.width / 3)));
    }
    if (span + width > s.width) {
        throw UsageError(fmt::format("--span: {}rollers at a distance of {} have no room on a {} of {}; give at most {}",
                                     request.span ? "" : "missing, and by default ", millimetres(span), s.shape,
                                     millimetres(s.width), millimetres(s.width - width)));
    }
    if (span < 2 * width) {
        throw UsageError(
            fmt::format("{}: rollers {} wide at a distance of {} leave no room between them; {} fits",
                        request.roller_width ? "--roller-width" : "--span", millimetres(width), millimetres(span),
                        request.roller_width ? "at most " + millimetres(span / 2) : "at least " + millimetres(2 * width)));
    }
    const auto place = [&](double x, double side) { return boundary_node_near(x, side * s.height / 2, s)[0]; };
    platens.bottom.at = {place(-span / 2, -1), place(span / 2, -1)};
    platens.top.at = {place(0, 1)};
    platens.bottom.width = platens.top.width = width;
}

/// A gauge on the lower face, centred at the mouth of the notch.
ProbeRequest gauge_over_mouth(double gauge, const Specimen& s) {
    const auto notch = edge_notch(s);
    if (!notch) {
        throw UsageError(
            fmt::format("--mouth-gauge: the {} has no notch from below; leave it out, or make one by graincrack-mesh {} --slit",
                        s.shape, s.shape));
    }
    const auto [x, y] = notch->mouth;
    if (std::abs(x) + gauge / 2 > s.width / 2) {
        throw UsageError(fmt::format("--mouth-gauge: {} about a notch at {} leave the lower face of a {} of {}; at most {} fits",
                                     format_length(gauge), format_length(x), s.shape, format_length(s.width),
                                     format_length(s.width - 2 * std::abs(x))));
    }
    ProbeRequest probe;
    probe.name = mouth_probe;
    probe.form = ProbeRequest::Form::gauge;
    probe.centre = {x - gauge / 2, y};
    probe.end = {x + gauge / 2, y};
    return probe;
}

bool has_shape_of(const TestDescription& test, const Specimen& specimen) {
    return std::find(test.shapes.begin(), test.shapes.end(), specimen.shape) != test.shapes.end();
}

bool loads(const TestDescription& test, const Specimen& specimen) {
    if (test.loading == Loading::program) return true;
    if (!test.shapes.empty()) return has_shape_of(test, specimen);
    return specimen.shape == "rectangle" || has_end_faces(specimen);
}

/// The tests that load a specimen, such as "bend, uniaxial or program"; tests made for its shape come first.
std::string tests_of(const Specimen& specimen) {
    std::vector<std::string_view> names;
    for (const bool own : {true, false}) {
        for (const TestDescription& test : all_tests()) {
            if (loads(test, specimen) && has_shape_of(test, specimen) == own) names.push_back(test.name);
        }
    }
    const std::string_view last = names.back();
    names.pop_back();
    return names.empty() ? std::string(last) : fmt::format("{} or {}", fmt::join(names, ", "), last);
}

}  // namespace

double usual_span(const Specimen& specimen) {
    constexpr double heights_of_beam = 4;
    constexpr double diameters_of_half_disc = 0.6;
    return specimen.shape == "half-disc" ? diameters_of_half_disc * specimen.width : heights_of_beam * specimen.height;
}

Program standard_test(const LoadingRequest& request, double peak_drop, const Specimen& specimen, const Rock& rock) {
    const double transit_time = bar_transit_time(specimen, rock);
    const Loading loading = description_of(request.test).loading;
    Program program;
    program.name = program.file = name_of(request.test);
    program.platens.emplace();
    program.platens->bonded = loading == Loading::tension;
    program.platens->max_strain = request.max_strain;
    if (loading == Loading::bending) add_rollers(request, specimen, *program.platens);
    if (request.heat != 0) program.stages.push_back(heating(heat_stage, request.heat, request, transit_time));
    if (request.cool) program.stages.push_back(heating(cool_stage, 0, request, transit_time));
    if (request.confining_pressure > 0) {
        program.boundary_conditions = {membrane()};
        program.stages.push_back(isotropic(request.confining_pressure,
                                           pressure_rise_time(request, specimen.height, rock, transit_time), transit_time));
    }
    Stage axial;
    axial.name = axial_stage;
    axial.platens = axial_motion(request, transit_time);
    if (peak_drop > 0) axial.peak_drop = peak_drop;
    if (request.mouth_gauge) program.probes = {gauge_over_mouth(*request.mouth_gauge, specimen)};
    if (request.mouth_opening) {
        axial.until = {{mouth_probe, 0, fmt::format("{}.{}", mouth_probe, gauge_columns().front().name), *request.mouth_opening}};
    }
    program.stages.push_back(axial);
    std::transform(program.stages.begin(), program.stages.end(), std::back_inserter(program.order),
                   [](const Stage& stage) { return stage.name; });
    return program;
}

void require_shape(TestKind kind, const Specimen& specimen, const std::string& file) {
    const TestDescription& test = description_of(kind);
    if (loads(test, specimen)) return;
    const bool needs_faces = test.shapes.empty();
    throw InputError(fmt::format("{}: is a {}, and a {} test loads {}; make one by graincrack-mesh {}, or load this one by {}",
                                 file, specimen.shape, test.name,
                                 needs_faces ? "the faces bottom and top" : fmt::format("a {}", fmt::join(test.shapes, " or a ")),
                                 needs_faces ? "rectangle" : test.shapes.front(), tests_of(specimen)));
}

}  // namespace graincrack
