// Loads on parts of a round outline, and supports of single nodes: resultant, moment and work by closed form, symmetry, and the
// strain of a disc under a pressure that varies round it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/check.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

using std::numbers::pi;

constexpr double outline_radius = 0.04;
constexpr int sectors = 48;

/// A disc of one grain: rings of cells of two triangles about a fan, alike under a quarter turn.
Specimen polar_disc(int rings) {
    std::vector<Point> points{{0, 0}};
    for (int i = 1; i <= rings; ++i) {
        for (int k = 0; k < sectors; ++k) {
            const double r = outline_radius * i / rings;
            points.push_back({r * std::cos(2 * pi * k / sectors), r * std::sin(2 * pi * k / sectors)});
        }
    }
    std::vector<Triangle> triangles;
    const auto at = [](int ring, int k) { return 1 + (ring - 1) * sectors + k % sectors; };
    for (int k = 0; k < sectors; ++k) {
        triangles.push_back({0, at(1, k), at(1, k + 1)});
        for (int i = 1; i < rings; ++i) {
            triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return specimen_of_grains(points, triangles, std::vector<int>(triangles.size(), 0));
}

ProgramRun run_of(const std::string& conditions, const std::string& until, double damping, int rings = 4) {
    ProgramRun run(polar_disc(rings),
                   "name = \"loads\"\nstages = [\"load\"]\n" + conditions + "\n[stage.load]\nuntil = { " + until + " }\n",
                   augig_law(), PlaneCondition::strain, damping);
    run.go(20);
    return run;
}

/// Moment of the loads of the last step about the origin, N.
double moment_of(const ProgramRun& run) {
    double moment = 0;
    for (const LoadedEnd& end : run.run.boundary.prescribed.ends) {
        const Vector2 at = run.run.assemblage.position[end.node] + run.run.state.displacement[end.node];
        const Vector2 load = run.run.state.prescribed.load[end.edge];
        moment += at.x * load.y - at.y * load.x;
    }
    return moment;
}

/// Twice the area that the outline encloses, m².
double twice_area(const ProgramRun& run) {
    double area = 0;
    for (const LoadedEdge& edge : run.run.boundary.prescribed.edges) {
        const auto place = [&](std::int32_t i) { return run.run.assemblage.position[i] + run.run.state.displacement[i]; };
        const Vector2 from = place(edge.nodes[0]);
        const Vector2 to = place(edge.nodes[1]);
        area += from.x * to.y - from.y * to.x;
    }
    return area;
}

/// Where the corner of the outline at an angle (degrees) is now.
Vector2 outline_at(const ProgramRun& run, double angle) {
    const Vector2 corner{outline_radius * std::cos(angle * degree), outline_radius * std::sin(angle * degree)};
    std::int32_t nearest = 0;
    for (std::int32_t i = 0; i < run.run.assemblage.n_nodes(); ++i) {
        if (length(run.run.assemblage.position[i] - corner) < length(run.run.assemblage.position[nearest] - corner)) nearest = i;
    }
    return run.run.assemblage.position[nearest] + run.run.state.displacement[nearest];
}

// On a polygon both follow from the ends of the part: p times the chord turned inwards, and the shear along the chord.
TEST(OutlineLoads, HaveTheResultantAndTheMomentOfTheirChord) {
    const ProgramRun run = run_of(R"(
        boundary.pad = { angles = ["-30 deg", "30 deg"], pressure = "3 MPa" }
        boundary.brush = { angles = ["60 deg", "150 deg"], shear = "2 MPa" }
        boundary.twist = { angles = ["165 deg", "195 deg"], shear = "1 MPa" }
    )",
                                  "time = \"0.1 us\"", 0);
    EXPECT_EQ(run.run.boundary.prescribed.edges.size(), 8U + 12U + 4U);
    const auto expect_force = [&](const char* name, const Vector2& expected) {
        expect_close(run.column(name, "force_x").back(), expected.x, 1e-12, 1e6 * outline_radius);
        expect_close(run.column(name, "force_y").back(), expected.y, 1e-12, 1e6 * outline_radius);
    };
    const Vector2 chord = outline_at(run, 30) - outline_at(run, -30);
    EXPECT_GT(chord.y, 0.99 * outline_radius);
    expect_force("pad", 3e6 * Vector2{-chord.y, chord.x});
    expect_force("brush", 2e6 * (outline_at(run, 150) - outline_at(run, 60)));
    expect_force("twist", 1e6 * (outline_at(run, 195) - outline_at(run, 165)));
    // Twice the area between a part and the middle, per edge: the arm of the shear is the apothem. The pressure has none.
    const double of_edge = outline_radius * outline_radius * std::sin(2 * pi / sectors);
    expect_close(moment_of(run), (12 * 2e6 + 4 * 1e6) * of_edge, 1e-4, 1e6 * of_edge);  // but for the motion of 0.1 us
}

// A constant pressure all round has the potential p A, whose steps are booked exactly but for the last half.
TEST(OutlineLoads, DoTheWorkOfPressureTimesArea) {
    for (const double damping : {0.0, 0.8}) {
        const ProgramRun run =
            run_of(R"(boundary.all = { angles = ["-180 deg", "180 deg"], pressure = "3 MPa" })", "time = \"15 us\"", damping);
        ASSERT_EQ(run.run.boundary.prescribed.edges.size(), static_cast<std::size_t>(sectors));
        const double before = outline_radius * outline_radius * sectors * std::sin(2 * pi / sectors);
        const double work = 3e6 * 0.5 * (before - twice_area(run));
        EXPECT_GT(work, 0);
        expect_close(run.energies.back().external, work, 1e-3, work);
        EXPECT_LT(run.residual(), 1e-3);
    }
}

// Two pads opposite, and the same turned by a quarter: what is told is turned. The body stays where it is, to rounding without
// damping, whose sign of noise at rest is noise.
TEST(OutlineLoads, OnOppositePartsDoNotMoveTheBodyAndTurnWithIt) {
    const auto squeezed = [](int turn, double damping) {
        const auto pad = [&](const char* name, int from) {
            return fmt::format(R"(boundary.{} = {{ angles = ["{} deg", "{} deg"], pressure = {{ to = "5 MPa", over = "20 us" }} }}
)",
                               name, from + turn, from + turn + 60);
        };
        return run_of(pad("a", -30) + pad("b", 150) + R"(
            probe.x.circle = ["20 mm", 0, "8 mm"]
            probe.y.circle = [0, "20 mm", "8 mm"]
            probe.edge.point = [0, "-39 mm"]
        )",
                      damping > 0 ? "time = \"1 ms\", rest = 1e-6" : "time = \"40 us\"", damping);
    };
    const ProgramRun one = squeezed(0, 0.8);
    const ProgramRun turned = squeezed(90, 0.8);
    const ProgramRun swinging = squeezed(0, 0);
    ASSERT_EQ(one.stage_controller.records().at(0).ended_by, "rest");
    const double moved = std::abs(one.column("edge", "displacement_y").back());
    EXPECT_GT(moved, 1e-7);
    expect_close(length(swinging.run.mean(swinging.run.state.displacement)), 0, 1e-12, moved);
    expect_close(length(one.run.mean(one.run.state.displacement)), 0, 2e-3, moved);
    const auto last = [](const ProgramRun& run, const char* probe, const char* column) {
        return run.column(probe, column).back();
    };
    const double stress = std::abs(last(one, "x", "stress_xx"));
    EXPECT_GT(stress, 1e6);
    expect_close(last(turned, "y", "stress_yy"), last(one, "x", "stress_xx"), 1e-6, stress);
    expect_close(last(turned, "x", "stress_xx"), last(one, "y", "stress_yy"), 1e-6, stress);
    expect_close(last(turned, "x", "stress_yy"), last(one, "y", "stress_xx"), 1e-6, stress);
}

// Held at two nodes as a beam is: they bear what the loads leave, one force and its moment. Balanced loads leave nothing.
TEST(OutlineLoads, LeaveTheirSupportsWhatIsNotBalanced) {
    const std::string supports = R"(
        boundary.foot = { at = [0, "-41 mm"], velocity_x = 0, velocity_y = 0 }
        boundary.side = { at = ["-40 mm", 0], velocity_x = 0 }
    )";
    const ProgramRun pushed = run_of(supports + R"(
        boundary.pad = { angles = ["-30 deg", "30 deg"], pressure = { to = "1 MPa", over = "20 us" } })",
                                     "time = \"2 ms\", rest = 1e-8", 0.8);
    ASSERT_EQ(pushed.run.boundary.prescribed.nodes.size(), 2U);
    const double force = 1e6 * outline_radius;  // towards −x, whose line passes the middle: so the side bears all of it
    expect_close(pushed.column("side", "force_x").back(), force, 1e-3, force);
    expect_close(pushed.column("foot", "force_x").back(), 0, 1e-3, force);
    const ProgramRun squeezed = run_of(supports + R"(
        boundary.all = { angles = ["0 deg", "360 deg"], pressure = { to = "1 MPa", over = "20 us" } })",
                                       "time = \"2 ms\", rest = 1e-8", 0.8);
    for (const char* name : {"foot", "side"}) {
        for (const char* column : {"force_x", "force_y"}) expect_close(squeezed.column(name, column).back(), 0, 1e-4, force);
    }
}

// p0 + p2 cos 2θ + p4 cos 4θ normal to a disc: εv = −2 (1 + ν)(1 − 2 ν)/E Σ (r/R)^n pn cos nθ (harmonic extension of p). The
// mean stress of the elements in a circle is that in its middle, since σxx + σyy is harmonic.
TEST(OutlineLoads, StrainADiscAsAPressureThatVariesRoundIt) {
    constexpr double p0 = 5e6, p2 = 3e6, p4 = 1e6;
    std::string conditions;
    for (int k = 0; k < sectors; ++k) {
        const double angle = (k + 0.5) * 2 * pi / sectors;
        const double p = p0 + p2 * std::cos(2 * angle) + p4 * std::cos(4 * angle);
        conditions +=
            fmt::format("boundary.p{} = {{ angles = [\"{} deg\", \"{} deg\"], pressure = {{ to = {}, over = \"20 us\" }} }}\n", k,
                        k * 7.5, (k + 1) * 7.5, p);
    }
    conditions += "probe.q = { ring = [0, 0, \"24 mm\"], points = 16, reach = \"5 mm\" }\n";  // .6 R
    const ProgramRun run = run_of(conditions, "time = \"2 ms\", rest = 1e-6", 0.8, 16);
    const Rock rock = augig_granite().rock;
    const double plane = (1 + rock.poisson_ratio) * (1 - 2 * rock.poisson_ratio) / rock.young_modulus;
    const double shear = rock.young_modulus / (1 + rock.poisson_ratio);
    for (int k = 0; k < 16; ++k) {
        const double angle = k * pi / 8;
        const auto of = [&](const char* column) { return run.column(fmt::format("q.{:03}", k), column).back(); };
        const double expected =
            -2 * plane * (p0 + p2 * std::pow(0.6, 2) * std::cos(2 * angle) + p4 * std::pow(0.6, 4) * std::cos(4 * angle));
        verify("elements: disc under p0 + p2 cos 2t + p4 cos 4t, volumetric strain at .6 R (1e-4)", 1e4 * of("volumetric_strain"),
               1e4 * expected, 0.01, "harmonic extension of p", 1e4 * 2 * plane * p0);
        expect_close(of("angle"), angle, 1e-15, pi);
        // Strain and stress are of the same elements; they differ by the rotation, of the size of the strain.
        expect_close(plane * (of("stress_xx") + of("stress_yy")), of("volumetric_strain"), 1e-6, 2 * plane * p0);
        expect_close(shear * (of("strain_xx") - of("strain_yy")), of("stress_xx") - of("stress_yy"), 1e-3, p0);
        expect_close(shear * of("strain_xy"), of("stress_xy"), 1e-3, p0);
    }
}

}  // namespace
}  // namespace graincrack::test
