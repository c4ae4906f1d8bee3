// What the stages of a calibration share: the finished runs, the steps taken so far, and the two ways out of a stage.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "post/calibrate/decide.hpp"

namespace graincrack::calibrate {

/// Thrown where runs are missing: no later decision can be taken. Caught in `decide` only.
struct RunsMissing {
    std::vector<WantedRun> runs;
};
/// Thrown where a calibration ends. Caught in `decide` only.
struct Ended {
    Ending ending;
    std::string reason;
};

/// One calibration on its way.
class Progress {
public:
    Progress(const Material& rock, const Study& study, const std::vector<FinishedRun>& finished);

    [[nodiscard]] const Material& rock() const { return rock_; }
    [[nodiscard]] const Study& study() const { return study_; }
    [[nodiscard]] const std::vector<Target>& targets() const { return targets_; }
    [[nodiscard]] const Target& target(const std::string& name) const { return calibrate::target(targets_, name); }
    [[nodiscard]] double laboratory(const std::string& key) const { return rock_.laboratory.at(key); }

    /// The finished runs of all these. \throws RunsMissing with those that are not
    std::vector<FinishedRun> get(const std::vector<WantedRun>& wanted) const;
    /// Runs of one test at one point on specimens first, first + 1, …
    std::vector<FinishedRun> get(const WantedRun& one, std::int64_t first, std::size_t n) const;
    /// The same on as many specimens as the rule asks for.
    std::vector<FinishedRun> sampled(const WantedRun& one, std::int64_t first, const SamplingRule& rule) const;

    void note(std::string stage, std::string what, std::string result);

    Decision decision;  ///< so far

private:
    Material rock_;
    Study study_;
    std::vector<Target> targets_;
    FinishedRuns finished_;
};

std::vector<double> strengths_of(const std::vector<FinishedRun>& runs);

/// First seeds of the specimens of each purpose: none is used for two.
namespace seeds {
constexpr std::int64_t near = 1;
constexpr std::int64_t designs = 101;
constexpr std::int64_t replicates = 2001;
constexpr std::int64_t final_discs = 4001;
constexpr std::int64_t confirmation = 6001;
constexpr std::int64_t predictions = 8001;
constexpr std::int64_t per_round = 500;
}  // namespace seeds

}  // namespace graincrack::calibrate
