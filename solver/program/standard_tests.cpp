#include "solver/program/standard_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "share/base/error.hpp"
#include "solver/model/transit_time.hpp"

namespace graincrack {
namespace {

// Times in transits of a bar wave through the specimen.

/// In which the platens reach a fixed speed, and at least that in which the pressure rises then.
constexpr double start_transits = 10;
/// In which the pressure rises where the rate is not fixed: slowly enough that nothing breaks on the way.
constexpr double pressure_transits = 40;
/// That the isotropic stage may take to come to rest.
constexpr double give_up_transits = 200;
/// Unbalanced ratio, and relative error of the axial pressure, at the end of the isotropic stage.
constexpr double isotropic_rest = 2e-3;

constexpr const char* membrane_name = "membrane";

TimeFunction ramp(double value, double duration) {
    TimeFunction f;
    f.kind = TimeFunction::Kind::ramp;
    f.value = value;
    f.duration = duration;
    return f;
}

/// Time in which the confining pressure rises, s. At a fixed rate this is as long as the platens then take to the same axial
/// stress in an elastic bar.
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

PlatenMotion axial_motion(const LoadingRequest& request, double transit_time) {
    const bool apart = request.test == TestKind::tension;
    const double speed = apart ? -request.platen_speed : request.platen_speed;
    if (request.rate == RateKind::automatic) return AutomaticRate{apart, request.automatic_tolerance(), request.rate_share};
    if (request.rate == RateKind::blocks) return LoadingBlocks{speed, request.block_steps, request.rest_tolerance};
    return ramp(speed, start_transits * transit_time);
}

}  // namespace

Program standard_test(const LoadingRequest& request, double peak_drop, const Specimen& specimen, const Rock& rock) {
    const double transit_time = bar_transit_time(specimen, rock);
    Program program;
    program.name = program.file = name_of(request.test);
    program.platens.emplace();
    program.platens->bonded = request.test == TestKind::tension;
    program.platens->max_strain = request.max_strain;
    if (request.confining_pressure > 0) {
        program.boundary_conditions = {membrane()};
        program.stages = {isotropic(request.confining_pressure, pressure_rise_time(request, specimen.height, rock, transit_time),
                                    transit_time)};
    }
    Stage axial;
    axial.name = axial_stage;
    axial.platens = axial_motion(request, transit_time);
    if (peak_drop > 0) axial.peak_drop = peak_drop;
    program.stages.push_back(axial);
    std::transform(program.stages.begin(), program.stages.end(), std::back_inserter(program.order),
                   [](const Stage& stage) { return stage.name; });
    return program;
}

void require_shape(TestKind test, const Specimen& specimen, const std::string& file) {
    if (test == TestKind::brazilian && specimen.shape == "rectangle") {
        throw InputError(
            fmt::format("{}: is a rectangle, and a Brazilian test loads a disc; make one by graincrack-mesh disc, or "
                        "load the rectangle by uniaxial, triaxial, tension or program",
                        file));
    }
    if (test != TestKind::brazilian && test != TestKind::program && specimen.shape == "disc") {
        throw InputError(
            fmt::format("{}: is a disc, and a {} test loads a rectangle; make one by graincrack-mesh rectangle, or "
                        "load the disc by brazilian or program",
                        file, name_of(test)));
    }
}

}  // namespace graincrack
