#include "post/cracks/fragments.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "post/run/crystals.hpp"
#include "post/table/column.hpp"
#include "share/base/union_find.hpp"
#include "share/file/specimen_measures.hpp"

namespace graincrack {

namespace {

double total_area(const Fragments& fragments) {
    return std::accumulate(fragments.all.begin(), fragments.all.end(), 0.0,
                           [](double sum, const Fragment& f) { return sum + f.area; });
}

/// True if a contact still connects its grains: a point of it is not separated.
bool holds(const std::array<std::uint8_t, 2>& points) {
    constexpr auto separated = static_cast<std::uint8_t>(PointState::separated);
    return points[0] != separated || points[1] != separated;
}

/// Each crystal and each fragment that has a grain of it, ascending. \param fragment of each grain
std::vector<std::array<std::size_t, 2>> parts_of_crystals(const Specimen& specimen, const std::vector<std::size_t>& fragment) {
    std::vector<std::array<std::size_t, 2>> parts;
    parts.reserve(specimen.n_grains());
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) parts.push_back({crystal_of(specimen, g), fragment[g]});
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return parts;
}

/// Centre of area of each grain, times its area, m³.
std::vector<std::array<double, 2>> first_moments(const Specimen& s) {
    std::vector<std::array<double, 2>> moments(s.n_grains(), {0, 0});
    for (std::size_t e = 0; e < s.n_elements(); ++e) {
        const auto place = [&](std::size_t k) { return s.node_position[static_cast<std::size_t>(s.element_nodes[e][k])]; };
        const auto [a, b, c] = std::array{place(0), place(1), place(2)};
        const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
        auto& moment = moments[static_cast<std::size_t>(s.element_grain[e])];
        for (std::size_t axis = 0; axis < 2; ++axis) moment[axis] += area * (a[axis] + b[axis] + c[axis]) / 3;
    }
    return moments;
}

}  // namespace

double Fragment::diameter() const { return 2 * std::sqrt(area / std::numbers::pi); }

std::size_t Fragments::single_grains() const {
    return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Fragment& f) { return f.grains == 1; }));
}

Fragments find_fragments(const Specimen& specimen, const std::vector<std::array<std::uint8_t, 2>>& state) {
    UnionFind sets(specimen.n_grains());
    const auto grains = grains_of_contacts(specimen);
    for (std::size_t c = 0; c < specimen.n_contacts(); ++c) {
        if (holds(state[c])) sets.join(grains[c][0], grains[c][1]);
    }
    const auto moments = first_moments(specimen);
    std::map<std::size_t, Fragment> found;  // by the first grain
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        Fragment& f = found[sets.find(g)];
        ++f.grains;
        f.area += specimen.grain_area[g];
        for (std::size_t axis = 0; axis < 2; ++axis) f.centre[axis] += moments[g][axis];
    }
    std::vector<std::pair<std::size_t, Fragment>> order(found.begin(), found.end());
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second.area > b.second.area; });
    Fragments fragments;
    std::map<std::size_t, std::size_t> index;
    for (auto& [first, f] : order) {
        for (double& x : f.centre) x /= f.area;
        index[first] = fragments.all.size();
        fragments.all.push_back(f);
    }
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) fragments.of_grain.push_back(index.at(sets.find(g)));
    for (const auto& [crystal, fragment] : parts_of_crystals(specimen, fragments.of_grain)) ++fragments.all[fragment].crystals;
    return fragments;
}

void write_fragments(std::ostream& out, const Fragments& fragments, TableFormat format) {
    using namespace unit;
    const double total = total_area(fragments);
    const Fragment* const first = fragments.all.data();
    const Columns<Fragment> columns{{"fragment", none, [first](const Fragment& f) { return &f - first; }},
                                    {"grains", none, [](const Fragment& f) { return f.grains; }},
                                    {"area", square_millimetre, [](const Fragment& f) { return f.area; }},
                                    {"diameter", millimetre, [](const Fragment& f) { return f.diameter(); }},
                                    {"share_of_area", none, [total](const Fragment& f) { return f.area / total; }},
                                    {"x", millimetre, [](const Fragment& f) { return f.centre[0]; }},
                                    {"y", millimetre, [](const Fragment& f) { return f.centre[1]; }},
                                    {"crystals", none, [](const Fragment& f) { return f.crystals; }}};
    write_table(out, columns, fragments.all, format);
}

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
    std::vector<std::size_t> counts(number_of_crystals(specimen), 0);
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        if (pieces.find(g) == g) ++counts[crystal_of(specimen, g)];
    }
    return counts;
}

}  // namespace

std::vector<Crystal> find_crystals(const Specimen& specimen, const std::vector<Crack>& cracks,
                                   const std::vector<std::array<std::uint8_t, 2>>& state, const Fragments& fragments) {
    const auto grains = grains_of_contacts(specimen);
    std::vector<Crystal> crystals(number_of_crystals(specimen));
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
