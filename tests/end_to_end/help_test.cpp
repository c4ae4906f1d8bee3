// Help of options whose words are those of a table.
#include "share/rock/contact_parameters.hpp"
#include "tests/end_to_end/shell.hpp"

namespace graincrack::test {
namespace {

TEST(Help, EveryContactParameterIsAnOptionAndSaysWhatItIsUnlessGiven) {
    const Shell shell;
    std::string help = shell.must("graincrack-solve uniaxial --help-all | tr -s ' \\n' ' '");
    for (const ContactParameter& row : all_contact_parameters()) {
        const std::size_t at = help.find(row.option() + " ");
        ASSERT_NE(at, std::string::npos) << row.option();
        const std::string own = help.substr(at, help.find(" --", at + 1) - at);
        EXPECT_NE(own.find(row.quantity.meaning), std::string::npos) << own;
        EXPECT_NE(own.find(row.is_needed() ? "default: the material's [" : std::string("else ") + row.usual), std::string::npos)
            << own;
    }
}

}  // namespace
}  // namespace graincrack::test
