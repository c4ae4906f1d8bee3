#include "tests/support/golden.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>

namespace graincrack::test {

namespace {

constexpr const char* title_mark = "### ";

using Sections = std::vector<std::pair<std::string, std::string>>;  // title and text

/// The golden file of a test's source, whose name may be relative to the folder of the build.
std::string golden_file(const std::string& source) {
    const std::string below = source.substr(source.rfind("tests/"));
    return std::string(GRAINCRACK_SOURCE) + "/" + below.substr(0, below.rfind('.')) + ".golden";
}

std::string without_line_ends(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

/// The text with words in place of names that differ by machine and run: of temporary folders and of the source.
std::string without_places(const std::string& text) {
    const std::regex folder(std::filesystem::temp_directory_path().string() + "/graincrack-test-\\w{6}");
    std::string without = std::regex_replace(text, folder, "FOLDER");
    const std::string source = GRAINCRACK_SOURCE;
    for (std::size_t at = 0; (at = without.find(source, at)) != std::string::npos;) without.replace(at, source.size(), "SOURCE");
    return without_line_ends(without);
}

Sections read(const std::string& path) {
    Sections sections;
    std::ifstream in(path);
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with(title_mark)) {
            sections.emplace_back(line.substr(4), "");
        } else if (!sections.empty()) {
            sections.back().second += line + "\n";
        }
    }
    return sections;
}

std::string& section(Sections& sections, const std::string& title) {
    for (auto& [known, text] : sections) {
        if (known == title) return text;
    }
    return sections.emplace_back(title, "").second;
}

void write(const std::string& path, const Sections& sections) {
    std::ofstream out(path);
    for (const auto& [title, text] : sections) out << title_mark << title << "\n" << without_line_ends(text) << "\n\n";
}

/// "line 3: …" of the first line in which two texts differ.
std::string first_difference(const std::string& text, const std::string& golden) {
    std::istringstream is(text), was(golden);
    for (int number = 1;; ++number) {
        std::string one, other;
        const bool more = !std::getline(is, one).fail();
        const bool as_well = !std::getline(was, other).fail();
        if (one != other || !more || !as_well) {
            return "line " + std::to_string(number) + " is\n  " + one + "\nand in the golden file\n  " + other;
        }
    }
}

}  // namespace

void expect_golden(const std::string& text, const std::string& what, const char* file, int line) {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    const std::string title = std::string(test.test_suite_name()) + "." + test.name() + (what.empty() ? "" : ": " + what);
    const std::string path = golden_file(file);
    const std::string own = without_places(text);
    if (own.empty()) ADD_FAILURE_AT(file, line) << title << ": there is no text";
    Sections sections = read(path);
    std::string& golden = section(sections, title);
    if (std::getenv("GRAINCRACK_ACCEPT") != nullptr) {
        golden = own;
        write(path, sections);
    } else if (own != without_line_ends(golden)) {
        ADD_FAILURE_AT(file, line) << path << ", " << title << ": " << first_difference(own, without_line_ends(golden))
                                   << "\n(tests/run --accept writes golden files anew and shows what changes)";
    }
}

}  // namespace graincrack::test
