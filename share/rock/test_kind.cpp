#include "share/rock/test_kind.hpp"

#include <algorithm>

namespace graincrack {

const std::vector<TestDescription>& all_tests() {
    constexpr auto stress = PlaneCondition::stress;
    constexpr auto strain = PlaneCondition::strain;
    // Fractions: means of logarithms over three seeds each of augig-granite-calibrated, lac-du-bonnet-granite-calibrated and
    // augig-granite-triangles, rectangles of 30 × 60 mm: uniaxial 1/34 to 1/57; at 8 MPa 1/17 to 1/57; direct tension 1/1006 to
    // 1/1955, of triangles 1/126 to 1/228; beams of 100 × 20 mm 1/109 to 1/178, half-discs of 50 mm with a slit 1/12 to 1/111;
    // 18 discs of 40 and 68 mm of five rocks 1/22 to 1/980. Tolerances by what the load rises by in a transit at the peak:
    // direct tension of augig-granite-calibrated 0.6 to 1.0 % at 0.0015, 0.2 to 0.4 % at 0.0005, strengths lower by 1.1 ± 0.3 %
    // (8 pairs); its discs 0.1 to 0.2 % at 0.0015, half of that at 0.00075, strengths lower by 0.1 ± 0.9 % (8 pairs); discs of
    // a gabbro 0.4 to 0.6 % at 0.0015, strengths higher by 2.6 ± 1.1 % than at 0.000375, at 0.00075 by 0.9 ± 0.4 % (10 pairs).
    using L = Loading;
    // clang-format off
    static const std::vector<TestDescription> tests{
        {TestKind::uniaxial, "uniaxial", "compression between platens",
         "Uniaxial compression", "uniaxial", L::compression, {}, strain, false, 1 / 60.0},
        {TestKind::triaxial, "triaxial", "compression between platens under confining pressure",
         "Compression", "triaxial", L::compression, {}, strain, true, 1 / 42.0},
        {TestKind::brazilian, "brazilian", "compression of a disc between platens",
         "Brazilian test", "Brazilian", L::splitting, {"disc", "ring"}, stress, false, 1 / 600.0, 0.75e-3},
        {TestKind::tension, "tension", "direct tension between bonded platens",
         "Direct tension", "direct tension", L::tension, {}, strain, false, 1 / 1600.0, 0.5e-3},
        {TestKind::bend, "bend", "bending of a beam or a half-disc on three rollers",
         "Three-point bending", "bending", L::bending, {"beam", "half-disc"}, strain, false, 1 / 90.0, 1.5e-3},
        {TestKind::program, "program", "a loading program from a file: stages, boundary conditions, gravity, probes",
         "program", "program", L::program}};
    // clang-format on
    return tests;
}

const TestDescription& description_of(TestKind kind) { return all_tests()[static_cast<std::size_t>(kind)]; }

const TestDescription& test_named(std::string_view name) {
    const auto& tests = all_tests();
    const auto found = std::find_if(tests.begin(), tests.end(), [&](const TestDescription& t) { return t.name == name; });
    return found == tests.end() ? tests.back() : *found;
}

}  // namespace graincrack
