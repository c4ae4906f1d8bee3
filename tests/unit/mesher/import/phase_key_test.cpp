#include "mesher/import/phase_key.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "share/base/error.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/temporary_folder.hpp"

namespace graincrack::mesher {
namespace {

using Phases = std::map<int, std::string>;

PhaseKey key_of_text(const std::string& text) {
    const test::TemporaryFolder folder;
    std::ofstream(folder.file("key.tsv")) << text;
    return PhaseKey(folder.file("key.tsv"));
}

TEST(PhaseKey, TellsColoursFromNumbersAndComments) {
    EXPECT_EQ(colour_of_text("#c03020"), 0xc03020);
    EXPECT_EQ(colour_of_text("C03020"), 0xc03020);
    EXPECT_EQ(colour_of_text("#103020"), 0x103020);
    for (const char* text : {"103020", "#c0302", "#c030200", "#c0302g"}) EXPECT_FALSE(colour_of_text(text)) << text;
    EXPECT_EQ(colour_text(0x00ff07), "#00ff07");
}

TEST(PhaseKey, HasNumbersAndColoursOfLabels) {
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
}

TEST(PhaseKey, RefusesInOneLine) {
    test::Refusals refused;
    const auto add = [&](const std::string& what, const std::string& text) {
        refused.add<InputError>(what, [&] {
            const PhaseKey key = key_of_text(text);
            (void)key.phase({"1"});
            (void)key.of_labels();
        });
    };
    add("a grain without a row", "key\tphase\n2\tq\n");
    add("a grain without a phase", "key\tphase\n1\t?\n");
    add("no phase at all", "Quartz\n");
    add("a name with a capital", "1\tQ\n");
    add("two phases", "1\tq\n1\tf\n");
    add("no rows", "key\tphase\n");
    add("a third column without a name", "1\tq\t2\n");
    add("a blank in place of a tab", "#c03020 q\n");
    add("a word for a label", "1\tq\nx\tq\n");
    add("a colour of two phases", "1\tq\n#c03020\tq\n#C03020\tf\n");
    refused.add<InputError>("labels without phases", [] { (void)key_of_text("key\tphase\n1\t?\n2\t?\n").of_labels(); });
    test::expect_golden(refused.text());
}

}  // namespace
}  // namespace graincrack::mesher
