// How far a step is from the least it could take: `whole_run SPECIMEN [selective]`. Prints, for a specimen under load, what each
// stage takes of a grain-step, its operations and bytes, and the floor: the time this processor needs for as many additions and
// multiplications on its widest vector unit, or for as many bytes from where the run's data lie, whichever is longer.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string_view>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "tests/benchmark/stages.hpp"

namespace graincrack::benchmark {
namespace {

/// Shortest of some tries, s.
template <class Act>
double shortest_time(int tries, int repeats, Act&& act) {
    double best = 1e9;
    for (int i = 0; i < tries; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        for (int k = 0; k < repeats; ++k) act();
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / repeats);
    }
    return best;
}

/// Additions and multiplications a second of independent chains in registers.
double operation_rate(VectorTarget target) {
    constexpr std::int32_t n = 128;
    constexpr int rounds = 20000;
    alignas(64) double x[n];
    std::fill_n(x, n, 1.0);
    const double time = shortest_time(5, 1, [&] {
        run_on(target, [&]() GRAINCRACK_KERNEL {
            for (int k = 0; k < rounds; ++k) {
                for (std::int32_t i = 0; i < n; ++i) x[i] = x[i] * 0.999 + 0.001;
            }
        });
    });
    return 2.0 * n * rounds / time;
}

/// Bytes a second, read and written, of x ← a x + y over arrays as large as the run's data.
double byte_rate(VectorTarget target, double bytes) {
    const auto n = static_cast<std::size_t>(std::max(bytes / 16, 1024.0));
    std::vector<double> x(n, 1.0);
    std::vector<double> y(n, 0.5);
    double* __restrict const to = x.data();
    const double* const from = y.data();
    const int repeats = static_cast<int>(std::max<std::size_t>(1, 20'000'000 / n));
    const double time = shortest_time(5, repeats, [&] {
        run_on(target, [&]() GRAINCRACK_KERNEL {
            for (std::size_t i = 0; i < n; ++i) to[i] = 0.5 * to[i] + from[i];
        });
    });
    return 24.0 * static_cast<double>(n) / time;
}

void print_table(LoadedSpecimen& loaded) {
    const VectorTarget target = loaded.assemblage.vector_target;
    double bytes_of_grain = 0;
    for (const Stage& stage : stages_of(loaded)) bytes_of_grain += stage.bytes;
    const double operations = operation_rate(target);
    const double bytes = byte_rate(target, bytes_of_grain * loaded.grains());
    const double to_ns = 1e9 / loaded.grains();
    const int repeats = static_cast<int>(std::max(1.0, 2e6 / loaded.grains()));
    ThreadTeam alone(1);
    constexpr std::int64_t steps = 20;
    const double step = to_ns * shortest_time(7, std::max(1, repeats / 20), [&] { loaded.advance_by(steps, alone); }) / steps;
    fmt::print("{} grains, {}, {:.1f} GFlop/s, {:.1f} GB/s\n", loaded.grains(), name_of(target), operations * 1e-9, bytes * 1e-9);
    fmt::print("stage\tns_per_grain_step\tshare\toperations\tbytes\tfloor_ns\ttimes_the_floor\n");
    const auto row = [](const std::string& name, double ns, double share, double n_operations, double n_bytes, double floor) {
        fmt::print("{}\t{:.1f}\t{:.2f}\t{:.0f}\t{:.0f}\t{:.1f}\t{:.1f}\n", name, ns, share, n_operations, n_bytes, floor,
                   ns / floor);
    };
    double all_operations = 0;
    double all_bytes = 0;
    double all_floors = 0;
    for (const Stage& stage : stages_of(loaded)) {
        const double ns = to_ns * shortest_time(7, repeats, [&] { stage.run(loaded); });
        const double floor = 1e9 * std::max(stage.operations / operations, stage.bytes / bytes);
        row(stage.name, ns, ns / step, stage.operations, stage.bytes, floor);
        all_operations += stage.operations;
        all_bytes += stage.bytes;
        all_floors += floor;
    }
    row("step", step, 1, all_operations, all_bytes, all_floors);
}

int run(int argc, char** argv) {
    if (argc < 2 || argc > 3 || (argc == 3 && std::string_view(argv[2]) != "selective")) {
        throw UsageError("whole_run SPECIMEN [selective] fits");
    }
    LoadedSpecimen loaded(read_specimen(H5Input(argv[1], "specimen")), LawVariant::consistent, argc == 3, widest_vector_target());
    print_table(loaded);
    return 0;
}

}  // namespace
}  // namespace graincrack::benchmark

int main(int argc, char** argv) {
    return graincrack::run_tool("whole_run", [&] { return graincrack::benchmark::run(argc, argv); });
}
