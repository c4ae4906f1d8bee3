// Where a film goes: names and sizes, the program that encodes it, a folder of pictures.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "post/film/child_process.hpp"
#include "post/film/film.hpp"
#include "post/film/picture_folder.hpp"
#include "post/film/video_file.hpp"
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

TEST(Encoding, TakesWhatThereIs) {
    const auto codec = [](const std::string& path, const std::vector<std::string>& encoders) {
        return encoding_of(path, encoders).at(1);
    };
    EXPECT_EQ(codec("film.mp4", {"mpeg4", "libx264"}), "libx264");
    EXPECT_EQ(codec("film.mp4", {"mpeg4"}), "mpeg4");
    EXPECT_EQ(codec("film.webm", {"libvpx-vp9", "libx264"}), "libvpx-vp9");
    test::expect_one_line<OutputError>([] { encoding_of("film.webm", {"libx264"}); }, {"no encoder for VP9"});
    test::expect_one_line<OutputError>([] { encoding_of("film.mp4", {"flv"}); }, {"no encoder for H.264"});
}

TEST(ChildProcess, KeepsWhatAProgramPrintsAndItsExitCode) {
    EXPECT_EQ(ChildProcess::start({"graincrack-no-such-program"}), nullptr);
    const auto child = ChildProcess::start({"sh", "-c", "cat; echo wrong >&2; exit 3"});
    ASSERT_NE(child, nullptr);
    const std::vector<unsigned char> bytes(300000, 'x');
    EXPECT_TRUE(child->write(bytes));
    EXPECT_EQ(child->wait(), 3);
    EXPECT_EQ(child->output(), std::string(300000, 'x'));
    EXPECT_EQ(child->errors(), "wrong\n");
}

TEST(ChildProcess, TakesNoMoreOnceItHasEnded) {
    const auto child = ChildProcess::start({"sh", "-c", "exec <&-; exit 7"});
    ASSERT_NE(child, nullptr);
    const std::vector<unsigned char> bytes(300000, 'x');
    EXPECT_FALSE(child->write(bytes));
    EXPECT_EQ(child->wait(), 7);
    const auto sleeping = ChildProcess::start({"sleep", "1000"});  // is ended with its handle
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

TEST(PictureFolder, NamesTheCommandThatJoinsIt) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("film/");
    EXPECT_EQ(PictureFolder(path, {640, 480}, 250).joining_command("film.mp4", 25),
              "ffmpeg -framerate 25 -i " + path + "frame_%04d.png -c:v libx264 -pix_fmt yuv420p -movflags +faststart film.mp4");
    const std::string odd = folder.file("it's 5 %");
    const std::string command = PictureFolder(odd, {640, 480}, 20000).joining_command("a b.mp4", 2);
    EXPECT_NE(command.find("it'\\''s 5 %%/frame_%05d.png' "), std::string::npos) << command;
    EXPECT_TRUE(command.ends_with(" 'a b.mp4'")) << command;
}

}  // namespace
}  // namespace graincrack
