#include "mesher/fabric/phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "mesher/fabric/crystals.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "share/base/error.hpp"
#include "share/base/quantities.hpp"
#include "share/base/text.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

constexpr double sum_tolerance = 1e-6;
constexpr std::size_t longest_phase_name = 256;  ///< bytes, as in specimens and materials

[[noreturn]] void refuse(const std::string& option, const std::string& wrong, const std::string& right) {
    throw UsageError(option + ": " + wrong + "; give " + right);
}

/// The areas of all crystals, m².
std::vector<double> crystal_areas(const Specimen& specimen, std::span<const int> crystal_of_grain) {
    std::vector<double> area(index(std::ranges::max(crystal_of_grain)) + 1);
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) area[index(crystal_of_grain[g])] += specimen.grain_area[g];
    return area;
}

/// Pairs of crystals with a contact, in both orders.
std::set<std::pair<int, int>> neighbouring_crystals(const Specimen& specimen, std::span<const int> crystal_of_grain) {
    std::set<std::pair<int, int>> pairs;
    for (const auto& [a, b] : crystals_of_contacts(specimen, crystal_of_grain)) pairs.insert({{a, b}, {b, a}});
    return pairs;
}

std::vector<int> random_order(std::size_t n, RandomNumbers& random) {
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

/// The cluster of every crystal, grown from the first crystals in `order`.
std::vector<std::size_t> grown_clusters(const std::vector<int>& order, std::size_t n_clusters,
                                        const std::set<std::pair<int, int>>& neighbours) {
    std::vector<std::size_t> cluster(order.size(), n_clusters);  // unreached crystals have this extra cluster
    std::vector<int> reached(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(n_clusters));
    for (std::size_t i = 0; i < n_clusters; ++i) cluster[index(reached[i])] = i;
    std::sort(reached.begin(), reached.end());  // the winner at a crystal in reach of several must not depend on the order
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const int from = reached[i];
        for (auto pair = neighbours.lower_bound({from, 0}); pair != neighbours.end() && pair->first == from; ++pair) {
            std::size_t& next = cluster[index(pair->second)];
            if (next != n_clusters) continue;
            next = cluster[index(from)];
            reached.push_back(pair->second);
        }
    }
    return cluster;
}

}  // namespace

std::vector<PhaseFraction> parse_phases(std::string_view text) {
    std::vector<PhaseFraction> fractions;
    for (const std::string_view item : split(text, ',')) {
        const auto [name, value] = sides_of_equals(item);
        if (name.size() == item.size()) {
            refuse("--phases", fmt::format("\"{}\" is not a phase with its fraction", item),
                   "quartz=0.32,feldspar=0.62,mica=0.06");
        }
        fractions.push_back({name, parse_quantity(value, quantity::phase_fraction, "--phases: " + name)});
    }
    return fractions;
}

void check(const PhaseRequest& request) {
    const auto& phases = request.fractions;
    if (phases.empty() && !request.seed && request.cluster == 1) return;
    const char* const option = request.seed ? "--phase-seed" : "--phase-cluster";
    if (phases.empty()) refuse(option, "there are no phases", "--phases quartz=0.4,feldspar=0.6");
    if (phases.size() > max_phases) refuse("--phases", fmt::format("{} are too many", phases.size()), "at most 22 phases");
    double sum = 0;
    for (auto phase = phases.begin(); phase != phases.end(); ++phase) {
        const std::string& name = phase->name;
        if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
            refuse("--phases", fmt::format("\"{}\" is not a valid name of a phase", name), "a name of a-z, 0-9 and _");
        }
        if (name.size() > longest_phase_name) {
            refuse("--phases", fmt::format("a name has {} bytes", name.size()), fmt::format("at most {}", longest_phase_name));
        }
        if (std::any_of(phases.begin(), phase, [&](const PhaseFraction& other) { return other.name == name; })) {
            refuse("--phases", name + " is given twice", "each phase once");
        }
        sum += phase->fraction;
    }
    if (!(std::abs(sum - 1) <= sum_tolerance)) {
        refuse("--phases", "the fractions add up to " + format_number(sum, 7), "fractions of the area with the sum 1");
    }
}

void assign_phases(Specimen& specimen, std::span<const int> crystal_of_grain, const PhaseRequest& request) {
    if (request.fractions.empty()) return;
    RandomNumbers random(request.seed.value_or(specimen.seed), phase_stream);
    const std::vector<double> area = crystal_areas(specimen, crystal_of_grain);
    const std::size_t n = area.size();
    std::vector<int> order = random_order(n, random);
    const double n_clusters = std::clamp(std::round(static_cast<double>(n) / request.cluster), 1.0, static_cast<double>(n));
    const std::vector<std::size_t> cluster =
        grown_clusters(order, static_cast<std::size_t>(n_clusters), neighbouring_crystals(specimen, crystal_of_grain));
    std::stable_sort(order.begin(), order.end(),
                     [&](int i, int j) { return cluster[index(i)] < cluster[static_cast<std::size_t>(j)]; });

    const double whole = std::accumulate(area.begin(), area.end(), 0.0);
    std::vector<std::uint8_t> phase_of_crystal(n);
    std::uint8_t phase = 0;
    double before = 0;                                   // area of the crystals before this one
    double end = whole * request.fractions[0].fraction;  // end of the current phase on the line, m²
    for (const int crystal : order) {
        const double own = area[index(crystal)];
        while (before + 0.5 * own > end && phase + 1U < request.fractions.size()) {
            end += whole * request.fractions[++phase].fraction;
        }
        phase_of_crystal[index(crystal)] = phase;
        before += own;
    }
    specimen.phase_names.clear();
    for (const PhaseFraction& each : request.fractions) specimen.phase_names.push_back(each.name);
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) specimen.grain_phase[g] = phase_of_crystal[index(crystal_of_grain[g])];
}

}  // namespace graincrack::mesher
