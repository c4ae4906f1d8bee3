// Settings in files, and where two differ.
#include "share/file/settings.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "share/base/error.hpp"
#include "share/file/h5_file.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack {
namespace {

const Settings one_of_each{
    {"edge"},
    {"cool", true, Dimension::one, SettingGroup::heat},
    {"width", 0.08, Dimension::length, SettingGroup::size},
    {"grains", 1122.0},
    {"seed", std::uint64_t{1} << 63U, Dimension::one, SettingGroup::seed},
    {"tessellation", "voronoi", Dimension::one, SettingGroup::fabric},
    {"holes", std::vector{0.0, 1.0 / 3, 2e-3}, Dimension::length, SettingGroup::cuts},
    {"flaw_classes", std::vector<std::string>{"joint broken", "\"quoted\""}, Dimension::one, SettingGroup::cuts}};

/// Reads settings back from the group of a file, whose attribute of fields `change` may damage.
template <class Change>
Settings read_back(const Change& change) {
    const test::TemporaryFolder folder;
    H5Output out(folder.file("s.h5"), "specimen");
    out.create_group("/specimen");
    write_settings(out, "/specimen", one_of_each);
    change(out);
    out.commit();
    return read_settings(H5Input(folder.file("s.h5")), "/specimen");
}

TEST(Settings, OfEveryTypeComeBackFromAFile) {
    EXPECT_EQ(read_back([](H5Output&) {}), one_of_each);
}

TEST(Settings, AreRefusedIfTheyAreDamaged) {
    test::Refusals refused;
    for (const std::string text : {"{", "{}", R"({"edge": {"unit": "1"}})"}) {
        const auto damage = [&](H5Output& out) { out.attribute("/specimen", "request_fields", text); };
        refused.add<InputError>(text, [&] { read_back(damage); });
    }
    test::expect_golden(std::regex_replace(refused.text(), std::regex("\\(.*\\)"), "(…)"));  // words of the library
}

TEST(Settings, AreShownWithTheirUnits) {
    std::string text = shown({"peak_drop", 0.0, Dimension::one, SettingGroup::end}) + "\n";  // not "peak drop 0"
    for (const Setting& each : one_of_each) text += shown(each) + "\n";
    test::expect_golden(text);
    EXPECT_EQ(number_of(one_of_each, "width"), 0.08);
    EXPECT_EQ(text_of(one_of_each, "tessellation"), "voronoi");
    EXPECT_EQ(text_of(one_of_each, "width"), "");
}

TEST(FirstDifference, IsOfAGroupThatCounts) {
    Settings other = one_of_each;
    EXPECT_EQ(first_difference(one_of_each, other).first, nullptr);
    other[3].value = 1123.0;
    EXPECT_EQ(first_difference(one_of_each, other).first, nullptr) << "grains are of the group none here";
    EXPECT_EQ(first_difference(one_of_each, other, {}).second, &other[3]);
    other.push_back({"span", 0.1, Dimension::length, SettingGroup::size});
    EXPECT_EQ(first_difference(one_of_each, other).first, nullptr);
    EXPECT_EQ(first_difference(one_of_each, other).second, &other.back());
    EXPECT_EQ(first_difference(other, one_of_each).first, &other.back());
}

}  // namespace
}  // namespace graincrack
