// What is computed from the crack log: fragments, counts, events, balance.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "post/cracks/crack_counts.hpp"
#include "post/cracks/emission.hpp"
#include "post/cracks/fragments.hpp"
#include "post/cracks/rosette.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/run_tables.hpp"

namespace graincrack {
namespace {

using State = std::vector<std::array<std::uint8_t, 2>>;
constexpr auto separated_point = static_cast<std::uint8_t>(PointState::separated);
constexpr auto failed = static_cast<std::uint8_t>(PointState::failed_shear);

/// Both points of all contacts whose middle is at a height, in a state.
State state_at(const Specimen& s, double height, std::uint8_t value) {
    State state(s.n_contacts(), {0, 0});
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto y = [&](std::size_t k) { return s.node_position[static_cast<std::size_t>(s.contact_nodes[c][k])][1]; };
        if (std::abs((y(0) + y(1)) / 2 - height) < 1e-9) state[c] = {value, value};
    }
    return state;
}

TEST(Fragments, AreTwoBehindACutThrough) {
    const Specimen s = test::grid_specimen(4, 4, 0.04, 0.04);
    const double cut = 0.01;                                                // one quarter above
    EXPECT_EQ(find_fragments(s, state_at(s, cut, failed)).all.size(), 1U);  // failed, not separated
    const Fragments two = find_fragments(s, state_at(s, cut, separated_point));
    ASSERT_EQ(two.all.size(), 2U);
    EXPECT_EQ(two.all[0].grains, 24U);
    EXPECT_EQ(two.all[1].grains, 8U);
    EXPECT_NEAR(two.all[0].area, 0.75 * 0.04 * 0.04, 1e-15);
    EXPECT_NEAR(two.all[1].centre[1], 0.015, 1e-12);
    EXPECT_NEAR(two.all[1].centre[0], 0, 1e-12);
    EXPECT_NEAR(two.all[0].diameter(), 2 * std::sqrt(0.0012 / std::numbers::pi), 1e-12);
    EXPECT_EQ(two.single_grains(), 0U);
    EXPECT_EQ(test::field(test::written(write_fragments, two, TableFormat::tsv), "share_of_area"), "0.75");
    for (std::size_t g = 0; g < s.n_grains(); ++g) EXPECT_EQ(two.of_grain[g], g >= 24 ? 1U : 0U);
}

TEST(Fragments, HoldTogetherByHalfAContact) {
    const Specimen s = test::grid_specimen(1, 1, 0.01, 0.01);  // two grains, one contact
    EXPECT_EQ(find_fragments(s, {{separated_point, failed}}).all.size(), 1U);
    const Fragments apart = find_fragments(s, {{separated_point, separated_point}});
    EXPECT_EQ(apart.all.size(), 2U);
    EXPECT_EQ(apart.single_grains(), 2U);
}

const Rock rock{25.8e9, 0.23, 2650, 1.5e6, 3.0e6, 8.8e6};
const double shear_modulus = 25.8e9 / (2 * 1.23);

Crack crack_at(double x, double time, double opening = 3e-6, double sliding = 4e-6) {
    return {.time = time, .position = {x, 0}, .length = 0.002, .opening = opening, .sliding = sliding, .energy_released = 0.1};
}

TEST(Emission, IsOneEventOfPointsNearInSpaceAndTime) {
    const EmissionWindow window{0.01, 1e-5};
    const auto count = [&](const std::vector<Crack>& cracks) { return find_events(cracks, rock, window).size(); };
    EXPECT_EQ(count({crack_at(0, 0), crack_at(0.009, 9e-6)}), 1U);
    EXPECT_EQ(count({crack_at(0, 0), crack_at(0.011, 0)}), 2U);
    EXPECT_EQ(count({crack_at(0, 0), crack_at(0, 1.1e-5)}), 2U);
    // A chain is one event however long it is; the order of the rows does not matter.
    const auto chain = find_events({crack_at(0.018, 1.8e-5), crack_at(0, 0), crack_at(0.009, 9e-6)}, rock, window);
    ASSERT_EQ(chain.size(), 1U);
    EXPECT_DOUBLE_EQ(chain[0].time, 0);
    EXPECT_DOUBLE_EQ(chain[0].duration, 1.8e-5);
    EXPECT_DOUBLE_EQ(chain[0].contacts, 1.5);
    EXPECT_NEAR(chain[0].position[0], 0.009, 1e-15);
}

TEST(Emission, HasAMomentOfModulusTimesLengthTimesJump) {
    std::vector<Crack> cracks{crack_at(0, 0), crack_at(0.001, 0)};
    cracks[1].mode = CrackMode::shear;
    const auto events = find_events(cracks, rock, {0.01, 1e-5});
    ASSERT_EQ(events.size(), 1U);
    EXPECT_NEAR(events[0].moment, 2 * shear_modulus * 0.002 * 5e-6, 1e-6);  // √(3² + 4²) µm
    EXPECT_NEAR(events[0].magnitude(), 2.0 / 3 * std::log10(events[0].moment) - 6.07, 1e-12);
    EXPECT_DOUBLE_EQ(events[0].tensile_share, 0.5);
    EXPECT_DOUBLE_EQ(events[0].energy, 0.2);
    EXPECT_DOUBLE_EQ(events[0].length, 0.004);
    // The jump is that at the event of the label, not at failure.
    Crack crack = crack_at(0, 0, 1e-6, 0);
    crack.damaged_50 = {1e-4, 3e-6, 4e-6};
    for (const auto& [event, jump] : {std::pair{CrackEvent::failed, 1e-6}, {CrackEvent::half_damaged, 5e-6}}) {
        const std::vector<Crack> cracks_of_label = labelled({crack}, {event, CrackModeRule::traction});
        EXPECT_NEAR(find_events(cracks_of_label, rock, {0.01, 1e-5}).at(0).moment, shear_modulus * 0.002 * jump, 1e-7);
    }
}

TEST(Emission, HasAWindowOfTwoEdgesAtHalfTheShearSpeed) {
    const EmissionWindow window = default_window(rock, 0.004);
    EXPECT_DOUBLE_EQ(window.distance, 0.008);
    EXPECT_NEAR(window.time, 0.008 / (1989.39 / 2), 1e-9);  // √(G/ρ) of Augig granite, 1989.39 m/s
}

TEST(GutenbergRichter, HasTheSlopeOfAkiAboveItsCompleteness) {
    std::vector<double> magnitudes{-9, -8.5};  // below the completeness: not counted
    for (int i = 0; i < 10; ++i) magnitudes.push_back(-5 + 0.1 * i);
    const auto fit = fit_gutenberg_richter(magnitudes, -5);
    ASSERT_TRUE(fit.has_value());
    EXPECT_EQ(fit->events, 10U);
    EXPECT_NEAR(fit->b, std::log10(std::numbers::e) / 0.45, 1e-12);  // Aki: log10(e)/(mean − completeness)
    EXPECT_NEAR(fit->error, fit->b / std::sqrt(10.0), 1e-12);
    EXPECT_FALSE(fit_gutenberg_richter({1, 2, 3}, 0).has_value());
    EXPECT_NEAR(completeness_of({-6, -5, -5.01, -5.02, -4}), -5.05, 1e-12);  // the most frequent magnitude
}

TEST(GutenbergRichter, TellsWhetherDataFollowItsLine) {
    const auto fit_of = [](const auto& magnitude_of) {
        std::vector<double> magnitudes;
        for (int i = 0; i < 100; ++i) magnitudes.push_back(magnitude_of((i + 0.5) / 100));
        return fit_gutenberg_richter(magnitudes, -5).value();
    };
    // Magnitudes of the exponential distribution at their own shares; and half of them at one place, half far away.
    const auto line = fit_of([](double share) { return -5 - 0.5 * std::log(1 - share); });
    EXPECT_LT(line.distance, 0.02);
    EXPECT_TRUE(line.follows_line());
    const auto two = fit_of([](double share) { return share < 0.5 ? -4.95 : -3.5; });
    EXPECT_FALSE(two.follows_line());
    EXPECT_NEAR(two.distance_by_chance(), 1.094 / (10 + 0.26 + 0.05) + 0.002, 1e-12);  // Stephens (1974), 100 events
}

TEST(CrackBalance, SeparatesModesAndCountsWhatIsSeparated) {
    std::vector<Crack> cracks{crack_at(0, 1, 1e-6, 2e-6), crack_at(0, 1, 2e-6, -1e-6), crack_at(0, 2, 1e-6, -2e-6),
                              crack_at(0, 2, 0, 1e-6)};
    cracks[3].mode = CrackMode::shear;
    cracks[0].separated.time = 1.5;
    cracks[2].separated.time = 9;
    EXPECT_DOUBLE_EQ(balance_cracks(cracks, 1).tensile, 1);
    EXPECT_DOUBLE_EQ(balance_cracks(cracks, 1).separated, 0);
    const CrackBalance late = balance_cracks(cracks, 3);
    EXPECT_DOUBLE_EQ(late.tensile, 1.5);
    EXPECT_DOUBLE_EQ(late.shear, 0.5);
    EXPECT_DOUBLE_EQ(late.separated, 0.5);
}

constexpr double pi = std::numbers::pi;

TEST(Rosette, HasLinesWithoutAHead) {
    EXPECT_EQ(rosette_bin(0), 0U);
    EXPECT_EQ(rosette_bin(pi), 0U);
    EXPECT_EQ(rosette_bin(-pi), 0U);
    EXPECT_EQ(rosette_bin(pi / 4), rosette_bin(pi / 4 - pi));
    EXPECT_EQ(rosette_bin(pi / 2), 9U);
    EXPECT_EQ(rosette_bin(pi - 0.01), 17U);
}

TEST(Rosette, HasThreeDirectionsOfAGrid) {
    const Rosette rosette = crack_rosette({}, test::grid_specimen(4, 4, 0.04, 0.04));
    EXPECT_NEAR(rosette.facet[0], 3 * 0.04, 1e-12);
    EXPECT_NEAR(rosette.facet[9], 3 * 0.04, 1e-12);
    EXPECT_NEAR(rosette.facet[4], 16 * std::sqrt(2) * 0.01, 1e-12);  // 45°
    EXPECT_NEAR(std::accumulate(rosette.facet.begin(), rosette.facet.end(), 0.0), 6 * 0.04 + 16 * std::sqrt(2) * 0.01, 1e-12);
}

TEST(Rosette, SumsLengthsOfCracksByMode) {
    std::vector<Crack> cracks(3, crack_at(0, 0));
    for (Crack& crack : cracks) crack.orientation = 25 * pi / 180;
    cracks[2].mode = CrackMode::shear;
    const Rosette rosette = crack_rosette(cracks, test::grid_specimen(1, 1, 0.01, 0.01));
    EXPECT_NEAR(rosette.tensile[2], 0.004, 1e-15);
    EXPECT_NEAR(rosette.shear[2], 0.002, 1e-15);
}

TEST(Rosette, CountsAsAlongTheLoadWhatIsWithin30Degrees) {
    std::array<double, Rosette::n_bins> length{};
    EXPECT_EQ(share_along_load(length), std::nullopt);
    for (std::size_t bin = 0; bin < length.size(); ++bin) length[bin] = bin >= 6 && bin < 12 ? 3 : 1;  // 60° to 120° from x
    EXPECT_DOUBLE_EQ(share_along_load(length).value(), 18.0 / 30);
    length.fill(0);
    length[5] = length[12] = 1;
    EXPECT_EQ(share_along_load(length), 0.0);
}

TEST(Rosette, HasNoSharesWithoutCracks) {
    const Rosette rosette = crack_rosette({}, test::grid_specimen(4, 4, 0.04, 0.04));
    const std::string table = test::written(write_rosette, rosette, TableFormat::tsv);
    EXPECT_EQ(test::parse_tsv(table).size(), 19U);
    EXPECT_EQ(test::field(table, "tensile_share"), "");
    EXPECT_NE(test::field(table, "facet_share"), "");
}

/// A cell of two grains is a crystal: two crystals side by side.
Specimen two_crystals() {
    Specimen s = test::grid_specimen(2, 1, 0.02, 0.01);
    for (std::size_t g = 0; g < s.n_grains(); ++g) s.grain_crystal.push_back(static_cast<std::int32_t>(g / 2));
    s.phase_names = {"quartz", "feldspar"};
    s.grain_phase = {0, 0, 1, 1};
    return s;
}

/// The contact between two grains.
std::int32_t contact_of(const Specimen& s, std::int32_t a, std::int32_t b) {
    const auto grain = grain_of_nodes(s);
    for (std::size_t c = 0; c < s.n_contacts(); ++c) {
        const auto at = [&](std::size_t k) { return grain[static_cast<std::size_t>(s.contact_nodes[c][k])]; };
        if ((at(0) == a && at(2) == b) || (at(0) == b && at(2) == a)) return static_cast<std::int32_t>(c);
    }
    return -1;
}

struct Broken {
    Specimen specimen = two_crystals();
    std::vector<Crack> cracks;
    State state = State(specimen.n_contacts(), {0, 0});
    std::int32_t within = contact_of(specimen, 0, 1);
    std::int32_t between = -1;
    Broken() {
        for (const auto& [a, b] : {std::pair{0, 2}, {0, 3}, {1, 2}, {1, 3}}) {
            between = std::max(between, contact_of(specimen, a, b));
        }
        cracks = {crack_at(0, 1), crack_at(0, 2), crack_at(0, 1)};
        cracks[0].contact = cracks[1].contact = within;
        cracks[2].contact = between;
        cracks[2].mode = CrackMode::shear;
    }
};

TEST(CrackedCrystals, HaveCracksWithinOrAround) {
    Broken b;
    ASSERT_GE(b.within, 0);
    ASSERT_GE(b.between, 0);
    b.state[static_cast<std::size_t>(b.within)] = {separated_point, separated_point};
    const Fragments fragments = find_fragments(b.specimen, b.state);
    const auto crystals = find_crystals(b.specimen, b.cracks, b.state, fragments);
    ASSERT_EQ(crystals.size(), 2U);
    EXPECT_EQ(fragments.all[0].crystals, 2U);
    EXPECT_EQ(fragments.all[1].crystals, 1U);
    // A tensile crack in the first, half a crack in shear around both. One half of the first has lost the other, and is alone:
    // the other half hangs on the neighbour.
    test::expect_golden(test::written(write_crystals, crystals, TableFormat::tsv));
}

TEST(CrackedCrystals, AreCountedOnceForEachMode) {
    const Broken b;
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks).tensile, 1);
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks).shear, 0) << "the crack in shear is between two crystals";
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks, 0.5).tensile, 0) << "before the first crack";
    const RunClasses classes = classes_of_run("run", b.specimen, b.cracks, {}, 0.5);
    ASSERT_TRUE(classes.crystals.has_value());
    EXPECT_EQ(classes.crystals->contacts, 2U);
    EXPECT_DOUBLE_EQ(classes.crystals->at_peak.value().tensile, 0);
    EXPECT_DOUBLE_EQ(classes.crystals->at_end.tensile, 1);
}

TEST(CrackedCrystals, AreGrainsWhereThereAreNone) {
    Broken b;
    b.specimen.grain_crystal.clear();
    b.state.assign(b.specimen.n_contacts(), {separated_point, separated_point});
    const auto crystals = find_crystals(b.specimen, b.cracks, b.state, find_fragments(b.specimen, b.state));
    ASSERT_EQ(crystals.size(), 4U);
    EXPECT_DOUBLE_EQ(crystals[0].around.tensile, 1);
    EXPECT_EQ(crystals[0].pieces, 1U);
    EXPECT_DOUBLE_EQ(count_cracked_crystals(b.specimen, b.cracks).tensile, 0);
    EXPECT_FALSE(classes_of_run("run", b.specimen, b.cracks, {}, {}).crystals.has_value());
}

}  // namespace
}  // namespace graincrack
