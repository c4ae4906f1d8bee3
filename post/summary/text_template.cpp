#include "post/summary/text_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "post/summary/expression.hpp"
#include "post/table/condition.hpp"
#include "post/table/table.hpp"
#include "share/base/error.hpp"

namespace graincrack::summary {

namespace {

using Group = std::vector<std::size_t>;
/// A part of a text; nothing if what it shows is empty.
using Part = std::function<std::optional<std::string>(const Group&)>;
using Parts = std::vector<Part>;

std::string joined(const std::vector<std::string>& texts) {
    std::string text;
    for (const std::string& each : texts) text += (text.empty() ? "" : "; ") + each;
    return text;
}

/// COLUMN or COLUMN where CONDITION and …
Part entries_part(const std::string& text, const JoinedRows& rows) {
    const std::size_t where = text.find(" where ");
    const std::vector<std::string>* const entries = &rows.column(text.substr(0, where));
    std::vector<std::pair<Condition, const std::vector<std::string>*>> conditions;
    for (std::size_t at = where == std::string::npos ? where : where + 7; at != std::string::npos;) {
        const std::size_t end = text.find(" and ", at);
        const auto condition = parse_condition(text.substr(at, end == std::string::npos ? end : end - at));
        if (!condition) throw UsageError(fmt::format("{{{}}}: {}", text, condition_form));
        conditions.emplace_back(*condition, &rows.column(condition->column));
        at = end == std::string::npos ? end : end + 5;
    }
    return [entries, conditions](const Group& group) -> std::optional<std::string> {
        std::vector<std::string> found;
        for (const std::size_t row : group) {
            const bool all = std::all_of(conditions.begin(), conditions.end(),
                                         [&](const auto& c) { return meets(c.first, (*c.second)[row]); });
            const std::string& entry = (*entries)[row];
            if (all && !entry.empty() && std::find(found.begin(), found.end(), entry) == found.end()) found.push_back(entry);
        }
        return found.empty() ? std::nullopt : std::optional(joined(found));
    };
}

/// EXPRESSION or EXPRESSION:FORMAT
Part number_part(const std::string& text, const JoinedRows& rows) {
    const std::size_t colon = text.rfind(':');
    const GroupExpression expression = parse_expression(text.substr(0, colon), rows);
    const std::string format = colon == std::string::npos ? "" : "{" + text.substr(colon) + "}";
    try {
        if (!format.empty()) static_cast<void>(fmt::format(fmt::runtime(format), 1.0));
    } catch (const fmt::format_error&) {
        throw UsageError(
            fmt::format("{{{}}}: \"{}\" is no format of a number; .1f, +.2f or .0e fits", text, text.substr(colon + 1)));
    }
    return [expression, format](const Group& group) -> std::optional<std::string> {
        const Number number = expression(group);
        if (!number) return std::nullopt;
        return format.empty() ? Cell(*number).text() : fmt::format(fmt::runtime(format), *number == 0 ? 0.0 : *number);
    };
}

/// What stands between braces: a column by itself, or an expression, which has a statistic in it.
Part braces_part(const std::string& text, const JoinedRows& rows) {
    return text.substr(0, text.find(" where ")).find('(') == std::string::npos ? entries_part(text, rows)
                                                                               : number_part(text, rows);
}

/// The place of what closes, from `from` on. \throws UsageError
std::size_t closing(const std::string& text, char close, std::size_t from) {
    const std::size_t at = text.find(close, from);
    if (at == std::string::npos) throw UsageError(fmt::format("{}: {} is needed", text, close));
    return at;
}

/// Texts and braces, without brackets.
Parts parts_of(const std::string& text, const JoinedRows& rows) {
    Parts parts;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = std::min(text.find('{', at), text.size());
        if (open > at) parts.emplace_back([fixed = text.substr(at, open - at)](const Group&) { return fixed; });
        if (open == text.size()) break;
        const std::size_t close = closing(text, '}', open);
        parts.push_back(braces_part(text.substr(open + 1, close - open - 1), rows));
        at = close + 1;
    }
    return parts;
}

std::optional<std::string> all_of(const Parts& parts, const Group& group) {
    std::string text;
    for (const Part& part : parts) {
        const auto shown = part(group);
        if (!shown) return std::nullopt;
        text += *shown;
    }
    return text;
}

/// Alternatives, by semicolons.
Part brackets_part(const std::string& text, const JoinedRows& rows) {
    std::vector<Parts> alternatives;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(';', at), text.size());
        alternatives.push_back(parts_of(text.substr(at, end - at), rows));
        at = end + 1;
    }
    return [alternatives](const Group& group) -> std::optional<std::string> {
        for (const Parts& parts : alternatives) {
            if (auto shown = all_of(parts, group)) return shown;
        }
        return std::nullopt;
    };
}

}  // namespace

TextTemplate parse_template(const std::string& text, const JoinedRows& rows) {
    Parts parts;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = std::min(text.find('[', at), text.size());
        for (Part& part : parts_of(text.substr(at, open - at), rows)) parts.push_back(std::move(part));
        if (open == text.size()) break;
        const std::size_t close = closing(text, ']', open);
        parts.push_back(brackets_part(text.substr(open + 1, close - open - 1), rows));
        at = close + 1;
    }
    return [parts](const Group& group) {
        std::string shown;
        for (const Part& part : parts) shown += part(group).value_or("-");
        return shown;
    };
}

}  // namespace graincrack::summary
