// Grains and contacts of several phases: laminates, a wave across the boundary of two minerals, the class that breaks and rubs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solver/detection/node_edge_contact.hpp"
#include "tests/support/linear_statics.hpp"
#include "tests/support/phases.hpp"
#include "tests/support/verify.hpp"

namespace graincrack::test {
namespace {

const std::vector<Phase> minerals{{60e9, 0, 2600}, {83.1e9, 0, 2650}, {29.3e9, 0, 3000}};  // feldspar, quartz, mica

/// Contacts so stiff that they hardly give way, the same of every class.
ContactLaws stiff_contacts(std::size_t n_phases, double stiffness) {
    return same_of_every_class(with_stiffnesses(augig_law(LawVariant::consistent), stiffness, stiffness / 10), n_phases);
}

constexpr int layers = 50;  // 62, 32 and 6 % of them feldspar, quartz and mica
std::uint8_t phase_of_layer(int layer) { return static_cast<std::uint8_t>(layer % 16 == 7 ? 2 : layer % 3 == 1 ? 1 : 0); }

/// A laminate of one grain a layer along x (in series under a load along x) or along y (in parallel).
Specimen laminate(bool in_series) {
    Specimen s = in_series ? crossed_blocks(layers, 1, 0.5, 0.01, [](int i, int) { return i; })
                           : crossed_blocks(4, layers, 0.04, 0.5, [](int, int j) { return j; });
    s.phase_names = {"feldspar", "quartz", "mica"};
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = phase_of_layer(static_cast<int>(g));
    return s;
}
std::array<double, 3> fractions() {
    std::array<double, 3> count{};
    for (int layer = 0; layer < layers; ++layer) count[phase_of_layer(layer)] += 1.0 / layers;
    return count;
}

// A pulled laminate of 62, 32 and 6 % less what its contacts give way: 1/E = Σ f/E (Reuss 1929), 61.61 GPa, to 0.5 %.
TEST(Minerals, HaveTheModulusOfReussInSeries) {
    const std::array<double, 3> f = fractions();
    ASSERT_NEAR(f[0], 0.62, 1e-12);
    ASSERT_NEAR(f[1], 0.32, 1e-12);
    const double stiffness = 1e4 * 60e9 / 0.01;
    const SmallRun run(laminate(true), minerals, stiff_contacts(3, stiffness), PlaneCondition::stress);
    const double stress = 1e6;
    const Eigen::VectorXd u = equilibrium(run, tangent_stiffness(run), boundary_load(run, {stress, 0, 0}));
    const double contacts = (layers - 1) / (stiffness * 0.5);
    verify("phases: laminate of 62/32/6 % in series, modulus (GPa)", 1e-9 / (mean_strain(run, u).xx / stress - contacts), 61.61,
           0.005, "Reuss");
}

/// The load that strains all layers of a laminate in parallel alike, along x, N, and its sum on one end.
struct LoadOfLayers {
    Eigen::VectorXd load;
    double force = 0;
};
LoadOfLayers load_of_layers(const SmallRun& run, double strain) {
    // Ends that are held plane: each layer is pulled by its share of the load.
    const Assemblage& a = run.assemblage;
    LoadOfLayers pull{Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(a.position.size()))};
    for (const auto& edge : run.specimen.boundary_edges) {
        const std::int32_t i = a.node_of_specimen[edge[0]];
        const std::int32_t j = a.node_of_specimen[edge[1]];
        const double outwards = a.position[j].y - a.position[i].y;
        const double traction = strain * minerals[a.phase_of_node[i]].young_modulus;
        pull.load(2 * i) += 0.5 * traction * outwards;
        pull.load(2 * j) += 0.5 * traction * outwards;
        pull.force += outwards > 0 ? traction * outwards : 0;
    }
    return pull;
}

// Each layer pulled by its share of the load: E = Σ f E (Voigt 1889), 65.55 GPa, to 0.5 %.
TEST(Minerals, HaveTheModulusOfVoigtInParallel) {
    const SmallRun run(laminate(false), minerals, stiff_contacts(3, 1e4 * 60e9 / 0.01), PlaneCondition::stress);
    const auto [load, force] = load_of_layers(run, 1e-5);
    const Eigen::VectorXd u = equilibrium(run, tangent_stiffness(run), load);
    verify("phases: laminate of 62/32/6 % in parallel, modulus (GPa)", 1e-9 * force / 0.5 / mean_strain(run, u).xx, 65.55, 0.005,
           "Voigt");
}

// Free laminates expand by means of their expansions: by fractions in series; by fractions times moduli in parallel, which the
// work of the load tells that strains all layers alike.
TEST(Minerals, ExpandByTheirMeansInLaminates) {
    const std::array<double, 3> f = fractions();
    const std::array<double, 3> alpha{6e-6, 13e-6, 9e-6};
    std::vector<Phase> warm = minerals;
    for (std::size_t p = 0; p < 3; ++p) warm[p].thermal_expansion = alpha[p];
    constexpr double temperature = 1e-3;  // K, so that displacements are small
    const auto warmed = [&](const SmallRun& run) {
        return equilibrium(run, tangent_stiffness(run), load_of_temperature(run, temperature));
    };
    const ContactLaws stiff = stiff_contacts(3, 1e4 * 60e9 / 0.01);
    const SmallRun series(laminate(true), warm, stiff, PlaneCondition::stress);
    verify("phases: laminate in series, expansion (1e-6/K)", 1e6 * mean_strain(series, warmed(series)).xx / temperature,
           1e6 * (f[0] * alpha[0] + f[1] * alpha[1] + f[2] * alpha[2]), 1e-6, "mean by fractions");
    const SmallRun parallel(laminate(false), warm, stiff, PlaneCondition::stress);
    const auto [load, force] = load_of_layers(parallel, 1);
    const double stiffness = f[0] * 60 + f[1] * 83.1 + f[2] * 29.3;
    verify("phases: laminate in parallel, expansion (1e-6/K)", 1e6 * load.dot(warmed(parallel)) / force / 0.04 / temperature,
           1e6 * (f[0] * 60 * alpha[0] + f[1] * 83.1 * alpha[1] + f[2] * 29.3 * alpha[2]) / stiffness, 1e-6,
           "mean by fractions and moduli");
}

// A pulse of stress from quartz into biotite: 2 Z2/(Z1 + Z2) goes on and (Z2 − Z1)/(Z1 + Z2) comes back, Z = √(E ρ);
// to 2 %.
TEST(Minerals, ShareAPulseAtTheirBoundary) {
    constexpr int cells = 400;
    constexpr double length = 0.4;
    Specimen s = crossed_blocks(cells, 1, length, length / cells, [](int i, int) { return 2 * i / cells; });
    s.phase_names = {"quartz", "biotite"};
    s.grain_phase = {0, 1};
    const std::vector<Phase> bar{{83.1e9, 0, 2650}, {29.3e9, 0, 3000}};
    SmallRun run(std::move(s), bar, stiff_contacts(2, 100 * 83.1e9 / (length / cells)), PlaneCondition::stress, 0.5);
    const double speed = std::sqrt(bar[0].young_modulus / bar[0].density);
    constexpr double middle = -0.1;
    constexpr double width = 0.01;  // ten cells
    const auto shape = [&](double x) { return std::exp(-(x - middle) * (x - middle) / (2 * width * width)); };
    // Strain ε(x − c t) with v = −c ε; displacements are the integral of ε.
    const auto displacement = [&](double x) {
        return 1e-9 * width * std::sqrt(M_PI / 2) * (1 + std::erf((x - middle) / (width * M_SQRT2)));
    };
    for (std::size_t i = 0; i < run.state.displacement.size(); ++i) {
        const double x = run.assemblage.position[i].x;
        run.state.displacement[i].x = displacement(x);
        run.state.velocity[i].x = -1e-9 * speed * shape(x + 0.5 * speed * run.parameters.time_step);
    }
    run.begin();
    run.steps(static_cast<std::int64_t>(0.17 / speed / run.parameters.time_step));  // 70 mm behind the boundary
    double transmitted = 0, reflected = 0;
    for (std::size_t e = 0; e < run.assemblage.element_nodes.size(); ++e) {
        const double stress = element_stress(run.assemblage, e, run.state)[0];
        const bool is_quartz = run.specimen.element_grain[e] == 0;
        double& largest = is_quartz ? reflected : transmitted;
        largest = std::abs(stress) > std::abs(largest) ? stress : largest;
    }
    const double incident = 1e-9 * bar[0].young_modulus;
    verify("phases: pulse from quartz into biotite, transmitted", transmitted / incident, 0.7744, 0.02, "2 Z2/(Z1 + Z2)");
    verify("phases: pulse from quartz into biotite, reflected", reflected / incident, -0.2256, 0.02, "(Z2 - Z1)/(Z1 + Z2)");
}

// A column of grains of two phases, pulled: all its boundaries are stressed alike, and those of the weak class give way first.
// The grains do not contract (ν = 0), so that the stress is uniform but for the waves of the loading: the platens start within a
// transit of the column and approach at 2 v, so that their force and the stress of a boundary differ by 2 √(E ρ) v at most.
TEST(Minerals, BreakWhereTheirWeakClassIs) {
    constexpr int n_grains = 9;  // a a b b a a b b a: boundaries of every class
    constexpr double width = 0.005;
    Specimen s = crossed_blocks(2, n_grains, width, 0.0025 * n_grains, [](int, int j) { return j; });
    s.phase_names = {"quartz", "mica"};
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = g / 2 % 2;
    const std::vector<Phase> phases{minerals[1], minerals[2]};
    constexpr double speed = 5e-3;  // m/s, of each platen
    for (const LawDescription& law : all_contact_laws()) {
        for (const std::int32_t weak : {0, 1, 2}) {
            std::vector<ContactParameters> contacts(n_contact_classes(2), augig_contact(PlaneCondition::stress));
            contacts[weak] = scaled_contact(contacts.front(), 0.4);
            SmallRun run(s, phases, make_contact_laws(contacts, law.variant), PlaneCondition::stress);
            run.load_by({.test = TestKind::tension}, 0.5, contacts.front());
            run.parameters.damping = 0.8;
            run.begin();
            run.steps(500, {{}, {-speed, speed}, nullptr});
            double largest = 0, force = 0;
            do {
                run.steps(20, {{-speed, speed}, {-speed, speed}, nullptr});
                force = run.measured().force_top;
                largest = std::max(largest, force);
            } while (force > 0.5 * largest);
            const double strength = contacts[weak].tensile_strength;
            verify("phases: load at which a column of two phases breaks over that of its weak class", largest / width / strength,
                   1, 2 * std::sqrt(phases[0].young_modulus * phases[0].density) * speed / strength,
                   "its tensile strength, waves");
            std::array<int, 3> failed{};
            for_each_contact(run.assemblage, [&](std::int32_t c, std::int32_t contact_class) {
                for (const std::size_t point : points_of(c)) failed[contact_class] += run.state.failed[point];
            });
            for (const std::int32_t k : {0, 1, 2}) {
                EXPECT_EQ(failed[k] >= 4, k == weak) << law.name << ", weak " << weak << ", class " << k;
                EXPECT_TRUE(k == weak || failed[k] == 0) << law.name << ", weak " << weak;
            }
        }
    }
}

// Two grains that touch by a node–edge contact slide at the friction angle of their class, whatever those of other classes are.
TEST(Phases, GiveANodeEdgeContactTheLawOfItsTwoGrains) {
    const double angles[] = {50, 20, 40};
    for (const std::array<std::uint8_t, 2> phases : {std::array<std::uint8_t, 2>{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
        Specimen s = one_diagonal_grid(1, 1, 4e-3, 4e-3);
        s.phase_names = {"quartz", "mica"};
        s.grain_phase = {phases[0], phases[1]};
        ContactLaws laws(augig_law());
        laws.of_class.clear();
        for (const double angle : angles) {
            ContactParameters contact = augig_contact();
            contact.friction_angle = angle * degree;
            laws.of_class.push_back(make_contact_law(contact, LawVariant::consistent));
        }
        const Assemblage a = make_assemblage(s, augig_granite().rock, PlaneCondition::strain);
        const auto& surface = a.surface;
        // Any node of the one grain and any edge of the other.
        const auto edge =
            std::find_if(surface.edges.begin(), surface.edges.end(), [](const SurfaceEdge& e) { return e.grain == 1; });
        const auto node = std::find(surface.grain_of_node.begin(), surface.grain_of_node.end(), 0);
        const CandidatePair pair{static_cast<std::int32_t>(node - surface.grain_of_node.begin()),
                                 static_cast<std::int32_t>(edge - surface.edges.begin())};
        const double expected = angles[contact_class(phases[0], phases[1])] * degree;
        EXPECT_NEAR(std::atan(friction_law(a, laws, pair).tan_friction), expected, 1e-12);
    }
}

// Grains of three phases thrown at each other without damping: what they had is stored, dissipated or still motion.
TEST(Phases, BalanceTheirEnergyWithScatteredStrengths) {
    SmallRun run = varied_phases(jittered_grid(6, 10, 0.02, 0.03, 0.25)).run(LawVariant::consistent, 0.3);
    constexpr double speed = 6;  // m/s, at the ends
    run.set_velocity([&](const Vector2& x) { return Vector2{0, -speed * x.y / 0.015}; });
    run.begin();
    const double initial = run.measured().energies.kinetic;
    run.steps(1500);
    EXPECT_GT(run.failed_points(), 50U);
    const Energies last = run.measured().energies;
    EXPECT_GT(last.fracture_tension + last.fracture_shear, 0.02 * initial);
    verify("phases: energy balance with scattered strengths, over the initial energy", (last.balance_error() + initial) / initial,
           0, 2e-3, "conservation of energy", 1);
}

}  // namespace
}  // namespace graincrack::test
