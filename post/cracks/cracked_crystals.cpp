#include "post/cracks/cracked_crystals.hpp"

#include <algorithm>
#include <set>

#include "post/run/crystals.hpp"
#include "post/table/column.hpp"
#include "share/base/union_find.hpp"

namespace graincrack {

namespace {

/// Crystals and the grains on both sides of contacts.
class ContactSides {
public:
    explicit ContactSides(const Specimen& specimen) : specimen_(specimen), grain_of_node_(grain_of_nodes(specimen)) {}

    [[nodiscard]] std::array<std::size_t, 2> grains(std::size_t contact) const {
        const auto grain_at = [&](std::size_t k) {
            const auto node = static_cast<std::size_t>(specimen_.contact_nodes[contact][k]);
            return static_cast<std::size_t>(grain_of_node_[node]);
        };
        return {grain_at(0), grain_at(2)};
    }
    [[nodiscard]] std::array<std::size_t, 2> crystals(std::size_t contact) const {
        const auto [a, b] = grains(contact);
        return {crystal_of(specimen_, a), crystal_of(specimen_, b)};
    }

private:
    const Specimen& specimen_;
    std::vector<std::int32_t> grain_of_node_;
};

/// Of each crystal the pieces that contacts within it hold together.
std::vector<std::size_t> count_pieces(const Specimen& specimen, const ContactSides& sides,
                                      const std::vector<std::array<std::uint8_t, 2>>& state) {
    UnionFind pieces(specimen.n_grains());
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        const auto [a, b] = sides.grains(c);
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
    const ContactSides sides(specimen);
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
        const auto [a, b] = sides.crystals(static_cast<std::size_t>(crack.contact));
        if (a == b) {
            crystals[a].within.add(crack);
        } else {
            crystals[a].around.add(crack);
            crystals[b].around.add(crack);
        }
    }
    const std::vector<std::size_t> pieces = count_pieces(specimen, sides, state);
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
    const std::vector<std::size_t> pieces = count_pieces(specimen, ContactSides(specimen), state);
    return static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), [](std::size_t n) { return n > 1; }));
}

ModeCounts count_cracked_crystals(const Specimen& specimen, const std::vector<Crack>& cracks, std::optional<double> until) {
    if (specimen.grain_crystal.empty()) return {};
    const ContactSides sides(specimen);
    std::set<std::size_t> tensile;
    std::set<std::size_t> shear;
    for (const Crack& crack : cracks) {
        const auto [a, b] = sides.crystals(static_cast<std::size_t>(crack.contact));
        if (a != b || (until && crack.time > *until)) continue;
        (crack.mode == CrackMode::tensile ? tensile : shear).insert(a);
    }
    return {static_cast<double>(tensile.size()), static_cast<double>(shear.size())};
}

}  // namespace graincrack
