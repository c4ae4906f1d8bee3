// Tests that are rows of a TOML file beside them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/support/check.hpp"

namespace graincrack::test {

/// The text with values in place of their keys in braces.
std::string with_values(std::string text, const std::map<std::string, std::string>& values);

/// What a reader must refuse. Of a file: `requires`, what holds of the text in a sentence; `text`, with those of the table
/// `texts` in place of their names in braces (they may have others, in the order of the alphabet); `says`, one part of the
/// message or several; or `message`, all of it.
struct RefusedText {
    std::string sentence;
    std::string text;
    std::vector<std::string> says;
    std::string message;  ///< "": not compared
};
/// \param file below tests/unit
std::vector<RefusedText> refused_texts(const std::string& file);

/// Fails unless `act(text)` throws an `Exception` for each of the file's texts, with one line that says what it must. \return
/// number
template <class Exception, class Act>
std::size_t expect_refused(const std::string& file, const Act& act) {
    const std::vector<RefusedText> rows = refused_texts(file);
    for (const RefusedText& row : rows) {
        SCOPED_TRACE(row.sentence);
        expect_one_line<Exception>([&] { act(row.text); }, row.says);
        try {
            if (!row.message.empty()) act(row.text);
        } catch (const Exception& error) {
            EXPECT_EQ(error.what(), row.message);
        }
    }
    return rows.size();
}

}  // namespace graincrack::test
