// Time of a step and of its stages, for each law and vector unit: `tests/benchmark/run`. Real time; items are grains.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/model/vertex_clusters.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/stable_time_step.hpp"
#include "solver/step/contact_forces.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "solver/step/step.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::benchmark {
namespace {

constexpr double speed = 0.05;  // of each platen, m/s

LoadingRequest compression() {
    LoadingRequest request;
    request.platen_friction = 5 * test::degree;
    return request;
}

/// Augig granite between platens, intact and compressed to about a tenth of its strength.
struct LoadedSpecimen {
    Specimen specimen;
    Assemblage assemblage;
    StepParameters parameters;
    Boundary boundary;
    State state;

    LoadedSpecimen(Specimen s, LawVariant law, bool scaled, VectorTarget vector_target)
        : specimen(std::move(s)),
          assemblage(make_assemblage(specimen, test::augig_granite().rock, PlaneCondition::strain)),
          parameters{make_contact_law(test::augig_contact(), law), 0, 0.8},
          boundary(test::boundary_of_test(assemblage, specimen, compression(), test::augig_contact())) {
        assemblage.vector_target = vector_target;
        const double factor = scaled ? sufficient_mass_scaling(assemblage, boundary, parameters.laws) : 0;
        parameters.mass_scaling = make_mass_scaling(assemblage, factor);
        parameters.time_step = 0.7 * stable_time_step(assemblage, boundary, parameters.laws, factor);
        state = make_state(assemblage, boundary, specimen);
        for (std::size_t i = 0; i < state.velocity.size(); ++i) {
            state.velocity[i] = {0, -2 * speed * assemblage.position[i].y / specimen.height};
        }
        start(assemblage, parameters, state);
        ThreadTeam alone(1);
        advance_by(2000, alone);
    }
    /// Further steps at the platens' speed.
    void advance_by(std::int64_t steps, ThreadTeam& team) {
        const IntervalLoading loading{{speed, -speed}, {speed, -speed}, nullptr};
        advance(assemblage, boundary, parameters, loading, steps, team, state);
    }
    [[nodiscard]] double grains() const { return static_cast<double>(specimen.n_grains()); }
};

template <class Act>
void for_each_chunk(std::size_t n, Act&& act) {
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(n); ++chunk) act(chunk);
}

void contacts(LoadedSpecimen& l) {
    for_each_chunk(l.assemblage.contact_chunks.size(),
                   [&](std::int32_t chunk) { advance_contacts(l.assemblage, l.parameters.laws, chunk, l.state.step, l.state); });
}
void forces(LoadedSpecimen& l) {
    static ThreadTeam alone(1);
    sum_nodal_forces(l.assemblage, l.boundary, l.state.loading, alone, l.state);
}
void nodes(LoadedSpecimen& l) {
    StepParameters still = l.parameters;
    still.time_step = 0;  // as much work, and the state stays
    for_each_chunk(l.assemblage.node_chunks.size(), [&](std::int32_t chunk) {
        book_half_load_work(l.assemblage, l.boundary, chunk, 0, l.state);
        integrate_nodes(l.assemblage, l.boundary, still, chunk, l.state);
        book_half_load_work(l.assemblage, l.boundary, chunk, 0, l.state);
    });
}
void clusters(LoadedSpecimen& l) {
    const double time_step = std::exchange(l.parameters.time_step, 0.0);
    for_each_chunk(l.assemblage.node_chunks.size(), [&](std::int32_t chunk) {
        update_clusters(l.assemblage, l.parameters, l.state.loading, chunk, l.state);
        integrate_clusters(l.assemblage, l.parameters, l.state.loading, chunk, l.state);
    });
    l.parameters.time_step = time_step;
}

constexpr int few = 17;    // × 33 cells of two grains: 1,122
constexpr int many = 178;  // × 354: 126,024
Specimen granite(int columns) {
    const int rows = columns == few ? 33 : 354;
    const double cell = 4.5e-3;
    return test::jittered_grid(columns, rows, cell * columns, cell * rows, 0.25);
}

void count(::benchmark::State& timer, const LoadedSpecimen& loaded, double steps) {
    const double grain_steps = loaded.grains() * steps * static_cast<double>(timer.iterations());
    timer.SetItemsProcessed(static_cast<std::int64_t>(grain_steps));
    timer.counters["ns/grain-step"] =
        ::benchmark::Counter(grain_steps * 1e-9, ::benchmark::Counter::kIsRate | ::benchmark::Counter::kInvert);
}

void run_steps(::benchmark::State& timer, int columns, LawVariant law, bool scaled, VectorTarget target, int threads) {
    LoadedSpecimen loaded(granite(columns), law, scaled, target);
    ThreadTeam team(threads);
    constexpr std::int64_t steps = 20;
    for (auto _ : timer) loaded.advance_by(steps, team);
    count(timer, loaded, static_cast<double>(steps));
}

/// Every contact is a crack, and each grain was displaced in another direction, so that some two hundred nodes are in node–edge
/// contact.
LoadedSpecimen loose_grains(VectorTarget target) {
    Specimen specimen = granite(few);
    specimen.contact_kind.assign(specimen.n_contacts(), static_cast<std::uint8_t>(ContactKind::pre_existing_crack));
    LoadedSpecimen loaded(std::move(specimen), LawVariant::consistent, false, target);
    constexpr double push = 50;  // m/s
    for (std::size_t i = 0; i < loaded.state.velocity.size(); ++i) {
        const double angle = 2.4 * loaded.assemblage.surface.grain_of_node[i];
        loaded.state.velocity[i] += Vector2{push * std::cos(angle), push * std::sin(angle)};
    }
    ThreadTeam alone(1);
    loaded.advance_by(2000, alone);
    return loaded;
}

/// Node–edge contacts alone, moved or detected where they are.
void run_node_edge_contacts(::benchmark::State& timer, VectorTarget target, bool detects_contacts) {
    LoadedSpecimen loaded = loose_grains(target);
    loaded.parameters.time_step = 0;
    for (auto _ : timer) {
        for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(loaded.state.contact_pairs.chunks.size()); ++chunk) {
            (detects_contacts ? detect_contacts : move_active_contacts)(loaded.assemblage, loaded.parameters, chunk,
                                                                        loaded.state);
        }
    }
    count(timer, loaded, 1);
    const auto& moving = loaded.state.contact_pairs.active.count;
    timer.counters["node-edge contacts"] = std::accumulate(moving.begin(), moving.end(), 0);
}

using Stage = void (*)(LoadedSpecimen&);
void run_stage(::benchmark::State& timer, Stage stage, bool scaled, VectorTarget target) {
    LoadedSpecimen loaded(granite(few), LawVariant::consistent, scaled, target);
    for (auto _ : timer) stage(loaded);
    count(timer, loaded, 1);
}

void measure_all(::benchmark::State& timer) {
    LoadedSpecimen loaded(granite(few), LawVariant::consistent, false, widest_vector_target());
    ThreadTeam team(1);
    for (auto _ : timer) {
        ::benchmark::DoNotOptimize(measure(loaded.assemblage, loaded.boundary, loaded.parameters, team, loaded.state));
    }
    count(timer, loaded, 1);
}

void add(const std::string& name, auto&& run) {
    ::benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(::benchmark::kMicrosecond);
}

void add_all() {
    for (const VectorTarget target : {VectorTarget::plain, VectorTarget::avx2, VectorTarget::avx512}) {
        if (!is_available(target)) continue;
        const std::string unit(name_of(target));
        for (const bool scaled : {false, true}) {
            const std::string masses = scaled ? "scaled/" : "";
            for (const auto& [stage, act] : std::vector<std::pair<std::string, Stage>>{
                     {"contacts", contacts}, {"forces", forces}, {"integration", scaled ? clusters : nodes}}) {
                add("stage/" + masses + stage + "/1122/" + unit, [=](auto& timer) { run_stage(timer, act, scaled, target); });
            }
            for (const int threads : {1, 2}) {
                for (const int columns : {few, many}) {
                    const std::string size = columns == few ? "1122/" : "126024/";
                    add("step/" + masses + size + unit + "/threads:" + std::to_string(threads),
                        [=](auto& timer) { run_steps(timer, columns, LawVariant::consistent, scaled, target, threads); });
                }
            }
        }
        add("stage/node-edge contacts/1122/" + unit, [=](auto& timer) { run_node_edge_contacts(timer, target, false); });
        add("stage/detection/1122/" + unit, [=](auto& timer) { run_node_edge_contacts(timer, target, true); });
        for (const LawDescription& law : all_contact_laws()) {
            add("law/" + std::string(law.name) + "/1122/" + unit,
                [=, variant = law.variant](auto& timer) { run_steps(timer, few, variant, false, target, 1); });
        }
    }
    add("measure/1122", measure_all);
}

}  // namespace
}  // namespace graincrack::benchmark

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    graincrack::benchmark::add_all();
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
