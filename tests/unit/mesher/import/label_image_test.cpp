#include "mesher/import/label_image.hpp"

#include <gtest/gtest.h>

#include "share/base/error.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/rows.hpp"
#include "tests/unit/mesher/import/png_writer.hpp"

namespace graincrack::mesher {
namespace {

/// The refusal of a picture.
void add(test::Refusals& refused, const std::string& what, const std::string& bytes) {
    refused.add<InputError>(what, [&] { read_label_image(bytes, "section"); });
}

TEST(LabelImage, ReadsTheLabelsOfEveryKindOfPng) {
    const std::vector<int> bytes{0, 1, 2, 255, 7, 7};
    for (const bool interlaced : {false, true}) {
        const LabelImage grey = read_label_image(png_of(3, 2, bytes, {PNG_COLOR_TYPE_GRAY, 8, interlaced}), "");
        EXPECT_EQ(grey.width, 3);
        EXPECT_EQ(grey.height, 2);
        EXPECT_EQ(grey.labels, bytes);
        test::expect_golden(grey.format);
        EXPECT_EQ(read_label_image(png_of(3, 2, bytes, {PNG_COLOR_TYPE_PALETTE, 8, interlaced}), "").labels, bytes);
        const std::vector<int> words{0, 1, 256, 65535, 30000, 255};
        EXPECT_EQ(read_label_image(png_of(3, 2, words, {PNG_COLOR_TYPE_GRAY, 16, interlaced}), "").labels, words);
    }
    for (const int bits : {1, 2, 4}) {
        const std::vector<int> few{0, 1, 1, 0, (1 << bits) - 1, 1};
        EXPECT_EQ(read_label_image(png_of(3, 2, few, {PNG_COLOR_TYPE_GRAY, bits}), "").labels, few) << bits;
        EXPECT_EQ(read_label_image(png_of(3, 2, few, {PNG_COLOR_TYPE_PALETTE, bits}), "").labels, few) << bits;
    }
}

TEST(LabelImage, TakesEachColourForALabel) {
    const auto labels = [](const std::vector<int>& samples, int colour_type, int bits = 8) {
        return read_label_image(png_of(2, 1, samples, {colour_type, bits}), "").labels;
    };
    EXPECT_EQ(labels({0, 0, 0, 1, 2, 3}, PNG_COLOR_TYPE_RGB), (std::vector<int>{0, 0x010203}));
    EXPECT_EQ(labels({1, 2, 3, 255, 1, 2, 3, 254}, PNG_COLOR_TYPE_RGB_ALPHA), (std::vector<int>{0x010203, 0x01010203}));
    EXPECT_EQ(labels({9, 255, 9, 0}, PNG_COLOR_TYPE_GRAY_ALPHA), (std::vector<int>{9, static_cast<int>(0xff000009U)}));
    EXPECT_EQ(labels({9, 65535, 300, 65534}, PNG_COLOR_TYPE_GRAY_ALPHA, 16), (std::vector<int>{9, 0x1012c}));
}

TEST(LabelImage, ReadsText) {
    const LabelImage image = read_label_image("1\t2  3\r\n 4\t5\t2147483647 \n\n", "");
    EXPECT_EQ(image.width, 3);
    EXPECT_EQ(image.height, 2);
    EXPECT_EQ(image.labels, (std::vector<int>{1, 2, 3, 4, 5, 2147483647}));
    EXPECT_EQ(image.at(1, 1), 5);
    EXPECT_EQ(read_label_image("\xef\xbb\xbf"
                               "5",
                               "")
                  .labels,
              std::vector<int>{5});
}

TEST(LabelImage, RefusesBadText) {
    EXPECT_EQ(test::expect_refused<InputError>("mesher/import/label_image.toml",
                                               [](const std::string& text) { read_label_image(text, "section"); }),
              12U);
}

TEST(LabelImage, RefusesBadPictures) {
    test::Refusals refused;
    add(refused, "a JPEG", "\xff\xd8\xff\xe0");
    add(refused, "a TIFF", std::string("II*\0", 4));
    add(refused, "part of a signature", "\x89PNG");
    add(refused, "a signature alone", "\x89PNG\r\n\x1a\n");
    add(refused, "colours of 16 bits", png_of(1, 1, {1, 2, 3}, {PNG_COLOR_TYPE_RGB, 16}));
    // A picture of one row of 20,000 pixels whose header says that it has 20,000 rows.
    std::string bytes = png_of(20000, 1, std::vector<int>(20000), {PNG_COLOR_TYPE_GRAY, 1});
    bytes.replace(20, 4, std::string("\0\0\x4e\x20", 4));
    const unsigned long check = crc32(0, reinterpret_cast<const unsigned char*>(bytes.data()) + 12, 17);
    for (std::size_t k = 0; k < 4; ++k) bytes[29 + k] = static_cast<char>(check >> (24 - 8 * k) & 0xffU);
    add(refused, "more pixels than are read", bytes);
    test::expect_golden(refused.text());
}

TEST(LabelImage, RefusesDamagedPictures) {
    std::vector<int> samples(400);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<int>(i * i % 251);
    test::Refusals refused;
    for (const bool interlaced : {false, true}) {
        const std::string whole = png_of(20, 20, samples, {PNG_COLOR_TYPE_GRAY, 8, interlaced});
        for (std::size_t n = 8; n < whole.size(); ++n) add(refused, std::to_string(n) + " bytes", whole.substr(0, n));
        for (std::size_t i = 8; i < whole.size(); ++i) {
            std::string damaged = whole;
            damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
            add(refused, "another byte at " + std::to_string(i), damaged);
        }
    }
}

TEST(LabelImage, KnowsWhatLooksLikeOne) {
    EXPECT_TRUE(looks_like_labels(png_of(1, 1, {0})));
    for (const char* text : {"1 2\t3\r\n4 5 6\n", "1 -2"}) EXPECT_TRUE(looks_like_labels(text)) << text;
    for (const char* text : {"", "\n \n", "$MeshFormat\n4.1 0 8\n", "1.5 2"}) EXPECT_FALSE(looks_like_labels(text)) << text;
}

}  // namespace
}  // namespace graincrack::mesher
