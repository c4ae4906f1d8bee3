#include "mesher/import/phase_key.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "share/base/error.hpp"

namespace graincrack::mesher {
namespace {

using Phases = std::map<int, std::string>;

std::string key_path() { return testing::TempDir() + "/phase_key.tsv"; }

PhaseKey key_of_text(const std::string& text) {
    std::ofstream(key_path()) << text;
    return PhaseKey(key_path());
}

/// What is said of a key of labels, behind the name of its file.
std::string message_of_labels(const std::string& text) {
    try {
        static_cast<void>(key_of_text(text).of_labels());
    } catch (const InputError& error) {
        const std::string message = error.what();
        return message.rfind(key_path(), 0) == 0 ? message.substr(key_path().size()) : message;
    }
    return "no error";
}

TEST(PhaseKey, TellsColoursFromNumbersAndComments) {
    EXPECT_EQ(colour_of_text("#c03020"), 0xc03020);
    EXPECT_EQ(colour_of_text("C03020"), 0xc03020);
    EXPECT_EQ(colour_of_text("#103020"), 0x103020);
    EXPECT_FALSE(colour_of_text("103020"));  // a number
    EXPECT_FALSE(colour_of_text("#c0302"));
    EXPECT_FALSE(colour_of_text("#c030200"));
    EXPECT_FALSE(colour_of_text("#c0302g"));
    EXPECT_EQ(colour_text(0x00ff07), "#00ff07");
}

TEST(PhaseKey, OfLabelsHasNumbersAndColours) {
    const PhaseKey key = key_of_text(
        "# minerals\n#by colours, all of them\n#beef\nkey\tphase\n#c03020\tquartz\r\n\"#00ff00\"\t\"mica\"\n'#0000FF'\tmica\n"
        "abcdef\tclay\n103020\tlime\n7\tsalt\n-3\tsalt\n");
    const PhaseKey::OfLabels labels = key.of_labels();
    EXPECT_EQ(labels.by_colour, (Phases{{0xc03020, "quartz"}, {0x00ff00, "mica"}, {0x0000ff, "mica"}, {0xabcdef, "clay"}}));
    EXPECT_EQ(labels.by_number, (Phases{{103020, "lime"}, {7, "salt"}, {-3, "salt"}}));
    EXPECT_EQ(key.phases().front(), "quartz");
}

TEST(PhaseKey, HasFurtherColumnsBehindTheirNames) {
    const PhaseKey key = key_of_text("key\tlabel\tphase\tpieces\n4\t4\tq\t2\n5\t5\t?\t7\n");
    EXPECT_EQ(key.of_labels().by_number, (Phases{{4, "q"}}));
    EXPECT_EQ(key.phase({"4"}), "q");
    EXPECT_THROW(static_cast<void>(key.phase({"5"})), InputError);
    EXPECT_EQ(message_of_labels("4\tq\t2\n"),
              ": line 1: \"4\\x09q\\x092\" is no row; a key, a tab and the name of a phase (a-z, 0-9, _) are needed");
}

TEST(PhaseKey, OfLabelsRefusesInOneLine) {
    EXPECT_EQ(message_of_labels("x\tq\n"), ": the key \"x\" is no label; of pictures keys are integers or colours as #c03020");
    EXPECT_EQ(message_of_labels("#c03020 q\n"),
              ": line 1: \"#c03020 q\" is no row; a key, a tab and the name of a phase (a-z, 0-9, _) are needed");
    EXPECT_EQ(message_of_labels("#c03020\tq\n#C03020\tf\n"), ": #c03020 has the phases f and q; give one");
    EXPECT_EQ(message_of_labels("key\tphase\n1\t?\n2\t?\n"),
              ": no phase is named yet; the name of a phase (a-z, 0-9, _) is needed in place of each ?");
}

}  // namespace
}  // namespace graincrack::mesher
