#include "share/base/units.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <string>

#include "share/base/error.hpp"
#include "share/rock/contact_parameters.hpp"

namespace graincrack {
namespace {

std::string complaint(const std::string& text, const Quantity& quantity) {
    try {
        parse_quantity(text, quantity, "--edge");
    } catch (const UsageError& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "nothing wrong with " + text;
}

const Quantity& of(ContactValue value) { return contact_parameter(value).quantity; }

constexpr Quantity any(Dimension dimension) { return {"any", dimension, -quantity::unbounded, quantity::unbounded, "anything"}; }

TEST(Units, DecimalUnitsGiveTheSameDoubleAsTheSiNumber) {
    EXPECT_EQ(parse_quantity("4mm", quantity::mean_edge, "--edge"), 0.004);
    EXPECT_EQ(parse_quantity("5.13mm", quantity::mean_edge, "--edge"), 0.00513);
    EXPECT_EQ(parse_quantity("0.00513", quantity::mean_edge, "--edge"), 0.00513);
    EXPECT_EQ(parse_quantity("5.13e0 mm", quantity::mean_edge, "--edge"), 0.00513);
    EXPECT_EQ(parse_quantity("513e+1um", quantity::mean_edge, "--edge"), 0.00513);
    EXPECT_EQ(parse_quantity("74.57 MPa", of(&ContactParameters::cohesion), "--cc"), 74.57e6);
    EXPECT_EQ(parse_quantity(" +25.8GPa ", quantity::young_modulus, "E"), 25.8e9);
    EXPECT_EQ(parse_quantity("2.65 g/cm3", quantity::density, "rho"), 2650);
    EXPECT_EQ(parse_quantity("10%", quantity::edge_spread, "--spread"), 0.1);
    EXPECT_EQ(parse_quantity("6.87e5 MPa/mm", of(&ContactParameters::normal_stiffness), "kt"), 6.87e14);
    EXPECT_EQ(parse_quantity("5mm/s", quantity::platen_speed, "--rate"), 0.005);
    EXPECT_EQ(parse_quantity("90J/m2", of(&ContactParameters::fracture_energy), "Gf"), 90);
    EXPECT_EQ(parse_quantity("0.09 kJ/m2", of(&ContactParameters::fracture_energy), "Gf"), 90);
    EXPECT_EQ(parse_quantity("90 N/m", of(&ContactParameters::fracture_energy), "Gf"), 90);
    EXPECT_EQ(parse_quantity("-2e-3MN", any(Dimension::force), "F"), -2000);
}

TEST(Units, OtherUnits) {
    EXPECT_DOUBLE_EQ(parse_quantity("48.76deg", of(&ContactParameters::friction_angle), "phi"), 48.76 * std::numbers::pi / 180);
    EXPECT_DOUBLE_EQ(parse_quantity("48.76°", of(&ContactParameters::friction_angle), "phi"), 48.76 * std::numbers::pi / 180);
    EXPECT_EQ(parse_quantity("10min", any(Dimension::time), "t"), 600);
    EXPECT_EQ(parse_quantity("1.5 h", any(Dimension::time), "t"), 5400);
    EXPECT_DOUBLE_EQ(parse_quantity("6mm/min", quantity::platen_speed, "--rate"), 1e-4);
    for (const char* text : {"1.5MPa.m^0.5", "1.5 MPa√m", "1.5 MPa*m^0.5", "1500 kPa.m^0.5", "1.5e6"}) {
        EXPECT_EQ(parse_quantity(text, quantity::mode_i_toughness, "K"), 1.5e6) << text;
    }
}

TEST(Units, EveryListedUnitIsReadAndGivenBack) {
    for (std::size_t i = 0; i < dimension_rows.size(); ++i) {
        const auto dimension = static_cast<Dimension>(i);
        EXPECT_EQ(units_of(dimension).front().symbol, si_unit(dimension));
        for (const Unit& unit : units_of(dimension)) {
            const double si = parse_quantity("3.7 " + std::string(unit.symbol), any(dimension), "x");
            EXPECT_NEAR(si / (3.7 * unit.to_si), 1, 1e-15) << unit.symbol;
            EXPECT_NEAR(in_unit(si, dimension, unit.symbol), 3.7, 1e-15) << unit.symbol;
        }
    }
    EXPECT_THROW(in_unit(1, Dimension::length, "MPa"), std::invalid_argument);
    EXPECT_EQ(in_unit(0.00513, Dimension::length, "mm"), 5.13);
}

TEST(Units, ComplaintsNameOptionFaultAndRemedyInOneLine) {
    const std::string wrong_dimension = complaint("4MPa", quantity::mean_edge);
    EXPECT_EQ(wrong_dimension,
              "--edge: \"4MPa\" has the unit of a stress, a length is needed; units that fit: m, mm, cm, um or km (a bare number "
              "is in m)");
    EXPECT_EQ(complaint("4furlong", quantity::mean_edge),
              "--edge: unknown unit \"furlong\" in \"4furlong\"; units that fit: m, mm, cm, um or km (a bare number is in m)");
    EXPECT_NE(complaint("4MM", quantity::mean_edge).find("did you mean mm?"), std::string::npos);
    EXPECT_NE(complaint("4,5mm", quantity::mean_edge).find("the decimal mark is a point"), std::string::npos);
    EXPECT_NE(complaint("4mm mm", quantity::mean_edge).find("unknown unit \"mm mm\""), std::string::npos);
    EXPECT_NE(complaint("0x10", quantity::mean_edge).find("unknown unit \"x10\""), std::string::npos);
    EXPECT_NE(complaint("four", quantity::mean_edge).find("\"four\" is not a number"), std::string::npos);
    EXPECT_NE(complaint("mm", quantity::mean_edge).find("is not a number"), std::string::npos);
    EXPECT_NE(complaint("", quantity::mean_edge).find("no value given"), std::string::npos);
    EXPECT_NE(complaint("+-4", quantity::mean_edge).find("is not a number"), std::string::npos);
    EXPECT_EQ(complaint("-4mm", quantity::mean_edge), "--edge: \"-4mm\" is out of bounds; it must be above 0 m and at most 1 km");
    EXPECT_EQ(complaint("51", of(&ContactParameters::friction_angle)),
              "--edge: \"51\" has no unit and was taken for 2922 deg, which is out of bounds; write 51deg; it must be from 0 deg "
              "to 88.81 deg");
    EXPECT_EQ(
        complaint("5", quantity::max_strain),
        "--edge: \"5\" has no unit and was taken for 5, which is out of bounds; write 5%; it must be above 0 and at most 0.5");
    EXPECT_NE(complaint("0", quantity::mean_edge).find("out of bounds"), std::string::npos);
    EXPECT_NE(complaint("60%", quantity::edge_spread).find("from 0 to 0.5"), std::string::npos);
    EXPECT_NE(complaint("91deg", of(&ContactParameters::friction_angle)).find("from 0 deg to 88.81 deg"), std::string::npos);
    for (const char* text : {"nan", "inf", "-inf", "infinity", "nan mm", "1e400", "1e308 km"}) {
        EXPECT_NE(complaint(text, quantity::mean_edge).find("is not a finite number"), std::string::npos) << text;
    }
    EXPECT_EQ(complaint("a\nb", quantity::mean_edge).find('\n'), std::string::npos);
    EXPECT_LT(complaint(std::string(10000, 'x'), quantity::mean_edge).size(), 300U);
}

TEST(Units, AWordForAValue) {
    EXPECT_EQ(parse_quantity_or("none", "none", 0, quantity::damping, "--damping"), 0);
    EXPECT_EQ(parse_quantity_or("0.8", "none", 0, quantity::damping, "--damping"), 0.8);
    try {
        parse_quantity_or("off", "none", 0, quantity::damping, "--damping");
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(),
                     "--damping: \"off\" is not a number; a pure number, or one in %, fits; the word none fits too");
    }
    EXPECT_THROW(parse_quantity_or("1.5", "none", 0, quantity::damping, "--damping"), UsageError);
    EXPECT_THROW(parse_quantity_or("", "none", 0, quantity::damping, "--damping"), UsageError);
}

TEST(Units, NumbersReadBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3, 1e-300, 6.87e14, -0.0, 5e-324, std::numeric_limits<double>::max(), 25.8e9}) {
        EXPECT_EQ(parse_quantity(format_number(value), any(Dimension::one), "x"), value);
    }
    EXPECT_EQ(format_number(0.004), "0.004");
    EXPECT_EQ(format_number(4.0), "4");
    EXPECT_EQ(format_number(std::nan("")), "nan");
    EXPECT_EQ(format_number(-std::nan("")), "nan");
    EXPECT_EQ(format_number(-INFINITY), "-inf");
    EXPECT_EQ(format_number(24.1534, 4), "24.15");
    EXPECT_EQ(format_number(std::nan(""), 4), "nan");
}

TEST(Units, QuantitiesAreShownInAReadableUnit) {
    EXPECT_EQ(format_quantity(0.004, Dimension::length), "4 mm");
    EXPECT_EQ(format_quantity(0.16, Dimension::length), "160 mm");
    EXPECT_EQ(format_quantity(2.58e10, Dimension::stress), "25.8 GPa");
    EXPECT_EQ(format_quantity(-8.73e6, Dimension::stress), "-8.73 MPa");
    EXPECT_EQ(format_quantity(0.005, Dimension::speed), "5 mm/s");
    EXPECT_EQ(format_quantity(std::numbers::pi / 2, Dimension::angle), "90 deg");
    EXPECT_EQ(format_quantity(0, Dimension::length), "0 m");
    EXPECT_EQ(format_quantity(0.25, Dimension::one), "0.25");
    EXPECT_EQ(format_quantity(6.87e14, Dimension::stiffness), "6.87e+05 MPa/mm");
    EXPECT_EQ(format_quantity(1e-9, Dimension::time), "0.001 us");
    EXPECT_EQ(format_quantity(0.0008, Dimension::length, 2), "0.8 mm");
    EXPECT_EQ(format_quantity(0.0008, Dimension::length, 3), "800 um");
    EXPECT_EQ(format_quantity(0.9996e-3, Dimension::length, 3), "1 mm");
}

/// A locale with decimal comma and grouped thousands, on any machine.
struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Units, TheLocaleDoesNotMatter) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    std::setlocale(LC_ALL, "de_DE.UTF-8");  // if it is installed
    EXPECT_EQ(parse_quantity("5.13mm", quantity::mean_edge, "--edge"), 0.00513);
    EXPECT_EQ(format_number(25800000.5), "25800000.5");
    EXPECT_EQ(format_number(1234.5, 5), "1234.5");
    EXPECT_EQ(format_quantity(0.1605, Dimension::length), "160.5 mm");
    std::locale::global(before);
    std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace graincrack
