// Caveats of a measured strength, printed wherever it is shown.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "post/measure/brazilian.hpp"
#include "post/run/comparability.hpp"

namespace graincrack {

/// Reasons to doubt the strength of a run: it reached no peak; it was far from equilibrium; damping carried part of the load; a
/// disc did not split from its middle. \param split of a Brazilian test, empty for others
std::vector<Caveat> caveats_of(const RunData& run, const std::optional<BrazilianSplit>& split);
/// The same, read from the run. \param run the data of `reader`
std::vector<Caveat> caveats_of(const RunReader& reader, const RunData& run);

/// As a line below a picture: "caveat: first cracks at 0.81 R, not inside 0.5 R".
std::string note_line(const Caveat& caveat);

/// The runs of a set with the caveats of their strengths.
class CaveatCount {
public:
    void add(const RunData& run, const std::vector<Caveat>& caveats);
    /// "Brazilian: first cracks outside 0.5 R (9 of 9 runs)", a line for each test, pressure and kind; last the `tension_line`.
    [[nodiscard]] std::vector<std::string> lines() const;
    /// That direct tension is stronger than the Brazilian test, with what rock does; empty where it is not, without both tests,
    /// and for runs of several materials or fabrics.
    [[nodiscard]] std::string tension_line() const;

private:
    struct Group {
        std::string label;  ///< of the test
        std::size_t runs = 0;
        std::vector<std::pair<std::string, std::size_t>> kinds;  ///< with the number of runs, in their order
        std::vector<double> strengths;                           ///< of the runs that have one, Pa
    };
    Group& group(const RunData& run);
    [[nodiscard]] double mean_of(const std::string& test) const;  ///< strength, Pa; NaN without one
    std::vector<Group> groups_;
    std::vector<ComparedSettings> rocks_;  ///< the first of each material and fabric
};

/// Reads runs, each test of a specimen once, and counts the caveats of their strengths. \param command as of `once_each`
/// \throws InputError
std::vector<RunData> read_doubted_runs(const std::vector<std::string>& paths, CaveatCount& count, const std::string& command,
                                       std::ostream& diagnostics);

}  // namespace graincrack
