#include "post/chart/picture_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "share/base/error.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

TEST(PictureFolder, AppearsWholeOrNotAtAll) {
    const test::TemporaryFolder folder;
    const std::string path = folder.file("film");
    const auto names = [](const std::string& of) {
        std::set<std::string> found;
        for (const auto& each : std::filesystem::directory_iterator(of)) found.insert(each.path().filename());
        return found;
    };
    const auto write = [&](std::size_t n, std::size_t fails_at) {
        write_picture_folder(path + "/", n, [&](std::size_t i) {
            if (i == fails_at) throw InputError("no frame");
            return std::vector<unsigned char>{'x'};
        });
    };
    EXPECT_THROW(write(2, 1), InputError);
    EXPECT_EQ(names(folder.file("")), std::set<std::string>{});
    write(3, 9);
    EXPECT_THROW(write(2, 1), InputError);
    EXPECT_EQ(names(path), (std::set<std::string>{"frame-0001.png", "frame-0002.png", "frame-0003.png"}));
    write(2, 9);  // in place of the others
    EXPECT_EQ(names(path), (std::set<std::string>{"frame-0001.png", "frame-0002.png"}));
    test::GoldenRefusals refused;
    for (const char* other : {"notes.txt", "frame-1.png"}) {
        std::ofstream(path + "/" + other) << "mine";
        refused.add<OutputError>("another file", [&] { write(1, 9); });
        std::filesystem::remove(path + "/" + other);
    }
    EXPECT_EQ(names(folder.file("")), std::set<std::string>{"film"});
    std::ofstream(folder.file("file")) << "mine";
    refused.add<OutputError>("a file", [&] { write_picture_folder(folder.file("file"), 0, {}); });
    refused.add<OutputError>("below none", [&] { write_picture_folder(folder.file("none/film"), 0, {}); });
}

}  // namespace
}  // namespace graincrack
