#include "post/claims/evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/claims/levels.hpp"
#include "post/statistics/rank.hpp"
#include "post/table/number.hpp"
#include "share/base/error.hpp"

namespace graincrack::claims {

namespace {

std::string shown(const Estimate& e, const std::string& unit) {
    std::string text = fmt::format("{:.4g}", e.value);
    if (e.low && e.high) text += fmt::format(" ({:.4g} to {:.4g})", *e.low, *e.high);
    return unit.empty() ? text : text + " " + unit;
}

std::string percent(double part) { return fmt::format("{:+.1f} %", 100 * part); }

Finding open(const std::string& reason) { return {Verdict::open, std::nullopt, "not measured", "", reason, ""}; }

std::string counted_peaks(const std::vector<Row>& rows) { return rows.size() == 1 ? rows.front().without_peak : ""; }

const char* const too_wide = "the interval is too wide for a verdict";

/// The paper's number: of the claim, or of a column. Empty if that is empty.
std::optional<double> claimed_number(const Claim& claim, const std::vector<Row>& rows) {
    return claim.value.starts_with('=') ? rows.front().paper : parse_number(claim.value);
}

Finding value_finding(const Claim& claim, const Estimate& ours, double paper) {
    using Kind = Tolerance::Kind;
    Finding finding{Verdict::open, ours, "", "", "", ""};
    const double amount = claim.tolerance.amount;
    if (claim.tolerance.kind == Kind::interval) {
        finding.verdict = judge_covered(ours, paper, amount);
        finding.difference = fmt::format("{:+.2f}", ours.value - paper);
        return finding;
    }
    const bool relative = claim.tolerance.kind == Kind::relative;
    finding.verdict = judge_value(ours, paper, relative ? amount * std::abs(paper) : amount);
    finding.difference = paper != 0 ? percent(ours.value / paper - 1) : fmt::format("{:+.3g}", ours.value);
    return finding;
}

Bound bound_of(const Claim& claim, const std::string& where) {
    const bool or_equal = claim.value.size() > 1 && claim.value[1] == '=';
    const auto number = parse_number(claim.value.substr(or_equal ? 2 : 1));
    if (!number) throw InputError(fmt::format("{}: \"{}\" is no bound; one such as >=0.5 is needed", where, claim.value));
    return {*number, claim.value[0] == '>', or_equal};
}

/// Without an interval of its own, or one of standard errors in place of Student's.
Finding order_finding(const Claim& claim, const std::vector<Row>& rows, const Estimate& ours, const std::string& where) {
    const Bound bound = bound_of(claim, where);
    if (claim.tolerance.kind != Tolerance::Kind::standard_errors) return {judge_order(ours, bound), ours, "", "", "", ""};
    const std::vector<double> values = numbers_of(rows);
    const Sample all = sample(values);
    if (!all.deviation) return {Verdict::open, ours, "", "", "one specimen has no standard error", ""};
    const double error = *all.deviation / std::sqrt(static_cast<double>(all.n));
    const double beyond = (bound.above ? 1 : -1) * (all.mean.value - bound.value);
    Finding finding{beyond >= claim.tolerance.amount * error ? Verdict::holds : Verdict::differs, ours, "", "", "", ""};
    if (error > 0) finding.difference = fmt::format("{:+.1f} standard errors", (all.mean.value - bound.value) / error);
    return finding;
}

/// Two columns of two tables, joined by a third.
struct Joined {
    std::vector<double> ours;
    std::vector<double> theirs;
};
Joined join(const Claim& claim, const summary::Database& tables, const std::string& where) {
    const std::size_t colon = claim.against.find(':');
    if (colon == std::string::npos) {
        throw InputError(fmt::format("{}: against \"{}\"; TABLE:COLUMN is needed", where, claim.against));
    }
    const std::string sql = fmt::format(
        "SELECT ours, theirs FROM (SELECT {0} AS key, {1} AS ours FROM {2} WHERE {3}) JOIN (SELECT {0} AS key, {4} AS theirs "
        "FROM {5}) USING (key) WHERE ours IS NOT NULL AND theirs IS NOT NULL",
        claim.by, claim.column, claim.table, claim.where.empty() ? "TRUE" : claim.where, claim.against.substr(colon + 1),
        claim.against.substr(0, colon));
    Joined joined;
    for (const std::vector<Cell>& row : tables.answer_of_file(sql, where)) {
        joined.ours.push_back(parse_number(row[0].text()).value_or(0) * claim.factor);
        joined.theirs.push_back(parse_number(row[1].text()).value_or(0));
    }
    return joined;
}

/// The rank correlation of two columns, or the median of |ln ratio|.
Finding joined_finding(const Claim& claim, const summary::Database& tables, const std::string& where) {
    const Joined joined = join(claim, tables, where);
    if (joined.ours.size() < 3) return open("fewer than three rows can be compared");
    const std::string count = fmt::format(" over {} rows", joined.ours.size());
    if (claim.kind == Kind::order) {
        const Estimate rank{rank_correlation(joined.ours, joined.theirs), std::nullopt, std::nullopt};
        return {judge_order(rank, bound_of(claim, where)), rank, shown(rank, "") + count, "", "", ""};
    }
    std::vector<double> ratio(joined.ours.size());
    std::vector<double> off(joined.ours.size());
    for (std::size_t i = 0; i < ratio.size(); ++i) {
        ratio[i] = joined.ours[i] / joined.theirs[i];
        off[i] = std::abs(std::log(ratio[i]));
    }
    const Estimate middle{median(off), std::nullopt, std::nullopt};
    return {middle.value <= claim.tolerance.amount ? Verdict::holds : Verdict::differs,
            middle,
            fmt::format("median |ln ratio| {:.2g}", middle.value) + count,
            percent(median(ratio) - 1),
            "",
            ""};
}

Finding levels_finding(const Claim& claim, const std::vector<Row>& rows) {
    const std::optional<LevelDifference> found =
        claim.pair.empty() ? difference_between_levels(claim, rows) : difference_on_same_specimens(claim, rows);
    if (!found) return open("fewer than two levels can be compared");
    const Estimate& part = found->largest;
    Finding finding{found->verdict, part, "", percent(part.value), "", ""};
    finding.ours->value *= 100;
    if (part.low) finding.ours->low = 100 * *part.low;
    if (part.high) finding.ours->high = 100 * *part.high;
    finding.text = "at most " + shown(*finding.ours, "%");
    return finding;
}

Finding trend_finding(const Claim& claim, const std::vector<Row>& rows) {
    const std::vector<std::pair<double, Estimate>> levels = estimates_by_level(rows);
    if (levels.size() < 2) return open("fewer than two levels can be compared");
    const auto& [from, first] = levels.front();
    const auto& [to, last] = levels.back();
    return {judge_change(first, last, claim.value == "rises"),
            last,
            fmt::format("{:.4g} at {:g}, {:.4g} at {:g}{}", first.value, from, last.value, to, counted_peaks(rows)),
            "",
            "not above the scatter",
            ""};
}

std::optional<Finding> number_finding(const Claim& claim, const std::vector<Row>& rows, const std::string& where) {
    const std::optional<double> paper =
        claim.kind == Kind::value || claim.kind == Kind::equality ? claimed_number(claim, rows) : std::optional(0.0);
    if (!paper) return std::nullopt;
    const std::optional<Estimate> ours = estimate_of(claim, rows);
    if (!ours) return open("our column is empty");
    Finding finding;
    switch (claim.kind) {
        case Kind::value: finding = value_finding(claim, *ours, *paper); break;
        case Kind::sign:
            finding = {judge_sign(*ours, claim.value == "+"), *ours, "", "", "the interval has both signs", ""};
            break;
        case Kind::order: finding = order_finding(claim, rows, *ours, where); break;
        default: {
            // A following 5 may be rounded up or down: a thousandth of the last digit more.
            const bool equal = std::abs(ours->value - *paper) <= claim.tolerance.amount * 1.001;
            finding = {equal ? Verdict::holds : Verdict::differs, *ours, "", "", "", ""};
            if (*paper != 0) finding.difference = fmt::format("{:+.2f} %", 100 * (ours->value / *paper - 1));
        }
    }
    if (finding.verdict == Verdict::holds && !rows.front().meets_needs) {
        finding.verdict = Verdict::open;
        finding.reason = fmt::format("{} does not follow from these rows", claim.needs);
    }
    finding.text = shown(*ours, claim.unit) + counted_peaks(rows);
    if (claim.value.starts_with('=')) finding.paper = shown({*paper, std::nullopt, std::nullopt}, claim.unit);
    return finding;
}

}  // namespace

std::optional<Finding> evaluate(const Claim& claim, const summary::Database& tables) {
    const std::string where = fmt::format("claim {} ({})", claim.row, claim.name);
    // A study with fewer levels has no column for the others.
    if (claim.only_if_measured && !claim.against.empty() && !tables.has(claim.table, claim.column)) return std::nullopt;
    const std::vector<Row> rows = rows_of(claim, tables, where);
    if (rows.empty()) {
        if (claim.only_if_measured) return std::nullopt;
        return open("there are no such rows");
    }
    std::optional<Finding> finding;
    if (!claim.against.empty()) {
        finding = joined_finding(claim, tables, where);
    } else if (claim.kind == Kind::trend) {
        finding = trend_finding(claim, rows);
    } else if (claim.kind == Kind::equality && !claim.by.empty()) {
        finding = levels_finding(claim, rows);
    } else {
        finding = number_finding(claim, rows, where);
    }
    if (finding && finding->verdict == Verdict::open && finding->reason.empty()) finding->reason = too_wide;
    return finding;
}

}  // namespace graincrack::claims
