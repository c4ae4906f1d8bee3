#include "mesher/mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "share/base/error.hpp"
#include "tests/unit/mesher/test_requests.hpp"

namespace graincrack::mesher {
namespace {

Request notched(double length, int elements_per_edge = 1) {
    Request request = rectangle_of(1122);
    request.fabric.elements_per_edge = elements_per_edge;
    request.notch = length;
    return request;
}

// A notch is one line: every point of it, except for its two ends, belongs to two of its contacts, and the ends lie within an
// edge of the requested positions.
TEST(Notch, IsOneLineOfTheWantedLength) {
    for (const int n : {1, 3}) {
        const Specimen s = mesh(notched(0.032, n));
        std::map<std::pair<double, double>, int> ends;
        for (std::size_t c = 0; c < s.n_contacts(); ++c) {
            if (!starts_broken(s.contact_kind[c])) continue;
            for (const int side : {0, 1}) {
                const auto& p = s.node_position[static_cast<std::size_t>(s.contact_nodes[c][side])];
                ++ends[{p[0], p[1]}];
                EXPECT_LT(std::abs(p[1]), s.statistics.max_edge);
            }
        }
        ASSERT_FALSE(ends.empty());
        EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](const auto& e) { return e.second == 1; }), 2);
        EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](const auto& e) { return e.second > 2; }), 0);
        EXPECT_NEAR(ends.rbegin()->first.first - ends.begin()->first.first, 0.032, s.statistics.max_edge);
    }
}

TEST(Notch, ChangesNothingElse) {
    Request whole = notched(0.032);
    whole.notch.reset();
    const Specimen with = mesh(notched(0.032));
    const Specimen without = mesh(whole);
    EXPECT_EQ(with.node_position, without.node_position);
    EXPECT_EQ(with.contact_nodes, without.contact_nodes);
    EXPECT_EQ(std::count(without.contact_kind.begin(), without.contact_kind.end(), 1), 0);
}

TEST(Notch, TooShortOrTooLongIsRefused) {
    EXPECT_THROW(plan_mesh(notched(0.005)), UsageError);
    EXPECT_THROW(plan_mesh(notched(0.075)), UsageError);
    Request narrow = notched(0.011);
    narrow.region = rectangle(0.02, 0.16);
    narrow.fabric.grains = 100;  // edges of about 8.5 mm
    EXPECT_NE(refusal(narrow).find("no room"), std::string::npos) << "a notch in two edges' width";
    EXPECT_EQ(refusal(notched(0.011)) + refusal(notched(0.059)), "");
}

}  // namespace
}  // namespace graincrack::mesher
