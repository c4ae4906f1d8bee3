// The table of laws; what laws do is in tests/physics (every_contact_law_test, contact_law_curves_test).
#include "solver/law/contact_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace graincrack::test {
namespace {

TEST(ContactLawTable, ReadsEveryParameterByEveryLawOrByThoseThatNameIt) {
    for (const ContactParameter& row : all_contact_parameters()) {
        const auto names_it = [&](const LawDescription& law) { return law.reads(row.value); };
        EXPECT_EQ(std::any_of(all_contact_laws().begin(), all_contact_laws().end(), names_it), !row.every_law)
            << row.quantity.name;
    }
}

TEST(ContactLawTable, CountsDamageInLawsWithFrictionBesideCohesion) {
    for (const LawDescription& law : all_contact_laws()) {
        const bool beside = law.variant == LawVariant::combined || law.variant == LawVariant::cohesive_frictional;
        EXPECT_EQ(law.crack_event(), beside ? CrackEvent::half_damaged : CrackEvent::failed) << law.name;
    }
}

TEST(ContactLawTable, HasASectionOfThePageForEveryLaw) {
    std::ifstream file(GRAINCRACK_SOURCE "/share/doc/laws.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const LawDescription& law : all_contact_laws()) {
        EXPECT_NE(page.find("\n## `" + std::string(law.name) + "`"), page.npos) << law.name;
    }
}

}  // namespace
}  // namespace graincrack::test
