#include "mesher/assemblage/counts.hpp"

#include <gtest/gtest.h>

#include "mesher/mesh.hpp"

namespace graincrack::mesher {
namespace {

TEST(Counts, AreThoseOfTheArrays) {
    for (const int n : {1, 2, 3}) {
        Request request;
        request.region = rectangle(0.04, 0.06);
        request.fabric.grains = 200;
        request.fabric.elements_per_edge = n;
        const Specimen s = mesh(request);
        const auto boundary = static_cast<std::int64_t>(s.n_boundary_edges()) / n;
        const AssemblageCounts counts = assemblage_counts(200, boundary, n);
        EXPECT_EQ(static_cast<std::int64_t>(s.n_nodes()), counts.nodes) << n;
        EXPECT_EQ(static_cast<std::int64_t>(s.n_elements()), counts.elements) << n;
        EXPECT_EQ(static_cast<std::int64_t>(s.n_contacts()), counts.contacts) << n;
        EXPECT_EQ(s.grain_area.size(), 200U) << n;
    }
}

}  // namespace
}  // namespace graincrack::mesher
