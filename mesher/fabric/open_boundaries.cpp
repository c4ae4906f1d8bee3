#include "mesher/fabric/open_boundaries.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesher/fabric/crystals.hpp"
#include "mesher/plane/geometry.hpp"
#include "mesher/plane/random_numbers.hpp"
#include "share/base/error.hpp"
#include "share/base/units.hpp"

namespace graincrack::mesher {

namespace {

using Position = std::array<double, 2>;

struct Boundary {
    std::uint64_t order = 0;  ///< random order
    double length = 0;        ///< m
    std::vector<std::size_t> contacts;
    std::set<Position> ends;       ///< m
    std::size_t place = SIZE_MAX;  ///< place among the boundaries in rows
};

/// The boundaries between two crystals, in the order of opening.
std::vector<Boundary> drawn_boundaries(const Specimen& specimen, std::span<const int> crystal_of_grain, std::uint64_t seed) {
    const auto crystals = crystals_of_contacts(specimen, crystal_of_grain);
    std::map<std::uint64_t, Boundary> in_order;
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const bool has_class = !specimen.contact_flaw.empty() && specimen.contact_flaw[c] > 0;
        if (has_class || specimen.contact_kind[c] != static_cast<std::uint8_t>(ContactKind::grain_boundary)) continue;
        const auto& [low, high] = crystals[c];
        if (low == high) continue;
        const std::uint64_t bits = mixed_bits(mixed_bits(seed, open_stream), static_cast<std::uint64_t>(low));
        const std::uint64_t order = mixed_bits(bits, static_cast<std::uint64_t>(high));
        Boundary& boundary = in_order[order];
        boundary.order = order;
        boundary.length += contact_length(specimen, c);
        boundary.contacts.push_back(c);
        for (const std::size_t end : {0U, 1U}) {
            const Position& place = specimen.node_position[index(specimen.contact_nodes[c][end])];
            if (!boundary.ends.insert(place).second) boundary.ends.erase(place);  // another contact of it continues there
        }
    }
    std::vector<Boundary> boundaries;
    for (auto& [order, boundary] : in_order) boundaries.push_back(std::move(boundary));
    return boundaries;
}

using Meeting = std::map<Position, std::vector<Boundary*>>;  ///< boundaries ending at each place

/// The boundary at a tip of a row that deviates least from the line between its tips, and moves that tip; null for none.
Boundary* straightest(const Meeting& meeting, const std::set<Position>& places_of_rows, std::array<Position, 2>& tips) {
    const auto direction = [](const Position& p, const Position& q) { return unit({q[0] - p[0], q[1] - p[1]}); };
    Boundary* best = nullptr;
    double largest_cosine = -2;
    for (const auto& [from, tip] : {std::pair{tips[0], tips[1]}, std::pair{tips[1], tips[0]}}) {
        for (Boundary* const boundary : meeting.at(tip)) {
            const auto& ends = boundary->ends;
            const Position& end = *ends.begin() == tip ? *ends.rbegin() : *ends.begin();
            if (ends.size() != 2 || places_of_rows.contains(end)) continue;
            const double cosine = dot(direction(from, tip), direction(tip, end));
            if (cosine <= largest_cosine) continue;
            largest_cosine = cosine;
            best = boundary;
            tips = {from, end};
        }
    }
    return best;
}

/// Orders boundaries by rows, which continue with the probability q; the others follow. A boundary of several pieces, or all
/// around a crystal, is a row by itself.
void put_in_rows(std::vector<Boundary>& boundaries, double q) {
    Meeting meeting;
    for (Boundary& boundary : boundaries) {
        for (const Position& end : boundary.ends) meeting[end].push_back(&boundary);
    }
    std::set<Position> places;
    std::size_t n_in_rows = 0;
    const auto add = [&](Boundary& boundary) {
        boundary.place = n_in_rows++;
        places.insert(boundary.ends.begin(), boundary.ends.end());
    };
    for (Boundary& first : boundaries) {
        if (std::ranges::any_of(first.ends, [&](const Position& end) { return places.contains(end); })) continue;
        add(first);
        if (first.ends.size() != 2) continue;
        std::array tips{*first.ends.begin(), *first.ends.rbegin()};
        for (std::uint64_t n = 1; uniform_of(mixed_bits(first.order, n)) < q; ++n) {
            Boundary* const next = straightest(meeting, places, tips);
            if (next == nullptr) break;
            add(*next);
        }
    }
    std::ranges::stable_sort(boundaries, {}, &Boundary::place);
}

}  // namespace

void check(const OpenBoundaryRequest& request) {
    if (request.fraction && !(*request.fraction >= 0 && *request.fraction < 1)) {
        throw UsageError("--open-boundaries: " + format_number(*request.fraction) +
                         " is out of range; give a fraction of the length of grain boundaries from 0 to below 1");
    }
    if (!request.fraction && (request.seed || request.row != 1)) {
        throw UsageError(std::string(request.seed ? "--open-seed" : "--open-length") +
                         ": no boundaries are open; add --open-boundaries 0.2");
    }
}

void open_boundaries(Specimen& specimen, std::span<const int> crystal_of_grain, const OpenBoundaryRequest& request) {
    if (!request.fraction) return;
    std::vector<Boundary> boundaries = drawn_boundaries(specimen, crystal_of_grain, request.seed.value_or(specimen.seed));
    if (request.row > 1) put_in_rows(boundaries, 1 - 1 / request.row);
    double requested = 0;  // remaining length to open, m
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
