#include "solver/loading/standard_tests.hpp"

#include <algorithm>
#include <limits>

#include "solver/setup/transit_time.hpp"

namespace graincrack {
namespace {

constexpr double start_transits = 10;     // wave transits the platens take to reach a fixed speed
constexpr double ramp_transits = 40;      // the pressure takes at least where the rate is not fixed: nothing breaks on the way
constexpr double give_up_transits = 200;  // that the isotropic stage may take to come to rest
constexpr double isotropic_rest = 2e-3;   // unbalanced ratio, and relative error of the axial pressure, at its end

TimeFunction ramp(double value, double duration) {
    TimeFunction f;
    f.kind = TimeFunction::Kind::ramp;
    f.value = value;
    f.duration = duration;
    return f;
}

/// The pressure rises as slowly as the test goes on.
double pressure_time(const LoadingRequest& request, double height, const Rock& rock, double transit_time) {
    if (request.rate != RateKind::fixed) {
        return ramp_transits * transit_time;
    }
    const double as_fast_as_the_test = request.confining_pressure / rock.young_modulus * height / (2 * request.platen_speed);
    return std::max(start_transits * transit_time, as_fast_as_the_test);
}

BoundaryCondition membrane() {
    BoundaryCondition condition;
    condition.name = "membrane";
    condition.region.parts = {"left", "right"};
    condition.is_set[static_cast<std::size_t>(Action::pressure)] = true;
    return condition;
}

Stage isotropic(double pressure, double ramp_time, double transit_time) {
    Stage stage;
    stage.name = isotropic_stage;
    stage.platens = PressureServo{ramp(pressure, ramp_time)};
    stage.settings["membrane"][static_cast<std::size_t>(Action::pressure)] = ramp(pressure, ramp_time);
    stage.longest_time = ramp_time + give_up_transits * transit_time;
    stage.rest = isotropic_rest;
    stage.must_end_by = "rest";
    return stage;
}

PlatenMotion axial_motion(const LoadingRequest& request, double transit_time) {
    const bool apart = request.test == TestKind::tension;
    const double speed = apart ? -request.platen_speed : request.platen_speed;
    switch (request.rate) {
        case RateKind::fixed: break;
        case RateKind::automatic: return AutomaticRate{apart, request.rate_tolerance, request.rate_share};
        case RateKind::blocks: return LoadingBlocks{speed, request.block_steps, request.rate_tolerance};
    }
    return ramp(speed, start_transits * transit_time);
}

}  // namespace

Program standard_test(const LoadingRequest& request, double peak_drop, const Specimen& specimen, const Rock& rock) {
    const double transit_time = bar_transit_time(specimen, rock);
    Program program;
    program.name = program.file = name_of(request.test);
    program.platens = {request.test == TestKind::tension, request.max_strain};
    if (request.confining_pressure > 0) {
        program.boundary_conditions = {membrane()};
        program.stages = {
            isotropic(request.confining_pressure, pressure_time(request, specimen.height, rock, transit_time), transit_time)};
    }
    Stage axial;
    axial.name = axial_stage;
    axial.platens = axial_motion(request, transit_time);
    axial.longest_time = std::numeric_limits<double>::infinity();
    if (peak_drop > 0) axial.peak_drop = peak_drop;
    program.stages.push_back(axial);
    std::transform(program.stages.begin(), program.stages.end(), std::back_inserter(program.order),
                   [](const Stage& stage) { return stage.name; });
    return program;
}

Program program_of(const SimulationRequest& request, const Specimen& specimen) {
    return request.program ? *request.program
                           : standard_test(request.loading, request.peak_drop, specimen, request.material.rock);
}

}  // namespace graincrack
