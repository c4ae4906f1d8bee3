#include "share/base/units.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <string>

#include "share/base/error.hpp"
#include "share/base/text.hpp"
#include "share/rock/contact_parameters.hpp"
#include "tests/support/golden_refusals.hpp"

namespace graincrack {
namespace {

const Quantity& of(ContactValue value) { return contact_parameter(value).quantity; }

constexpr Quantity any(Dimension dimension) { return {"any", dimension, -quantity::unbounded, quantity::unbounded, "anything"}; }

TEST(Units, GiveTheSameDoubleAsTheSiNumberWhereTheyAreDecimal) {
    const auto expect = [](const Quantity& quantity, double si, const std::vector<std::string>& texts) {
        for (const std::string& text : texts) EXPECT_EQ(parse_quantity(text, quantity, "x"), si) << text;
    };
    expect(quantity::mean_edge, 0.004, {"4mm"});
    expect(quantity::mean_edge, 0.00513, {"5.13mm", "0.00513", "5.13e0 mm", "513e+1um"});
    expect(of(&ContactParameters::cohesion), 74.57e6, {"74.57 MPa"});
    expect(quantity::young_modulus, 25.8e9, {" +25.8GPa "});
    expect(quantity::density, 2650, {"2.65 g/cm3"});
    expect(quantity::edge_spread, 0.1, {"10%"});
    expect(of(&ContactParameters::normal_stiffness), 6.87e14, {"6.87e5 MPa/mm"});
    expect(quantity::platen_speed, 0.005, {"5mm/s"});
    expect(of(&ContactParameters::fracture_energy), 90, {"90J/m2", "0.09 kJ/m2", "90 N/m"});
    expect(any(Dimension::force), -2000, {"-2e-3MN"});
    expect(any(Dimension::time), 600, {"10min"});
    expect(any(Dimension::time), 5400, {"1.5 h"});
    expect(quantity::mode_i_toughness, 1.5e6, {"1.5MPa.m^0.5", "1.5 MPa√m", "1.5 MPa*m^0.5", "1500 kPa.m^0.5", "1.5e6"});
    for (const char* angle : {"48.76deg", "48.76°"}) {
        EXPECT_DOUBLE_EQ(parse_quantity(angle, of(&ContactParameters::friction_angle), "phi"), 48.76 * std::numbers::pi / 180);
    }
    EXPECT_DOUBLE_EQ(parse_quantity("6mm/min", quantity::platen_speed, "--rate"), 1e-4);
}

TEST(Units, AreReadAndGivenBack) {
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

TEST(Units, RefuseWithOptionFaultAndRemedyInOneLine) {
    test::GoldenRefusals refused;
    const auto refuse = [&](const Quantity& quantity, const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            const auto parse = [&] { parse_quantity(text, quantity, "--edge"); };
            refused.add<UsageError>(fmt::format("{} \"{}\"", quantity.name, printable(shortened(text, 20))), parse);
        }
    };
    refuse(quantity::mean_edge, {"4MPa", "4furlong", "4MM",      "4,5mm",  "4mm mm", "0x10",     "four",
                                 "mm",   "",         "+-4",      "-4mm",   "0",      "a\nb",     "nan",
                                 "inf",  "-inf",     "infinity", "nan mm", "1e400",  "1e308 km", std::string(10000, 'x')});
    refuse(of(&ContactParameters::friction_angle), {"51", "91deg"});
    refuse(quantity::max_strain, {"5"});
    refuse(quantity::edge_spread, {"60%"});
    refuse(quantity::density, {"0"});
    refuse(quantity::poisson_ratio, {"0.5"});
    for (const char* text : {"off", "1.5", "1", ""}) {
        const auto parse = [&] { parse_quantity_or(text, "none", 0, quantity::damping, "--damping"); };
        refused.add<UsageError>(fmt::format("damping \"{}\"", text), parse);
    }
}

TEST(Units, TakeAWordForAValue) {
    EXPECT_EQ(parse_quantity_or("none", "none", 0, quantity::damping, "--damping"), 0);
    EXPECT_EQ(parse_quantity_or("0.8", "none", 0, quantity::damping, "--damping"), 0.8);
    EXPECT_EQ(parse_quantity("0", quantity::poisson_ratio, "nu"), 0);
}

TEST(Units, WriteNumbersThatReadBackAsTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3, 1e-300, 6.87e14, -0.0, 5e-324, std::numeric_limits<double>::max(), 25.8e9}) {
        EXPECT_EQ(parse_quantity(format_number(value), any(Dimension::one), "x"), value);
    }
    std::string text;
    for (const double value : {0.004, 4.0, std::nan(""), -std::nan(""), -double{INFINITY}}) text += format_number(value) + "\n";
    for (const double value : {24.1534, std::nan("")}) text += format_number(value, 4) + "\n";
    test::expect_golden(text);
}

TEST(Units, ShowQuantitiesInAReadableUnit) {
    std::string text;
    const auto add = [&](double value, Dimension dimension, int digits = 4) {
        text += fmt::format("{} {} {}: {}\n", value, si_unit(dimension), digits, format_quantity(value, dimension, digits));
    };
    for (const double value : {0.004, 0.16, 0.0}) add(value, Dimension::length);
    for (const double value : {2.58e10, -8.73e6}) add(value, Dimension::stress);
    add(0.005, Dimension::speed);
    add(std::numbers::pi / 2, Dimension::angle);
    add(0.25, Dimension::one);
    add(6.87e14, Dimension::stiffness);
    add(1e-9, Dimension::time);
    add(0.0008, Dimension::length, 2);
    for (const double value : {0.0008, 0.9996e-3}) add(value, Dimension::length, 3);
    test::expect_golden(text);
}

/// A locale with decimal comma and grouped thousands, on any machine.
struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(Units, DoNotDependOnTheLocale) {
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
