#include "solver/run/run_driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "share/error.hpp"
#include "solver/run/program_driver.hpp"

namespace graincrack {
namespace {

/// The four tests: platens, and a membrane where there is a pressure, to the drop behind the peak or the strain cap.
class TestDriver : public RunDriver {
public:
    TestDriver(const SimulationRequest& request, const Specimen& specimen)
        : request_(request), loading_(request.loading, specimen, request.material.rock, request.plane) {}

    [[nodiscard]] std::int64_t interval_steps(double time_step) const override { return loading_.interval_steps(time_step); }
    IntervalLoading next(const RunView& view, double duration) override { return loading_.next(view.feedback, duration); }
    void note(const RunView& /*view*/) override {}
    [[nodiscard]] std::string stop_reason(const RunView& view) const override {
        if (loading_.is_isotropic()) {
            return "";
        }
        if (view.cracked && view.driven_stress < (1 - request_.peak_drop) * view.peak) {
            return "peak drop";
        }
        return std::abs(view.axial_strain) >= request_.loading.max_strain ? "strain cap" : "";
    }
    [[nodiscard]] bool counts() const override { return !loading_.is_isotropic(); }
    [[nodiscard]] double platen_speed() const override { return loading_.platen_speed(); }
    [[nodiscard]] double progress(const RunView& view) const override {
        return std::abs(view.axial_strain) / request_.loading.max_strain;
    }
    void complete(RunHeader& header, double time) override {
        header.isotropic_end_time = loading_.isotropic_end_time();
        if (request_.loading.rate == RateKind::automatic) {
            header.platen_speed = loading_.mean_speed(time);
        }
    }
    [[nodiscard]] StageControllerState saved(double /*time*/) const override {
        StageControllerState state{{}, {}, loading_.platen_speed(), 0};
        Loading::visit_state(loading_, [&state](const char* name, const auto& value) {
            state.names.emplace_back(name);
            state.values.push_back(static_cast<double>(value));
        });
        return state;
    }
    void resume(const StageControllerState& state) override {
        Loading::visit_state(loading_, [&state](const char* name, auto& value) {
            const auto at = std::find(state.names.begin(), state.names.end(), name);
            if (at == state.names.end()) {
                throw InputError(
                    fmt::format("the saved state of the loading lacks \"{}\"; only a test's own checkpoint has it", name));
            }
            value = static_cast<std::decay_t<decltype(value)>>(state.values[static_cast<std::size_t>(at - state.names.begin())]);
        });
    }
    void go_on(const StageControllerState& state, const RunReader& /*checkpoint*/, double /*time_step*/) override {
        resume(state);
    }
    void append(H5Output& /*file*/, std::size_t /*first*/) const override {}
    void write(H5Output& /*file*/) const override {}

private:
    const SimulationRequest& request_;
    Loading loading_;
};

}  // namespace

std::unique_ptr<RunDriver> make_run_driver(const SimulationRequest& request, const Assemblage& assemblage,
                                           const Specimen& specimen) {
    if (request.program) {
        return std::make_unique<ProgramDriver>(*request.program, assemblage, specimen, request.material.rock);
    }
    return std::make_unique<TestDriver>(request, specimen);
}

}  // namespace graincrack
