// Commands and what they must answer: each case of the files *.toml beside this one is a test.
//
// A case is a requirement, in a sentence, with the files that it needs (`files.toml` makes them), and steps: itself, and the rows
// of `then`. The keys of a step:
//   command        lines of bash, behind the prelude of `files.toml`; the first one that fails ends them
//   exit           the exit code, 0 unless given
//   stdout, stderr, ..._lacks    a text, or several, that must stand there, or must not
//   stdout_is, stderr_is         the whole text
//   stdout_lines, stderr_lines   number of lines
//   leaves         names in the folder afterwards, with spaces between them
// Unless a step says otherwise, a command that ends with another code than 0 prints nothing to stdout and one line to stderr,
// which begins with the name of a program, and leaves no file. `for_each` repeats a case for each of its texts, which takes the
// place of {each}; or for each of its rows, whose values take the place of their keys in braces or are keys of the first step. A
// case is skipped where its lines `only_where` fail. A row that has another key, or a value of another type, fails.
// `wrong_rows.py` shows that each key fails where its value is wrong; it names another folder of rows by GRAINCRACK_ROWS.
#include <toml++/toml.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "tests/end_to_end/shell.hpp"
#include "tests/support/rows.hpp"

namespace graincrack::test {
namespace {

struct Case {
    std::string name;
    toml::table table;
};
void PrintTo(const Case& value, std::ostream* stream) { *stream << value.name; }

const std::string folder_of_cases = GRAINCRACK_SOURCE "/tests/end_to_end/";

const toml::table& common() {
    static const toml::table table = toml::parse_file(folder_of_cases + "files.toml");
    return table;
}

/// The words of a sentence, joined; no test has another sign in its name.
std::string joined(const std::string& sentence) {
    std::string name;
    bool begins = true;
    for (const char c : sentence) {
        const bool is_of_word = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (is_of_word) name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        begins = !is_of_word && c != '\'';
    }
    return name;
}

std::vector<Case> all_cases() {
    const char* const other = std::getenv("GRAINCRACK_ROWS");
    std::map<std::string, toml::table> files;
    for (const auto& file : std::filesystem::directory_iterator(other == nullptr ? folder_of_cases : other)) {
        const std::string stem = file.path().stem().string();
        if (file.path().extension() == ".toml" && stem != "files") files[stem] = toml::parse_file(file.path().string());
    }
    std::vector<Case> cases;
    for (const auto& [stem, file] : files) {
        const toml::array* rows = file["case"].as_array();
        if (rows == nullptr || file.size() != 1) throw std::invalid_argument(stem + ".toml: another table than [[case]]");
        for (const auto& row : *rows) {
            const toml::table& table = *row.as_table();
            cases.push_back({joined(stem) + "_" + joined(table["requires"].value_or("")), table});
        }
    }
    return cases;
}

using Values = std::map<std::string, std::string>;

/// One row of a case, run and checked.
class Step {
public:
    Step(const Shell& shell, const toml::table& row, const Values& values) : shell_(shell), row_(row), values_(values) {
        for (const auto& [key, value] : row) {
            const auto type = types().find(key.str());
            EXPECT_TRUE(type != types().end() && type->second.contains(value.type())) << key.str() << ": no such key, or type";
        }
    }

    /// Of the values of keys.
    static const std::map<std::string, std::set<toml::node_type>, std::less<>>& types() {
        using enum toml::node_type;
        static const std::map<std::string, std::set<toml::node_type>, std::less<>> all{
            {"requires", {string}},      {"only_where", {string}},
            {"files", {array}},          {"then", {array}},
            {"for_each", {array}},       {"command", {string}},
            {"exit", {integer}},         {"leaves", {string}},
            {"stdout", {string, array}}, {"stdout_is", {string}},
            {"stdout_lines", {integer}}, {"stdout_lacks", {string, array}},
            {"stderr", {string, array}}, {"stderr_is", {string}},
            {"stderr_lines", {integer}}, {"stderr_lacks", {string, array}}};
        return all;
    }

    void check() const {
        const std::string command = with_values(row_["command"].value<std::string>().value(), values_);
        const int code = row_["exit"].value_or(0);
        const std::string before = shell_.names();
        const Outcome outcome = run(shell_, command);
        EXPECT_EQ(outcome.exit_code, code) << command << "\n" << outcome.out << outcome.err;
        expect_text("stdout", outcome.out, code != 0);
        expect_text("stderr", outcome.err, false);
        if (const auto names = row_["leaves"].value<std::string>()) {
            EXPECT_EQ(std::regex_replace(shell_.names(), std::regex("\n"), " "),
                      with_values(*names, values_) + (names->empty() ? "" : " "));
        } else if (code != 0) {
            EXPECT_EQ(shell_.names(), before) << command;
        }
        if (code == 0 || row_.contains("stderr_is") || row_.contains("stderr_lines")) return;
        EXPECT_EQ(n_lines(outcome.err), 1) << outcome.err;
        EXPECT_TRUE(std::regex_search(outcome.err, std::regex("^graincrack-(mesh|solve|post): "))) << outcome.err;
    }

    static Outcome run(const Shell& shell, const std::string& lines) {
        return shell.run("source=" GRAINCRACK_SOURCE " build=" GRAINCRACK_BIN "/..\nset -e\n" +
                         common()["prelude"]["bash"].value<std::string>().value() + lines);
    }

private:
    void expect_text(const std::string& stream, const std::string& text, bool is_empty) const {
        const auto whole = row_[stream + "_is"].value<std::string>();
        const std::string otherwise = is_empty && !row_.contains(stream) ? "" : text;
        EXPECT_EQ(text, whole ? with_values(*whole, values_) : otherwise) << stream;
        EXPECT_EQ(n_lines(text), row_[stream + "_lines"].value_or(n_lines(text))) << stream << ": " << text;
        for (const std::string& part : texts(stream)) EXPECT_TRUE(text.find(part) != std::string::npos) << part << "\n" << text;
        for (const std::string& part : texts(stream + "_lacks")) EXPECT_EQ(text.find(part), std::string::npos) << text;
    }
    [[nodiscard]] std::vector<std::string> texts(const std::string& key) const {
        std::vector<std::string> found;
        if (const auto one = row_[key].value<std::string>()) found.push_back(with_values(*one, values_));
        if (const toml::array* several = row_[key].as_array()) {
            for (const auto& each : *several) found.push_back(with_values(each.value<std::string>().value(), values_));
        }
        return found;
    }

    const Shell& shell_;
    const toml::table& row_;
    const Values& values_;
};

void check_case(const toml::table& first, const Values& values) {
    const Shell shell;
    EXPECT_NE(first["requires"].value_or(""), std::string());
    const std::string condition = first["only_where"].value_or("");
    const int unfulfilled = Step::run(shell, condition).exit_code;
    ASSERT_NE(unfulfilled, 127) << "no such command: " << condition;
    if (unfulfilled != 0) GTEST_SKIP() << "only where: " << condition;
    if (const toml::array* files = first["files"].as_array()) {
        for (const auto& file : *files) {
            const auto name = file.value<std::string>().value();
            const auto lines = common()["files"][name].value<std::string>();
            const Outcome made = Step::run(shell, lines.value_or("false"));
            ASSERT_EQ(made.exit_code, 0) << name << (lines ? "" : ": no such file") << "\n" << made.err;
        }
    }
    Step(shell, first, values).check();
    if (const toml::array* then = first["then"].as_array()) {
        for (const auto& row : *then) {
            ASSERT_TRUE(row.is_table()) << "then: another value than a step";
            Step(shell, *row.as_table(), values).check();
        }
    }
}

class Commands : public testing::TestWithParam<Case> {};

TEST_P(Commands, Answer) {
    const toml::table& table = GetParam().table;
    const toml::array* variants = table["for_each"].as_array();
    if (variants == nullptr) return check_case(table, {});
    EXPECT_FALSE(variants->empty()) << "for_each: no rows";
    std::ostringstream text;
    text << table;
    for (const auto& variant : *variants) {
        toml::table first = table;
        Values values;
        const auto add = [&](const std::string& key, const toml::node& value) {
            const bool is_key = Step::types().contains(key);
            if (is_key) first.insert_or_assign(key, value);
            if (const auto word = value.value<std::string>()) values[key] = *word;
            EXPECT_TRUE(is_key || (values.contains(key) && text.str().find("{" + key + "}") != std::string::npos))
                << "for_each: {" << key << "} is in no line, or its value no text";
        };
        if (const toml::table* row = variant.as_table()) {
            for (const auto& [key, value] : *row) add(std::string(key.str()), value);
        } else {
            add("each", variant);
        }
        check_case(first, values);
    }
}

INSTANTIATE_TEST_SUITE_P(, Commands, testing::ValuesIn(all_cases()), [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace graincrack::test
