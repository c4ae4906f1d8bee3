// Selective mass scaling: the nodes that contacts hold together at a vertex of the reference mesh move against each other with
// 1 + β times their mass, and together with their own (Olovsson, Simonsson & Unosson 2005 do so for the nodes of an element).
//
// For a cluster of nodes held together, with masses m and total mass m_g:
//
//   M' = M + β (M − m mᵀ/m_g)            a_i = ā + (f_i/m_i − ā)/(1 + β),  ā = Σf/m_g
//
// Contacts are much stiffer than grains, so it is their relative motion that limits the step: what is slowed is the vibration
// over a contact, which a quasi-static test does not ask for. Balance at rest and momentum stay what they are; angular momentum
// of the relative motion does not.
//
// A contact point holds its two nodes together while it carries something or soon may: until it has separated and opened by
// `cluster_reach`, and again when it comes as close. Groups are what is connected by such points, so fragments fly free of each
// other. Where they are to meet others than their first partners (`StepParameters::substeps`) mass scaling is over. A cluster
// that touches a platen, or comes as close to one, is held by it as by a mass without limit: ā is the platen's. What that mass
// takes to be moved along with the platen is the platen's work.
//
// When clusters change, nodes that part keep their velocities, and nodes that meet their momentum M' v (kept velocities would
// make energy there). Both lose kinetic energy, never gain any; what is lost is booked.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"

namespace graincrack {

/// Opening of a separated contact at which its nodes part, over its length. What moves freely has its own mass, and would run
/// deep into a contact that is stiff for that mass; it must be slowed before. At the speed to which a grain springs back from
/// 100 MPa, σ/√(ρ E) = 12 m/s, a step with mass scaling (5e-7 s) takes it 1.2e-3 of a 5 mm edge.
inline constexpr double cluster_reach = 4e-3;

/// Most nodes in a chunk of clusters.
inline constexpr std::int32_t nodes_per_chunk = 256;

/// Constant data of the scaling. Default: none.
struct MassScaling {
    /// A contact point that joins two nodes.
    struct Link {
        std::int32_t first, second;  ///< nodes
        std::int32_t point;          ///< 2 c + p
        double reach;                ///< opening up to which it holds them once it has separated, m
    };
    double factor = 0;                ///< β; 0: masses are as they are
    std::vector<std::int32_t> nodes;  ///< [n] all nodes, cluster by cluster
    std::vector<Link> links;          ///< cluster by cluster
    std::vector<Range> clusters;      ///< of nodes
    std::vector<Range> links_of_cluster;
    std::vector<Range> chunks;  ///< of clusters, that one thread works on at a time; at most `nodes_per_chunk` nodes each
    /// Masses of nodes, each twice: of x and of y.
    std::vector<double> mass, inverse_mass;
    [[nodiscard]] bool is_on() const { return factor > 0; }
    [[nodiscard]] Range nodes_of(std::int32_t chunk) const {
        return {clusters[chunks[chunk].begin].begin, clusters[chunks[chunk].end - 1].end};
    }
};
/// Representative of `i` in a forest of parents, with the way there shortened.
std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i);

/// \throws InputError if more nodes meet at a vertex than a chunk can hold
MassScaling make_mass_scaling(const Assemblage& assemblage, double factor);

/// Energies summed over a chunk of clusters since the start, J.
struct ClusterSums {
    double damping = 0;
    double regrouping_loss = 0;  ///< kinetic energy that changes of clusters took away
    double platen_work = 0;      ///< done on the added mass that platens hold
};

/// A node that a platen holds.
struct ConstrainedNode {
    std::int32_t place;                ///< within the chunk
    std::uint8_t constraining_platen;  ///< see `ClusterState::constraining_platen`
};

/// Who is held together now.
struct ClusterState {
    std::vector<std::uint8_t> linked;     ///< [link] 1 while the point holds its nodes together
    std::vector<std::uint8_t> supported;  ///< [place] `State::near_platen` of the node
    std::vector<std::uint8_t>
        constraining_platen;              ///< [place] of the component it is the first of: 1 + its platen, 0 if none holds it
    std::vector<std::int32_t> component;  ///< [place] first node of those it is held together with
    std::vector<double> inverse_mass;     ///< [place] of the component it is the first of; 0 if a platen holds that, 1/kg
    std::vector<std::uint8_t> whole;      ///< [cluster] 1 while all of its nodes are held together
    std::vector<ClusterSums> sums;        ///< by chunk

    // Found by `complete_cluster_state`: who is held, and where clusters may change.
    std::vector<std::vector<ConstrainedNode>> constrained;  ///< by chunk
    std::vector<std::int32_t> chunk_of_point;               ///< [2 c]
    std::vector<std::uint8_t> cracked;                      ///< by chunk: 1 once a point of it has failed
    std::vector<std::vector<std::int32_t>> platen_nodes;    ///< by chunk: nodes that platens may touch
    /// To be told by whatever thread sees a point fail.
    void note_failure(std::size_t point) {
        if (!chunk_of_point.empty()) {
            std::atomic_ref(cracked[chunk_of_point[point]]).store(1, std::memory_order_relaxed);
        }
    }
};
/// Velocities of the platens, by `ClusterState::constraining_platen`.
class PlatenVelocities {
public:
    /// As node velocities: half a step before now.
    PlatenVelocities(const StepLoading& loading, double time_step)
        : velocity_{Vector2{}, {0, loading.increment_before[0] / time_step}, {0, loading.increment_before[1] / time_step}} {}
    [[nodiscard]] const Vector2& operator[](std::uint8_t constraining_platen) const { return velocity_[constraining_platen]; }

private:
    std::array<Vector2, 3> velocity_;
};

}  // namespace graincrack
