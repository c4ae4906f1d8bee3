// Fracture energy of specimens: a straight interface in tension, and the double cantilever, whose crack propagates when the
// energy release rate of bending is Gf.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

ContactLaw law_of(LawVariant variant, FractureEnergyChoice::Kind energy, double tensile_strength = 24.15e6) {
    Material material = augig_granite();
    material.contact.tensile_strength = tensile_strength;
    return make_contact_law(contact_parameters(material, PlaneCondition::stress, FractureEnergyChoice{energy, 0}), variant);
}

// --- a straight interface pulled apart by bonded platens -------------------------------------------------------------------

// External work − stored energy − kinetic energy − energy absorbed by damping = Gf A, both where separation is stable (mixed-mode
// energy: the blocks are stiffer than the softening branch) and where it is unstable (mode-I energy): to 1 %; the strength is tc,
// to the oscillations at this rate.
TEST(Fracture, TakesItsEnergyOnAStraightInterface) {
    for (const LawVariant variant : {LawVariant::literal, LawVariant::consistent}) {
        for (const auto kind : {FractureEnergyChoice::Kind::mixed, FractureEnergyChoice::Kind::mode_i}) {
            const ContactLaw law = law_of(variant, kind);
            SmallRun run(crossed_blocks(8, 4, 0.02, 0.01, [](int, int j) { return j < 2 ? 0 : 1; }), law, PlaneCondition::stress);
            run.load_by({.test = TestKind::tension}, 0.5, contact_parameters(augig_granite(), PlaneCondition::stress, {}));
            run.parameters.damping = 0.8;
            run.begin();
            const double speed = 5e-3;
            run.steps(2000, {{}, {-speed, speed}, nullptr});
            double largest = 0;
            // until each platen has moved as far as the interface opens and the blocks elongate together
            const double far = law.dut + 0.01 * law.tc / 25.8e9;
            while (run.state.loading.platen_displacement[top_platen] < far) {
                run.steps(200, {{-speed, speed}, {-speed, speed}, nullptr});
                largest = std::max(largest, run.measured().force_top);
            }
            const Energies e = run.measured().energies;
            const double area = 0.02;
            const std::string name =
                std::string(name_of(variant)) + (kind == FractureEnergyChoice::Kind::mixed ? ", mixed" : ", mode I");
            verify("specimens: straight interface, work less elastic, kinetic and damping, " + name + " (J/m2)",
                   (e.external - e.strain - e.kinetic - e.damping - e.platen - e.contact) / area, law.gf, 0.01, "Gf");
            verify_between("specimens: straight interface, strength over tc", largest / area / law.tc, 0.98, 1.02,
                           "tc; oscillations at this rate are 1 %");
            for (std::size_t point = 0; point < run.state.failed.size(); ++point) EXPECT_TRUE(run.state.points[point].separated);
        }
    }
}

// --- double cantilever ---------------------------------------------------------------------------------------------------

constexpr double h = 0.01;                 // height of an arm, m
constexpr int cells_of_arm = 8;            // of four triangles, over the height of an arm
constexpr double cell = h / cells_of_arm;  // m
constexpr double width = 2 * cell;         // of the loaded part of a face
constexpr double small = 1e-3 * cell;

/// Two arms of solid grain on an interface that is cut open from the left end to `cut` (m from it). Pressure acts on the arms'
/// inner faces at the end and, where `couple` is not 0, against that on their outer faces `couple` farther in: a pure moment on
/// the rest of the arms.
struct Cantilever {
    SmallRun run;
    LinearPressure pressure;

    Cantilever(const ContactLaw& law, double length, double cut, double couple)
        : run(specimen(length, cut, couple), law, PlaneCondition::stress) {
        std::vector<BoundaryPart> pressed;
        for (std::size_t part = 5; part < run.specimen.part_names.size(); ++part) {
            pressed.push_back(static_cast<BoundaryPart>(part));
        }
        run.press_on(pressed, 0.7);
        run.parameters.damping = 0.8;
        run.begin();
    }
    static Specimen specimen(double length, double cut, double couple) {
        Specimen s = crossed_blocks(static_cast<int>(std::lround(length / cell)), 2 * cells_of_arm, length, 2 * h,
                                    [](int, int j) { return j < cells_of_arm ? 0 : 1; });
        const auto within = [length](double x, double from, double to) {
            return x > -length / 2 + from - small && x < -length / 2 + to + small;
        };
        cut_contacts(s, [&](double x, double) { return within(x, 0, cut); });
        name_boundary(s, "inner", [&](double x, double y) { return within(x, 0, width) && std::abs(y) < small; });
        if (couple > 0) {
            name_boundary(s, "outer",
                          [&](double x, double y) { return within(x, couple, couple + width) && std::abs(y) > h - small; });
        }
        return s;
    }
    [[nodiscard]] std::size_t separated() const {
        std::size_t count = 0;
        for (std::size_t point = 0; point < run.state.failed.size(); ++point) count += run.state.points[point].separated ? 1 : 0;
        return count;
    }
    /// Length of the interface that has failed and not separated, m.
    [[nodiscard]] double zone() const { return 0.5 * cell * static_cast<double>(run.failed_points() - separated()); }

    /// Pressure at which the first point separates. It grows to 0.85 of `expected` in a third of the `duration`, and then more
    /// slowly than the arms oscillate.
    double pressure_at_first_separation(double expected, double duration) {
        constexpr int interval = 50;
        while (separated() == 0 && pressure.present() < 1.3 * expected) {
            const double rate = (pressure.present() < 0.85 * expected ? 0.85 * 3 : 0.15 * 1.5) * expected / duration;
            run.steps_under(pressure, pressure.present() + rate * interval * run.parameters.time_step, interval);
        }
        return pressure.present();
    }
    /// Number of points that separate within `duration` under constant pressure.
    std::size_t separated_under(double constant, double duration) {
        const std::size_t before = separated();
        pressure.set(constant);
        run.steps_under(pressure, constant, static_cast<std::int64_t>(duration / run.parameters.time_step));
        return separated() - before;
    }
};

ContactLaw mixed_law(double tensile_strength) {
    return law_of(LawVariant::consistent, FractureEnergyChoice::Kind::mixed, tensile_strength);
}
/// Mc = t √(Gf E h³/12), 968 N: the moment at which J = M²/(E I) of both arms is Gf.
double critical_moment(const ContactLaw& law) { return std::sqrt(law.gf * 25.8e9 * h * h * h / 12); }

// The J integral is the area under the traction at the notch: Gf when the point at the notch separates, for any length of the
// zone: at Mc = √(Gf E h³/12), to 2 %.
TEST(Fracture, OpensADoubleCantileverUnderEndMoments) {
    const double couple = h;
    double longest = 0;
    for (const double tensile_strength : {12e6, 24.15e6}) {
        const ContactLaw law = mixed_law(tensile_strength);
        Cantilever dcb(law, 0.0675, couple + width + h, couple);
        const double expected = critical_moment(law);
        EXPECT_NEAR(expected, 968, 1);
        const double pressure = expected / (width * couple);
        const std::string strength = fmt::format(" at tc = {} MPa", tensile_strength * 1e-6);
        verify("specimens: double cantilever, end moments" + strength + " (N)",
               dcb.pressure_at_first_separation(pressure, 3e-3) * width * couple, expected, 0.02, "sqrt(Gf E h^3/12)");
        EXPECT_GT(dcb.zone(), 3 * cell);  // resolved
        EXPECT_TRUE(longest == 0 || dcb.zone() < 0.7 * longest);
        longest = std::max(longest, dcb.zone());
        EXPECT_GT(dcb.separated_under(1.1 * pressure, 5e-4), 5U);  // the crack propagates
    }
}

// P (a + 0.64 h) = Mc, since the root of the arms rotates: 11,200 N at a = 80 mm, for a short zone; to 10 %.
TEST(Fracture, OpensADoubleCantileverUnderForces) {
    const double a = 0.08;
    const ContactLaw law = mixed_law(40e6);
    Cantilever dcb(law, 0.11, a + width / 2, 0);
    const double expected = critical_moment(law) / (a + 0.64 * h);
    EXPECT_NEAR(expected, 11200, 50);
    verify("specimens: double cantilever, forces at a = 80 mm (N)",
           dcb.pressure_at_first_separation(expected / width, 6e-3) * width, expected, 0.1, "Mc/(a + 0.64 h)");
    verify_between("specimens: double cantilever, zone under forces over h", dcb.zone() / h, cell / h, 0.5,
                   "short, and resolved");
    EXPECT_GT(dcb.separated_under(1.1 * expected / width, 2e-3), 5U);  // the crack propagates
}

}  // namespace
}  // namespace graincrack::test
