#include "post/cracks/cracked_crystals.hpp"

#include <algorithm>
#include <set>

#include "post/run/crystals.hpp"
#include "post/table/column.hpp"
#include "share/base/union_find.hpp"

namespace graincrack {

namespace {

/// The crystals of the two grains of a contact.
std::array<std::size_t, 2> crystals_of(const Specimen& specimen, const std::array<std::size_t, 2>& grains) {
    return {crystal_of(specimen, grains[0]), crystal_of(specimen, grains[1])};
}

/// The number of pieces of each crystal that contacts within it hold together.
std::vector<std::size_t> count_pieces(const Specimen& specimen, const std::vector<std::array<std::uint8_t, 2>>& state) {
    UnionFind pieces(specimen.n_grains());
    const auto grains = grains_of_contacts(specimen);
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const auto [a, b] = grains[c];
        if (crystal_of(specimen, a) == crystal_of(specimen, b) && holds(state[c])) pieces.join(a, b);
    }
    std::vector<std::size_t> counts(n_crystals(specimen), 0);
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        if (pieces.find(g) == g) ++counts[crystal_of(specimen, g)];
    }
    return counts;
}

}  // namespace

std::vector<Crystal> find_crystals(const Specimen& specimen, const std::vector<Crack>& cracks,
                                   const std::vector<std::array<std::uint8_t, 2>>& state, const Fragments& fragments) {
    const auto grains = grains_of_contacts(specimen);
    std::vector<Crystal> crystals(n_crystals(specimen));
    const auto moments = first_moments(specimen);
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        Crystal& crystal = crystals[crystal_of(specimen, g)];
        crystal.phase = specimen.phase_names[specimen.grain_phase[g]];
        ++crystal.grains;
        crystal.area += specimen.grain_area[g];
        for (std::size_t axis = 0; axis < 2; ++axis) crystal.centre[axis] += moments[g][axis];
    }
    for (const auto& [crystal, fragment] : parts_of_crystals(specimen, fragments.of_grain)) ++crystals[crystal].fragments;
    for (const Crack& crack : cracks) {
        const auto [a, b] = crystals_of(specimen, grains[static_cast<std::size_t>(crack.contact)]);
        if (a == b) {
            crystals[a].within.add(crack);
        } else {
            crystals[a].around.add(crack);
            crystals[b].around.add(crack);
        }
    }
    const std::vector<std::size_t> pieces = count_pieces(specimen, state);
    for (std::size_t i = 0; i < crystals.size(); ++i) {
        crystals[i].pieces = pieces[i];
        for (double& x : crystals[i].centre) x /= crystals[i].area;
    }
    return crystals;
}

void write_crystals(std::ostream& out, const std::vector<Crystal>& crystals, TableFormat format) {
    using namespace unit;
    using C = Crystal;
    const C* const first = crystals.data();
    const Columns<C> columns{{"crystal", none, [first](const C& c) { return &c - first; }},
                             {"phase", none, [](const C& c) { return c.phase; }},
                             {"grains", none, [](const C& c) { return c.grains; }},
                             {"area", square_millimetre, [](const C& c) { return c.area; }},
                             {"x", millimetre, [](const C& c) { return c.centre[0]; }},
                             {"y", millimetre, [](const C& c) { return c.centre[1]; }},
                             {"tensile_cracks_within", none, [](const C& c) { return count_cell(c.within.tensile); }},
                             {"shear_cracks_within", none, [](const C& c) { return count_cell(c.within.shear); }},
                             {"tensile_cracks_around", none, [](const C& c) { return count_cell(c.around.tensile); }},
                             {"shear_cracks_around", none, [](const C& c) { return count_cell(c.around.shear); }},
                             {"pieces", none, [](const C& c) { return c.pieces; }},
                             {"fragments", none, [](const C& c) { return c.fragments; }}};
    write_table(out, columns, crystals, format);
}

std::size_t count_split_crystals(const Specimen& specimen, const std::vector<std::array<std::uint8_t, 2>>& state) {
    if (specimen.grain_crystal.empty()) return 0;
    const std::vector<std::size_t> pieces = count_pieces(specimen, state);
    return static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), [](std::size_t n) { return n > 1; }));
}

ModeCounts count_cracked_crystals(const Specimen& specimen, const std::vector<Crack>& cracks, std::optional<double> until) {
    if (specimen.grain_crystal.empty()) return {};
    const auto grains = grains_of_contacts(specimen);
    std::set<std::size_t> tensile;
    std::set<std::size_t> shear;
    for (const Crack& crack : cracks) {
        const auto [a, b] = crystals_of(specimen, grains[static_cast<std::size_t>(crack.contact)]);
        if (a != b || (until && crack.time > *until)) continue;
        (crack.mode == CrackMode::tensile ? tensile : shear).insert(a);
    }
    return {static_cast<double>(tensile.size()), static_cast<double>(shear.size())};
}

}  // namespace graincrack
