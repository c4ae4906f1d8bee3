#include "post/calibrate/run.hpp"

#include <cmath>

namespace graincrack::calibrate {

namespace {

/// Tables have seven digits, and values of runs pass through units on their way.
constexpr double equal_within = 2e-6;

bool equal(double a, double b) { return std::abs(a - b) <= equal_within * std::max(std::abs(a), std::abs(b)); }

bool equal(const std::array<double, n_parameters>& a, const std::array<double, n_parameters>& b) {
    for (std::size_t i = 0; i < n_parameters; ++i) {
        if (!equal(a[i], b[i])) return false;
    }
    return true;
}

}  // namespace

PlaneCondition plane_of(const std::string& test) { return test == "brazilian" ? PlaneCondition::stress : PlaneCondition::strain; }

bool same_run(const Material& rock, const WantedRun& a, const WantedRun& b) {
    return a.test == b.test && a.seed == b.seed && equal(a.confining_pressure, b.confining_pressure) &&
           a.max_strain == b.max_strain && a.notched == b.notched &&
           equal(effective_values(rock, a.point, plane_of(a.test)), effective_values(rock, b.point, plane_of(b.test)));
}

FinishedRuns::Key FinishedRuns::key_of(const std::string& test, double pressure, std::int64_t seed) {
    return {test, std::llround(pressure), seed};
}

FinishedRuns::FinishedRuns(const Material& rock, std::vector<FinishedRun> runs, double max_strain)
    : rock_(rock), runs_(std::move(runs)), max_strain_(max_strain) {
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        places_[key_of(runs_[i].test, runs_[i].confining_pressure, runs_[i].seed)].push_back(i);
    }
}

const FinishedRun* FinishedRuns::find(const WantedRun& wanted) const {
    const auto found = places_.find(key_of(wanted.test, wanted.confining_pressure, wanted.seed));
    if (found == places_.end()) return nullptr;
    const auto values = effective_values(rock_, wanted.point, plane_of(wanted.test));
    for (const std::size_t i : found->second) {
        const FinishedRun& run = runs_[i];
        if (run.mode_i_toughness.has_value() != wanted.notched) continue;
        const bool strain_counts = wanted.test == "uniaxial" || wanted.test == "triaxial";
        if (strain_counts && !equal(run.max_strain, wanted.max_strain.value_or(max_strain_))) continue;
        if (equal(run.values, values)) return &run;
    }
    return nullptr;
}

}  // namespace graincrack::calibrate
