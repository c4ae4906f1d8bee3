// What ranks tell each other, and how errors of one end all.
#include "solver/ranks/ranks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "share/base/error.hpp"
#include "solver/ranks/alike.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/thread_ranks.hpp"

namespace graincrack::test {
namespace {

/// As many numbers as the rank has, and none of the first.
std::vector<double> numbers_of_rank(int rank) {
    std::vector<double> numbers(static_cast<std::size_t>(rank));
    std::iota(numbers.begin(), numbers.end(), 10.0 * rank);
    return numbers;
}

TEST(Ranks, GatherListsOfAnyLength) {
    for (int n = 1; n <= 5; ++n) {
        std::vector<std::vector<double>> expected;
        std::vector<double> one_after_the_other;
        for (int rank = 0; rank < n; ++rank) {
            expected.push_back(numbers_of_rank(rank));
            one_after_the_other.insert(one_after_the_other.end(), expected.back().begin(), expected.back().end());
        }
        on_thread_ranks(n, [&](const Ranks& ranks) {
            const std::vector<double> own = numbers_of_rank(ranks.rank());
            EXPECT_EQ(ranks.size(), n);
            EXPECT_EQ(ranks.gather_all(own), expected);
            std::vector<std::int32_t> counts(static_cast<std::size_t>(n));
            std::iota(counts.begin(), counts.end(), 0);
            EXPECT_EQ(ranks.gather_all(own, counts), expected);
            EXPECT_EQ(ranks.concatenate(own), one_after_the_other);
            EXPECT_EQ(ranks.gather_first(own), ranks.is_first() ? expected : std::vector<std::vector<double>>{});
        });
    }
}

TEST(Ranks, ExchangeWhatIsForEachOther) {
    for (int n = 1; n <= 5; ++n) {
        // From rank i to rank k go (i + 2 k) mod 4 numbers.
        const auto message = [](int from, int to) {
            return std::vector<std::int32_t>(static_cast<std::size_t>((from + 2 * to) % 4), 100 * from + to);
        };
        on_thread_ranks(n, [&](const Ranks& ranks) {
            std::vector<std::vector<std::int32_t>> sent;
            std::vector<std::vector<std::int32_t>> expected;
            for (int other = 0; other < n; ++other) {
                sent.push_back(message(ranks.rank(), other));
                expected.push_back(message(other, ranks.rank()));
            }
            EXPECT_EQ(ranks.exchange(sent), expected);
        });
    }
}

TEST(Ranks, AgreeOnNumbers) {
    for (int n = 1; n <= 5; ++n) {
        on_thread_ranks(n, [n](const Ranks& ranks) {
            const int rank = ranks.rank();
            EXPECT_EQ(ranks.of_first(rank + 7), 7);
            EXPECT_EQ(ranks.largest(-5.0 + rank), -6.0 + n);
            std::array largest{-1.0 * rank, 2.0 * rank};
            ranks.take_largest(largest);
            EXPECT_EQ(largest, (std::array{0.0, 2.0 * (n - 1)}));
            std::array<std::int64_t, 2> sums{rank, std::int64_t{1} << 40};
            ranks.take_sums(sums);
            EXPECT_EQ(sums, (std::array<std::int64_t, 2>{n * (n - 1) / 2, std::int64_t{n} << 40}));
            EXPECT_TRUE(ranks.any(rank == n - 1));
            EXPECT_FALSE(ranks.any(false));
        });
    }
}

TEST(Ranks, SendNumbersInAChannelRepeatedly) {
    on_thread_ranks(3, [](const Ranks& ranks) {
        // Around a circle: one number to the next rank, two numbers to the one before.
        const int next = (ranks.rank() + 1) % 3;
        const int before = (ranks.rank() + 2) % 3;
        const auto channel = ranks.open({{next, 1, 2}, {before, 2, 1}});
        for (int round = 0; round < 3; ++round) {
            channel->to_send(0)[0] = 10 * round + ranks.rank();
            channel->to_send(1)[0] = 100 + round;
            channel->to_send(1)[1] = ranks.rank();
            channel->start();
            channel->finish();
            EXPECT_EQ(channel->received(1)[0], 10 * round + before);
            EXPECT_EQ(channel->received(0)[0], 100 + round);
            EXPECT_EQ(channel->received(0)[1], next);
        }
        EXPECT_EQ(ranks.counts().messages, 6);
        EXPECT_EQ(ranks.counts().bytes, 9 * 8);
    });
    EXPECT_EQ(Ranks::alone().open({}), nullptr);
}

TEST(Ranks, DoOnTheFirstWhatIsDoneOnce) {
    for (const int n : {1, 3}) {
        std::vector<int> done;
        on_thread_ranks(n, [&](const Ranks& ranks) { ranks.on_first([&] { done.push_back(ranks.rank()); }); });
        EXPECT_EQ(done, std::vector<int>{0});
    }
}

/// What `on_first` throws on each rank if the first one throws `error`: its exit code and message, a line each.
template <class Exception>
std::string errors_on_first(const Exception& error) {
    std::array<std::string, 3> errors;
    on_thread_ranks(3, [&](const Ranks& ranks) {
        try {
            ranks.on_first([&] { throw error; });
        } catch (const Error& known) {
            errors[ranks.rank()] = std::to_string(static_cast<int>(known.code())) + " " + known.what();
        } catch (const std::exception& unknown) {
            errors[ranks.rank()] = unknown.what();
        }
        EXPECT_EQ(ranks.of_first(3), 3);  // all continue together
    });
    return errors[0] + "\n" + errors[1] + "\n" + errors[2] + "\n";
}

TEST(Ranks, ShareAnErrorOfTheFirst) {
    expect_golden(errors_on_first(OutputError("no space left")) + errors_on_first(std::runtime_error("unknown")));
    const auto fail = [](const Ranks& ranks) { ranks.on_first([] { throw InputError("of the first"); }); };
    EXPECT_THROW(fail(Ranks::alone()), InputError);
    EXPECT_THROW(on_thread_ranks(4, fail), InputError);
}

// --- ranks that are threads ------------------------------------------------------------------------------------------------

TEST(ThreadRanks, EndWithTheErrorOfAnyOfThem) {
    Refusals refused;
    for (int failing = 0; failing < 4; ++failing) {
        int n_continued = 0;
        const std::string name = "rank " + std::to_string(failing);
        refused.add<NumericalError>(name + " fails", [&] {
            on_thread_ranks(4, [&](const Ranks& ranks) {
                EXPECT_EQ(ranks.largest(1), 1);
                if (ranks.rank() == failing) throw NumericalError(name);
                static_cast<void>(ranks.largest(2));
                ++n_continued;
            });
        });
        EXPECT_EQ(n_continued, 0);
    }
    expect_golden(refused.text());
}

TEST(Ranks, PrepareAlikeOrNameWhatDiffers) {
    const auto prepare = [](const std::function<Facts(int)>& facts_of_rank) {
        on_thread_ranks(3, [&](const Ranks& ranks) { prepare_alike(ranks, [&] { return facts_of_rank(ranks.rank()); }); });
    };
    const auto settings = [](const SettingValue& rate) {
        return facts_of({{"rate", rate, Dimension::speed, SettingGroup::rate}, {"seed", 1.0}}, "--");
    };
    const auto fail = [&](int first) {
        prepare([first](int rank) {
            if (rank >= first) throw InputError("b.h5: no such file");
            return Facts{};
        });
    };
    EXPECT_NO_THROW(prepare([&](int) { return settings(5e-3); }));
    Refusals refused;
    refused.add<UsageError>("another rate",
                            [&] { prepare([&](int rank) { return settings(rank == 2 ? SettingValue("auto") : 5e-3); }); });
    refused.add<UsageError>("no rate", [&] { prepare([&](int rank) { return settings(rank == 2 ? SettingValue() : 5e-3); }); });
    refused.add<UsageError>("another file", [&] { prepare([](int rank) { return Facts{{"a.h5", rank == 1 ? "f0" : "f1"}}; }); });
    refused.add<UsageError>("no file on a rank", [&] { fail(1); });
    refused.add<InputError>("no file", [&] { fail(0); });
    expect_golden(refused.text());
}

}  // namespace
}  // namespace graincrack::test
