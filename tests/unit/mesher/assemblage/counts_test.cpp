#include "mesher/assemblage/counts.hpp"

#include <gtest/gtest.h>

#include "mesher/specimen_maker.hpp"

namespace graincrack::mesher {
namespace {

TEST(Counts, AreThoseOfTheArrays) {
    for (const int n : {1, 2, 3}) {
        SpecimenRequest request;
        request.region = rectangle(0.04, 0.06);
        request.grains = 200;
        request.elements_per_edge = n;
        const Specimen s = make_specimen(request);
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
