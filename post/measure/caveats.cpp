#include "post/measure/caveats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "post/measure/strength.hpp"
#include "post/run/run_state.hpp"
#include "post/run/test_label.hpp"
#include "post/statistics/statistics.hpp"
#include "share/file/equilibrium.hpp"

namespace graincrack {

std::vector<Caveat> caveats_of(const RunData& run, const std::optional<BrazilianSplit>& split) {
    const RunHeader& header = run.header;
    std::vector<Caveat> found;
    if (split) found = split->caveats;
    if (header.loading() != Loading::program) {  // whose stages need no peak
        const Strength strength = measure_strength(run);
        const std::string when =
            strength.peak_kind == "cap" ? "by the strain limit" : "before it was stopped (" + header.stop_reason + ")";
        if (!strength.strength) {
            found.push_back({"did_not_fail", did_not_fail,
                             fmt::format("{} {}: its largest stress, {:.4g} MPa, is no strength", did_not_fail, when,
                                         strength.largest.stress * 1e-6)});
        }
    }
    const std::string equilibrium = equilibrium_warning(header, run.history);
    if (!equilibrium.empty()) found.push_back({"equilibrium", "far from equilibrium", equilibrium});
    if (header.damping_load > trusted_damping_load) {
        found.push_back({"damping_load", "damping carries load",
                         fmt::format("damping carries {:.2g} % of the load; where grains slide, the strength is too high by "
                                     "several times this share",
                                     100 * header.damping_load)});
    }
    return found;
}

std::vector<Caveat> caveats_of(const RunReader& reader, const RunData& run) {
    if (!splits(run)) return caveats_of(run, std::nullopt);
    const Specimen specimen = reader.specimen();
    return caveats_of(run, measure_split(run, load_curve(run), specimen, read_cracks(reader, specimen)));
}

std::string note_line(const Caveat& caveat) {
    constexpr std::size_t room = 43;  // characters that fit beside the words before, at the size of notes
    return "caveat: " + (caveat.text.size() <= room ? caveat.text : caveat.kind);
}

CaveatCount::Group& CaveatCount::group(const RunData& run) {
    const std::string label = series_label(run);
    const auto found = std::ranges::find(groups_, label, &Group::label);
    return found != groups_.end() ? *found : groups_.emplace_back(Group{label, 0, {}, {}});
}

void CaveatCount::add(const RunData& run, const std::vector<Caveat>& caveats) {
    Group& own = group(run);
    ++own.runs;
    if (const auto strength = measure_strength(run).reported()) own.strengths.push_back(*strength);
    for (const Caveat& caveat : caveats) {
        const auto known = std::ranges::find_if(own.kinds, [&](const auto& kind) { return kind.first == caveat.kind; });
        ++(known != own.kinds.end() ? *known : own.kinds.emplace_back(caveat.kind, 0)).second;
    }
    const ComparedSettings traits = compared_settings(run);
    const bool known =
        std::ranges::any_of(rocks_, [&](const auto& each) { return differences(each, traits, of_the_test).empty(); });
    if (!known) rocks_.push_back(traits);
}

std::vector<std::string> CaveatCount::lines() const {
    std::vector<std::string> lines;
    for (const Group& g : groups_) {
        for (const auto& [kind, runs] : g.kinds) {
            lines.push_back(fmt::format("{}: {} ({} of {} run{})", g.label, kind, runs, g.runs, g.runs == 1 ? "" : "s"));
        }
    }
    const std::string tension = tension_line();
    if (!tension.empty()) lines.push_back(tension);
    return lines;
}

double CaveatCount::mean_of(const std::string& test) const {
    const auto found = std::ranges::find(groups_, series_label(test, 0), &Group::label);
    return found != groups_.end() ? sample(found->strengths).mean.value : NAN;
}

std::string CaveatCount::tension_line() const {
    const double brazilian = mean_of("brazilian");
    const double direct = mean_of("tension");
    if (!(direct > brazilian) || rocks_.size() > 1) return "";
    return fmt::format(
        "direct tension is {:.2f} times the Brazilian strength; in rock it is 0.7 to 0.9 times (Perras & Diederichs 2014)",
        direct / brazilian);
}

std::vector<RunData> read_doubted_runs(const std::vector<std::string>& paths, CaveatCount& count, const std::string& command,
                                       std::ostream& diagnostics) {
    std::vector<RunData> runs = read_runs(paths);
    std::vector<RunData> kept;
    for (const std::size_t i : once_each(list_of(runs), command, diagnostics)) {
        count.add(runs[i], caveats_of(RunReader(paths[i]), runs[i]));
        kept.push_back(std::move(runs[i]));
    }
    return kept;
}

}  // namespace graincrack
