#include "solver/run/outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "share/file/peak.hpp"
#include "solver/setup/request.hpp"

namespace graincrack {

double sign_of_strength(const RunSettings& header, const History& history) {
    if (header.loading() != Loading::program) return header.loading() == Loading::tension ? 1 : -1;
    const std::vector<double>& stress = history[HistoryColumn::axial_stress];
    const auto [lowest, highest] = std::minmax_element(stress.begin(), stress.end());
    return *highest > -*lowest ? 1 : -1;
}

std::size_t peak_row(const RunSettings& header, const History& history) {
    const double sign = sign_of_strength(header, history);
    const std::vector<double>& stress = history[HistoryColumn::axial_stress];
    const auto peak = std::max_element(stress.begin(), stress.end(), [sign](double l, double r) { return sign * l < sign * r; });
    return static_cast<std::size_t>(peak - stress.begin());
}

std::size_t strength_row(const RunHeader& header, const History& history) {
    const auto strength = find_strength(header, history, sign_of_strength(header, history));
    return strength ? strength->row : peak_row(header, history);
}

double peak_time(const RunHeader& header, const History& history) {
    return history.size() == 0 ? 0 : history[HistoryColumn::time][strength_row(header, history)];
}

namespace {

/// Largest difference of the platen forces over their mean, before the row of the strength while the mean exceeds half of it.
double platen_force_difference(const RunSettings& header, const History& history, std::size_t peak, double width) {
    const double sign = sign_of_strength(header, history);
    const double peak_stress = sign * history[HistoryColumn::axial_stress][peak];
    double worst = 0;
    for (std::size_t i = 0; i < peak; ++i) {
        const double top = history[HistoryColumn::force_top][i];
        const double bottom = history[HistoryColumn::force_bottom][i];
        const double mean = 0.5 * sign * (top + bottom);
        if (mean / width > 0.5 * peak_stress) worst = std::max(worst, std::abs(top - bottom) / mean);
    }
    return worst;
}

/// Mean of the damping load over the travel of the platens from nine tenths of the strain at the peak to the peak.
double damping_load_at_peak(const History& history, std::size_t peak) {
    const std::vector<double>& strain = history[HistoryColumn::axial_strain];
    double sum = 0, travel = 0;
    for (std::size_t i = peak; i > 0 && std::abs(strain[i - 1]) >= 0.9 * std::abs(strain[peak]); --i) {
        const double increment = std::abs(strain[i] - strain[i - 1]);
        sum += increment * history[HistoryColumn::damping_load][i];
        travel += increment;
    }
    return travel > 0 ? sum / travel : 0;
}

/// Mean (Pa) and standard deviation (Pa) of the confining pressure over the rows from a time on (s).
std::pair<double, double> achieved_confinement(const History& history, double begin) {
    double sum = 0, squares = 0, n = 0;
    for (std::size_t i = 0; i < history.size(); ++i) {
        if (history[HistoryColumn::time][i] >= begin) {
            const double p = history[HistoryColumn::confining_pressure][i];
            sum += p;
            squares += p * p;
            n += 1;
        }
    }
    const double mean = sum / n;
    return {mean, std::sqrt(std::max(0.0, squares / n - mean * mean))};
}

}  // namespace

double factor_of_strength(const RunSettings& header) { return header.loading() == Loading::splitting ? 2 / std::numbers::pi : 1; }

std::string load_text(const RunSettings& header, double axial_stress, double width) {
    if (header.loading() == Loading::bending) return fmt::format("{:.4g} kN/m", axial_stress * width * 1e-3);
    return fmt::format("{:.2f} MPa", factor_of_strength(header) * axial_stress * 1e-6);
}

void complete_header(const History& history, double width, RunHeader& header) {
    header.peak_axial_stress =
        sign_of_strength(header, history) * history[HistoryColumn::axial_stress][peak_row(header, history)];
    header.peak_time = peak_time(header, history);
    const std::size_t peak = strength_row(header, history);
    header.platen_force_difference = platen_force_difference(header, history, peak, width);
    header.damping_load = damping_load_at_peak(history, peak);
    const double external = history[HistoryColumn::energy_external].back();
    header.damping_share = external > 0 ? history[HistoryColumn::energy_damping].back() / external : 0;
    std::tie(header.confinement_mean, header.confinement_deviation) = achieved_confinement(history, header.isotropic_end_time);
}

}  // namespace graincrack
