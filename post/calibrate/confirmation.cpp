#include "post/calibrate/confirmation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace graincrack::calibrate {

namespace {

WantedRun test_of(const Target& target, const Point& point, const std::string& reason) {
    return {target.test, target.confining_pressure, 0, point, std::nullopt, reason, target.notched};
}

/// What a run says about a target; empty if it has no such value.
std::optional<double> result_of(const Target& target, const FinishedRun& run) {
    if (target.name == "young_modulus") return run.young_modulus.value();
    if (target.name == "poisson_ratio") return run.poisson_ratio.value();
    if (target.name == "crack_initiation") return run.crack_initiation;
    if (target.name == "crack_damage") return run.crack_damage;
    if (target.name == "mode_i_toughness") return run.mode_i_toughness;
    return run.strength;
}

std::string bistable_note(const std::vector<FinishedRun>& runs) {
    std::vector<bool> has_peak;
    for (const FinishedRun& run : runs) has_peak.push_back(run.has_peak);
    const auto found = find_bistable(strengths_of(runs), has_peak);
    if (!found) return "";
    return fmt::format(
        "two kinds of tests: {} fall behind a peak of {:.4g} MPa, {} harden up to the strain limit, at {:.4g} MPa; the mean is "
        "of neither",
        found->with_peak, found->mean_with_peak * 1e-6, found->without_peak, found->mean_without_peak * 1e-6);
}

/// Within the bound with an interval no wider than it; outside of it with the whole interval; else undecided.
std::string verdict_on(const Target& target, const Estimate& ours) {
    const double off = std::abs(ours.value - target.value);
    const double half = ours.high ? *ours.high - ours.value : 0;
    if (off <= target.tolerance() && half <= target.tolerance()) return "within";
    return off - half > target.tolerance() ? "outside" : "undecided";
}

Outcome outcome_of(const Target& target, const std::vector<FinishedRun>& runs) {
    std::vector<double> values;
    for (const FinishedRun& run : runs) {
        if (const auto value = result_of(target, run)) values.push_back(*value);
    }
    if (values.empty()) return {target, std::nullopt, 0, "", ""};
    const Sample all = sample(values);
    const std::string verdict = std::isnan(target.value) ? "" : verdict_on(target, all.mean);
    return {target, all.mean, all.n, verdict, bistable_note(runs)};
}

std::int64_t confirmation_seed(std::size_t round) {
    return seeds::confirmation + static_cast<std::int64_t>(round) * seeds::per_round;
}

}  // namespace

Ending confirm(Progress& progress, std::size_t round) {
    const std::int64_t first = confirmation_seed(round);
    Decision& decision = progress.decision;
    decision.outcomes.clear();
    for (const Target& target : progress.targets()) {
        if (target.role == Role::predicted) continue;
        const bool disc = target.test == "brazilian";
        const SamplingRule& rule = disc ? progress.study().discs : progress.study().rectangles;
        // E and ν are those of the uniaxial tests for UCS.
        const WantedRun run = test_of(target, decision.point, "the calibrated point on new specimens");
        const auto runs = progress.sampled(run, first, rule);
        decision.outcomes.push_back(outcome_of(target, runs));
        const Outcome& outcome = decision.outcomes.back();
        progress.note("confirmation", fmt::format("{}, {} new specimens", target.symbol, outcome.specimens),
                      fmt::format("{:.4g} ± {:.2g} {} for {:.4g}: {}{}{}", outcome.ours->value / target.si,
                                  (*outcome.ours->high - outcome.ours->value) / target.si, target.unit, target.value / target.si,
                                  outcome.verdict, outcome.note.empty() ? "" : "; ", outcome.note));
    }
    const auto any = [&](const char* verdict) {
        return std::any_of(decision.outcomes.begin(), decision.outcomes.end(),
                           [&](const Outcome& o) { return o.verdict == verdict; });
    };
    return any("outside") ? Ending::not_reached : any("undecided") ? Ending::undecided : Ending::calibrated;
}

void predict(Progress& progress, std::size_t round) {
    std::vector<WantedRun> wanted;
    for (const Target& target : progress.targets()) {
        if (target.role == Role::fitted || target.test == "uniaxial") continue;
        for (std::size_t i = 0; i < progress.study().predicted; ++i) {
            wanted.push_back(test_of(target, progress.decision.point, "a prediction"));
            wanted.back().seed = seeds::predictions + static_cast<std::int64_t>(i);
        }
    }
    const std::vector<FinishedRun> runs = progress.get(wanted);
    auto next = runs.begin();
    for (const Target& target : progress.targets()) {
        if (target.role == Role::fitted) continue;
        if (target.test == "uniaxial") {  // measured on the specimens for UCS
            const WantedRun run = test_of(target, progress.decision.point, "");
            const auto uniaxial = progress.sampled(run, confirmation_seed(round), progress.study().rectangles);
            progress.decision.outcomes.push_back(outcome_of(target, uniaxial));
            continue;
        }
        const auto end = next + static_cast<std::ptrdiff_t>(progress.study().predicted);
        progress.decision.outcomes.push_back(outcome_of(target, {next, end}));
        next = end;
    }
}

}  // namespace graincrack::calibrate
