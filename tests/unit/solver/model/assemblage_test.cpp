// The specimen as the kernels see it.
#include "solver/model/assemblage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "share/file/specimen.hpp"
#include "tests/support/augig_granite.hpp"
#include "tests/support/check.hpp"
#include "tests/support/specimens.hpp"

namespace graincrack::test {
namespace {

Assemblage of(const Specimen& s) { return make_assemblage(s, augig_granite().rock, PlaneCondition::strain); }

TEST(Assemblage, GivesNoMassToANodeOfNoElement) {
    Specimen s = one_diagonal_grid(1, 1, 0.01, 0.01);
    s.node_position.insert(s.node_position.begin(), {0.5, 0.5});
    renumber_nodes(s, [](std::int32_t node) { return node + 1; });
    const Assemblage a = of(s);
    const std::int32_t i = a.node_of_specimen[0];
    EXPECT_EQ(a.mass[i], 0);
    EXPECT_EQ(a.inverse_mass[i], 0);
}

TEST(Assemblage, RenumbersEachNodeOnce) {
    Specimen s = union_jack_grid(4, 4, 0.02, 0.02);
    // Any order of nodes is allowed: reverse it.
    const auto n = static_cast<std::int32_t>(s.n_nodes());
    std::reverse(s.node_position.begin(), s.node_position.end());
    renumber_nodes(s, [n](std::int32_t node) { return n - 1 - node; });
    ASSERT_NO_THROW(validate(s, "reversed"));
    const Assemblage a = of(s);
    std::vector<std::int32_t> sorted = a.node_of_specimen;
    std::sort(sorted.begin(), sorted.end());
    for (std::int32_t i = 0; i < n; ++i) {
        ASSERT_EQ(sorted[i], i);
        EXPECT_EQ(a.position[a.node_of_specimen[i]].x, s.node_position[i][0]);
        EXPECT_EQ(a.position[a.node_of_specimen[i]].y, s.node_position[i][1]);
    }
    for (std::int32_t e = 0; e < a.n_elements(); ++e) {
        EXPECT_GT(a.element_geometry[e].area, 0);
        EXPECT_EQ(a.element_nodes[e][1], a.node_of_specimen[s.element_nodes[e][1]]);
    }
}

using Slots = std::map<std::int32_t, std::vector<std::int32_t>>;

/// The slots of each node, in the order they are summed in.
template <std::size_t few>
Slots slots_of(const SlotsOfNodes<few>& table, std::size_t zero_slot) {
    Slots slots;
    for (std::size_t i = 0; i < table.first.size(); ++i) {
        for (const std::int32_t slot : table.first[i]) {
            if (slot != static_cast<std::int32_t>(zero_slot)) slots[static_cast<std::int32_t>(i)].push_back(slot);
        }
    }
    for (const FurtherSlot& further : table.further) slots[further.node].push_back(further.slot);
    return slots;
}

TEST(Assemblage, HasTheGeometryAndTheSlotsOfItsContacts) {
    const Specimen s = jittered_grid(4, 5, 0.02, 0.03, 0.2);
    const Assemblage a = of(s);
    ASSERT_EQ(a.contacts.size(), s.n_contacts());
    double length_sum = 0;
    Slots expected;
    for (std::int32_t c = 0; c < a.n_contacts(); ++c) {
        for (std::int32_t k = 0; k < 4; ++k) expected[a.contacts[c].nodes[k]].push_back(slot_of(c, k));
    }
    EXPECT_EQ(slots_of(a.contact_slots, a.contact_chunks.size() * slot_stride), expected);
    for (const ContactGeometry& g : a.contacts) {
        EXPECT_EQ(2 * g.point_area, length(g.edge));
        length_sum += length(g.edge);
    }
    expect_close(a.contact_length, length_sum, 1e-14, length_sum);
}

// A node inside of a grain is in many elements.
TEST(Assemblage, HasSlotsOfTheNodesOfEveryElement) {
    const Assemblage a = of(crossed_blocks(12, 10, 0.02, 0.03, [](int i, int /*j*/) { return i / 4; }));
    Slots expected;
    for (std::int32_t e = 0; e < a.n_elements(); ++e) {
        for (std::int32_t k = 0; k < 3; ++k) expected[a.element_nodes[e][k]].push_back(element_slot_of(e, k));
    }
    EXPECT_FALSE(a.element_slots.further.empty());
    EXPECT_EQ(slots_of(a.element_slots, a.element_chunks.size() * element_slot_stride), expected);
}

/// A rectangle of 1,200 grains whose phases follow no pattern of its rows.
Specimen of_three_phases() {
    Specimen s = one_diagonal_grid(20, 30, 0.02, 0.03);
    s.phase_names = {"quartz", "feldspar", "mica"};
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_phase[g] = static_cast<std::uint8_t>(g * g % 7 % 3);
    return s;
}

TEST(Assemblage, SortsContactsByClassIntoChunksOfOne) {
    const Specimen s = of_three_phases();
    const Assemblage a = of(s);
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    ASSERT_EQ(a.n_contacts(), static_cast<std::int32_t>(s.n_contacts()));
    ASSERT_EQ(a.contacts.size(), a.specimen_contact.size());
    std::vector<int> seen(s.n_contacts(), 0);
    std::int32_t last_class = -1;
    std::int32_t place = 0;
    for (const ContactChunk& chunk : a.contact_chunks) {
        EXPECT_EQ(chunk.contacts.begin, place);
        EXPECT_GE(chunk.contact_class, last_class);
        for (std::int32_t c = chunk.contacts.begin; c < chunk.contacts.end; ++c) {
            const auto of_specimen = static_cast<std::size_t>(a.specimen_contact[c]);
            ++seen[of_specimen];
            EXPECT_EQ(a.contact_of_specimen[of_specimen], c);
            const auto phase = [&](std::size_t k) {
                return s.grain_phase[grain[static_cast<std::size_t>(s.contact_nodes[of_specimen][k])]];
            };
            EXPECT_EQ(static_cast<std::int32_t>(contact_class(phase(0), phase(2))), chunk.contact_class);
            EXPECT_EQ(a.contacts[c].nodes[0], a.node_of_specimen[s.contact_nodes[of_specimen][0]]);
        }
        last_class = chunk.contact_class;
        place += contacts_per_chunk;
    }
    EXPECT_EQ(last_class, 5);
    EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
    for (std::size_t c = 0; c < a.contacts.size(); ++c) EXPECT_EQ(a.specimen_contact[c] < 0, a.contacts[c].point_area == 0);
}

TEST(Assemblage, HasTheElasticityAndMassOfTheMineralOfEachGrain) {
    Specimen s = of_three_phases();
    const std::vector<Phase> phases{{83.1e9, 0.08, 2650}, {60e9, 0.25, 2600}, {29.3e9, 0.27, 3000}};
    const Assemblage a = make_assemblage(s, phases, PlaneCondition::stress);
    double mass = 0;
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        const Phase& phase = phases[s.grain_phase[s.element_grain[e]]];
        const PlaneElasticity c = make_plane_elasticity(phase.young_modulus, phase.poisson_ratio, PlaneCondition::stress);
        EXPECT_EQ(a.elasticity[e].c11, c.c11);
        EXPECT_EQ(a.elasticity[e].mu, c.mu);
        EXPECT_EQ(a.element_mass[e], phase.density * a.element_geometry[e].area);
        mass += a.element_mass[e];
    }
    EXPECT_NEAR(std::accumulate(a.mass.begin(), a.mass.end(), 0.0), mass, 1e-12 * mass);
    for (std::size_t i = 0; i < a.mass.size(); ++i) EXPECT_NEAR(a.mass[i] * a.inverse_mass[i], 1, 1e-15);
}

}  // namespace
}  // namespace graincrack::test
