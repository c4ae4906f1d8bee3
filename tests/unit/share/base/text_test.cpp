#include "share/base/text.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

using Texts = std::vector<std::string_view>;

TEST(Split, GivesPartsBetweenSeparators) {
    EXPECT_EQ(split("a,b,,c", ','), (Texts{"a", "b", "", "c"}));
    EXPECT_EQ(split("a,", ','), (Texts{"a", ""}));
    EXPECT_EQ(split("", ','), Texts{""});
    EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
    EXPECT_EQ(trimmed(" "), "");
}

TEST(KeyAndValue, AreDividedByTheFirstEqualsSign) {
    EXPECT_EQ(key_and_value("a=b=c", "--set", "KEY=VALUE"), (std::pair<std::string, std::string>("a", "b=c")));
    EXPECT_EQ(key_and_value("a=", "--set", "KEY=VALUE").second, "");
    const auto read = [](const std::string& text) { key_and_value(text, "--set", "KEY=VALUE"); };
    test::GoldenRefusals().add_each<UsageError>({"", "a", "=b"}, read);
}

TEST(TextOfFile, IsThatOfAPipeAtEachCallAndHasAnEnd) {
    const test::TemporaryFolder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(pipe) << "a = 1\n"; });
    EXPECT_EQ(text_of_file(pipe), "a = 1\n");
    writer.join();
    EXPECT_EQ(text_of_toml(pipe), "a = 1\n");
    test::GoldenRefusals().add<InputError>("no end", [] { text_of_toml("/dev/zero"); });
}

}  // namespace
}  // namespace graincrack
