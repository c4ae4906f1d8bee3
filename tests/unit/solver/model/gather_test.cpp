// What ranks have of an array comes together on the first, whatever the others have at these places.
#include "solver/model/gather.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/phases.hpp"
#include "tests/support/small_run.hpp"
#include "tests/support/thread_ranks.hpp"

namespace graincrack {
namespace {

std::vector<double> numbers_from(std::size_t n, double first) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < n; ++i) numbers.push_back(first + static_cast<double>(i));
    return numbers;
}

/// On ranks, each item is a number on its owner and −1 on the others; `gather` must make the array whole on the first.
/// \param owner_of (part, item) \param gather (part, array)
template <class OwnerOf, class Gather>
void expect_gathered(std::size_t n_items, const OwnerOf& owner_of, const Gather& gather) {
    test::SmallRun run = test::varied_phases(test::jittered_grid(8, 16, 0.04, 0.08, 0.25)).run(LawVariant::consistent);
    const Assemblage& a = run.assemblage;
    for (int n = 1; n <= 5; ++n) {
        test::on_thread_ranks(n, [&](const Ranks& ranks) {
            const Part part = make_part(a, run.boundary.prescribed, ranks);
            const std::vector<double> whole = numbers_from(n_items, 5);
            std::vector<double> values = whole;
            for (std::size_t i = 0; i < n_items; ++i) values[i] = owner_of(part, i) == ranks.rank() ? whole[i] : -1;
            const std::vector<double> own = values;
            gather(part, values);
            EXPECT_EQ(values, ranks.is_first() ? whole : own) << n;
        });
    }
}

TEST(Gather, ItemsOfOwnersInAnyOrder) {
    expect_gathered(
        100, [](const Part& part, std::size_t i) { return static_cast<int>(i * i % 7) % part.ranks->size(); },
        [](const Part& part, std::vector<double>& values) {
            gather_items(
                part, [&](std::int32_t i) { return i * i % 7 % part.ranks->size(); }, values);
        });
}

TEST(Gather, ValuesOfNodes) {
    const std::size_t n_nodes = 8 * 16 * 2 * 3;
    expect_gathered(
        n_nodes, [](const Part& part, std::size_t i) { return part.owner_of_node(static_cast<std::int32_t>(i)); },
        [](const Part& part, std::vector<double>& values) { gather_nodes(part, values); });
    std::vector<double> none;
    test::on_thread_ranks(2, [&](const Ranks& ranks) {
        Part part;
        part.ranks = &ranks;
        part.first_node = {0, 3, 6};
        gather_nodes(part, none);  // an array that does not exist
    });
    EXPECT_TRUE(none.empty());
}

TEST(Gather, ValuesOfChunksOfWhichTheLastMayLackSome) {
    const test::SmallRun run = test::varied_phases(test::jittered_grid(8, 16, 0.04, 0.08, 0.25)).run(LawVariant::consistent);
    const std::size_t n_chunks = run.assemblage.contact_chunks.size();
    for (const std::size_t lacking : {0U, 2U}) {
        expect_gathered(
            3 * n_chunks - lacking,
            [](const Part& part, std::size_t i) { return part.contacts.owner_of(static_cast<std::int32_t>(i / 3)); },
            [](const Part& part, std::vector<double>& values) { gather_chunks(part, part.contacts, 3, values); });
    }
}

}  // namespace
}  // namespace graincrack
