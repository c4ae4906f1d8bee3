// The same run with 1, 2 and 3 threads, past its peak: the same file, to the digest.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "share/file/h5_file.hpp"
#include "solver/run/simulation.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/crystals.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/specimens.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::test {
namespace {

// Small, so that the barriers show: a dozen chunks of grains and contacts for three threads.
const Specimen& specimen() {
    static const Specimen s = jittered_grid(8, 16, 0.04, 0.08, 0.25);
    return s;
}

std::string digest_of(const SimulationRequest& r, SimulationSummary& summary, const Specimen& s = specimen()) {
    const TemporaryFolder folder;
    summary = simulate(s, r, folder.file("run.h5"), Verbosity::quiet, {});
    return H5Input(folder.file("run.h5"), "run").digest();
}

// Tension past the peak; compression, which fails in both modes and rubs, of real masses and scaled ones; crystals that break
// within and between, and slide on a flaw with values of its own; three phases with contacts of a pair and strengths that
// scatter.
TEST(Threads, GiveTheSameDigestByAnyNumber) {
    struct Row {
        const char* name;
        TestKind test;
        bool mass_scaling;
        Material material;
        Specimen specimen;
    };
    const std::vector<Row> rows{{"tension", TestKind::tension, false, augig_granite(), specimen()},
                                {"real masses", TestKind::uniaxial, false, augig_granite(), specimen()},
                                {"scaled masses", TestKind::uniaxial, true, augig_granite(), specimen()},
                                {"crystals", TestKind::uniaxial, false, granite_with_flaw(), crystals_with_flaw()},
                                {"phases", TestKind::uniaxial, false, granite_of_phases(), varied_phases(specimen()).specimen}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.name);
        SimulationRequest r = augig_request(row.test, row.test == TestKind::tension ? 0.3 : 1, 0.006);
        r.frames = 2;
        r.threads = 1;
        r.mass_scaling = row.mass_scaling;
        r.material = row.material;
        SimulationSummary summary;
        const std::string first = digest_of(r, summary, row.specimen);
        EXPECT_GT(summary.cracks.tensile, 5U);
        EXPECT_TRUE(row.test == TestKind::tension || summary.cracks.shear > 3);
        EXPECT_EQ(summary.header.mass_scaling_factor > 10, row.mass_scaling);
        for (const int threads : {2, 3}) {
            r.threads = threads;
            EXPECT_EQ(digest_of(r, summary, row.specimen), first) << threads;
        }
        // A run that differs has another digest.
        r.damping *= 0.999;
        EXPECT_NE(digest_of(r, summary, row.specimen), first);
    }
}

/// A specimen crushed until grains come into contact that were not neighbours.
SmallRun crushed(LawVariant law, double mass_scaling_factor, VectorTarget target, int threads, bool has_phases = false) {
    SmallRun run = has_phases ? varied_phases(specimen()).run(law) : SmallRun(specimen(), augig_law(law));
    run.assemblage.vector_target = target;
    run.parameters.damping = 0.8;
    run.parameters.mass_scaling = make_mass_scaling(run.assemblage, mass_scaling_factor);
    run.load_by({.platen_friction = 0.1, .max_strain = 0.05}, 0.7);
    run.begin();
    constexpr double speed = 2;  // m/s
    run.steps(mass_scaling_factor > 0 ? 1200 : 12000, {{speed, -speed}, {speed, -speed}, nullptr}, threads);
    return run;
}
/// The events of a run, none of which has been collected.
auto events_of(const SmallRun& run) {
    std::vector<std::tuple<std::int64_t, std::int32_t, std::uint8_t, ContactEventKind, double, double>> events;
    for (const std::vector<ContactEvent>& chunk : run.state.events) {
        for (const ContactEvent& e : chunk) {
            events.emplace_back(e.step, e.contact, e.point, e.kind, e.motion.opening, e.motion.sliding);
        }
    }
    return events;
}
bool same(const SmallRun& l, const SmallRun& r) {
    const auto bytes = [](const std::vector<Vector2>& v) {
        return std::string(reinterpret_cast<const char*>(v.data()), v.size() * sizeof(Vector2));
    };
    return bytes(l.state.displacement) == bytes(r.state.displacement) && bytes(l.state.velocity) == bytes(r.state.velocity) &&
           l.state.opening == r.state.opening && l.state.integrity == r.state.integrity && l.state.slip == r.state.slip &&
           l.state.next_level == r.state.next_level && events_of(l) == events_of(r);
}

// Stronger than what the design asks for (1e-9): no target contracts or reorders anything. With six classes of contacts, from
// which node–edge contacts take their values too.
TEST(Threads, LeaveTheBytesOfEveryLawOnEveryVectorUnit) {
    for (const LawDescription& law : all_contact_laws()) {
        for (const bool has_phases : {false, true}) {
            SCOPED_TRACE(law.name);
            const SmallRun plain = crushed(law.variant, 60, VectorTarget::plain, 1, has_phases);
            EXPECT_GT(plain.failed_points(), 20U);
            const auto& contacts = plain.state.contact_pairs.contacts;
            EXPECT_GT(std::count_if(contacts.begin(), contacts.end(), [](const NodeEdgeContact& c) { return c.active; }), 5);
            int threads = 0;
            for (const VectorTarget target : available_vector_targets()) {
                threads = threads % 3 + 1;
                EXPECT_TRUE(same(plain, crushed(law.variant, 60, target, threads, has_phases))) << name_of(target) << threads;
            }
        }
    }
}

}  // namespace
}  // namespace graincrack::test
