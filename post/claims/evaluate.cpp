#include "post/claims/evaluate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "post/claims/levels.hpp"
#include "post/statistics/rank.hpp"
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

const char* const too_wide = "the interval is too wide for a verdict";

/// " (3 of 10 without a peak)" of a row that counts them.
std::string without_peak(const Rows& rows) {
    if (rows.size() != 1 || !rows.has("without_peak")) return "";
    const auto total = rows.has("specimens") ? rows.number(0, "specimens")
                       : rows.has("runs")    ? rows.number(0, "runs")
                                             : std::nullopt;
    const auto count = rows.number(0, "without_peak");
    if (!count || *count == 0 || !total) return "";
    return fmt::format(" ({:.0f} of {:.0f} without a peak)", *count, *total);
}

/// The paper's number: of the claim, or of a column. Empty if that is empty.
std::optional<double> claimed_number(const Claim& claim, const Rows& rows) {
    if (claim.value.starts_with('=')) return rows.number(0, claim.value.substr(1));
    return parse_number(claim.value);
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
Finding order_finding(const Claim& claim, const Rows& rows, const Estimate& ours, const std::string& where) {
    const Bound bound = bound_of(claim, where);
    if (claim.tolerance.kind != Tolerance::Kind::standard_errors) return {judge_order(ours, bound), ours, "", "", "", ""};
    const std::vector<double> values = numbers_of(claim, rows);
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
Joined join(const Claim& claim, const Rows& rows, const Tables& tables, const std::string& where) {
    const std::size_t colon = claim.against.find(':');
    if (colon == std::string::npos) {
        throw InputError(fmt::format("{}: against \"{}\"; TABLE:COLUMN is needed", where, claim.against));
    }
    const TableFile& other = tables.at(claim.against.substr(0, colon), where);
    const std::vector<double> values = other.numbers_or_nan(claim.against.substr(colon + 1));
    const std::vector<std::string> keys = other.texts(claim.by);
    Joined joined;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto ours = rows.number(i, claim.column);
        const auto found = std::find(keys.begin(), keys.end(), rows.text(i, claim.by));
        if (!ours || found == keys.end()) continue;
        const double theirs = values[static_cast<std::size_t>(found - keys.begin())];
        if (!std::isfinite(theirs)) continue;
        joined.ours.push_back(*ours * claim.factor);
        joined.theirs.push_back(theirs);
    }
    return joined;
}

/// The rank correlation of two columns, or the median of |ln ratio|.
Finding joined_finding(const Claim& claim, const Rows& rows, const Tables& tables, const std::string& where) {
    const Joined joined = join(claim, rows, tables, where);
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

Finding levels_finding(const Claim& claim, const Rows& rows) {
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

Finding trend_finding(const Claim& claim, const Rows& rows) {
    const std::vector<std::pair<double, Estimate>> levels = estimates_by_level(claim, rows);
    if (levels.size() < 2) return open("fewer than two levels can be compared");
    const auto& [from, first] = levels.front();
    const auto& [to, last] = levels.back();
    return {judge_change(first, last, claim.value == "rises"),
            last,
            fmt::format("{:.4g} at {:g}, {:.4g} at {:g}{}", first.value, from, last.value, to, without_peak(rows)),
            "",
            "not above the scatter",
            ""};
}

/// Whether the rows have what the claim needs for a verdict.
bool has_needs(const Claim& claim, const Rows& rows) { return !claim.needs || matches(*claim.needs, rows, 0); }

std::optional<Finding> number_finding(const Claim& claim, const Rows& rows, const std::string& where) {
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
    if (finding.verdict == Verdict::holds && !has_needs(claim, rows)) {
        finding.verdict = Verdict::open;
        finding.reason = fmt::format("{} does not follow from these rows", claim.needs->column);
    }
    finding.text = shown(*ours, claim.unit) + without_peak(rows);
    if (claim.value.starts_with('=')) finding.paper = shown({*paper, std::nullopt, std::nullopt}, claim.unit);
    return finding;
}

}  // namespace

Tables::Tables(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        const std::string stem = file == "-" ? "stdin" : std::filesystem::path(file).stem().string();
        if (!tables_.emplace(stem, TableFile(file)).second) {
            throw InputError(fmt::format("{}: another table has the name {} too; claims name tables by their files", file, stem));
        }
    }
}

const TableFile& Tables::at(const std::string& stem, const std::string& where) const {
    const auto found = tables_.find(stem);
    if (found != tables_.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [name, table] : tables_) names.push_back(name);
    throw InputError(fmt::format("{}: no table {}; there are {}", where, stem, fmt::join(names, ", ")));
}

std::optional<Finding> evaluate(const Claim& claim, const Tables& tables) {
    const std::string where = fmt::format("claim {} ({})", claim.row, claim.name);
    const TableFile& table = tables.at(claim.table, where);
    // A study with fewer levels has no column for the others.
    if (claim.only_if_measured && !claim.against.empty() && !table.has(claim.column)) return std::nullopt;
    const Rows rows(table, claim.where);
    if (rows.size() == 0) {
        if (claim.only_if_measured) return std::nullopt;
        return open("there are no such rows");
    }
    std::optional<Finding> finding;
    if (!claim.against.empty()) {
        finding = joined_finding(claim, rows, tables, where);
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
