#include "share/file/equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "share/file/peak.hpp"

namespace graincrack {
namespace {

/// Relative rise of the load at the peak, while a wave crosses the specimen, beyond which a run warns. Measured against strengths
/// at the automatic rate: UCS of 1,122 grains 1 % too high at 0.0067, 2 % at 0.013, 4 % at 0.026; ten
/// tests at 4 MPa 0.3 % at 0.002 to 0.004 (share/doc/loading.md); a rectangle of 300 grains 3.5 % at 0.004, a disc of as many
/// 18 % at 0.015. It is the rate tolerance that examples and studies recommend, which costs a UCS 1.4 ± 1.1 % against 0.0015
/// (share/studies/minerals) and a confined strength 0.4 ± 1.6 % against half of it (share/studies/equilibrium).
constexpr double trusted_load_rise = 6e-3;
/// Difference of the platen forces before the peak, over their mean, the strength, beyond which a run warns; chosen, not fitted.
constexpr double trusted_force_difference = 0.05;
/// Mean unbalanced ratio before the peak beyond which a run warns. Measured on 300 grains: damped tests at the automatic rate,
/// which holds it below 0.002 while there is damage, have 3e-5 to 3e-4 and the strengths of slower ones; without damping it is
/// 0.007 in a rectangle and 0.008 in a disc, with 0.37 and 0.47 times these strengths, and 0.0008 in a tension test with the same
/// strength.
constexpr double trusted_unbalanced_ratio = 3e-3;

/// Row of the strength of a history or, if the test did not fail, of its largest axial stress. \pre it has rows
std::size_t row_of_peak(const RunHeader& header, const History& history) {
    const auto strength = find_strength(header, history, header.loading() == Loading::tension ? 1 : -1);
    if (strength) return strength->row;
    const std::vector<double>& stress = history[HistoryColumn::axial_stress];
    return static_cast<std::size_t>(
        std::max_element(stress.begin(), stress.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
        stress.begin());
}

/// Returns 2 v/(c ε) with the speed v of each platen and the strain ε at the peak, c = √(E/ρ): the relative rise of the load
/// while a wave crosses the specimen. It is 0 without strain.
double load_rise_at_peak(const RunHeader& header, const History& history, std::size_t peak) {
    const double strain = std::abs(history[HistoryColumn::axial_strain][peak]);
    const double wave_speed = std::sqrt(header.rock.young_modulus / header.rock.density);
    const double speed = std::abs(history[HistoryColumn::platen_speed][peak]);
    return strain > 0 && wave_speed > 0 ? 2 * speed / (wave_speed * strain) : 0;
}

/// Mean unbalanced ratio over the last tenth of the strain at the peak.
double unbalanced_before_peak(const History& history, std::size_t peak) {
    const std::vector<double>& strain = history[HistoryColumn::axial_strain];
    double sum = 0, rows = 0;
    for (std::size_t i = peak; i > 0 && std::abs(strain[i]) >= 0.9 * std::abs(strain[peak]); --i) {
        sum += history[HistoryColumn::unbalanced_ratio][i];
        ++rows;
    }
    return rows > 0 ? sum / rows : 0;
}

}  // namespace

std::string equilibrium_warning(const RunHeader& header, const History& history) {
    if (header.test == "program" || history.size() == 0) return "";  // programs may load in other ways
    const std::size_t peak = row_of_peak(header, history);
    const double rise = load_rise_at_peak(header, history, peak);
    if (rise > trusted_load_rise) {
        return fmt::format(
            "the test is far from equilibrium: at the peak the load rises by {:.2g} % of itself while a wave crosses the "
            "specimen, more than {:.2g} %, and the strength is too high: use a slower --rate or a smaller --rate-tolerance",
            100 * rise, 100 * trusted_load_rise);
    }
    if (header.platen_force_difference > trusted_force_difference) {
        return fmt::format(
            "the test is far from equilibrium: the platen forces differ by {:.1f} % of their mean before the peak, more than "
            "{:.0f} %, and the strength is uncertain by as much: use a slower --rate or more --damping",
            100 * header.platen_force_difference, 100 * trusted_force_difference);
    }
    const double unbalanced = unbalanced_before_peak(history, peak);
    if (unbalanced > trusted_unbalanced_ratio) {
        return fmt::format(
            "the test is far from equilibrium: the unbalanced ratio is {:.2g} before the peak, more than {:.2g}: waves run "
            "through the specimen, and what they break makes the strength too low: {}",
            unbalanced, trusted_unbalanced_ratio,
            header.damping == 0 ? "use --damping" : "use a slower --rate or more --damping");
    }
    return "";
}

}  // namespace graincrack
