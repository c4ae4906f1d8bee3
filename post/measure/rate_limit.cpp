#include "post/measure/rate_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "post/measure/strength.hpp"
#include "post/run/likeness.hpp"
#include "post/run/test_label.hpp"
#include "post/table/column.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack {
namespace {

constexpr double largest_change = 0.05;  // beyond it, twice as slow is not yet in the range where the error is linear
constexpr double least_ratio = 1.2;      // of the rates: the limit has the scatter of the change over the ratio less one

/// A measure of the rate: the tolerance of an automatic rate, or a fixed platen speed, m/s.
double rate_of(const RunHeader& h) { return h.rate == "auto" ? h.rate_tolerance * h.rate_share : h.platen_speed; }

/// A specimen under one test.
using RateKey = std::tuple<std::string, double, std::int64_t, std::int64_t, double>;
RateKey rate_key(const RunData& run) {
    const SpecimenSummary& s = run.specimen;
    return {run.header.test, run.header.confining_pressure, s.seed, s.grains, s.mean_edge};
}

struct RatePair {
    const RunData* fast = nullptr;
    const RunData* slow = nullptr;
    [[nodiscard]] double ratio() const { return rate_of(fast->header) / rate_of(slow->header); }
};

void require_same_test(const RatePair& pair) {
    const std::string& rate = pair.slow->header.rate;
    const std::string difference = differences(*pair.slow, *pair.fast, {Aspect::rate});
    if (!difference.empty()) {
        throw InputError(pair.slow->name + ": differs from " + pair.fast->name + " in " + difference +
                         "; the limit of slow loading needs tests that differ in their rate only");
    }
    if (rate == "blocks") {
        throw InputError(pair.slow->name + ": has --rate " + rate +
                         "; the limit of slow loading needs an automatic or a fixed rate");
    }
    if (!(pair.ratio() >= least_ratio)) {
        throw InputError(
            fmt::format("{}: its rate equals that of {} or is too near to it; the limit of slow loading needs the same test at "
                        "two rates, one of them at least {} times the other (--rate-tolerance, --rate-share)",
                        pair.slow->name, pair.fast->name, least_ratio));
    }
}

/// The pairs of each test and pressure.
std::map<std::pair<double, std::string>, std::vector<RatePair>> pairs_of(const std::vector<RunData>& runs) {
    std::map<RateKey, std::vector<const RunData*>> tests;
    require_alike(runs, "the limit of slow loading", {Aspect::rate});
    for (const RunData& run : runs) tests[rate_key(run)].push_back(&run);
    std::map<std::pair<double, std::string>, std::vector<RatePair>> pairs;
    for (auto& [key, members] : tests) {
        if (members.size() != 2) {
            throw InputError(
                fmt::format("{}: {} of this specimen and test {} given; the limit of slow loading needs two, at two rates",
                            members.front()->name, counted(members.size(), "run"), members.size() == 1 ? "is" : "are"));
        }
        std::sort(members.begin(), members.end(),
                  [](const RunData* a, const RunData* b) { return rate_of(a->header) > rate_of(b->header); });
        const RatePair pair{members[0], members[1]};
        require_same_test(pair);
        std::vector<RatePair>& others = pairs[{std::get<1>(key), std::get<0>(key)}];
        if (!others.empty() && std::abs(pair.ratio() / others.front().ratio() - 1) > 1e-9) {
            throw InputError(pair.fast->name + ": its rates are not in the ratio of those of " + others.front().fast->name +
                             "; a mean needs equal ratios");
        }
        others.push_back(pair);
    }
    return pairs;
}

/// The strengths of the pairs; empty if a run has none of this kind.
std::optional<std::pair<std::vector<double>, std::vector<double>>> strengths_of(const std::vector<RatePair>& pairs,
                                                                                StrengthKind kind) {
    std::pair<std::vector<double>, std::vector<double>> strengths;
    for (const RatePair& pair : pairs) {
        const auto fast = measure_strength(*pair.fast).value(kind);
        const auto slow = measure_strength(*pair.slow).value(kind);
        if (!fast || !slow) return std::nullopt;
        strengths.first.push_back(*fast);
        strengths.second.push_back(*slow);
    }
    return strengths;
}

struct RateRow {
    std::string test;
    double confining_pressure = 0;  ///< Pa
    StrengthKind kind{};
    std::size_t specimens = 0;
    double rate_ratio = 0;
    double fast = 0, slow = 0;  ///< means, Pa
    RateLimit limit;
};

const Columns<RateRow>& rate_columns() {
    using R = RateRow;
    using namespace unit;
    static const Columns<R> all{{"test", none, [](const R& r) { return r.test; }},
                                {"confining_pressure", megapascal, [](const R& r) { return r.confining_pressure; }},
                                {"strength", none, [](const R& r) { return name_of(r.kind); }},
                                {"specimens", none, [](const R& r) { return r.specimens; }},
                                {"rate_ratio", none, [](const R& r) { return r.rate_ratio; }},
                                {"fast", megapascal, [](const R& r) { return r.fast; }},
                                {"slow", megapascal, [](const R& r) { return r.slow; }},
                                {"change", percent, [](const R& r) { return r.limit.change.value; }},
                                {"change_low", percent, [](const R& r) { return r.limit.change.low; }},
                                {"change_high", percent, [](const R& r) { return r.limit.change.high; }},
                                {"limit", megapascal, [](const R& r) { return r.limit.limit; }},
                                {"error", megapascal, [](const R& r) { return r.limit.error; }}};
    return all;
}

Cell change_interval(const RateRow& r) {
    const Estimate& change = r.limit.change;
    return change.low ? Cell(fmt::format("{:+.2f} to {:+.2f}", 100 * *change.low, 100 * change.high.value_or(0))) : Cell();
}

const Columns<RateRow>& rate_terminal_columns() {
    using R = RateRow;
    using namespace unit;
    static const Columns<R> all{
        {"test", none, [](const R& r) { return series_label(r.test, r.confining_pressure) + ", " + name_of(r.kind); }},
        {"specimens", none, [](const R& r) { return r.specimens; }},
        {"faster", megapascal, [](const R& r) { return r.fast; }},
        {"slower", megapascal, [](const R& r) { return r.slow; }},
        {"change", percent, [](const R& r) { return fmt::format("{:+.2f}", 100 * r.limit.change.value); }},
        {"95 % interval", percent, change_interval},
        {"limit", megapascal, [](const R& r) { return r.limit.limit; }},
        {"error", megapascal, [](const R& r) { return format_number(r.limit.error * megapascal.factor, 2); }}};
    return all;
}

}  // namespace

RateLimit extrapolate_rate(std::span<const double> fast, std::span<const double> slow, double ratio) {
    std::vector<double> changes;
    std::vector<double> excess;  // of the slower rate over none
    for (std::size_t i = 0; i < fast.size(); ++i) {
        changes.push_back(fast[i] / slow[i] - 1);
        excess.push_back((fast[i] - slow[i]) / (ratio - 1));
    }
    const Estimate mean_excess = sample(excess).mean;
    const double half_interval = mean_excess.high ? *mean_excess.high - mean_excess.value : 0;
    return {sample(changes).mean, sample(slow).mean.value - mean_excess.value,
            std::max(std::abs(mean_excess.value), half_interval)};
}

void write_rate_limits(std::ostream& out, const std::vector<std::string>& paths, TableFormat format) {
    std::vector<RateRow> rows;
    const std::vector<RunData> runs = read_runs(paths);
    for (const auto& [test, pairs] : pairs_of(runs)) {
        for (const StrengthKind kind : {StrengthKind::largest, StrengthKind::first_peak}) {
            const auto strengths = strengths_of(pairs, kind);
            if (!strengths) continue;
            const auto& [fast, slow] = *strengths;
            const RateLimit limit = extrapolate_rate(fast, slow, pairs.front().ratio());
            if (std::abs(limit.change.value) > largest_change) {
                throw InputError(
                    fmt::format("{}: the {} stress changes by {:+.1f} % between the two rates of {}; above {:.0f} % the change "
                                "is not linear in the rate: give slower tests",
                                pairs.front().fast->name, name_of(kind), 100 * limit.change.value,
                                series_label(test.second, test.first), 100 * largest_change));
            }
            rows.push_back({test.second, test.first, kind, pairs.size(), pairs.front().ratio(), sample(fast).mean.value,
                            sample(slow).mean.value, limit});
        }
    }
    write_table(out, rate_columns(), rate_terminal_columns(), rows, format);
}

}  // namespace graincrack
