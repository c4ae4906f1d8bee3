#include "post/measure/brazilian.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "post/cracks/crack_network.hpp"
#include "post/run/crack_label.hpp"
#include "share/base/error.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {

namespace {

/// Radii. Cracks that scatter evenly over a disc are at 2/3, those of crystals of several strengths at 0.5 to 0.75.
constexpr double nearest_to_platens = 0.8;

/// Value of a column at a time, linear between rows.
double at_time(const std::vector<double>& times, const std::vector<double>& column, double time) {
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return column.front();
    if (after == times.end()) return column.back();
    const auto row = static_cast<std::size_t>(after - times.begin()) - 1;
    return CurvePoint{row, (time - times[row]) / (times[row + 1] - times[row])}.of(column);
}

std::optional<double> time_of_span(const Specimen& specimen, const std::vector<Crack>& cracks) {
    CrackNetwork network(specimen);
    for (const Crack& crack : cracks) {
        if (network.add(crack) >= spanning_share * specimen.height) return crack.time;
    }
    return std::nullopt;
}

std::optional<double> radius_of_first(const Specimen& specimen, const std::vector<Crack>& open, double peak_time) {
    const auto late = std::ranges::find_if(open, [&](const Crack& c) { return c.time > peak_time; });
    const auto by_peak = static_cast<std::size_t>(late - open.begin());
    if (by_peak == 0) return std::nullopt;
    const std::size_t n = std::clamp<std::size_t>(by_peak / 20, std::min<std::size_t>(2, by_peak), by_peak);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += std::hypot(open[i].position[0], open[i].position[1]);
    return sum / static_cast<double>(n) / (specimen.width / 2);
}

/// \param splits_early whether open cracks span the disc before its largest load
std::vector<Caveat> find_caveats(const BrazilianSplit& split, bool splits_early, double peak, const Specimen& specimen) {
    std::vector<Caveat> found;
    if (specimen.shape == "disc" && width_of_part(specimen, BoundaryPart::top) > 0) {
        const double angle = 2 * std::acos(std::min(1.0, specimen.height / specimen.width));
        const double degrees = 180 / std::numbers::pi;
        found.push_back({"flat_poles", "flat poles",
                         fmt::format("with flat poles of {:.3g} degrees the tensile strength is {:.2f} times 2F/(πtD) (Wang "
                                     "et al. 2004)",
                                     angle * degrees, strength_share_of_arcs(angle))});
    }
    if (!split.spanning_stress) {
        found.push_back(
            {"no_split", fmt::format("open cracks never span {:.2g} D", spanning_share),
             fmt::format("the disc did not split: its open cracks never span {:.2g} of the diameter", spanning_share)});
    } else if (const double off = 1 - *split.spanning_stress / peak; splits_early && off > 0.05) {
        found.push_back({"split_before_peak", "the largest load is not the load at splitting",
                         fmt::format("when open cracks spanned the disc, the load was {:.0f} % below the largest load, which may "
                                     "be the load of the halves",
                                     100 * off)});
    }
    if (split.first_crack_radius && *split.first_crack_radius > nearest_to_platens) {
        found.push_back(
            {"crushed_at_platens", fmt::format("first cracks outside {} R", nearest_to_platens),
             fmt::format(
                 "the first cracks are on average {:.2f} radii from the centre, near the platens: the disc was crushed there "
                 "before it split",
                 *split.first_crack_radius)});
    }
    return found;
}

}  // namespace

bool splits(const RunData& run) { return run.header.loading() == Loading::splitting && run.specimen.shape != "ring"; }

double strength_share_of_arcs(double angle) { return angle > 0 ? std::pow(std::sin(angle) / angle, 2) : 1; }

std::string BrazilianSplit::warning() const {
    std::string label;
    for (const Caveat& caveat : caveats) label += (label.empty() ? "" : "; ") + caveat.text;
    return label;
}

BrazilianSplit measure_split(const RunData& run, const LoadCurve& curve, const Specimen& specimen,
                             const std::vector<Crack>& log) {
    const auto& times = run.history[HistoryColumn::time];
    std::vector<Crack> cracks = labelled(log, {CrackEvent::failed, CrackModeRule::sign});
    std::ranges::stable_sort(cracks, [](const Crack& a, const Crack& b) { return a.time < b.time; });
    BrazilianSplit split;
    const auto time = time_of_span(specimen, cracks);
    if (time) split.spanning_stress = at_time(times, curve.stress, *time);
    std::erase_if(cracks, [](const Crack& c) { return c.mode != CrackMode::tensile; });
    split.first_crack_radius = radius_of_first(specimen, cracks, times[curve.peak]);
    split.caveats = find_caveats(split, time && *time < times[curve.peak], curve.peak_stress(), specimen);
    return split;
}

}  // namespace graincrack
