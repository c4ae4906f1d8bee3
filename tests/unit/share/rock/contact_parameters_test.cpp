// Each row of the table of contact parameters is a key of materials and of their template, and is derived unless given.
// Attributes of run files, options, comparisons and restarts are tested where they are, for each row too.
#include "share/rock/contact_parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "share/rock/material.hpp"
#include "share/rock/material_edit.hpp"
#include "tests/support/augig_granite.hpp"

namespace graincrack {
namespace {

/// A set in which each row has a value of its own.
GivenContact different_values() {
    GivenContact given;
    double value = 0.5;
    for (const ContactParameter& row : all_contact_parameters()) given.*row.given = value++;
    return given;
}

TEST(ContactParameters, HaveAMemberAKeyAndAnOptionForEachRow) {
    std::set<std::string> names;
    const GivenContact given = different_values();
    const ContactParameters all = derived_contact(given, test::augig_granite().rock, PlaneCondition::strain);
    const std::vector<std::string> keys = material_keys();
    for (const ContactParameter& row : all_contact_parameters()) {
        EXPECT_TRUE(names.insert(std::string(row.quantity.name)).second) << row.quantity.name;
        EXPECT_EQ(all.*row.value, *(given.*row.given)) << row.quantity.name;
        EXPECT_EQ(&contact_parameter(row.value), &row);
        EXPECT_EQ(std::count(keys.begin(), keys.end(), "contact." + row.key()), 1) << row.key();
    }
    EXPECT_EQ(names.size() * sizeof(double), sizeof(ContactValues<double>)) << "a member without a row";
    EXPECT_EQ(contact_parameter(&ContactParameters::residual_cohesion).key(), "residual_cohesion");
    EXPECT_EQ(contact_parameter(&ContactParameters::residual_cohesion).option(), "--contact-residual-cohesion");
    EXPECT_EQ(contact_parameter(&ContactParameters::mode_ii_fracture_energy).option(), "--mode-ii-fracture-energy");
}

TEST(ContactParameters, HaveExamplesThatTheirKeysMayHold) {
    for (const ContactParameter& row : all_contact_parameters()) {
        const std::string set = new_material("every-key", "marble", {{"contact." + row.key(), row.example}});
        EXPECT_NE(set.find("\n" + row.key() + " = "), std::string::npos) << set;
    }
}

// The energy of bridges does by its ratio alone, which is none here.
TEST(ContactParameters, DependOnThePlaneWhereTheyFollowIt) {
    const Material granite = test::augig_granite();
    const ContactParameters strain = derived_contact(granite.contact, granite.rock, PlaneCondition::strain);
    const ContactParameters stress = derived_contact(granite.contact, granite.rock, PlaneCondition::stress);
    for (const ContactParameter& row : all_contact_parameters()) {
        const double difference = std::abs(strain.*row.value - stress.*row.value);
        const bool follows = row.follows_plane && row.value != &ContactParameters::bridging_energy;
        EXPECT_EQ(difference > 1e-12 * std::abs(strain.*row.value), follows) << row.quantity.name;
    }
}

TEST(ContactParameters, AreThoseOfTheBaseUnlessGiven) {
    GivenContact given;
    given.cohesion = 30e6;
    given.residual_friction_angle = 0.3;
    const GivenContact all = overlay(given, different_values());
    for (const ContactParameter& row : all_contact_parameters()) {
        EXPECT_EQ(all.*row.given, given.*row.given ? given.*row.given : different_values().*row.given) << row.quantity.name;
    }
}

}  // namespace
}  // namespace graincrack
