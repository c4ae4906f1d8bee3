// Run files with a saved state, damaged in their names, types, shapes and values: all that is read of a run, and what a restart
// reads.
#include <filesystem>
#include <optional>

#include "share/file/h5_file.hpp"
#include "share/file/provenance.hpp"
#include "share/file/run_file.hpp"
#include "solver/program/standard_tests.hpp"
#include "solver/restart/saved_state.hpp"
#include "solver/run/simulation.hpp"
#include "solver/setup/setup.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/h5_edits.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"

namespace {

using namespace graincrack;

/// A run to 0.6 % strain, and what a restart asks.
struct Base {
    Base() : specimen(test::jittered_grid(3, 5, 0.02, 0.04, 0.2)) {
        request.material = test::augig_granite();
        request.contact = test::augig_contact();
        request.loading.rate = RateKind::fixed;
        request.loading.platen_speed = 1;
        request.loading.max_strain = 0.006;
        request.mass_scaling = true;
        request.save_state = true;
        request.frames = 2;
        simulate(specimen, request, file, Verbosity::quiet, {});
        setup.emplace(make_setup(specimen, request, program_of(request, specimen)));
    }
    Specimen specimen;
    SimulationRequest request;
    std::string file = fuzz::scratch_file("-base.h5");
    std::optional<Setup> setup;
};

void read_run(const std::string& file) {
    const RunReader run(file);
    fuzz::one_input([&] { static_cast<void>(run.specimen()); });
    fuzz::one_input([&] { static_cast<void>(run.history()); });
    fuzz::one_input([&] { static_cast<void>(run.cracks()); });
    fuzz::one_input([&] { static_cast<void>(run.frame_times()); });
    fuzz::one_input([&] {
        for (std::size_t frame = 0; frame < run.n_frames(); ++frame) static_cast<void>(run.frame(frame));
    });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const Base base;
    const std::string damaged = fuzz::scratch_file(".h5");
    fuzz::write_damaged(base.file, bytes, size, damaged);
    fuzz::one_input([&] { static_cast<void>(H5Input(damaged).digest()); });
    fuzz::one_input([&] { H5Input(damaged).check(); });
    fuzz::one_input([&] { read_run(damaged); });
    return fuzz::one_input([&] { read_saved_state(damaged, base.specimen, base.request, *base.setup); });
}
