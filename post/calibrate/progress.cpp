#include "post/calibrate/progress.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace graincrack::calibrate {

Progress::Progress(const Material& rock, const Study& study, const std::vector<FinishedRun>& finished)
    : rock_(rock), study_(study), targets_(targets_of(rock, study.targets)), finished_(rock, finished, study.max_strain) {
    // The contacts' own values of the file are only a first guess that nothing uses; derived ones must not come from them.
    if (!rock_.laboratory.contains("friction_angle")) {
        const double b = laboratory_slope(rock);
        rock_.laboratory["friction_angle"] = std::asin((b - 1) / (b + 1));
    }
}

std::vector<FinishedRun> Progress::get(const std::vector<WantedRun>& wanted) const {
    std::vector<FinishedRun> found;
    RunsMissing missing;
    for (const WantedRun& each : wanted) {
        if (const FinishedRun* run = finished_.find(each)) {
            found.push_back(*run);
            continue;
        }
        const auto same = [&](const WantedRun& other) { return same_run(rock_, each, other); };
        if (std::none_of(missing.runs.begin(), missing.runs.end(), same)) missing.runs.push_back(each);
    }
    if (!missing.runs.empty()) throw missing;
    return found;
}

std::vector<FinishedRun> Progress::get(const WantedRun& one, std::int64_t first, std::size_t n) const {
    std::vector<WantedRun> wanted(n, one);
    for (std::size_t i = 0; i < n; ++i) wanted[i].seed = first + static_cast<std::int64_t>(i);
    return get(wanted);
}

std::vector<FinishedRun> Progress::sampled(const WantedRun& one, std::int64_t first, const SamplingRule& rule) const {
    for (std::size_t n = std::min(rule.least, rule.most);;) {
        std::vector<FinishedRun> runs = get(one, first, n);
        const std::size_t wanted = specimens_wanted(strengths_of(runs), rule);
        if (wanted <= n) return runs;
        n = wanted;
    }
}

void Progress::note(std::string stage, std::string what, std::string result) {
    decision.steps.push_back({std::move(stage), std::move(what), std::move(result)});
}

std::vector<double> strengths_of(const std::vector<FinishedRun>& runs) {
    std::vector<double> out;
    for (const FinishedRun& run : runs) out.push_back(run.strength);
    return out;
}

}  // namespace graincrack::calibrate
