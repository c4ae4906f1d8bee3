// Time of a step and of its stages, for each law and vector unit: `tests/benchmark/run`. Real time; items are grains.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "tests/benchmark/stages.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::benchmark {
namespace {

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

void run_stage(::benchmark::State& timer, std::size_t index, bool scaled, VectorTarget target) {
    LoadedSpecimen loaded(granite(few), LawVariant::consistent, scaled, target);
    const Stage stage = stages_of(loaded)[index];
    for (auto _ : timer) stage.run(loaded);
    count(timer, loaded, 1);
}

void measure_all(::benchmark::State& timer) {
    LoadedSpecimen loaded(granite(few), LawVariant::consistent, false, widest_vector_target());
    for (auto _ : timer) ::benchmark::DoNotOptimize(measure(loaded.assemblage, loaded.boundary, loaded.parameters, loaded.state));
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
            for (std::size_t i = 0; i < 3; ++i) {
                const std::string stage = std::array{"contacts", "forces", "integration"}[i];
                add("stage/" + masses + stage + "/1122/" + unit, [=](auto& timer) { run_stage(timer, i, scaled, target); });
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
