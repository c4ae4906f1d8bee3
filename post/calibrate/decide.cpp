#include "post/calibrate/decide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "post/calibrate/compression_stage.hpp"
#include "post/calibrate/confirmation.hpp"
#include "post/calibrate/elastic_stage.hpp"
#include "post/calibrate/tensile_stage.hpp"

namespace graincrack::calibrate {

namespace {

/// A disagreement of the laboratory's own values above which a report says so.
constexpr double remarkable = 0.03;

void note_targets(Progress& progress) {
    std::string text;
    for (const Target& t : progress.targets()) {
        if (t.role == Role::predicted) continue;
        text += fmt::format("{}{} {:.5g}{}{} within {}", text.empty() ? "" : "; ", t.symbol, t.value / t.si,
                            t.unit.empty() ? "" : " ", t.unit,
                            t.absolute ? fmt::format("{:g}", t.bound) : fmt::format("{:g} %", 100 * t.bound));
    }
    progress.note(
        "targets", text,
        fmt::format("discs: {}; rectangles: {}", label_of(progress.study().discs), label_of(progress.study().rectangles)));
    const double off = disagreement(progress.rock());
    if (std::abs(off) > remarkable) {
        progress.note("targets", fmt::format("C and φ of the laboratory imply a UCS {:+.1f} % off the measured one", 100 * off),
                      "UCS and φ are fitted, C follows from them");
    }
}

/// Whether a change of the parameters of σt leaves UCS as it was: UCS changes by 0.3 % where Gf is five times as large, by 0.9 %
/// where the open shear strength is three times as large (share/doc/readings.md).
bool leaves_compression(const Point& before, const Point& after) {
    for (const Parameter p : {Parameter::tensile_strength, Parameter::fracture_energy, Parameter::open_shear_strength}) {
        if (!before[p] || !after[p]) continue;
        const double most = p == Parameter::tensile_strength ? 1.1 : 2;
        const double ratio = *after[p] / *before[p];
        if (ratio > most || ratio < 1 / most) return false;
    }
    return true;
}

/// Whether every mean is within its bound, though not every interval: another fit would not move a mean closer.
bool lacks_specimens_only(const Decision& decision) {
    return std::none_of(decision.outcomes.begin(), decision.outcomes.end(), [](const Outcome& o) {
        return !o.ours || std::abs(o.ours->value - o.target.value) > o.target.tolerance();
    });
}

/// "σt is outside, +12 % ± 3 % off with 80 specimens, for a bound of 5 %; …", of the targets that were missed
std::string label_of_missed(const std::vector<Outcome>& outcomes) {
    std::string missed;
    for (const Outcome& o : outcomes) {
        if (o.target.role == Role::predicted || o.verdict == "within" || !o.ours) continue;
        const double unit = o.target.absolute ? 1 : o.target.value / 100;
        const char* symbol = o.target.absolute ? "" : " %";
        const double half = o.ours->high ? *o.ours->high - o.ours->value : 0;
        missed += fmt::format("{}{} is {}, {:+.3g}{} ± {:.2g}{} off with {} specimens, for a bound of {:.2g}{}",
                              missed.empty() ? "" : "; ", o.target.symbol, o.verdict, (o.ours->value - o.target.value) / unit,
                              symbol, half / unit, symbol, o.specimens, o.target.tolerance() / unit, symbol);
    }
    return missed;
}

/// Time of runs, by the mean of finished ones of the same test; of a test without any, none is counted.
double time_of(const std::vector<WantedRun>& wanted, const std::vector<FinishedRun>& finished) {
    std::map<std::string, std::pair<double, double>> times;  // sum and number
    for (const FinishedRun& run : finished) {
        times[run.test].first += run.wall_time;
        times[run.test].second += 1;
    }
    double sum = 0;
    for (const WantedRun& run : wanted) {
        const auto time = times.find(run.test);
        if (time != times.end()) sum += time->second.first / time->second.second;
    }
    return sum;
}

void calibrate_rock(Progress& progress) {
    note_targets(progress);
    Point& point = progress.decision.point;
    find_elasticity(progress);
    double way = 0;
    TensilePath path = find_tensile_path(progress, way);
    find_start(progress);
    Ending ending = Ending::undecided;
    for (std::size_t round = 0; round < progress.study().rounds && ending != Ending::calibrated; ++round) {
        fit_compression(progress, round);
        const Point before = point;
        adjust_tensile(progress, path, way, seeds::final_discs + static_cast<std::int64_t>(round) * seeds::per_round);
        const bool last = round + 1 == progress.study().rounds;
        if (!last && !leaves_compression(before, point)) {
            progress.note("σt", "its parameters changed enough to change UCS", "cc and φc are fitted again");
            continue;
        }
        ending = confirm(progress, round);
        if (ending == Ending::calibrated) predict(progress, round);
        if (ending == Ending::undecided && lacks_specimens_only(progress.decision)) break;
    }
    throw Ended{ending, ending == Ending::calibrated ? "new specimens are within the bounds of every target"
                                                     : label_of_missed(progress.decision.outcomes)};
}

}  // namespace

std::string label_of(Ending ending) {
    switch (ending) {
        case Ending::calibrated: return "calibrated";
        case Ending::not_reached: return "not reached";
        case Ending::contradictory: return "contradictory";
        case Ending::undecided: return "undecided";
        default: return "runs are wanted";
    }
}

Decision decide(const Material& rock, const Study& study, const std::vector<FinishedRun>& finished) {
    Progress progress(rock, study, finished);
    try {
        calibrate_rock(progress);
    } catch (RunsMissing& missing) {
        progress.decision.ending = Ending::wanted;
        progress.decision.reason = missing.runs.front().reason;
        progress.decision.wanted_time = time_of(missing.runs, finished);
        progress.decision.wanted = std::move(missing.runs);
    } catch (const Ended& end) {
        progress.decision.ending = end.ending;
        progress.decision.reason = end.reason;
    }
    return std::move(progress.decision);
}

}  // namespace graincrack::calibrate
