// The same run with 1, 2 and 3 threads, past its peak: the same file, to the digest.
#include <gtest/gtest.h>

#include "share/h5_file.hpp"
#include "solver/simulation.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

SimulationRequest request(TestKind test, int threads) {
    SimulationRequest r;
    r.material = test::augig_granite();
    r.contact = test::augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i);
    r.loading.test = test;
    r.loading.platen_speed = test == TestKind::tension ? 0.3 : 1.0;
    r.loading.platen_friction = 5 * test::degree;
    r.loading.max_strain = 0.006;
    r.frames = 2;
    r.threads = threads;
    r.elements_per_thread = 1;
    return r;
}

// Small, so that the barriers show: a dozen blocks of grains and contacts for three threads.
const Specimen& specimen() {
    static const Specimen s = test::jittered_grid(8, 16, 0.04, 0.08, 0.25);
    return s;
}

std::string digest_of(const SimulationRequest& r, SimulationSummary& summary) {
    const test::TemporaryFolder folder;
    summary = simulate(specimen(), r, folder.file("run.h5"), Verbosity::quiet, {});
    return H5Input(folder.file("run.h5"), "run").digest();
}

TEST(Threads, OneTwoAndThreeGiveTheSameDigestPastThePeak) {
    SimulationSummary summary;
    const std::string first = digest_of(request(TestKind::tension, 1), summary);
    EXPECT_EQ(summary.header.stop_reason, "peak drop");
    EXPECT_GT(summary.tensile_cracks, 5U);
    EXPECT_GT(summary.header.steps, 1000);
    for (const int threads : {2, 3}) {
        EXPECT_EQ(digest_of(request(TestKind::tension, threads), summary), first) << threads << " threads";
    }
    // A run that differs has another digest.
    SimulationRequest other = request(TestKind::tension, 1);
    other.contact.tensile_strength *= 1.001;
    EXPECT_NE(digest_of(other, summary), first);
}

// Compression fails in both modes and rubs.
TEST(Threads, OneAndTwoGiveTheSameDigestThroughShearAndFriction) {
    SimulationSummary summary;
    const std::string first = digest_of(request(TestKind::uniaxial, 1), summary);
    EXPECT_GT(summary.tensile_cracks, 10U);
    EXPECT_GT(summary.shear_cracks, 10U);
    EXPECT_EQ(digest_of(request(TestKind::uniaxial, 2), summary), first);
}

// Damage before the peak is summed by lanes and blocks.
TEST(Threads, OneAndTwoGiveTheSameDigestWithDamageBeforeThePeak) {
    SimulationRequest damaged = request(TestKind::tension, 1);
    damaged.law = LawVariant::consistent;
    SimulationSummary summary;
    const std::string first = digest_of(damaged, summary);
    EXPECT_GT(summary.tensile_cracks, 5U);
    damaged.threads = 2;
    EXPECT_EQ(digest_of(damaged, summary), first);
}

}  // namespace
}  // namespace graincrack
