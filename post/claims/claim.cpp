#include "post/claims/claim.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "post/table/number.hpp"
#include "post/table/table_file.hpp"
#include "share/base/error.hpp"
#include "share/base/toml_file.hpp"

namespace graincrack::claims {

namespace {

const std::vector<std::string> needed_columns{"claim", "kind", "table", "column", "paper"};
const std::vector<std::string> further_columns{"where",   "value", "tolerance", "interval", "by",  "pair",
                                               "against", "needs", "factor",    "unit",     "note"};

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(' ');
    if (from == std::string::npos) return "";
    return text.substr(from, text.find_last_not_of(' ') - from + 1);
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t from = 0;
    for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, from)) {
        parts.push_back(trimmed(text.substr(from, at - from)));
        from = at + 1;
    }
    parts.push_back(trimmed(text.substr(from)));
    std::erase(parts, "");
    return parts;
}

/// The text with every {NAME} replaced.
std::string with_settings(const std::string& text, const std::map<std::string, std::string>& settings, const std::string& where) {
    std::string out;
    std::size_t from = 0;
    for (std::size_t at = text.find('{'); at != std::string::npos; at = text.find('{', from)) {
        const std::size_t end = text.find('}', at);
        if (end == std::string::npos) break;
        const std::string name = text.substr(at + 1, end - at - 1);
        const auto found = settings.find(name);
        if (found == settings.end()) {
            throw InputError(fmt::format("{}: {{{}}} is not set; give it by --set {}=…", where, name, name));
        }
        out += text.substr(from, at - from) + found->second;
        from = end + 1;
    }
    return out + text.substr(from);
}

Kind parse_kind(const std::string& text, const std::string& where) {
    static const std::map<std::string, Kind> kinds{{"value", Kind::value},
                                                   {"sign", Kind::sign},
                                                   {"trend", Kind::trend},
                                                   {"order", Kind::order},
                                                   {"equality", Kind::equality}};
    const auto found = kinds.find(text);
    if (found != kinds.end()) return found->second;
    throw InputError(fmt::format("{}: kind \"{}\"; value, sign, trend, order or equality is needed", where, text));
}

Tolerance parse_tolerance(const std::string& text, const std::string& where) {
    using Kind = Tolerance::Kind;
    if (text.empty()) return {};
    if (text == "interval") return {Kind::interval, std::numeric_limits<double>::infinity()};
    const std::array<std::pair<std::string, Kind>, 2> ends{{{"%", Kind::relative}, {"standard errors", Kind::standard_errors}}};
    for (const auto& [end, kind] : ends) {
        if (!text.ends_with(end)) continue;
        const auto amount = parse_number(trimmed(text.substr(0, text.size() - end.size())));
        if (amount) return {kind, kind == Kind::relative ? *amount / 100 : *amount};
    }
    const bool interval = text.starts_with("interval ");
    if (const auto amount = parse_number(interval ? text.substr(9) : text)) {
        return {interval ? Kind::interval : Kind::absolute, *amount};
    }
    throw InputError(
        fmt::format("{}: tolerance \"{}\"; a number, a part such as 5%, interval, interval WIDTH or N standard errors is needed",
                    where, text));
}

/// The rows of a file of claims.
class ClaimsFile {
public:
    ClaimsFile(const std::string& file, const std::map<std::string, std::string>& settings) : table_(file), settings_(settings) {
        for (const std::string& column : needed_columns) static_cast<void>(table_.texts(column));
        std::vector<std::string> known = needed_columns;
        known.insert(known.end(), further_columns.begin(), further_columns.end());
        for (const std::string& column : table_.columns()) {
            if (std::find(known.begin(), known.end(), column) != known.end()) continue;
            throw InputError(fmt::format("{}: unknown column {}; known are {}", file, column, fmt::join(known, ", ")));
        }
    }
    [[nodiscard]] std::size_t n_rows() const { return table_.n_rows(); }
    [[nodiscard]] std::string where(std::size_t row) const { return fmt::format("{}: row {}", table_.name(), row + 1); }
    [[nodiscard]] std::string text(std::size_t row, const std::string& column) const {
        return table_.has(column) ? with_settings(trimmed(table_.texts(column)[row]), settings_, where(row)) : "";
    }

private:
    TableFile table_;
    const std::map<std::string, std::string>& settings_;
};

/// \throws InputError if the claim lacks what its kind needs
void check(const Claim& claim, const std::string& where) {
    const auto needs = [&](bool there, const std::string& what) {
        if (!there) throw InputError(fmt::format("{}: {} is needed for this kind of claim", where, what));
    };
    const auto one_of = [&](const std::string& a, const std::string& b) {
        needs(claim.value == a || claim.value == b, fmt::format("a value {} or {}", a, b));
    };
    needs(!claim.name.empty() && !claim.table.empty() && !claim.column.empty(), "claim, table and column");
    if (claim.kind == Kind::sign) one_of("+", "-");
    if (claim.kind == Kind::trend) {
        one_of("rises", "falls");
        needs(!claim.by.empty() && !claim.interval.empty(), "by, the column of levels, and interval");
    }
    if (claim.kind == Kind::order) needs(claim.value.starts_with('<') || claim.value.starts_with('>'), "a value such as >=0.5");
    if (claim.kind == Kind::value) needs(claim.value.starts_with('=') || parse_number(claim.value), "a number as paper or value");
    const bool rounding = claim.kind == Kind::equality && claim.by.empty();
    needs(!rounding || parse_number(claim.value), "a number as paper or value");
    needs(claim.against.empty() || !claim.by.empty(), "by, the column that joins the tables");
}

Claim read_claim(const ClaimsFile& file, std::size_t row) {
    const std::string where = file.where(row);
    Claim claim;
    claim.row = static_cast<int>(row) + 1;
    claim.name = file.text(row, "claim");
    claim.kind = parse_kind(file.text(row, "kind"), where);
    claim.table = file.text(row, "table");
    claim.where = file.text(row, "where");
    claim.column = file.text(row, "column");
    claim.paper = file.text(row, "paper");
    claim.value = file.text(row, "value");
    if (claim.value.empty()) claim.value = claim.paper;
    claim.tolerance = parse_tolerance(file.text(row, "tolerance"), where);
    claim.interval = split(file.text(row, "interval"), ':');
    claim.by = file.text(row, "by");
    claim.pair = file.text(row, "pair");
    claim.against = file.text(row, "against");
    claim.needs = file.text(row, "needs");
    claim.only_if_measured = claim.needs == "rows";
    if (claim.only_if_measured) claim.needs.clear();
    const std::string factor = file.text(row, "factor");
    if (!factor.empty()) {
        const auto number = parse_number(factor);
        if (!number) throw InputError(fmt::format("{}: factor \"{}\"; a number is needed", where, factor));
        claim.factor = *number;
    }
    claim.unit = file.text(row, "unit");
    claim.note = file.text(row, "note");
    check(claim, where);
    return claim;
}

}  // namespace

std::vector<Claim> read_claims(const std::string& file, const std::map<std::string, std::string>& settings) {
    const ClaimsFile claims(file, settings);
    std::vector<Claim> out;
    for (std::size_t row = 0; row < claims.n_rows(); ++row) out.push_back(read_claim(claims, row));
    return out;
}

}  // namespace graincrack::claims
