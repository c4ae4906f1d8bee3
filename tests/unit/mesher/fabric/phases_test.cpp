#include "mesher/fabric/phases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "share/base/error.hpp"
#include "share/base/union_find.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

std::vector<PhaseFraction> granite() { return parse_phases("quartz=0.32,feldspar=0.62,mica=0.06"); }

/// The mean number of grains in a connected piece of a phase.
double mean_piece(const Specimen& s, std::uint8_t phase) {
    const std::vector<std::int32_t> grain = grain_of_nodes(s);
    UnionFind connected(s.n_grains());
    for (const auto& nodes : s.contact_nodes) {
        const auto a = static_cast<std::size_t>(grain[index(nodes[0])]);
        const auto b = static_cast<std::size_t>(grain[index(nodes[2])]);
        if (s.grain_phase[a] == phase && s.grain_phase[b] == phase) connected.join(a, b);
    }
    double grains = 0, pieces = 0;
    for (std::size_t g = 0; g < s.n_grains(); ++g) {
        if (s.grain_phase[g] != phase) continue;
        grains += 1;
        pieces += connected.find(g) == g ? 1 : 0;
    }
    return grains / pieces;
}

TEST(Phases, HaveTheirFractionsOfTheAreaToOneGrain) {
    const std::vector<std::vector<PhaseFraction>> fabrics{granite(), parse_phases("a=0.5,b=0.5"),
                                                          parse_phases("a=0.001,b=0.333,c=0.333,d=0.333"), parse_phases("a=1")};
    for (const std::int64_t grains : {60, 333, 1122, 5000}) {
        Request request = rectangle_of(grains);
        request.fabric.spread = 0.3;
        Specimen s = mesh(request);
        const double whole = std::accumulate(s.grain_area.begin(), s.grain_area.end(), 0.0);
        const double largest = *std::max_element(s.grain_area.begin(), s.grain_area.end());
        for (const auto& fractions : fabrics) {
            for (const double cluster : {1.0, 2.5, 10.0, 1e6}) {
                for (std::uint64_t seed = 0; seed < 30; ++seed) {
                    assign_phases(s, own_crystals(s), {fractions, seed, cluster});
                    ASSERT_EQ(s.phase_names.size(), fractions.size());
                    std::vector<double> area(fractions.size());
                    for (std::size_t g = 0; g < s.n_grains(); ++g) area.at(s.grain_phase[g]) += s.grain_area[g];
                    for (std::size_t p = 0; p < area.size(); ++p) {
                        EXPECT_EQ(s.phase_names[p], fractions[p].name);
                        EXPECT_LE(std::abs(area[p] - fractions[p].fraction * whole), largest * (1 + 1e-9))
                            << grains << " grains, cluster " << cluster << ", seed " << seed;
                        EXPECT_NEAR(phase_fractions(s)[p], area[p] / whole, 1e-12);
                    }
                }
            }
        }
    }
}

// Without clusters the phase of a grain says nothing about its neighbours.
TEST(Phases, SayNothingOfNeighbours) {
    Request request = rectangle_of(20000);
    request.fabric.phases.fractions = granite();
    const Specimen s = mesh(request);
    const std::vector<std::uint8_t> classes = contact_classes(s);
    const double f[] = {0.32, 0.62, 0.06};
    for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t q = 0; q <= p; ++q) {
            const double share = static_cast<double>(std::count(classes.begin(), classes.end(), contact_class(p, q))) /
                                 static_cast<double>(classes.size());
            const double expected = (p == q ? 1 : 2) * f[p] * f[q];
            // Three standard deviations of a binomial share, and as much again: contacts of one grain are not independent.
            EXPECT_NEAR(share, expected, 6 * std::sqrt(expected / static_cast<double>(classes.size()))) << p << q;
        }
    }
}

// Pieces of a rare phase are its clusters: seldom two of them meet.
TEST(Phases, LieInClustersOfTheMeanNumberOfGrains) {
    Specimen s = mesh(rectangle_of(20000));
    for (const double cluster : {1.0, 4.0, 10.0}) {
        double sum = 0;
        constexpr int n_seeds = 20;
        for (std::uint64_t seed = 0; seed < n_seeds; ++seed) {
            assign_phases(s, own_crystals(s), {parse_phases("rest=0.98,rare=0.02"), seed, cluster});
            sum += mean_piece(s, 1);
        }
        EXPECT_NEAR(sum / n_seeds / cluster, 1.05, 0.1) << cluster;
    }
}

TEST(Phases, BelongToCrystals) {
    Specimen s = mesh(rectangle_of(1000));
    std::vector<int> crystals = own_crystals(s);
    for (int& crystal : crystals) crystal /= 4;
    assign_phases(s, crystals, {granite(), 3, 2});
    for (std::size_t g = 0; g < s.n_grains(); ++g) EXPECT_EQ(s.grain_phase[g], s.grain_phase[g / 4 * 4]);
    EXPECT_NEAR(phase_fractions(s)[0], 0.32, 0.005);  // a crystal has 0.4 %
}

TEST(Phases, FollowTheSeedWhateverTheElements) {
    Request request = rectangle_of(1122);
    request.fabric.phases = {granite(), {}, 3};
    const Specimen first = mesh(request);
    EXPECT_EQ(mesh(request).grain_phase, first.grain_phase);
    request.fabric.elements_per_edge = 2;
    EXPECT_EQ(mesh(request).grain_phase, first.grain_phase);
    request.fabric.phases.seed = request.seed;
    EXPECT_EQ(mesh(request).grain_phase, first.grain_phase) << "the seed of the specimen, unless given";
    request.fabric.phases.seed = 2;
    const Specimen other = mesh(request);
    EXPECT_NE(other.grain_phase, first.grain_phase);
    EXPECT_EQ(other.grain_area, first.grain_area);
}

TEST(Phases, RefuseBadTexts) {
    const auto read = [](const std::string& phases) { check(PhaseRequest{parse_phases(phases), {}, 1}); };
    EXPECT_NO_THROW(read("quartz=0.32,feldspar=0.62,mica=6%"));
    EXPECT_NO_THROW(read("a=0.3333333,b=0.3333333,c=0.3333333")) << "rounded";
    std::string many = "p0=0.04";
    for (int i = 1; i < 25; ++i) many += ",p" + std::to_string(i) + "=0.04";
    test::Refusals refused;
    for (const std::string& phases :
         std::vector<std::string>{"quartz=0.5,mica=0.6", "quartz=0.5,mica=0.4", "quartz=0.5,quartz=0.5", "k-feldspar=1",
                                  "Quartz=1", "=1", "quartz", "", "quartz=1,", "quartz=0,mica=1", "quartz=-0.5,mica=1.5",
                                  "quartz=much,mica=0.5", "quartz=1mm", std::string(257, 'q') + "=1", many}) {
        refused.add<UsageError>(phases.size() < 100 ? phases : phases.substr(0, 12) + "...", [&] { read(phases); });
    }
    test::expect_golden(refused.text());
}

TEST(Phases, RefuseBadRequests) {
    const auto phases = [](const PhaseRequest& request) { return [request](Request& r) { r.fabric.phases = request; }; };
    Request good = rectangle_of(1122);
    good.fabric.phases = {granite(), 7, 2};
    compare_refusals(good, {{"a seed without phases", phases({{}, 7, 1})},
                            {"clusters without phases", phases({{}, {}, 2})},
                            {"a fraction that is no number", phases({{{"a", std::nan("")}, {"b", 1}}, {}, 1})}});
}

}  // namespace
}  // namespace graincrack::mesher
