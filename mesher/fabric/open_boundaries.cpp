#include "mesher/fabric/open_boundaries.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "mesher/fabric/crystals.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

struct Boundary {
    std::uint64_t order = 0;  ///< drawn at random
    double length = 0;        ///< m
    std::vector<std::size_t> contacts;
};

/// The boundaries between two crystals, in the order in which they open.
std::vector<Boundary> drawn_boundaries(const Specimen& specimen, std::span<const int> crystal_of_grain, std::uint64_t seed) {
    const auto crystals_of = crystals_of_contacts(specimen, crystal_of_grain);
    std::map<std::pair<int, int>, Boundary> of_crystals;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const bool has_class = !specimen.contact_flaw.empty() && specimen.contact_flaw[c] > 0;
        const auto crystals = std::minmax({crystals_of[c][0], crystals_of[c][1]});
        if (has_class || specimen.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::grain_boundary)) continue;
        if (crystals.first == crystals.second) continue;
        Boundary& boundary = of_crystals[crystals];
        boundary.length += contact_length(specimen, c);
        boundary.contacts.push_back(c);
    }
    std::vector<Boundary> boundaries;
    for (auto& [crystals, boundary] : of_crystals) {
        const auto low = static_cast<std::uint64_t>(crystals.first);
        const auto high = static_cast<std::uint64_t>(crystals.second);
        boundary.order = mixed_bits(mixed_bits(mixed_bits(seed, open_stream), low), high);
        boundaries.push_back(std::move(boundary));
    }
    std::stable_sort(boundaries.begin(), boundaries.end(),
                     [](const Boundary& a, const Boundary& b) { return a.order < b.order; });
    return boundaries;
}

}  // namespace

void check(const OpenBoundaryRequest& request) {
    if (request.fraction && !(*request.fraction >= 0 && *request.fraction < 1)) {
        throw UsageError("--open-boundaries: " + format_number(*request.fraction) +
                         " is out of range; give a fraction of the length of grain boundaries from 0 to below 1");
    }
    if (request.seed && !request.fraction) throw UsageError("--open-seed: no boundaries are open; add --open-boundaries 0.2");
}

void open_boundaries(Specimen& specimen, std::span<const int> crystal_of_grain, const OpenBoundaryRequest& request) {
    if (!request.fraction) return;
    const std::vector<Boundary> boundaries = drawn_boundaries(specimen, crystal_of_grain, request.seed.value_or(specimen.seed));
    double requested = 0;  // length that is yet to be opened
    for (const Boundary& boundary : boundaries) requested += *request.fraction * boundary.length;
    for (const Boundary& boundary : boundaries) {
        if (0.5 * boundary.length > requested) break;
        for (const std::size_t c : boundary.contacts) {
            specimen.contact_kind[c] = static_cast<std::uint8_t>(ContactKind::open_boundary);
        }
        requested -= boundary.length;
    }
}

}  // namespace graincrack::mesher
