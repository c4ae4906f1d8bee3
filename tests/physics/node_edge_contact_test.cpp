// Contact after failure: any node against any edge, with an energy, exact momenta, and no jump of force or energy when a contact
// is transferred to another edge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/detection/active_contacts.hpp"
#include "solver/detection/contact_detection.hpp"
#include "solver/detection/pair_list.hpp"
#include "tests/support/check.hpp"
#include "tests/support/small_run.hpp"

namespace graincrack::test {
namespace {

std::size_t pressing_contacts(const SmallRun& run) {
    return static_cast<std::size_t>(std::count_if(run.state.contact_pairs.contacts.begin(),
                                                  run.state.contact_pairs.contacts.end(),
                                                  [](const NodeEdgeContact& c) { return c.active && c.overlap > 0; }));
}
std::size_t released_contacts(const SmallRun& run) {
    return static_cast<std::size_t>(
        std::count(run.state.contact_pairs.released.begin(), run.state.contact_pairs.released.end(), 1));
}

/// Two separate triangles, the right one's corner towards the left one's face, `gap` apart, off its middle by `offset`.
Specimen two_grains(double gap, double offset) {
    const double h = 2e-3;
    return specimen_of_triangles({{-gap / 2, -h},
                                  {-gap / 2, h},
                                  {-gap / 2 - 3 * h, 0.3 * h},
                                  {gap / 2, offset},
                                  {gap / 2 + 2 * h, offset - h},
                                  {gap / 2 + 2 * h, offset + h}},
                                 {{0, 1, 2}, {3, 4, 5}});
}

// Momenta are conserved to round-off, the energy to a tenth of the 4.8e-3 that the impact gains at this step without the
// correction of the energy at release.
TEST(NodeEdgeContact, KeepsMomentaAndEnergyOfACornerThatHitsAFace) {
    SmallRun run(two_grains(1e-5, 0.4e-3), augig_law(), PlaneCondition::strain, 0.2);
    run.set_velocity([](const Vector2& p) { return p.x > 0 ? Vector2{-1.0, 0.7} : Vector2{0.5, 0}; });
    run.begin();
    const Momenta before = momenta_of(run);
    const double energy_before = run.measured().energies.kinetic;
    double pressed = 0, worst = 0;
    for (int i = 0; i < 4000; ++i) {
        run.steps(5);
        const Energies e = run.measured().energies;
        pressed = std::max(pressed, e.contact);
        worst = std::max(worst, std::abs(e.balance_error() + energy_before));
    }
    const Momenta after = momenta_of(run);
    const Energies last = run.measured().energies;
    EXPECT_GT(pressed, 0.01 * energy_before) << "they never met";
    EXPECT_GT(last.friction, 1e-4 * energy_before) << "nothing rubbed";
    EXPECT_EQ(pressing_contacts(run), 0U) << "they should have parted";
    expect_close(after.linear.x, before.linear.x, 1e-12, before.linear_scale);
    expect_close(after.linear.y, before.linear.y, 1e-12, before.linear_scale);
    expect_close(after.angular, before.angular, 1e-12, before.linear_scale * 1e-2);
    EXPECT_LT(worst, 5e-4 * energy_before);
}

/// Detects contacts at all pairs, once.
void detect_all(SmallRun& run) {
    State& s = run.state;
    for (std::int32_t chunk = 0; chunk < static_cast<std::int32_t>(s.contact_pairs.chunks.size()); ++chunk) {
        detect_contacts(run.assemblage, run.parameters, chunk, s);
    }
    find_areas_of_new_contacts(run.assemblage, run.parameters, s);
}

/// The node–edge contacts of the last grain of a specimen whose motion is prescribed; the other grains stand still.
struct Led {
    SmallRun run;
    std::int32_t node = 0;  ///< of the last grain, its lowest
    explicit Led(const Specimen& s) : run(s, augig_law()) {
        run.begin();
        const auto& grain = run.assemblage.surface.grain_of_node;
        const std::int32_t last = *std::max_element(grain.begin(), grain.end());
        for (std::int32_t i = 0; i < run.assemblage.n_nodes(); ++i) {
            const bool lower = grain[node] != last || run.assemblage.position[i].y < run.assemblage.position[node].y;
            node = grain[i] == last && lower ? i : node;
        }
    }
    /// \return force on the node, N
    Vector2 lead(const Vector2& by) {
        State& s = run.state;
        const auto& grain = run.assemblage.surface.grain_of_node;
        const Vector2 step = (1 / run.parameters.time_step) * by;
        for (std::size_t i = 0; i < s.velocity.size(); ++i) {
            const bool is_led = grain[i] == grain[node];
            s.velocity[i] = is_led ? step : Vector2{};
            s.displacement[i] += is_led ? by : Vector2{};
        }
        ++s.step;
        update_pair_list(run.assemblage, run.parameters, s);
        detect_all(run);
        Vector2 force;
        for (std::size_t i = 0; i < s.contact_pairs.pairs.size(); ++i) {
            force += s.contact_pairs.pairs[i].node == node ? s.contact_pairs.forces[3 * i] : Vector2{};
        }
        return force;
    }
};

// A row of grains with a flat top, and a triangle whose corner is led along it at constant depth.
TEST(NodeEdgeContact, PassesFromEdgeToEdgeWithoutAJump) {
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    const double a = 4e-3;
    const int n = 4;
    for (int i = 0; i <= n; ++i) points.push_back({i * a, 0});
    for (int i = 0; i < n; ++i) {
        points.push_back({(i + 0.5) * a, -a});
        triangles.push_back({n + 1 + i, i + 1, i});
        if (i > 0) triangles.push_back({n + i, n + 1 + i, i});
    }
    const auto corner = static_cast<int>(points.size());
    const double x0 = 0.3 * a;
    points.push_back({x0, 1e-5});
    points.push_back({x0 + a / 2, a});
    points.push_back({x0 - a / 2, a});
    triangles.push_back({corner, corner + 1, corner + 2});
    Led led(specimen_of_triangles(points, triangles));
    const ContactPairList& list = led.run.state.contact_pairs;
    const ContactLaw& law = led.run.parameters.laws[0];
    led.lead({0, 0});
    led.lead({0, -1e-5 - 1e-12});                  // in contact: the depth at which a contact is found is no overlap
    const Vector2 pressed = led.lead({0, -1e-8});  // 10 nm deep
    const double normal = law.kt * led.run.assemblage.surface.tributary[led.node] * 1e-8;
    expect_close(pressed.y, normal, 1e-3, normal);
    std::vector<std::int32_t> edges;
    for (int i = 0; i < 4000; ++i) {
        const Vector2 force = led.lead({2.5 * a / 4000, 0});
        ASSERT_NEAR(force.y, pressed.y, 1e-6 * normal) << "step " << i;
        if (i > 10) {  // friction has reached its limit within 0.1 µm and stays there
            ASSERT_NEAR(force.x, -pressed.y * law.tan_phi, 1e-6 * normal) << "step " << i;
        }
        for (std::size_t k = 0; k < list.pairs.size(); ++k) {
            if (list.contacts[k].active && list.pairs[k].node == led.node &&
                (edges.empty() || edges.back() != list.pairs[k].edge)) {
                edges.push_back(list.pairs[k].edge);
            }
        }
    }
    EXPECT_EQ(edges.size(), 3U) << "it should have passed two joints";
    const Vector2 back = led.lead({-1e-9, 0});  // friction turns by a spring, not at once
    EXPECT_LT(std::abs(back.x), pressed.y * law.tan_phi);
}

// A corner comes down on a roof of two bonded grains, so near its ridge that it is in the corner zone, where no contact begins,
// and goes on down beside the bond between them.
TEST(NodeEdgeContact, CatchesACornerThatSlipsInBesideABond) {
    const double a = 4e-3;
    for (const double beside : {0.4e-2, 0.45e-2, 0.8e-2, 2e-2}) {
        SCOPED_TRACE(beside);
        const double x = beside * a;
        Led led(specimen_of_triangles({{-a, 0}, {0, -a}, {a, 0}, {0, 0}, {x, 1e-5}, {x + a / 2, a}, {x - a / 2, a}},
                                      {{0, 1, 3}, {1, 2, 3}, {4, 5, 6}}));
        const double edge = led.run.assemblage.surface.mean_length;
        led.lead({0, 0});
        double depth = -1e-5;
        while (depth < 0.02 * edge && led.lead({0, -1e-4 * edge}).y <= 0) depth += 1e-4 * edge;
        // By design a node may be 0.6 % deep before a contact begins; it is to stay above 1 %.
        EXPECT_LT(depth, 0.008 * edge);
    }
}

// Corners of three large grains reach the same end of a small grain's edge in one detection and a fourth one in the next, between
// two updates of the pair list: together they may not be stiffer than the bonds for which the stable step was found.
TEST(NodeEdgeContact, SharesTheAreaOfAnEndAmongItsCorners) {
    const double a = 4e-3;
    std::vector<Point> points{{-a, 0}, {0, -a}, {a, 0}};
    std::vector<Triangle> triangles{{0, 1, 2}};
    for (const auto& [x, height] : {Point{-0.9 * a, 1e-5}, {-0.8 * a, 1e-5}, {-0.7 * a, 1e-5}, {-0.6 * a, 3e-5}}) {
        const auto corner = static_cast<int>(points.size());
        points.insert(points.end(), {{x, height}, {x + 0.02 * a, height + 3 * a}, {x - 0.02 * a, height + 3 * a}});
        triangles.push_back({corner, corner + 1, corner + 2});
    }
    SmallRun run(specimen_of_triangles(points, triangles), augig_law());
    run.begin();
    State& s = run.state;
    const GrainSurface& surface = run.assemblage.surface;
    const std::int32_t small = surface.grain_of_node[run.assemblage.node_of_specimen[0]];
    const auto raise = [&](const Vector2& by) {
        for (std::size_t i = 0; i < s.displacement.size(); ++i) {
            s.velocity[i] = surface.grain_of_node[i] == small ? (1 / run.parameters.time_step) * by : Vector2{};
            s.displacement[i] += run.parameters.time_step * s.velocity[i];
        }
    };
    raise({0, 2e-5});
    update_pair_list(run.assemblage, run.parameters, s);
    detect_all(run);
    raise({0, 2e-5});
    detect_all(run);
    double area = 0;
    double least = 0;  // that contacts have even where nothing is available
    int contacts = 0;
    for (std::size_t i = 0; i < s.contact_pairs.pairs.size(); ++i) {
        if (const NodeEdgeContact& contact = s.contact_pairs.contacts[i]; contact.active) {
            area += contact.area;
            least += 0.1 * surface.tributary[s.contact_pairs.pairs[i].node];
            ++contacts;
        }
    }
    ASSERT_EQ(contacts, 4);
    EXPECT_LE(area, 2 * surface.tributary[run.assemblage.node_of_specimen[0]] + least);
}

// A corner deep in many grains at once has a contact with each of them, and keeps them all.
TEST(NodeEdgeContact, KeepsAllContactsOfANodeWithMany) {
    const double a = 4e-3;
    const int many = 20;
    std::vector<Point> points;
    std::vector<Triangle> triangles;
    for (int i = 0; i < many; ++i) {
        points.insert(points.end(), {{-a, 0}, {0, -a}, {a, 0}});
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    points.insert(points.end(), {{0, 1e-5}, {a / 2, a}, {-a / 2, a}});
    triangles.push_back({3 * many, 3 * many + 1, 3 * many + 2});
    Led led(specimen_of_triangles(points, triangles));
    const ContactPairList& list = led.run.state.contact_pairs;
    const auto contacts = [&] {
        int count = 0;
        list.for_active([&](std::int32_t i) { count += list.pairs[list.active.pair[i]].node == led.node ? 1 : 0; });
        return count;
    };
    const double edge = led.run.assemblage.surface.mean_length;
    led.lead({0, -1e-5 - 0.007 * edge});
    ASSERT_EQ(contacts(), many);
    led.lead({0, -1e-6 * edge});
    EXPECT_EQ(contacts(), many);
}

// A contact that ends and begins again between two detections, at the same pair, is a new one: it needs an area.
TEST(NodeEdgeContact, IsANewOneWhenItStartsAgain) {
    const double a = 4e-3;
    Led led(specimen_of_triangles({{-a, 0}, {0, -a}, {a, 0}, {0, 1e-5}, {a / 2, a}, {-a / 2, a}}, {{0, 1, 2}, {3, 4, 5}}));
    State& s = led.run.state;
    ContactPairList& list = s.contact_pairs;
    led.lead({0, -2e-5});
    ASSERT_EQ(list.chunks.size(), 1U);
    ASSERT_EQ(list.active.count[0], 1);
    const auto move = [&](double by) {
        for (std::size_t i = 0; i < s.displacement.size(); ++i) {
            const bool is_led = led.run.assemblage.surface.grain_of_node[i] == led.run.assemblage.surface.grain_of_node[led.node];
            s.displacement[i].y += is_led ? by : 0;
        }
    };
    move(2e-5);
    move_active_contacts(led.run.assemblage, led.run.parameters, 0, s);
    ASSERT_FALSE(list.contacts[list.active.pair[0]].active);
    move(-2e-5);
    detect_contacts(led.run.assemblage, led.run.parameters, 0, s);
    ASSERT_EQ(list.active.count[0], 1);
    EXPECT_EQ(list.active.changed[0], 1);
    find_areas_of_new_contacts(led.run.assemblage, led.run.parameters, led.run.state);
    EXPECT_GT(list.contacts[list.active.pair[0]].area, 0);
}

/// Two blocks of a square cut along its diagonal by a crack, pressed together and slid along it. They are of two phases.
/// \param strength factor on the strengths of the contact
SmallRun sliding_blocks(double slide, const ContactLaws& laws, double strength = 1) {
    Specimen s = one_diagonal_grid(1, 1, 4e-3, 4e-3);
    s.contact_kind.assign(s.n_contacts(), static_cast<std::uint8_t>(ContactKind::pre_existing_crack));
    s.contact_strength_factor.assign(s.n_contacts(), strength);
    s.phase_names = {"quartz", "mica"};
    s.grain_phase = {0, 1};
    SmallRun run(std::move(s), std::vector<Phase>(2, phase_of(augig_granite().rock)), laws, PlaneCondition::strain, 0.2);
    const double r = std::sqrt(0.5);
    run.set_velocity([&](const Vector2&) { return Vector2{}; });
    for (std::int32_t i = 0; i < run.assemblage.n_nodes(); ++i) {
        const double side = run.assemblage.surface.grain_of_node[i] == 0 ? 1 : -1;
        // Grain 0 is below the diagonal: it goes up and to the left (against the other) and along the diagonal.
        run.state.velocity[i] = {side * r * (slide - 0.05), side * r * (slide + 0.05)};
    }
    run.begin();
    return run;
}

/// A law with residual values of its own: cohesion 10 MPa, 30°.
ContactLaw residual_law() {
    ContactParameters c = augig_contact();
    c.residual_cohesion = 10 * MPa;
    c.residual_friction_angle = 30 * degree;
    return make_contact_law(c, LawVariant::coulomb_slip);
}

/// \param law of the contact; contacts of either phase with itself have another, which must not matter
void expect_release_without_a_jump(const ContactLaw& law, double strength = 1) {
    ContactLaws laws(augig_law());
    laws.of_class = {make_contact_law(scaled_contact(augig_contact(), 3), law.variant), law, law};
    laws.of_class[2].worn_tan_phi = laws.of_class[0].worn_tan_phi = 5;
    laws.of_class[2].kt = laws.of_class[0].kt = 0.1 * law.kt;
    SmallRun run =
        sliding_blocks(120.0, laws, strength);  // so fast that the blocks are still pressed together when they have slid far
    const double energy = run.measured().energies.kinetic;
    const auto force_on_grain = [&run] {
        (void)run.measured();  // sums the forces
        Vector2 sum;
        for (std::int32_t i = 0; i < run.assemblage.n_nodes(); ++i) {
            sum += run.assemblage.surface.grain_of_node[i] == 0 ? run.state.force[i] : Vector2{};
        }
        return sum;
    };
    double pressed = 0;
    while (released_contacts(run) == 0 && run.state.step < 20000) {
        const Vector2 before = force_on_grain();
        const Energies e = run.measured().energies;
        pressed = length(before);
        // The update of the pair list that the step makes, seen from outside.
        update_pair_list(run.assemblage, run.parameters, run.state);
        const Vector2 after = force_on_grain();
        const Energies f = run.measured().energies;
        expect_close(after.x, before.x, 1e-9, std::max(length(before), 1.0));
        expect_close(after.y, before.y, 1e-9, std::max(length(before), 1.0));
        expect_close(f.contact, e.contact, 1e-9, std::max(e.contact, 1e-12));
        run.steps(1);
    }
    ASSERT_EQ(released_contacts(run), 1U);
    EXPECT_GT(pressed, 1.0) << "they were not pressed together at the release";
    run.steps(2000);
    const Energies last = run.measured().energies;
    EXPECT_GT(last.friction, 0.0);
    EXPECT_LT(std::abs(last.balance_error() + energy), 5e-3 * energy);
}

// The update that releases a bond leaves force and stored energy as they are, to round-off, under each law and strength factor.
TEST(NodeEdgeContact, TakesOverForceAndEnergyOfAReleasedContact) {
    expect_release_without_a_jump(augig_law());
    expect_release_without_a_jump(residual_law());
    expect_release_without_a_jump(augig_law(), 0.7);  // what the law keeps is over the strength factor
}

// Where both nodes of a point have gone past the edges of the other grain within an update, no pair takes over what it stored.
TEST(NodeEdgeContact, BooksTheEnergyOfAContactReleasedBeyondItsEdges) {
    ContactLaws laws(augig_law());
    laws.of_class.assign(3, augig_law());
    SmallRun run = sliding_blocks(120.0, laws);
    SmallRun before = run;
    while (released_contacts(run) == 0 && run.state.step < 20000) {
        before = run;
        update_pair_list(run.assemblage, run.parameters, run.state);
        run.steps(1);
    }
    ASSERT_EQ(released_contacts(run), 1U);
    const Energies e = before.measured().energies;
    for (std::int32_t i = 0; i < before.assemblage.n_nodes(); ++i) {
        if (before.assemblage.surface.grain_of_node[i] == 0) before.state.displacement[i] += Vector2{1, 1};
    }
    update_pair_list(before.assemblage, before.parameters, before.state);
    ASSERT_EQ(released_contacts(before), 1U);
    const Energies f = before.measured().energies;
    EXPECT_GT(e.contact, 0);
    EXPECT_EQ(f.contact, 0);
    expect_close(f.friction - e.friction, e.contact, 1e-9, e.contact);
}

// Sliding farther than friction allows, a node bears the residual cohesion and friction; at the end friction has taken all that
// the spring stored.
TEST(NodeEdgeContact, BearsResidualCohesionAndFriction) {
    const ContactLaw law = residual_law();
    const double area = 1e-3;
    const double overlap = 20 * MPa / law.kt;
    PairGeometry g = pair_geometry(Vector2{2e-3, 0}, Vector2{1e-3, overlap});
    const NodeEdgeResponse pressed = move_node_edge_contact(friction_law(law), {true, true, area, 0, overlap, 0, 0}, g, 1e-5);
    const double shear = 10 * MPa + 20 * MPa * std::tan(30 * degree);
    expect_close(law.ks * pressed.contact.elastic_slip, shear, 1e-12, shear);
    expect_close(std::abs(pressed.forces.on_node.x), area * shear, 1e-12, area * shear);
    EXPECT_GT(pressed.friction, 0);
    g = pair_geometry(Vector2{2e-3, 0}, Vector2{1e-3, -0.1 * overlap});
    const NodeEdgeResponse parted = move_node_edge_contact(friction_law(law), pressed.contact, g, 0);
    EXPECT_EQ(parted.contact.elastic_slip, 0);
    const double stored = 0.5 * area * shear * shear / law.ks;
    expect_close(parted.friction, stored, 1e-12, stored);
}

/// A node that slides to and fro under a constant pressure, by the law of faces that wear.
struct WearingNode {
    static constexpr double area = 1e-3;
    static constexpr double pressure = 20 * MPa;
    ContactLaw law = [] {
        ContactParameters c = augig_contact();
        c.friction_angle = 50 * degree;
        c.residual_friction_angle = 20 * degree;
        c.wear_slip = 0.2e-3;
        return make_contact_law(c, LawVariant::cohesive_frictional);
    }();
    PairGeometry geometry = pair_geometry(Vector2{2e-3, 0}, Vector2{1e-3, pressure / law.kt});
    NodeEdgeContact contact{true, true, area, 0, pressure / law.kt, 0, 0};
    double worn = 0, work = 0, friction = 0;  // m; of the shear traction, and dissipated, J

    void slide(double distance, int steps) {
        for (int i = 0; i < steps; ++i) {
            const double before = shear();
            const NodeEdgeResponse r = move_node_edge_contact<true>(friction_law(law), contact, geometry, distance / steps, worn);
            contact = r.contact;
            worn += std::abs(r.slip);
            friction += r.friction;
            work += 0.5 * area * (before + shear()) * distance / steps;
        }
    }
    [[nodiscard]] double shear() const { return law.ks * contact.elastic_slip; }
    /// p (tan φr + (tan φc − tan φr) (1 − w/w_s)), by what is worn
    [[nodiscard]] double limit() const {
        const double fresh = std::tan(50 * degree) - std::tan(20 * degree);
        return pressure * (std::tan(20 * degree) + fresh * std::max(0.0, 1 - worn / law.wear_slip));
    }
};

// Requirement: linear slip weakening (Ida 1972, J Geophys Res 77, 3796): the traction is on the line of what has been slid, in
// steps of any size and in either direction, and the work done is what friction dissipated and the spring stores. The tolerance
// is that of rounding.
TEST(Wear, FollowsTheLineOfItsSlipAndBooksItsWork) {
    WearingNode fine;
    WearingNode coarse;
    for (const double distance : {0.05e-3, -0.06e-3, 0.04e-3}) {
        fine.slide(distance, 100);
        coarse.slide(distance, 1);
        for (const WearingNode& node : {fine, coarse}) {
            expect_close(std::abs(node.shear()), node.limit(), 1e-12, node.limit());
            EXPECT_GT(node.shear() * distance, 0);
            const double stored = 0.5 * WearingNode::area * node.shear() * node.shear() / node.law.ks;
            expect_close(node.work, node.friction + stored, 1e-12, node.work);
        }
        expect_close(coarse.worn, fine.worn, 1e-12, fine.worn);
    }
    EXPECT_LT(fine.worn, fine.law.wear_slip);
    fine.slide(0.2e-3, 100);
    const double residual = WearingNode::pressure * std::tan(20 * degree);
    expect_close(fine.shear(), residual, 1e-12, residual);
    WearingNode worn;  // from the start
    worn.law.wear_slip = 0;
    worn.slide(0.1e-3, 10);
    expect_close(worn.shear(), residual, 1e-12, residual);
}

// From fresh to worn, in steps one of which ends where the fall does, friction dissipates p (tan φr D + ½ (tan φc − tan φr) w).
TEST(Wear, TakesHalfTheFallOfFrictionOverItsSlip) {
    WearingNode node;
    const double slope = node.limit() / node.law.ks;
    const double residual = WearingNode::pressure * std::tan(20 * degree);
    node.slide(slope, 10);                                                // to the limit of fresh faces
    node.slide(node.law.wear_slip - slope + residual / node.law.ks, 50);  // to where they are worn
    expect_close(node.worn, node.law.wear_slip, 1e-12, node.law.wear_slip);
    node.slide(0.3e-3, 50);
    const double fresh = WearingNode::pressure * std::tan(50 * degree) - residual;
    const double expected = WearingNode::area * (residual * 0.5e-3 + 0.5 * fresh * node.law.wear_slip);
    expect_close(node.friction, expected, 1e-12, expected);
}

/// Largest depth of any node in any triangle of another grain, found without the solver's search, m; 0 if none is inside another.
double deepest_overlap(const Assemblage& a, const std::vector<Vector2>& displacement) {
    const auto place = [&](std::int32_t n) { return a.position[n] + displacement[n]; };
    double deepest = 0;
    for (const auto& element : a.element_nodes) {
        const Vector2 corner[3] = {place(element[0]), place(element[1]), place(element[2])};
        for (std::int32_t n = 0; n < a.n_nodes(); ++n) {
            if (a.surface.grain_of_node[n] == a.surface.grain_of_node[element[0]]) continue;
            double depth = std::numeric_limits<double>::max();
            for (std::size_t k = 0; k < 3; ++k) {
                const Vector2 along = corner[(k + 1) % 3] - corner[k];
                const Vector2 from = place(n) - corner[k];
                depth = std::min(depth, (along.x * from.y - along.y * from.x) / length(along));
            }
            deepest = std::max(deepest, depth);
        }
    }
    return deepest;
}

// 48 grains crushed between platens far past the peak, with a law that closes its energy: the energy balance to half a per cent
// of the stored energy, overlaps below a hundredth of an edge, with mass scaling too.
TEST(NodeEdgeContact, KeepsEnergyAndShapeCrushedToFivePerCent) {
    constexpr double shortening = 0.05;
    const LoadingRequest request{.platen_speed = 0.4, .platen_friction = 5 * degree, .max_strain = shortening};
    for (const bool scaled : {false, true}) {
        SmallRun run(jittered_grid(4, 6, 0.02, 0.03, 0.25), augig_law(LawVariant::consistent));
        run.load_by(request, 0.7, augig_contact(PlaneCondition::strain, FractureEnergyChoice::Kind::mode_i));
        if (scaled) run.scale_masses(run.boundary, 0.7);
        run.parameters.damping = 0.8;
        run.begin();
        TestPlatens platens(request, run.specimen);
        double scale = 0, worst = 0, deepest = 0;
        std::size_t contacts = 0;
        while (run.state.loading.platen_displacement[bottom_platen] < 0.5 * shortening * 0.03) {
            const std::int64_t steps = scaled ? 200 : 2000;  // a scaled step is some ten times as long
            run.steps(steps, platens.next(run.state.time, static_cast<double>(steps) * run.parameters.time_step));
            const Energies e = run.measured().energies;
            scale = std::max(scale, e.stored());
            worst = std::max(worst, std::abs(e.balance_error()));
            deepest = std::max(deepest, deepest_overlap(run.assemblage, run.state.displacement));
            contacts = std::max(contacts, pressing_contacts(run));
        }
        EXPECT_GT(released_contacts(run), 5U);
        EXPECT_GT(contacts, 10U);
        EXPECT_LT(worst / scale, 5e-3);
        const double mean_edge = run.assemblage.surface.mean_length;
        EXPECT_LT(deepest, 0.01 * mean_edge);
        EXPECT_GT(deepest, 1e-5 * mean_edge);  // the measure sees overlaps
    }
}

}  // namespace
}  // namespace graincrack::test
