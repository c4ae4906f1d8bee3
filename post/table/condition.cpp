#include "post/table/condition.hpp"

#include <charconv>
#include <cmath>
#include <map>

namespace graincrack {

namespace {

using Comparison = Condition::Comparison;

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \t");
    return from == std::string::npos ? "" : text.substr(from, text.find_last_not_of(" \t") + 1 - from);
}

bool equal(double a, double b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

bool compare(Comparison comparison, double entry, double wanted) {
    switch (comparison) {
        case Comparison::less: return entry < wanted;
        case Comparison::less_or_equal: return entry <= wanted;
        case Comparison::greater: return entry > wanted;
        case Comparison::greater_or_equal: return entry >= wanted;
        case Comparison::not_equal: return !equal(entry, wanted);
        default: return equal(entry, wanted);
    }
}

}  // namespace

std::optional<double> parse_number(const std::string& text) {
    const char* from = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
    const char* const to = text.data() + text.size();
    double value = 0;
    const auto [end, error] = std::from_chars(from, to, value);
    if (error != std::errc{} || end != to) return std::nullopt;
    return value;
}

std::optional<Condition> parse_condition(const std::string& text) {
    const std::size_t at = text.find_first_of("<>=!");
    const std::size_t from = at == std::string::npos ? at : text.find_first_not_of("<>=!", at);
    static const std::map<std::string, Comparison> comparisons{{"=", Comparison::equal},   {"!=", Comparison::not_equal},
                                                               {"<", Comparison::less},    {"<=", Comparison::less_or_equal},
                                                               {">", Comparison::greater}, {">=", Comparison::greater_or_equal}};
    const auto found = from == std::string::npos ? comparisons.end() : comparisons.find(text.substr(at, from - at));
    if (at == 0 || found == comparisons.end()) return std::nullopt;
    const Condition condition{found->second, trimmed(text.substr(0, at)), trimmed(text.substr(from))};
    const bool takes_text = condition.comparison == Comparison::equal || condition.comparison == Comparison::not_equal;
    if (!takes_text && !parse_number(condition.value)) return std::nullopt;
    return condition;
}

bool meets(const Condition& condition, const std::string& entry) {
    const auto number = parse_number(entry);
    const auto wanted = parse_number(condition.value);
    if (number && wanted) return compare(condition.comparison, *number, *wanted);
    if (condition.comparison == Comparison::not_equal) return !entry.empty() && entry != condition.value;
    return condition.comparison == Comparison::equal && entry == condition.value;
}

}  // namespace graincrack
