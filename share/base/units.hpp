// Converts numbers with units between text and SI, independent of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "share/base/quantities.hpp"

namespace graincrack {

/// The units of a dimension, the SI unit first. Symbols are case-sensitive. Other spellings are accepted but not listed: "µm",
/// "°", "MPa√m", "MPa*m^0.5", "J/m^2", "kg/m^3".
std::vector<Unit> units_of(Dimension dimension);
/// The dimension of an SI unit as spelt in files; empty if it is none.
std::optional<Dimension> dimension_of_unit(std::string_view si_unit);

/// Reads "4mm", "4 mm", "48.76deg", "5 mm/s", "1.5MPa.m^0.5", "90J/m2" or a bare SI number.
/// Decimal units are exact: "5.13mm" and "0.00513" give the same double.
///
/// \param where source in the message: an option ("--edge") or file and key ("granite.toml: rock.density")
/// \throws UsageError if the text is no number, the unit is unknown or of another dimension, or the value is not finite or
///         out of the bounds of `quantity`; the message lists the units that fit
double parse_quantity(std::string_view text, const Quantity& quantity, std::string_view where);

/// Does the same for an option that also accepts a word: parse_quantity_or(text, "none", 0, quantity::damping, "--damping").
double parse_quantity_or(std::string_view text, std::string_view word, double word_value, const Quantity& quantity,
                         std::string_view where);

/// A note on a number without a unit that probably means another unit: any length or stress except 0, a speed of 1 m/s or more, a
/// density below 100 kg/m³, such as "--width: 80 has no unit and was taken for 80 m", where 80 mm is likelier. It is "" for other
/// texts. \param where as in parse_quantity
std::string bare_number_note(std::string_view text, const Quantity& quantity, std::string_view where);

/// The bounds of a quantity in words, in readable units: "above 0 m and at most 1000 m", "from 0 deg to 88.81 deg".
std::string bounds_text(const Quantity& quantity);

/// Converts an SI number to `unit` (a symbol of `units_of`). \throws std::invalid_argument for an unknown unit
double in_unit(double value, Dimension dimension, std::string_view unit);

/// Shortest text that reads back as the same double; "nan" and "inf" if it is not finite.
std::string format_number(double value);
/// Text with a number of significant digits, independent of the locale ("%.{digits}g").
std::string format_number(double value, int digits);
/// A number rounded to significant digits.
double rounded(double value, int digits);

/// A value in the largest common unit that keeps it readable: 0.004 m → "4 mm", 2.58e10 Pa → "25.8 GPa".
std::string format_quantity(double value, Dimension dimension, int digits = 4);
/// A length in such a unit.
std::string format_length(double value);

}  // namespace graincrack
