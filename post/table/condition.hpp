// Conditions on the rows of a table: "series=b", "level<=0.75", "peak_kind!=drop".
#pragma once

#include <optional>
#include <string>

namespace graincrack {

struct Condition {
    enum class Comparison { equal, not_equal, less, less_or_equal, greater, greater_or_equal } comparison = Comparison::equal;
    std::string column;
    std::string value;
};

/// Empty unless the text is COLUMN=VALUE or COLUMN!=VALUE, or <, <=, >, >= and a number behind a column.
std::optional<Condition> parse_condition(const std::string& text);
/// What parse_condition takes, for messages.
inline constexpr const char* condition_form = "COLUMN=VALUE or COLUMN!=VALUE, or <, <=, >, >= and a number, is needed";

/// Whether an entry of the condition's column meets it. Numbers are compared as numbers, equal within a part of 1e-9 (tables have
/// seven digits); an empty entry meets no condition.
bool meets(const Condition& condition, const std::string& entry);

/// A number, empty if the text is none.
std::optional<double> parse_number(const std::string& text);

}  // namespace graincrack
