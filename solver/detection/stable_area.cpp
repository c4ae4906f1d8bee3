#include "solver/detection/stable_area.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "solver/detection/pair_geometry.hpp"

namespace graincrack {
namespace {

/// η: what node–edge contacts may add to ω² Δt².
constexpr double stiffness_fraction = 0.5;
/// A new contact may have this fraction of the load of a cluster even where others have taken all of it: the next update reduces
/// their areas.
constexpr double fraction_of_new_contact = 0.125;

/// The part of a contact of unit area in the loads of the clusters of its nodes.
struct UnitLoads {
    std::array<std::int32_t, 3> cluster;
    std::array<double, 3> load{};  ///< kt |a_C| Σ_D |a_D|, Pa/m; 0 where the cluster is that of a node before
};
UnitLoads unit_loads(const Assemblage& a, const StepParameters& p, const CandidatePair& pair, const State& state) {
    const auto [first, second] = a.surface.edges[pair.edge].nodes;
    const double s = std::clamp(pair_geometry(a, state, pair).place, 0.0, 1.0);
    const std::array<double, 3> shares{1, -(1 - s), -s};
    UnitLoads loads{{a.cluster_of_node[pair.node], a.cluster_of_node[first], a.cluster_of_node[second]}};
    std::array<double, 3> sum{};  // a_C
    for (std::size_t k = 0; k < 3; ++k) {
        const auto same = std::find(loads.cluster.begin(), loads.cluster.end(), loads.cluster[k]);
        sum[static_cast<std::size_t>(same - loads.cluster.begin())] += shares[k];
    }
    const double all = friction_law(a, p.laws, pair).normal_stiffness * (std::abs(sum[0]) + std::abs(sum[1]) + std::abs(sum[2]));
    for (std::size_t k = 0; k < 3; ++k) loads.load[k] = std::abs(sum[k]) * all;
    return loads;
}

/// Largest load of a cluster, N/m.
double max_load(const StepParameters& p, std::int32_t cluster) {
    return stiffness_fraction * p.mass_scaling.cluster_mass[cluster] / (p.time_step * p.time_step);
}

void add_load(const UnitLoads& unit, double area, std::vector<double>& cluster_load) {
    for (std::size_t k = 0; k < 3; ++k) cluster_load[unit.cluster[k]] += area * unit.load[k];
}

/// Share of its area that the loads of its clusters leave a contact.
double fraction_left(const StepParameters& p, const UnitLoads& unit, const std::vector<double>& cluster_load) {
    double fraction = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        if (unit.load[k] > 0) fraction = std::min(fraction, max_load(p, unit.cluster[k]) / cluster_load[unit.cluster[k]]);
    }
    return fraction;
}

/// Reduces the area of a contact to a fraction of it, at the same energy.
void reduce_area(double fraction, std::size_t pair, ContactPairList& list) {
    NodeEdgeContact& contact = list.contacts[pair];
    const double growth = 1 / std::sqrt(fraction);
    contact.area *= fraction;
    contact.initial_overlap -= (growth - 1) * contact.overlap;
    contact.overlap *= growth;
    contact.elastic_slip *= growth;
    for (std::size_t k = 3 * pair; k < 3 * pair + 3; ++k) list.forces[k] = std::sqrt(fraction) * list.forces[k];
}

}  // namespace

void limit_contact_areas(const Assemblage& a, const StepParameters& p, State& s) {
    ContactPairList& list = s.contact_pairs;
    if (!p.mass_scaling.is_on()) return;
    std::vector<double> cluster_load(a.n_clusters(), 0.0);
    list.cluster_load.assign(a.n_clusters(), 0.0);
    for (std::size_t i = 0; i < list.pairs.size(); ++i) {
        if (list.contacts[i].active) add_load(unit_loads(a, p, list.pairs[i], s), list.contacts[i].area, cluster_load);
    }
    if (s.ghosts) {  // the owner of a cluster knows all contacts that load it
        s.ghosts->update([&](std::int32_t node) { return cluster_load[a.cluster_of_node[node]]; },
                         [&](std::int32_t node, double load) { cluster_load[a.cluster_of_node[node]] = load; });
    }
    for (std::size_t i = 0; i < list.pairs.size(); ++i) {
        if (list.contacts[i].active) {
            const UnitLoads unit = unit_loads(a, p, list.pairs[i], s);
            reduce_area(fraction_left(p, unit, cluster_load), i, list);
            add_load(unit, list.contacts[i].area, list.cluster_load);
        }
    }
}

void limit_new_areas(const Assemblage& a, const StepParameters& p, std::vector<NewContact>& contacts, State& s) {
    if (!p.mass_scaling.is_on()) return;
    std::vector<double>& cluster_load = s.contact_pairs.cluster_load;
    std::unordered_map<std::int32_t, double>
        fraction_of;  // first what contacts want of a cluster's load, then what fraction each gets
    std::vector<UnitLoads> units;
    for (const NewContact& contact : contacts) {
        units.push_back(unit_loads(a, p, s.contact_pairs.pairs[contact.pair], s));
        for (std::size_t k = 0; k < 3; ++k) fraction_of[units.back().cluster[k]] += contact.area * units.back().load[k];
    }
    for (auto& [cluster, fraction] : fraction_of) {
        const double most = max_load(p, cluster);
        fraction = std::max(most - cluster_load[cluster], fraction_of_new_contact * most) / fraction;
    }
    if (s.ghosts) {  // the owner of a cluster knows all contacts that want load of it
        const auto of_node = [&](std::int32_t node) { return fraction_of.find(a.cluster_of_node[node]); };
        s.ghosts->update([&](std::int32_t node) { return of_node(node) != fraction_of.end() ? of_node(node)->second : 1; },
                         [&](std::int32_t node, double fraction) {
                             if (of_node(node) != fraction_of.end()) of_node(node)->second = fraction;
                         });
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        double fraction = 1;
        for (std::size_t k = 0; k < 3; ++k) {
            if (units[i].load[k] > 0) fraction = std::min(fraction, fraction_of[units[i].cluster[k]]);
        }
        contacts[i].area *= fraction;
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) add_load(units[i], contacts[i].area, cluster_load);
}

}  // namespace graincrack
