#include "share/base/sha256.hpp"

#include <gtest/gtest.h>

namespace graincrack {
namespace {

TEST(Sha256, HasTheValuesOfItsStandard) {  // FIPS 180-2, appendix B
    EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Sha256, TellsTextsThatFollowOneAnotherApart) {
    Sha256 first, second;
    for (const char* text : {"ab", "c"}) first.add(std::string(text));
    for (const char* text : {"a", "bc"}) second.add(std::string(text));
    EXPECT_NE(first.hex(), second.hex());
}

}  // namespace
}  // namespace graincrack
