// Time of the stages of a step, of a step with each law and vector unit, and of a step of the specimens of the files that are
// given: `tests/benchmark/run`. Real time; items are elements.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "share/file/h5_file.hpp"
#include "share/file/specimen.hpp"
#include "share/rock/material.hpp"
#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/run/measure.hpp"
#include "solver/setup/setup.hpp"
#include "solver/step/contact_forces.hpp"
#include "solver/step/mass_scaling.hpp"
#include "solver/step/mass_scaling_step.hpp"
#include "solver/step/nodal_forces.hpp"
#include "solver/step/step.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::benchmark {
namespace {

constexpr double speed = 0.05;  // of each platen, m/s
const int processors = static_cast<int>(std::thread::hardware_concurrency());

SimulationRequest compression(const Material& material, LawVariant law, bool scaled, VectorTarget vector_target) {
    SimulationRequest request;
    request.material = material;
    request.contact = contact_parameters(material, request.plane, std::nullopt);
    request.law = law;
    request.mass_scaling = scaled;
    request.vector_target = vector_target;
    request.loading.platen_friction = material.platen_friction_angle;
    return request;
}

/// A specimen between platens, intact and compressed to about a tenth of its strength.
struct LoadedSpecimen : Setup {
    State state;

    LoadedSpecimen(const Specimen& specimen, const SimulationRequest& request)
        : Setup(make_setup(specimen, request, program_of(request, specimen))), state(make_state(assemblage, boundary, specimen)) {
        for (std::size_t i = 0; i < state.velocity.size(); ++i) {
            state.velocity[i] = {0, -2 * speed * assemblage.position[i].y / specimen.height};
        }
        start(assemblage, parameters, state);
        ThreadTeam all(processors);
        advance_by(request.mass_scaling ? 200 : 2000, all);  // scaled masses have steps about ten times as long
    }
    /// Further steps at the platens' speed.
    void advance_by(std::int64_t steps, ThreadTeam& team) {
        const IntervalLoading loading{{speed, -speed}, {speed, -speed}, nullptr};
        advance(assemblage, boundary, parameters, loading, steps, team, state);
    }
    [[nodiscard]] double elements() const { return assemblage.n_elements(); }
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

/// 17 × 33 cells of two grains: 1,122 grains of a kind.
Specimen granite() {
    constexpr double cell = 4.5e-3;
    return test::jittered_grid(17, 33, cell * 17, cell * 33, 0.25);
}
LoadedSpecimen loaded_granite(LawVariant law, bool scaled, VectorTarget target) {
    return {granite(), compression(test::augig_granite(), law, scaled, target)};
}

void count(::benchmark::State& timer, const LoadedSpecimen& loaded, double steps) {
    const double element_steps = loaded.elements() * steps * static_cast<double>(timer.iterations());
    timer.SetItemsProcessed(static_cast<std::int64_t>(element_steps));
    timer.counters["ns/element-step"] =
        ::benchmark::Counter(element_steps * 1e-9, ::benchmark::Counter::kIsRate | ::benchmark::Counter::kInvert);
}

void run_steps(::benchmark::State& timer, LoadedSpecimen& loaded, int threads) {
    const State begin = loaded.state;
    ThreadTeam team(threads);
    const std::int64_t steps = 32 * std::max(1, 25000 / loaded.assemblage.n_elements());
    for (auto _ : timer) {
        loaded.advance_by(steps, team);
        timer.PauseTiming();
        loaded.state = begin;
        timer.ResumeTiming();
    }
    count(timer, loaded, static_cast<double>(steps));
}

/// Every contact is a crack, and each grain was displaced in another direction, so that some hundreds of nodes are in node–edge
/// contact.
LoadedSpecimen loose_grains(VectorTarget target) {
    Specimen specimen = granite();
    specimen.contact_kind.assign(specimen.n_contacts(), static_cast<std::uint8_t>(ContactKind::pre_existing_crack));
    LoadedSpecimen loaded(specimen, compression(test::augig_granite(), LawVariant::consistent, false, target));
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
    LoadedSpecimen loaded = loaded_granite(LawVariant::consistent, scaled, target);
    for (auto _ : timer) stage(loaded);
    count(timer, loaded, 1);
}

void measure_all(::benchmark::State& timer) {
    LoadedSpecimen loaded = loaded_granite(LawVariant::consistent, false, widest_vector_target());
    ThreadTeam team(1);
    for (auto _ : timer) {
        ::benchmark::DoNotOptimize(measure(loaded.assemblage, loaded.boundary, loaded.parameters, team, loaded.state));
    }
    count(timer, loaded, 1);
}

void add(const std::string& name, auto&& run) {
    ::benchmark::RegisterBenchmark(name.c_str(), run)->UseRealTime()->Unit(::benchmark::kMicrosecond);
}

/// Adds steps of the specimen of a file with 1, 2, 4 … threads. It is set up once for all of them, since they follow one another.
void add_steps(const std::string& file, bool scaled, VectorTarget target) {
    const std::string name = fmt::format("step/{}/{}/{}/", std::filesystem::path(file).stem().string(),
                                         scaled ? "selective" : "none", name_of(target));
    for (int threads = 1; threads <= std::min(processors, 16); threads *= 2) {
        add(name + std::to_string(threads), [=](auto& timer) {
            static std::string present;
            static std::optional<LoadedSpecimen> loaded;
            if (present != name) {
                loaded.reset();
                const Specimen specimen = read_specimen(H5Input(file));
                const bool is_uniform = specimen.phase_names.size() == 1;
                const Material material = read_material(is_uniform ? "augig-granite" : "augig-granite-calibrated");
                loaded.emplace(specimen,
                               compression(material, is_uniform ? default_law : LawVariant::cohesive_frictional, scaled, target));
                present = name;
            }
            run_steps(timer, *loaded, threads);
        });
    }
}

/// \param files specimens of which steps are measured
void add_all(const std::vector<std::string>& files) {
    for (const VectorTarget target : {VectorTarget::plain, VectorTarget::avx2, VectorTarget::avx512}) {
        if (!is_available(target)) continue;
        const std::string unit(name_of(target));
        for (const bool scaled : {false, true}) {
            const std::string masses = scaled ? "scaled/" : "";
            for (const auto& [stage, act] : std::vector<std::pair<std::string, Stage>>{
                     {"contacts", contacts}, {"forces", forces}, {"integration", scaled ? clusters : nodes}}) {
                add("stage/" + masses + stage + "/1122/" + unit,
                    [=, act = act](auto& timer) { run_stage(timer, act, scaled, target); });
            }
            for (const std::string& file : files) add_steps(file, scaled, target);
        }
        add("stage/node-edge contacts/1122/" + unit, [=](auto& timer) { run_node_edge_contacts(timer, target, false); });
        add("stage/detection/1122/" + unit, [=](auto& timer) { run_node_edge_contacts(timer, target, true); });
        for (const LawDescription& law : all_contact_laws()) {
            add("law/" + std::string(law.name) + "/1122/" + unit, [=, variant = law.variant](auto& timer) {
                LoadedSpecimen loaded = loaded_granite(variant, false, target);
                run_steps(timer, loaded, 1);
            });
        }
    }
    add("measure/1122", measure_all);
}

}  // namespace
}  // namespace graincrack::benchmark

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    graincrack::benchmark::add_all({argv + 1, argv + argc});
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
