// HDF5 files: they appear complete or not at all, give back what was written, and a file that cannot be read gives a one-line
// error.
#include "share/file/h5_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "tests/support/golden_refusals.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

/// A file in a folder of its own.
struct TestFile : TemporaryFolder, H5Output {
    explicit TestFile(const std::string& kind) : H5Output(file("a.h5"), kind) {}
    H5Input read() {
        commit();
        return H5Input(file("a.h5"));
    }
};

template <class T>
void write_column(H5Output& file, const std::string& path, const std::vector<T>& values) {
    file.write<T>(path, std::span<const T>(values), {values.size()}, "1", "a test");
}

void write_bytes(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

template <class T>
void expect_round_trip(const std::vector<T>& values) {
    TestFile out("specimen");
    write_column(out, "/group/deeper/values", values);
    const H5Input in = out.read();
    EXPECT_EQ(in.read<T>("/group/deeper/values"), values);
    EXPECT_EQ(in.extents("/group/deeper/values"), Extents{values.size()});
}

TEST(H5File, GivesBackEveryTypeToTheLastBit) {
    expect_round_trip<double>({0.0, -0.0, 1.0 / 3, -1e308, std::numeric_limits<double>::denorm_min()});
    expect_round_trip<std::int32_t>({0, -1, std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()});
    expect_round_trip<std::int64_t>({0, -1, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()});
    expect_round_trip<std::uint8_t>({0, 1, 127, 128, 255});
}

TEST(H5File, KeepsTheShapeOfEmptyArraysAndRefusesValuesThatDoNotFillTheirs) {
    TestFile out("specimen");
    out.write<double>("/none", {}, {0}, "m", "nothing");
    out.write<std::int32_t>("/rows", {}, {0, 4}, "1", "no rows");
    const std::vector<double> three{1, 2, 3};
    EXPECT_THROW(out.write<double>("/x", three, {2, 2}, "1", ""), std::logic_error);
    EXPECT_THROW(out.append<double>("/x", three, {2}, "1", ""), std::logic_error);
    const H5Input in = out.read();
    EXPECT_TRUE(in.read<double>("/none").empty());
    EXPECT_EQ(in.extents("/rows"), (Extents{0, 4}));
}

TEST(H5File, GivesBackAttributesOfEveryType) {
    const std::vector<std::string> names{"quartz", "", "Glimmer µ φ"};
    TestFile out("specimen");
    out.create_group("/g");
    out.attribute("/g", "real", 1.0 / 3);
    out.attribute("/g", "whole", std::int64_t{-7000000000});
    out.attribute("/g", "text", std::string("tan φ = µ"));
    out.attribute("/g", "empty", std::string());
    out.attribute("/g", "reals", std::vector<double>{1, 2.5});
    out.attribute("/g", "wholes", std::vector<std::int64_t>{1, 0});
    out.attribute("/g", "texts", names);
    out.attribute("/g", "no_texts", std::vector<std::string>{});
    out.quantity("/g", "edge", 0.004, "m");
    out.attribute("/g", "real", 0.25);  // written again: replaced
    const H5Input in = out.read();
    EXPECT_EQ(in.attribute<double>("/g", "real"), 0.25);
    EXPECT_EQ(in.attribute<std::int64_t>("/g", "whole"), -7000000000);
    EXPECT_EQ(in.attribute<std::string>("/g", "text"), "tan φ = µ");
    EXPECT_EQ(in.attribute<std::string>("/g", "empty"), "");
    EXPECT_EQ(in.attribute<std::vector<double>>("/g", "reals"), (std::vector<double>{1, 2.5}));
    EXPECT_EQ(in.attribute<std::vector<std::int64_t>>("/g", "wholes"), (std::vector<std::int64_t>{1, 0}));
    EXPECT_EQ(in.attribute<std::vector<std::string>>("/g", "texts"), names);
    EXPECT_TRUE(in.attribute<std::vector<std::string>>("/g", "no_texts").empty());
    EXPECT_EQ(in.attribute<std::string>("/g", "edge_unit"), "m");
    EXPECT_EQ(in.attribute_or<double>("/g", "missing", 4.0), 4.0);
    const auto number = [&](const char* name) { static_cast<void>(in.attribute<double>("/g", name)); };
    test::GoldenRefusals().add_each<InputError>({"missing", "text", "reals"}, number);
}

TEST(H5File, MakesDatasetsOfAttributesAboveTheLimitOfTheLibrary) {
    const std::string text(100'000, 'a');
    const std::vector<std::string> texts{"b", "", std::string(70'000, 'c')};
    const std::vector<double> numbers(10'000, 0.5);
    TestFile out("run");
    out.create_group("/g");
    write_column<std::int32_t>(out, "/g/codes", {1, 2});
    for (const char* object : {"/", "/g", "/g/codes"}) {
        out.attribute(object, "text", std::string("short"));
        for (int twice = 0; twice < 2; ++twice) out.attribute(object, "text", text);
        out.attribute(object, "texts", texts);
        out.attribute(object, "numbers", numbers);
    }
    const H5Input in = out.read();
    for (const char* object : {"/", "/g", "/g/codes"}) {
        EXPECT_EQ(in.attribute<std::string>(object, "text"), text);
        EXPECT_EQ(in.attribute_or<std::vector<std::string>>(object, "texts", {}), texts);
        EXPECT_EQ(in.attribute<std::vector<double>>(object, "numbers"), numbers);
    }
    EXPECT_EQ(in.extents("/g/codes_texts"), (Extents{3, 70'000}));
    EXPECT_THROW(static_cast<void>(in.attribute<double>("/g", "numbers")), InputError);
}

TEST(H5File, HasUnitAndDescriptionOfDatasets) {
    TestFile out("specimen");
    out.write<double>("/nodes/position", std::vector<double>{1, 2, 3, 4}, {2, 2}, "m", "places");
    const H5Input in = out.read();
    EXPECT_EQ(in.attribute<std::string>("/nodes/position", "unit"), "m");
    EXPECT_EQ(in.attribute<std::string>("/nodes/position", "description"), "places");
    EXPECT_EQ(in.describe(), (std::vector<std::string>{"/nodes/position float64 [2,2] m places"}));
    EXPECT_EQ(in.children("/"), (std::vector<std::string>{"nodes"}));
    EXPECT_TRUE(in.children("/nowhere").empty());
    EXPECT_TRUE(in.has("/nodes/position"));
    EXPECT_FALSE(in.has("/nowhere/at/all"));
}

TEST(H5File, AppendsInPieces) {
    TestFile out("run");
    std::vector<double> all;
    for (const std::size_t rows : {0U, 3U, 1U, 5000U, 0U, 2U}) {
        std::vector<double> piece(2 * rows);
        std::iota(piece.begin(), piece.end(), static_cast<double>(all.size()));
        out.append<double>("/history/pairs", piece, {rows, 2}, "1", "grows");
        all.insert(all.end(), piece.begin(), piece.end());
    }
    const H5Input in = out.read();
    EXPECT_EQ(in.extents("/history/pairs"), (Extents{5006, 2}));
    EXPECT_EQ(in.read<double>("/history/pairs"), all);
}

TEST(H5File, LinksMovesAndRemoves) {
    TestFile out("run");
    write_column<double>(out, "/frames/part3/velocity", {1, 2});
    write_column<double>(out, "/frames/part4/velocity", {3, 4});
    out.remove("/frames/part4");
    out.move("/frames/part3", "/frames/0000");
    out.hard_link("/frames/0000/velocity", "/VTKHDF/PointData/velocity");
    EXPECT_THROW(out.hard_link("/frames/none", "/VTKHDF/x"), OutputError);
    EXPECT_THROW(out.move("/frames/none", "/frames/1"), OutputError);
    const H5Input in = out.read();
    EXPECT_EQ(in.children("/frames"), (std::vector<std::string>{"0000"}));
    EXPECT_EQ(in.read<double>("/VTKHDF/PointData/velocity"), (std::vector<double>{1, 2}));
}

TEST(H5File, ConvertsNumbersAndRefusesWhatIsMissing) {
    TestFile out("run");
    write_column<std::int32_t>(out, "/step", {1, 2});
    const H5Input in = out.read();
    EXPECT_EQ(in.read<double>("/step"), (std::vector<double>{1, 2}));
    test::GoldenRefusals refused;
    refused.add<InputError>("read", [&] { static_cast<void>(in.read<double>("/nothing")); });
    refused.add<InputError>("extents", [&] { static_cast<void>(in.extents("/a/b")); });
}

// --- whole or not at all ---------------------------------------------------------------------------------------------

TEST(H5File, IsLeftAsItWasWithoutACommit) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.h5");
    const auto write = [&](double value, bool is_committed) {
        const bool existed = fs::exists(file);
        H5Output out(file, "specimen");
        write_column<double>(out, "/x", {value});
        out.flush();
        EXPECT_TRUE(fs::exists(file + ".part"));
        EXPECT_EQ(fs::exists(file), existed);
        if (is_committed) out.commit();
    };
    write(1, false);
    EXPECT_TRUE(folder.is_empty());
    write(1, true);
    const std::string before = text_of_file(file);
    write(2, false);
    EXPECT_EQ(text_of_file(file), before);
    EXPECT_FALSE(fs::exists(file + ".part"));
    write(3, true);
    EXPECT_EQ(H5Input(file).read<double>("/x"), std::vector<double>{3});
}

TEST(H5File, IsAnOutputErrorAndLeavesNoPartIfItCannotBeWritten) {
    const TemporaryFolder folder;
    {
        H5Output out(folder.file("a.h5"), "specimen");
        fs::create_directory(folder.file("a.h5"));  // another program made a folder of that name meanwhile
        EXPECT_THROW(out.commit(), OutputError);
    }
    EXPECT_FALSE(fs::exists(folder.file("a.h5.part")));
    test::GoldenRefusals().add_each<OutputError>({"a.h5", "no/a.h5"},
                                                 [&](const char* name) { H5Output(folder.file(name), "run"); });
}

TEST(H5File, GoesThroughAPipe) {
    const TemporaryFolder folder;
    const int saved_out = ::dup(STDOUT_FILENO);
    const int saved_in = ::dup(STDIN_FILENO);
    const int image = ::open(folder.file("image").c_str(), O_RDWR | O_CREAT, 0600);
    ASSERT_GE(image, 0);
    ::dup2(image, STDOUT_FILENO);
    {
        H5Output out("-", "specimen");
        EXPECT_TRUE(out.is_stream());
        write_column<double>(out, "/x", {1, 2, 3});
        out.flush();
        out.commit();
    }
    ::dup2(saved_out, STDOUT_FILENO);
    ::close(saved_out);
    ::lseek(image, 0, SEEK_SET);
    ::dup2(image, STDIN_FILENO);
    {
        const H5Input in("-", "specimen");
        EXPECT_EQ(in.name(), "stdin");
        EXPECT_EQ(in.read<double>("/x"), (std::vector<double>{1, 2, 3}));
    }
    // After it was read to its end, the stream is empty, as when the program before wrote nothing.
    test::GoldenRefusals().add<InputError>("read again", [] { H5Input("-"); });
    ::dup2(saved_in, STDIN_FILENO);
    ::close(saved_in);
    ::close(image);
}

// --- what cannot be read ---------------------------------------------------------------------------------------------

/// Numbers that compression makes small.
std::vector<double> large() {
    std::vector<double> values(100000);
    std::iota(values.begin(), values.end(), 0.5);
    return values;
}
std::string large_file() {
    TestFile out("specimen");
    write_column(out, "/x", large());
    out.read();
    return text_of_file(out.file("a.h5"));
}

TEST(H5File, IsRefusedWithALineOfItsOwnForEachFault) {
    const TemporaryFolder folder;
    const std::string good = folder.file("good.h5");
    const std::string bytes = large_file();
    EXPECT_LT(bytes.size(), 400000U) << "compressed to half";
    write_bytes(good, bytes);
    test::GoldenRefusals refused;
    const auto read = [&](const std::string& name, const std::string& content) {
        write_bytes(folder.file(name), content);
        refused.add<InputError>(name, [&] { H5Input(folder.file(name)); });
    };
    read("empty.h5", "");
    read("text.h5", "this is no HDF5 file, but it is long enough to look into");
    read("half.h5", bytes.substr(0, bytes.size() / 2));
    read("head.h5", bytes.substr(0, 100));
    read("last.h5", bytes.substr(0, bytes.size() - 1));
    refused.add<InputError>("none.h5", [&] { H5Input(folder.file("none.h5")); });
    refused.add<InputError>("folder", [&] { H5Input(folder.file("")); });
    refused.add<InputError>("kind", [&] { H5Input(good, "run"); });
    const auto write = [&](const std::string& name, const std::string& format, std::int64_t version) {
        H5Output file(folder.file(name), "specimen");
        file.attribute("/", "format", format);
        file.attribute("/", "schema_version", version);
        file.commit();
        if (version != schema_version || format != "graincrack") {
            refused.add<InputError>(name, [&] { H5Input(folder.file(name)); });
        }
    };
    write("foreign.h5", "neper", 1);
    write("newer.h5", "graincrack", schema_version + 1);
    write("older.h5", "graincrack", schema_version - 1);
    write("same.h5", "graincrack", schema_version);
    EXPECT_NO_THROW(H5Input(folder.file("same.h5")));
    const H5Input in(good, "specimen");
    EXPECT_NO_THROW(in.check());
    EXPECT_EQ(in.read<double>("/x"), large());
}

TEST(H5File, FindsDamageInsideADataset) {
    const TemporaryFolder folder;
    std::string bytes = large_file();
    for (std::size_t i = bytes.size() / 2; i < bytes.size() / 2 + 64; ++i) {
        bytes[i] = static_cast<char>(~bytes[i]);  // in the middle of a compressed chunk
    }
    write_bytes(folder.file("a.h5"), bytes);
    test::expect_one_line<InputError>([&] { H5Input(folder.file("a.h5")).check(); }, {"a.h5", "/x"});
}

// --- digest ----------------------------------------------------------------------------------------------------------

std::string digest_of(const std::function<void(H5Output&)>& change) {
    TestFile out("run");
    out.write<double>("/x", std::vector<double>{1, 2, 3, 4}, {2, 2}, "m", "numbers");
    write_column<std::int32_t>(out, "/i", {1});
    out.create_group("/run");
    out.attribute("/run", "law", std::string("scaled"));
    change(out);
    return out.read().digest();
}

TEST(H5File, NamesTheObjectOfAnAttributeThatCannotBeDecoded) {
    TestFile out("run");
    out.create_group("/run");
    for (int i = 0; i < 30; ++i) out.attribute("/run", "good" + std::to_string(i), 1.5);
    out.attribute("/run", "spoiled", 1.5);
    out.commit();
    std::string bytes = text_of_file(out.file("a.h5"));
    const std::size_t type = bytes.find("spoiled") + 8;  // the type of an attribute follows its name
    ASSERT_EQ(bytes.at(type), 0x11);                     // a float, described by version 1
    bytes[type] = '\xff';
    write_bytes(out.file("a.h5"), bytes);
    const H5Input in(out.file("a.h5"), "run");
    EXPECT_EQ(in.attribute<double>("/run", "good0"), 1.5);
    test::GoldenRefusals refused;
    refused.add<InputError>("check", [&] { in.check(); });
    refused.add<InputError>("digest", [&] { static_cast<void>(in.digest()); });
}

TEST(H5File, HasADigestOfItsContent) {
    const std::string digest = digest_of([](H5Output&) {});
    EXPECT_EQ(digest.size(), 64U);
    EXPECT_EQ(digest, digest_of([](H5Output&) {}));
    EXPECT_EQ(digest, digest_of([](H5Output& out) {
                  write_column<double>(out, "/provenance/x", {1});
                  out.attribute("/provenance", "wall_time", 3.0);
              }));
}

TEST(H5File, HasAnotherDigestAfterEveryChange) {
    std::vector<std::string> digests{digest_of([](H5Output&) {})};
    const std::vector<std::function<void(H5Output&)>> changes{
        [](H5Output& out) {
            out.remove("/x");
            out.write<double>("/x", std::vector<double>{1, 2, 3, std::nextafter(4.0, 5.0)}, {2, 2}, "m", "numbers");
        },
        [](H5Output& out) {
            out.remove("/x");
            out.write<double>("/x", std::vector<double>{1, 2, 3, 4}, {4, 1}, "m", "numbers");
        },
        [](H5Output& out) {
            out.remove("/i");
            write_column<std::int64_t>(out, "/i", {1});
        },
        [](H5Output& out) { out.move("/i", "/j"); },
        [](H5Output& out) { out.attribute("/x", "unit", std::string("mm")); },
        [](H5Output& out) { out.attribute("/run", "law", std::string("literal")); },
        [](H5Output& out) { out.attribute("/run", "steps", std::int64_t{1}); },
        [](H5Output& out) { out.attribute("/", "kind", std::string("specimen")); },
        [](H5Output& out) { out.create_group("/provenance2"); },
    };
    for (const auto& change : changes) {
        const std::string digest = digest_of(change);
        EXPECT_EQ(std::count(digests.begin(), digests.end(), digest), 0) << "change " << digests.size();
        digests.push_back(digest);
    }
}

}  // namespace
}  // namespace graincrack
