#include "share/base/text.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

using Texts = std::vector<std::string_view>;

TEST(Text, PartsBetweenSeparators) {
    EXPECT_EQ(split("a,b,,c", ','), (Texts{"a", "b", "", "c"}));
    EXPECT_EQ(split("a,", ','), (Texts{"a", ""}));
    EXPECT_EQ(split("", ','), Texts{""});
    EXPECT_EQ(trimmed(" \ta b\r\n"), "a b");
    EXPECT_EQ(trimmed(" "), "");
}

TEST(Text, KeysAndValues) {
    EXPECT_EQ(key_and_value("a=b=c", "--set", "KEY=VALUE"), (std::pair<std::string, std::string>("a", "b=c")));
    EXPECT_EQ(key_and_value("a=", "--set", "KEY=VALUE").second, "");
    for (const char* bad : {"", "a", "=b"}) {
        test::expect_one_line<UsageError>([&] { key_and_value(bad, "--set", "KEY=VALUE"); }, {"--set ", "KEY=VALUE is needed"});
    }
}

TEST(Text, TheNearestWordIsNotFar) {
    EXPECT_EQ(did_you_mean("confning-pressure", {"edge", "confining-pressure"}), " (did you mean confining-pressure?)");
    EXPECT_EQ(did_you_mean("colour", {"edge", "spread"}), "");
}

TEST(Text, APipeGivesItsBytesAtEachCallAndWhatHasNoEndIsRefused) {
    const test::TemporaryFolder folder;
    const std::string pipe = folder.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(pipe) << "a = 1\n"; });
    EXPECT_EQ(text_of_file(pipe), "a = 1\n");
    writer.join();
    EXPECT_EQ(text_of_toml(pipe), "a = 1\n");
    test::expect_one_line<InputError>([] { text_of_toml("/dev/zero"); }, {"/dev/zero", "16 MB", "a TOML file is needed"});
}

}  // namespace
}  // namespace graincrack
