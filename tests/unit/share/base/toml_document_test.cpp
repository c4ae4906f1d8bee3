// TOML files in which single values are set: what else stands there stays as it is.
#include "share/base/toml_document.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "tests/support/golden.hpp"

namespace graincrack {
namespace {

using Path = TomlDocument::Path;

Path path_of(const TomlEntry& entry) {
    Path path = entry.section;
    path.push_back(entry.key);
    return path;
}

/// What a file says, by key.
std::map<Path, std::vector<std::string>> read(const std::string& text) {
    std::map<Path, std::vector<std::string>> values;
    for (const TomlEntry& entry : parse_toml(text, "file").entries) {
        for (const TomlValue& value : entry.values) values[path_of(entry)].push_back(value.text);
    }
    return values;
}

std::string with(const std::string& text, const Path& key, const std::string& value, bool is_remarked = false) {
    TomlDocument file(text, "stone.toml");
    file.set(key, value, is_remarked);
    return file.text();
}

/// Every key of a file is set and set back, with the line breaks and the end that it has and with others.
void expect_kept(const std::string& text) {
    const auto before = read(text);
    for (const auto& [key, values] : before) {
        TomlDocument file(text, "file");
        const std::string old = file.value(key).value();
        file.set(key, "\"é # [x]\"");
        auto expected = before;
        expected[key] = {"é # [x]"};
        EXPECT_EQ(read(file.text()), expected) << key.back();
        file.set(key, old);
        EXPECT_EQ(file.text(), text) << key.back();
    }
}

TEST(TomlDocument, SetsAndSetsBackValuesOfFiles) {
    std::size_t files = 0;
    for (const char* folder : {"materials", "studies", "programs"}) {
        for (const auto& file :
             std::filesystem::recursive_directory_iterator(GRAINCRACK_SOURCE "/share/" + std::string(folder))) {
            if (file.path().extension() != ".toml") continue;
            SCOPED_TRACE(file.path());
            expect_kept(text_of_toml(file.path().string()));
            ++files;
        }
    }
    EXPECT_GE(files, 30U);
}

const std::string odd =
    "\xEF\xBB\xBF\"é.x\" = 'é' # é\n\ta.'b c' = \"\"\"\n[no table]\n# no = \"example\"\n\"quoted\"\"\"\"  # s\n"
    "a.d = 1 # d\n[ phases . quartz ] # h\narray = [ 1, # ]\n 'a]' ,\n ]  # e\nrow = {x = 1, y={z= \"}\" }, w.v = [\"{\"]}\n"
    "number=+1_000.5e3   # num\ntrue=true\nhex=0x1F# hex\n[phases] # behind\n[x.y.z]\nk = -1";

TEST(TomlDocument, KeepsOddSpellings) {
    expect_kept(odd);
    std::string other = odd + "\n";
    for (std::size_t at = 0; (at = other.find('\n', at)) != std::string::npos; at += 2) other.replace(at, 1, "\r\n");
    expect_kept(other);
    EXPECT_EQ(with(other, {"x", "y", "z", "k"}, "2", true),
              std::string(other).replace(other.rfind("-1"), 2, "2                                   # was -1"));
}

TEST(TomlDocument, PutsNewKeysBehindThoseOfTheirTable) {
    const auto added = [](const Path& key, const std::string& line, const std::string& behind) {
        std::string expected = odd;
        expected.insert(odd.find(behind) + behind.size(), line);
        EXPECT_EQ(with(odd, key, "7"), expected) << line;
    };
    added({"n"}, "n = 7\n", "# é\n");
    added({"a", "n"}, "a.n = 7\n", "# d\n");
    added({"phases", "quartz", "n"}, "n = 7\n", "# hex\n");
    added({"phases", "n"}, "n = 7\n", "# behind\n");
    added({"phases", "quartz", "row", "n"}, ", n = 7", "[\"{\"]");
    added({"phases", "quartz", "row", "y", "n"}, ", n = 7", "z= \"}\"");
    added({"phases", "quartz", "row", "u", "n"}, ", u.n = 7", "[\"{\"]");
    added({"phases", "quartz", "row", "w", "n"}, ", w.n = 7", "[\"{\"]");
    added({"x", "y", "z", "n"}, "\nn = 7", "k = -1");
    added({"x", "y", "a b"}, "\n\n[x.y]\n\"a b\" = 7\n", "k = -1");
    EXPECT_EQ(with("a = {}", {"a", "b"}, "7"), "a = {b = 7}");
    EXPECT_EQ(with("", {"b"}, "7"), "b = 7\n");
}

TEST(TomlDocument, KeepsComments) {
    std::string text;
    for (const char* file : {"a = \"1 MPa\" # [KZ] Table 3\n", "a = [1,\n 2]\nb = 3", "b = 3"}) {
        text += with(file, {"a"}, "2", true) + "\n---\n";
    }
    test::expect_golden(text + with("[t]\nb = '''\n# a = 3\n'''\n# a = 1  # MPa\n[u]\n# a = 4", {"t", "a"}, "2", true));
}

TEST(TomlDocument, TakesKeysOut) {
    TomlDocument file("[a] # 1\nb = [1,\n2] # 2\n# 3\nc = 4", "file");
    file.remove({"a", "b"});
    EXPECT_EQ(file.text(), "[a] # 1\n# 3\nc = 4");
    file.remove({"a", "b"});
    file.remove({"a", "c"});
    EXPECT_EQ(file.text(), "[a] # 1\n# 3\n");
    file.add_table({"a", "x.y"}, "new");
    EXPECT_EQ(file.text(), "[a] # 1\n# 3\n\n[a.\"x.y\"]  # new\n");
}

TEST(TomlDocument, RefusesInOneLineWhatHasNoPlace) {
    test::Refusals refused;
    TomlDocument file(odd, "stone.toml");
    const auto refuse = [&](const Path& key, const std::string& value) {
        refused.add<InputError>(fmt::format("{} = {}", fmt::join(key, "."), printable(value)), [&] { file.set(key, value); });
        EXPECT_EQ(file.text(), odd);
    };
    refuse({"phases", "quartz"}, "1");
    refuse({"phases", "quartz", "array", "n"}, "1");
    for (const char* value : {"1\n[x]", "1 # x", ""}) refuse({"a", "d"}, value);
    const Path shared{"phases", "quartz", "row", "x"};
    refused.add<InputError>("removed", [&] { file.remove(shared); });
    refused.add<InputError>("[[a]]", [] { TomlDocument("[[a]]\nb = 1", "file"); });
    test::expect_golden(std::regex_replace(refused.text(), std::regex("Error while[^)\n]*"), "…"));  // words of the library
}

}  // namespace
}  // namespace graincrack
