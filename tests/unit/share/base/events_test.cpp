// Events are whole lines of JSON; lines on stderr stay as they are beside them.
#include "share/base/events.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

using Json = nlohmann::json;
using test::TemporaryFolder;

std::vector<Json> read_events(const std::string& path) {
    std::ifstream file(path);
    std::vector<Json> events;
    for (std::string line; std::getline(file, line);) events.push_back(Json::parse(line));
    return events;
}

// Each in a process of its own (EXPECT_EXIT), since events are opened once.
TEST(Events, AreLinesOfJsonBesideThoseOfStderr) {
    const TemporaryFolder folder;
    const std::string path = folder.file("events");
    const auto work = [&] {
        const int code = run_tool("graincrack-test", [&]() -> int {
            open_events(path);
            std::ostringstream out;
            say(out, "disc: 3 \"grains\"\\");
            warn(out, "strength", {"grains\x1b", "few_crystals"}, "a\xff.h5");
            tell_progress("mesh", 0.5, "half");
            add_to_outcome("stop_reason", "peak drop");
            add_to_outcome("strength", 1.5e8);
            add_output_to_outcome("run.h5");
            if (out.str() != "disc: 3 \"grains\"\\\nstrength: warning: grains\\x1b\n") return 9;
            throw InputError("a\nb");
        });
        std::exit(code);
    };
    EXPECT_EXIT(work(), testing::ExitedWithCode(3), "^graincrack-test: a b\n$");
    const std::vector<Json> events = read_events(path);
    ASSERT_EQ(events.size(), 4U);
    EXPECT_EQ(events[1]["text"], "grains\x1b");  // as it is
    std::string text;
    for (const Json& event : events) text += event.dump() + "\n";
    test::expect_golden(text);
}

TEST(Events, NeedADescriptorThatIsOpenForWriting) {
    test::GoldenRefusals refused;
    refused.add_each<UsageError>({"987", "99999999999999999999"}, open_events);
    const int reading = ::open("/dev/null", O_RDONLY);
    EXPECT_THROW(open_events(std::to_string(reading)), UsageError);
    ::close(reading);
    refused.add<OutputError>("no folder", [] { open_events("/no/such/folder/events"); });
}

TEST(Events, WithoutAReaderStopTheWorkAsAHangUp) {
    const auto work = [] {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) std::exit(9);
        open_events(std::to_string(ends[1]));
        ::close(ends[0]);
        catch_stop_signals();
        tell_progress("mesh", 0.5, "half");
        tell_progress("mesh", 0.6, "more");  // nobody is there: no second signal
        std::exit(stop_signal());
    };
    EXPECT_EXIT(work(), testing::ExitedWithCode(SIGHUP), "");
}

TEST(Events, OfOtherRanksAreNotWritten) {
    const TemporaryFolder folder;
    const auto work = [&] {
        leave_events();
        open_events(folder.file("events"));
        std::exit(std::filesystem::exists(folder.file("events")) ? 1 : 0);
    };
    EXPECT_EXIT(work(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace graincrack
