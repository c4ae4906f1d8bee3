#include "share/base/text.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/check.hpp"

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

}  // namespace
}  // namespace graincrack
