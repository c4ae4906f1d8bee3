// The output of a film: names and sizes, a folder of pictures, the command that joins them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "post/film/film.hpp"
#include "post/film/picture_folder.hpp"
#include "share/base/error.hpp"
#include "tests/support/check.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

TEST(FilmSize, IsEvenAndWide) {
    EXPECT_EQ(parse_film_size("1280x720").width, 1280);
    EXPECT_EQ(parse_film_size("1280x720").height, 720);
    for (const char* wrong : {"", "1280", "x720", "1280x", "1281x720", "1280x720x2", "1280 x 720", "100x80", "9000x5000",
                              "720x1280", "4000x240", "-1280x720"}) {
        test::expect_one_line<UsageError>([&] { parse_film_size(wrong); }, {"--size"});
    }
}

TEST(FilmName, IsThatOfAVideoOrOfAFolder) {
    EXPECT_TRUE(is_video_name("film.mp4"));
    EXPECT_TRUE(is_video_name("a.b/film.webm"));
    for (const char* folder : {"film", "film/", "a.b/film", ".", "/tmp", "v1.2/"}) EXPECT_FALSE(is_video_name(folder)) << folder;
    for (const char* wrong : {"film.avi", "film.gif", "film.png", "-"}) {
        test::expect_one_line<UsageError>([&] { is_video_name(wrong); }, {"--output"});
    }
}

TEST(FilmLength, IsOfTwoPicturesAtLeast) {
    EXPECT_EQ(n_pictures(10, 25), 250U);
    EXPECT_EQ(n_pictures(0.1, 20), 2U);
    test::expect_one_line<UsageError>([] { n_pictures(0.05, 25); }, {"two pictures from 0.08s on"});
}

TEST(PictureFolder, AppearsWholeOrNotAtAll) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("film");
    const auto names = [&] {
        std::set<std::string> found;
        for (const auto& each : std::filesystem::directory_iterator(folder.file(""))) found.insert(each.path().filename());
        return found;
    };
    Drawing drawing(640, 480);
    const auto write = [&](int n, bool whole) {
        PictureFolder pictures(path, {640, 480}, 12);
        for (int i = 0; i < n; ++i) pictures.add(drawing);
        if (whole) pictures.commit();
    };
    write(2, false);
    EXPECT_EQ(names(), std::set<std::string>{});
    write(3, true);
    EXPECT_EQ(names(), std::set<std::string>{"film"});
    write(1, false);
    EXPECT_TRUE(std::filesystem::exists(path + "/frame_0003.png"));
    write(2, true);  // a film in place of another
    EXPECT_TRUE(std::filesystem::exists(path + "/frame_0002.png"));
    EXPECT_FALSE(std::filesystem::exists(path + "/frame_0003.png"));
    std::ofstream(path + "/notes.txt") << "mine";
    test::expect_one_line<OutputError>([&] { write(1, true); }, {"notes.txt"});
    EXPECT_EQ(names(), std::set<std::string>{"film"});
    test::expect_one_line<OutputError>([&] { PictureFolder(folder.file("none/film"), {640, 480}, 1); }, {"does not exist"});
}

}  // namespace
}  // namespace graincrack
