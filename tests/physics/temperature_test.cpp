// Minerals that expand by different amounts, where the answer is known: free, clamped, around an inclusion, in a strip, in a
// ring, between ends; crystals that expand along their axis by another amount than across it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "share/file/fabric.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/linear_statics.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

constexpr double warmer = 100;  // K
const Phase mineral{60e9, 0.25, 2600, 8e-6};
/// Hooke's stress of strain that cannot happen, E α ΔT.
const double hindered = mineral.young_modulus * mineral.thermal_expansion * warmer;

SmallRun warm_run(PlaneCondition plane) {
    SmallRun run(jittered_grid(4, 5, 0.02, 0.03, 0.25), {mineral}, ContactLaws(augig_law()), plane);
    warm(run.assemblage, warmer, run.state);
    return run;
}

/// Strains a warm specimen as it expands freely and expects no stress but `pressure` across the plane, which does not strain.
void verify_free(SmallRun& run, const Tensor& strain, double pressure, double scale, const std::string& row) {
    for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
        const Vector2 x = run.assemblage.position[i];
        run.state.displacement[i] = {strain.xx * x.x + strain.xy * x.y, strain.xy * x.x + strain.yy * x.y};
    }
    for (std::int32_t e = 0; e < run.assemblage.n_elements(); ++e) {
        std::array<double, 4> stress = element_stress(run.assemblage, e, run.state);
        stress[3] += pressure;
        for (const double of_nothing : stress) verify(row, of_nothing / scale, 0, 1e-11, "no stress in the plane", 1);
    }
    run.begin();
    EXPECT_EQ(run.measured().energies.kinetic, 0);
    for (const Vector2& force : run.state.force) EXPECT_LT(length(force), 1e-12 * scale);
}

// A uniform strain α ΔT, (1 + ν) α ΔT in plane strain, leaves no stress in the plane, to round-off of E α ΔT.
TEST(Temperature, ExpandsAFreeMineralWithoutStress) {
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        SmallRun run = warm_run(plane);
        const bool is_strain = plane == PlaneCondition::strain;
        const double strain = (is_strain ? 1 + mineral.poisson_ratio : 1) * mineral.thermal_expansion * warmer;
        verify_free(run, {strain, strain, 0}, is_strain ? hindered : 0, hindered, "phases: free mineral, stress over E α ΔT");
    }
}

// −E α ΔT/(1 − 2ν) = −96 MPa in plane strain, −E α ΔT/(1 − ν) = −64 MPa in plane stress, to round-off.
TEST(Temperature, PressesAClampedMineral) {
    const SmallRun strain = warm_run(PlaneCondition::strain);
    const SmallRun stress = warm_run(PlaneCondition::stress);
    for (const std::size_t k : {0, 1, 3}) {
        verify("phases: clamped mineral in plane strain (MPa)", element_stress(strain.assemblage, 7, strain.state)[k] / MPa, -96,
               1e-12, "E α ΔT/(1 - 2 ν)");
        verify("phases: clamped mineral in plane stress (MPa)", element_stress(stress.assemblage, 7, stress.state)[k] / MPa,
               k == 3 ? 0 : -64, 1e-12, "E α ΔT/(1 - ν)", 64);
    }
}

// A solution by linear algebra, with contacts that hardly give way.
constexpr double little = 1e-6;  // K, so that displacements are small
const ContactLaw glue = joint_law(6e15, 6e15, 0);
const Phase feldspar{60e9, 0.32, 2600, 6e-6};
const Phase quartz{83.1e9, 0.17, 2650, 13e-6};

/// A specimen without supports at rest, a little warmer.
SmallRun warm_at_rest(Specimen specimen, const std::vector<Phase>& phases, PlaneCondition plane) {
    for (std::size_t p = 0; p < phases.size(); ++p) {
        specimen.phase_names.resize(phases.size(), "mineral");
        specimen.phase_names[p] += std::to_string(p);
        specimen.grain_phase[p] = static_cast<std::uint8_t>(p);
    }
    SmallRun run(std::move(specimen), phases, same_of_every_class(glue, phases.size()), plane);
    const Eigen::VectorXd u = equilibrium(run, tangent_stiffness(run), load_of_temperature(run, little));
    for (std::int32_t i = 0; i < run.assemblage.n_nodes(); ++i) run.state.displacement[i] = displacement_of(u, i);
    warm(run.assemblage, little, run.state);
    return run;
}
/// What of a phase counts in the plane: E, ν and α in plane stress; E/(1 − ν²), ν/(1 − ν) and (1 + ν) α in plane strain.
Phase in_plane(Phase p, PlaneCondition plane) {
    if (plane == PlaneCondition::stress) return p;
    const double nu = p.poisson_ratio;
    return {p.young_modulus / (1 - nu * nu), nu / (1 - nu), p.density, (1 + nu) * p.thermal_expansion};
}
/// What each halving of the elements leaves of an error: 1/4, as triangles of constant strain are of order 2.
void verify_halving(const std::string& name, const std::array<double, 3>& error) {
    for (const std::size_t m : {1, 2}) {
        verify_between("phases: error left by elements half as long, " + name, error[m] / error[m - 1], 0.2, 0.33, "1/4");
    }
}
/// Compares three meshes, each of elements half as long, with a closed form: also the value to which the last two lead by that
/// order.
void verify_limit(const std::string& name, const std::array<double, 3>& measured, double expected, const std::string& source) {
    verify("phases: " + name, (4 * measured[2] - measured[1]) / 3, expected, 1e-4, source + "; limit of fine meshes");
    verify_halving(name, {measured[0] - expected, measured[1] - expected, measured[2] - expected});
}

/// Rings of triangles around the origin from radius to radius; a ring is of the grain `grain_of_ring`, ascending from 0.
Specimen rings(int around, const std::vector<double>& radius, const std::function<int(int)>& grain_of_ring) {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    std::vector<int> grain;
    const bool has_centre = radius.front() == 0;
    const auto node = [&](int ring, int k) {
        return has_centre && ring == 0 ? 0 : (ring - has_centre) * around + has_centre + k % around;
    };
    for (int ring = 0; ring < static_cast<int>(radius.size()); ++ring) {
        for (int k = 0; k < (has_centre && ring == 0 ? 1 : around); ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            points.push_back({radius[ring] * std::cos(angle), radius[ring] * std::sin(angle)});
        }
        for (int k = 0; ring > 0 && k < around; ++k) {
            triangles.push_back({node(ring - 1, k), node(ring, k), node(ring, k + 1)});
            if (node(ring - 1, k) != node(ring - 1, k + 1)) {
                triangles.push_back({node(ring - 1, k), node(ring, k + 1), node(ring - 1, k + 1)});
            }
            grain.resize(triangles.size(), grain_of_ring(ring - 1));
        }
    }
    return specimen_of_grains(points, triangles, grain);
}

// Pressure of a round inclusion of radius 1 in a ring up to R:
//
//   p = Δα ΔT/[(1 + ν)/E + 2/(E (R² − 1)) + (1 − νi)/Ei]      i: of the inclusion; the second term is 0 in an endless plane
//
// With these minerals 7e-4/(1.32/60e9 + 0.83/83.1e9) = 21.883 MPa in an endless plane in plane stress, and with the values of
// `in_plane` (1.17 · 13 − 1.32 · 6) 1e-4/(1.4706/66.845e9 + 0.79518/85.573e9) = 23.296 MPa in plane strain, where α of both
// counts and not their difference alone.
TEST(Temperature, PressesARoundGrainOfQuartzInFeldspar) {
    for (const auto& [plane, endless] : {std::pair(PlaneCondition::stress, 21.883), {PlaneCondition::strain, 23.296}}) {
        const Phase inside = in_plane(quartz, plane);
        const Phase outside = in_plane(feldspar, plane);
        std::array<double, 3> pressure{};
        double expected = 0;
        for (const int fine : {1, 2, 4}) {
            std::vector<double> radius{0};
            for (int i = 1; i <= 3 * fine; ++i) radius.push_back(i / (3.0 * fine));
            for (int i = 1; i <= 15 * fine; ++i) radius.push_back(std::exp(0.2 * i / fine));
            const SmallRun run = warm_at_rest(rings(32 * fine, radius, [fine](int ring) { return ring < 3 * fine ? 0 : 1; }),
                                              {quartz, feldspar}, plane);
            const auto stress = element_stress(run.assemblage, 0, run.state);
            pressure[fine / 2] = -0.5 * (stress[0] + stress[1]) * (warmer / little) / MPa;
            const auto of_ring = [&](double outer) {
                return (inside.thermal_expansion - outside.thermal_expansion) * warmer / MPa /
                       ((1 + outside.poisson_ratio + 2 / (outer * outer - 1)) / outside.young_modulus +
                        (1 - inside.poisson_ratio) / inside.young_modulus);
            };
            EXPECT_NEAR(of_ring(1e6), endless, 1e-3);
            expected = of_ring(radius.back());
        }
        verify_limit("quartz, plane " + std::string(name_of(plane)) + " (MPa)", pressure, expected, "Lamé");
    }
}

// A strip of two layers of half its height h each bends (Timoshenko 1925, with m = 1):
//
//   κ h = 24 Δα ΔT/(14 + n + 1/n)      n = E1/E2
//
// With n = 83.1/60 and Δα = 7e-6 1.0430e-3 in plane stress; with the values of `in_plane` n = 85.573/66.845, Δα = 7.29e-6 and
// 1.0893e-3 in plane strain. Free ends disturb 3 h from them by e^(−4.2 · 3) = 3e-6.
TEST(Temperature, BendsAStripOfTwoLayers) {
    for (const auto& [plane, expected] : {std::pair(PlaneCondition::stress, 1.0430e-3), {PlaneCondition::strain, 1.0893e-3}}) {
        constexpr double h = 0.01;  // m
        std::array<double, 3> curvature{};
        for (const int fine : {1, 2, 4}) {
            const int across = 4 * fine;
            const SmallRun run =
                warm_at_rest(crossed_blocks(8 * across, across, 8 * h, h, [=](int, int j) { return 2 * j / across; }),
                             {feldspar, quartz}, plane);
            // Deflection of the lower side over the middle of the strip.
            const auto deflection = [&](double x) {
                const std::vector<Vector2>& p = run.assemblage.position;
                const auto at = std::min_element(p.begin(), p.end(), [x](const Vector2& a, const Vector2& b) {
                    return length(a - Vector2{x, -h / 2}) < length(b - Vector2{x, -h / 2});
                });
                return run.state.displacement[at - p.begin()].y;
            };
            curvature[fine / 2] = (2 * deflection(0) - deflection(h) - deflection(-h)) / h * (warmer / little);
        }
        verify_limit("strip, curvature times height, plane " + std::string(name_of(plane)), curvature, expected,
                     "Timoshenko (1925)");
    }
}

// A ring from a to b = 2 a that is warmer inside, as heat flows: ΔT ln(b/r)/ln(b/a). It is made of rings of phases, whose
// expansion stands for the temperature at their mean radius. In plane strain
//
//   σθ = E α ΔT/(2 (1 − ν) ln(b/a)) [1 − ln(b/r) − (1 + b²/r²) ln(b/a)/(b²/a² − 1)]
//
// With E α ΔT = 48 MPa, ν = 0.25 and ln 2 = 0.693147 the factor is 46.166 MPa; [] is 1 − 8/3 ln 2 = −0.848392 at a and
// 1 − 2/3 ln 2 = 0.537902 at b: −39.167 and 24.833 MPa. In plane stress there is no 1/(1 − ν): −29.375 and 18.625 MPa.
TEST(Temperature, PressesTheWarmInsideOfARing) {
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        const double factor = hindered / MPa / (2 * std::numbers::ln2) / (plane == PlaneCondition::strain ? 0.75 : 1);
        const std::string name = "phases: ring, plane " + std::string(name_of(plane));
        std::array<double, 3> worst{};
        for (const int fine : {1, 2, 4}) {
            const int n = 5 * fine;
            std::vector<double> radius{1};
            std::vector<double> middle;
            std::vector<Phase> phases;
            for (int i = 0; i < n; ++i) {
                radius.push_back(1 + (i + 1.0) / n);
                middle.push_back(1 + (i + 0.5) / n);
                phases.push_back(mineral);
                phases.back().thermal_expansion *= std::log2(2 / middle.back());
            }
            const SmallRun run = warm_at_rest(rings(48 * fine, radius, [](int ring) { return ring; }), phases, plane);
            std::vector<double> hoop(phases.size());  // means of the rings, MPa
            for (std::int32_t e = 0; e < run.assemblage.n_elements(); ++e) {
                const auto [i, j, k] = run.assemblage.element_nodes[e];
                const Vector2 centre = run.assemblage.position[i] + run.assemblage.position[j] + run.assemblage.position[k];
                const Vector2 r = (1 / length(centre)) * centre;
                const auto [xx, yy, xy, zz] = element_stress(run.assemblage, e, run.state);
                hoop[run.specimen.element_grain[static_cast<std::size_t>(e)]] +=
                    (xx * r.y * r.y + yy * r.x * r.x - 2 * xy * r.x * r.y) * (warmer / little) / MPa / (96 * fine);
            }
            for (std::size_t ring = 0; ring < hoop.size(); ++ring) {
                const double r = middle[ring];
                const double exact = factor * (1 - std::log(2 / r) - (1 + 4 / (r * r)) * std::numbers::ln2 / 3);
                double& error = worst[fine / 2];
                error = std::max(error, std::abs(hoop[ring] - exact) / factor);
            }
            if (fine < 4) continue;
            const auto at_end = [](double first, double second, double third) {  // of the parabola through three rings
                return (15 * first - 10 * second + 3 * third) / 8;
            };
            verify(name + ", inner side (MPa)", at_end(hoop[0], hoop[1], hoop[2]),
                   plane == PlaneCondition::strain ? -39.167 : -29.375, 2e-3, "Timoshenko & Goodier; 20 rings");
            verify(name + ", outer side (MPa)", at_end(hoop[n - 1], hoop[n - 2], hoop[n - 3]),
                   plane == PlaneCondition::strain ? 24.833 : 18.625, 2e-3, "Timoshenko & Goodier; 20 rings");
        }
        verify_halving("ring, plane " + std::string(name_of(plane)), worst);
    }
}

/// A bar of two minerals between ends that are a frame, which expands by `frame` (1/K) or not at all.
struct Pair {
    const char* what;
    double feldspar, quartz, frame;  ///< expansions, 1/K
    bool sides_are_held;             ///< nothing moves across the bar
};

// A bar of two halves of length L and height h between ends that a frame holds is cooled until its boundary cracks. What the
// halves contract more than the frame is taken by their stress σ and by the opening δ: Δ L T = σ L Σ1/E + δ, Δ = Σα − 2 α of the
// frame. (With a frame of one of the minerals Δ is the difference of their α; with one that stays as it is, their sum.) Before
// its peak the contact has σ = tc e^(1 − λ) δ/δct, λ² = (δ/δct)² + (s/δso)², where s is its sliding. A contact that is soft in
// shear slides freely: its ends by s = ½ Δα T h, with Δα of both minerals, since their contraction across differs. It cracks at
// λ = 1, hence where
//
//   1/T² = (Δ L/g)² + (½ Δα h/δso)²,   g = tc L Σ1/E + δct
//
// Where the sides are held nothing slides, and the second term is 0. A contact that is stiff in shear keeps free sides together,
// and its ends bear a shear for which there is no closed form: with those of Augig granite such a bar cracks from there, earlier.
TEST(Temperature, OpensAClampedPairOfMinerals) {
    constexpr double half = 0.05;  // m
    constexpr double height = 0.01;
    constexpr Pair pairs[] = {{"alike", 7e-6, 7e-6, 0, false},
                              {"sides held", 7e-6, 13e-6, 0, true},
                              {"sides held, in feldspar", 7e-6, 13e-6, 7e-6, true},
                              {"free sides", 7e-6, 13e-6, 0, false}};
    for (const Pair& pair : pairs) {
        const std::vector<Phase> phases{{60e9, 0, 2600, pair.feldspar}, {83.1e9, 0, 2650, pair.quartz}};
        const double difference = pair.sides_are_held ? 0 : pair.quartz - pair.feldspar;
        Specimen s = crossed_blocks(10, 1, 2 * half, height, [](int i, int) { return i / 5; });
        s.phase_names = {"feldspar", "quartz"};
        s.grain_phase = {0, 1};
        ContactParameters contact = augig_contact(PlaneCondition::stress);
        if (difference > 0) {
            contact.shear_stiffness = 0.01 * phases[0].young_modulus / height;
            contact.open_shear_strength = contact.shear_stiffness * 2.5e-6 / std::numbers::e;  // sliding of 2.5 µm
        }
        const ContactLaw law = make_contact_law(contact, LawVariant::consistent);
        const double per_second = -150 / 0.03;  // K/s
        ProgramRun bar(std::move(s),
                       "name = \"cool\"\nstages = [\"cool\"]\n" +
                           fmt::format("boundary.left = {{ on = \"left\", velocity_x = {} }}\nboundary.right = {{ on = "
                                       "\"right\", velocity_x = {} }}\n",
                                       -pair.frame * half * per_second, pair.frame * half * per_second) +
                           (pair.sides_are_held ? "boundary.sides = { on = [\"bottom\", \"top\"], velocity_y = 0 }\n" : "") +
                           "stage.cool.temperature = { times = [0, \"30 ms\"], values = [0, \"-150 K\"] }\n"
                           "stage.cool.until = { time = \"30 ms\", tensile_cracks = 1 }\n",
                       law, PlaneCondition::stress, 0.8, 0.5, augig_granite().rock, contact, 0, phases);
        bar.go(20);
        ASSERT_EQ(bar.stage_controller.records().front().ended_by, "tensile_cracks") << pair.what;
        const double gives_way = contact.tensile_strength * half * (1 / phases[0].young_modulus + 1 / phases[1].young_modulus) +
                                 contact.critical_opening;
        const double expected = -1 / std::hypot((pair.feldspar + pair.quartz - 2 * pair.frame) * half / gives_way,
                                                0.5 * difference * height * law.inv_dso);
        verify("phases: clamped pair, " + std::string(pair.what) + " (K)", bar[HistoryColumn::temperature].back(), expected,
               difference > 0 ? 5e-3 : 2e-3, "tc on its bars and its contact; waves of the cooling");
    }
}

// --- crystals that expand along their axis by another amount than across it -----------------------------------------------

constexpr double heated_by = 100;  // K
constexpr double along_axis = 7.7e-6, across_axis = 13.3e-6;
const Phase crystal{60e9, 0.25, 2650, along_axis, {{0, along_axis}}, {{0, across_axis}}};

/// Grains of one crystal. \param seed by which its axis is drawn
SmallRun warm_crystal(PlaneCondition plane, std::uint64_t seed) {
    Specimen s = jittered_grid(3, 4, 0.02, 0.03, 0.25);
    s.grain_crystal.assign(s.n_grains(), 0);
    s.seed = seed;
    SmallRun run(std::move(s), {crystal}, ContactLaws(augig_law()), plane);
    warm(run.assemblage, heated_by, run.state);
    return run;
}

// The free strain of an axis, turned, and ν times what is hindered across the plane: no stress in the plane, to round-off of E α
// ΔT.
TEST(CrystalExpansion, LeavesAFreeCrystalWithoutStressAtAnyAngle) {
    for (const PlaneCondition plane : {PlaneCondition::strain, PlaneCondition::stress}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            SmallRun run = warm_crystal(plane, seed);
            const double angle = crystal_axes(run.specimen).at(0);
            const double c = std::cos(angle), s = std::sin(angle);
            const double held = plane == PlaneCondition::strain ? crystal.poisson_ratio * across_axis : 0;
            const double xx = along_axis * c * c + across_axis * s * s + held,
                         yy = along_axis * s * s + across_axis * c * c + held;
            const double xy = (along_axis - across_axis) * c * s;
            const double across = crystal.young_modulus * across_axis * heated_by;
            verify_free(run, {heated_by * xx, heated_by * yy, heated_by * xy}, plane == PlaneCondition::strain ? across : 0,
                        across, "phases: free crystal with an axis, stress over E α ΔT");
        }
    }
}

// Clamped, λ = μ = 24 GPa: −(λ (a + 2 b) + 2 μ a) ΔT along the axis, −(λ (a + 2 b) + 2 μ b) ΔT across it; in plane stress with
// λ* = E ν/(1 − ν²) = 16 GPa and a + b. Turned by 30°.
TEST(CrystalExpansion, PressesAClampedCrystalByItsAxes) {
    const auto expect = [](PlaneCondition plane, const std::array<double, 4>& expected) {
        SmallRun run = warm_crystal(plane, 1);
        for (CrystalAxis& axis : run.assemblage.expansion.axis) axis = make_crystal_axis(std::numbers::pi / 6);
        const std::array<double, 4> stress = element_stress(run.assemblage, 7, run.state);
        for (std::size_t k = 0; k < 4; ++k) {
            verify("phases: clamped crystal, its axis at 30°, plane " + std::string(name_of(plane)) + " (MPa)", stress[k] / MPa,
                   expected[k], 1e-12, "Hooke's law of the free strain, turned", 100);
        }
    };
    expect(PlaneCondition::strain, {-126.0, -139.44, 13.44 * std::numbers::sqrt3 / 2, -146.16});
    expect(PlaneCondition::stress, {-77.28, -90.72, 13.44 * std::numbers::sqrt3 / 2, 0});
}

// χ² of 20 equal parts of [0, π), and the mean of exp 2iφ of crystals and of neighbours in number: four standard deviations of
// the mean of 10,000 uniform directions, √(1/2n) a component.
TEST(CrystalExpansion, DrawsUniformAxes) {
    constexpr std::size_t n = 10'000, parts = 20;
    Specimen s;
    s.grain_phase.assign(n, 0);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        s.seed = seed;
        const std::vector<double> angles = crystal_axes(s);
        ASSERT_EQ(angles.size(), n);
        std::array<double, parts> counts{};
        std::complex<double> mean, of_neighbours;
        for (std::size_t i = 0; i < n; ++i) {
            ++counts.at(static_cast<std::size_t>(parts * angles[i] / std::numbers::pi));
            mean += std::polar(1.0 / n, 2 * angles[i]);
            of_neighbours += std::polar(1.0 / n, 2 * (angles[i] - angles[(i + 1) % n]));
        }
        double chi_squared = 0;
        for (const double count : counts) chi_squared += (count - n / parts) * (count - n / parts) / (n / parts);
        verify_between("phases: χ² of the axes of crystals, 19 degrees of freedom", chi_squared, 5.41, 43.82, "0.1 and 99.9 %");
        for (const auto& sum : {mean, of_neighbours}) {
            verify("phases: mean direction of the axes of crystals", std::max(std::abs(sum.real()), std::abs(sum.imag())), 0,
                   4 / std::sqrt(2.0 * n), "none, to four standard deviations", 1);
        }
    }
    s.grain_crystal.assign(n, 0);
    s.grain_crystal.back() = 1;  // an axis a crystal, not a grain
    const std::vector<double> of_two = crystal_axes(s);
    EXPECT_TRUE(of_two[0] == of_two[n - 2] && of_two[0] != of_two[n - 1]);
}

// ∫α dT of 6e-6 at 0 and 14e-6 at 400 K, linear between and constant outside, and a modulus that falls to 0.6 on the way; clamped
// in plane stress, −f E ∫α dT/(1 − ν).
TEST(CrystalExpansion, FollowsCurvesOfTemperature) {
    Phase changing = crystal;
    changing.along = changing.across = {{0, 6e-6}, {400, 14e-6}};
    changing.softening = {{0, 1}, {400, 0.6}};
    SmallRun run(jittered_grid(3, 4, 0.02, 0.03, 0.25), {changing}, ContactLaws(augig_law()), PlaneCondition::stress);
    for (const auto& [kelvin, expected] : {std::array{300.0, -151.2}, {450.0, -225.6}, {-100.0, 48.0}}) {
        warm(run.assemblage, kelvin, run.state);
        verify("phases: clamped mineral that changes with temperature (MPa)",
               element_stress(run.assemblage, 7, run.state)[0] / MPa, expected, 1e-12, "f E ∫α dT/(1 - ν)");
    }
}

}  // namespace
}  // namespace graincrack::test
