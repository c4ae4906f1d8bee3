#include "share/rock/test_kind.hpp"

#include <algorithm>

namespace graincrack {

const std::vector<TestDescription>& all_tests() {
    constexpr auto stress = PlaneCondition::stress;
    constexpr auto strain = PlaneCondition::strain;
    // Fractions measured with augig-granite-triangles: uniaxial 1/69, 1/63 (280 grains), 1/59 (twice the tolerance), 1/71 (masses
    // as they are); triaxial at 8 MPa 1/15; at the tolerance 0.0015 direct tension 1/616, Brazilian 1/502. With augig-granite:
    // bending of four beams and two half-discs 1/53 to 1/94. Tolerances by what the load rises by in a transit at the peak:
    // direct tension of augig-granite-calibrated 0.6 to 1.0 % at 0.0015, 0.2 to 0.4 % at 0.0005, with strengths lower by
    // 1.1 ± 0.3 % (8 pairs); its discs 0.1 to 0.2 % at 0.0015, half of that at 0.00075, with strengths lower by 0.1 ± 0.9 % (8
    // pairs); discs of a gabbro 0.4 to 0.6 % at 0.0015, with strengths higher by
    // 2.6 ± 1.1 % than at 0.000375, at 0.00075 by 0.9 ± 0.4 % (10 pairs).
    using L = Loading;
    // clang-format off
    static const std::vector<TestDescription> tests{
        {TestKind::uniaxial, "uniaxial", "compression between platens",
         "Uniaxial compression", "uniaxial", L::compression, {}, strain, false, 1 / 65.0},
        {TestKind::triaxial, "triaxial", "compression between platens under confining pressure",
         "Compression", "triaxial", L::compression, {}, strain, true, 1 / 15.0},
        {TestKind::brazilian, "brazilian", "compression of a disc between platens",
         "Brazilian test", "Brazilian", L::splitting, {"disc", "ring"}, stress, false, 1 / 260.0, 0.75e-3},
        {TestKind::tension, "tension", "direct tension between bonded platens",
         "Direct tension", "direct tension", L::tension, {}, strain, false, 1 / 350.0, 0.5e-3},
        {TestKind::bend, "bend", "bending of a beam or a half-disc on three rollers",
         "Three-point bending", "bending", L::bending, {"beam", "half-disc"}, strain, false, 1 / 75.0, 1.5e-3},
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

std::vector<std::string_view> all_shapes() {
    std::vector<std::string_view> shapes{"rectangle"};
    for (const TestDescription& test : all_tests()) shapes.insert(shapes.end(), test.shapes.begin(), test.shapes.end());
    shapes.emplace_back("polygon");
    return shapes;
}

}  // namespace graincrack
