// Selective mass scaling: the nodes that contacts link at a vertex of the reference mesh, a vertex cluster, move relative to each
// other with 1 + β times their mass, and together with their own mass (Olovsson, Simonsson & Unosson 2005 do so for the nodes of
// an element).
//
// For linked nodes with masses m and total mass m_g:
//
//   M' = M + β (M − m mᵀ/m_g)            a_i = ā + (f_i/m_i − ā)/(1 + β),  ā = Σf/m_g
//
// Contacts are much stiffer than grains, so the relative motion of their nodes limits the step. The scaling slows the vibration
// of contacts, which does not matter in a quasi-static test. Equilibrium and momentum are unchanged; angular momentum of the
// relative motion is not conserved.
//
// A contact point links its two nodes until it has separated and opened by `cluster_reach`, and again when it comes as close. The
// nodes of a cluster that links connect form a component, so fragments move freely. When grains come into contact with others
// than their first neighbours, mass scaling ends (`StepParameters::substeps`). A component with a node on a platen, or as close
// to one, is constrained by the platen as by an infinite mass: ā is the platen's. The force that accelerates the added mass with
// the platen does work, which is booked as the platen's.
//
// When components change, nodes that split keep their velocities, and nodes that join keep their momentum M' v, as keeping their
// velocities would create energy. Both lose kinetic energy and never gain any; the loss is booked.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"

namespace graincrack {

/// Opening of a separated contact up to which its nodes are linked, over its length. A free node has its own mass and would
/// overlap too far in one step with mass scaling, so it is slowed before it comes into contact. At the speed to which a grain
/// rebounds from 100 MPa, σ/√(ρ E) = 12 m/s, it moves by 1.2e-3 of a 5 mm edge in such a step (5e-7 s).
inline constexpr double cluster_reach = 4e-3;

/// Largest number of nodes in a chunk of clusters.
inline constexpr std::int32_t nodes_per_chunk = 256;

/// Constant data of the scaling. Default: none.
struct MassScaling {
    /// A contact point that links two nodes.
    struct Link {
        std::int32_t first, second;  ///< places in `nodes`
        std::int32_t point;          ///< 2 c + p
        double reach;                ///< opening up to which it links them once it has separated, m
    };
    double factor = 0;                ///< β; 0: no mass scaling
    std::vector<std::int32_t> nodes;  ///< [n] all nodes, cluster by cluster; a node is known by its place in this list
    std::vector<Link> links;          ///< cluster by cluster
    std::vector<Range> clusters;      ///< of places
    std::vector<Range> links_of_cluster;
    std::vector<Range> chunks;  ///< of clusters, that one thread works on at a time; at most `nodes_per_chunk` nodes each
    /// Masses of nodes, each twice: of x and of y.
    std::vector<double> mass, inverse_mass;
    [[nodiscard]] bool is_on() const { return factor > 0; }
    [[nodiscard]] Range nodes_of(std::int32_t chunk) const {
        return {clusters[chunks[chunk].begin].begin, clusters[chunks[chunk].end - 1].end};
    }
};
/// Bytes of its arrays.
std::size_t memory_of(const MassScaling& scaling);
/// Representative of `i` in a forest of parents, with the path to it shortened.
std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i);

/// \throws InputError if more nodes meet at a vertex than a chunk can hold
MassScaling make_mass_scaling(const Assemblage& assemblage, double factor);

/// Energies summed over a chunk of clusters since the start, J.
struct ClusterSums {
    double damping = 0;
    double regrouping_loss = 0;  ///< kinetic energy lost where components changed
    double platen_work = 0;      ///< done on the added mass that platens constrain
};

/// A node that a platen constrains.
struct ConstrainedNode {
    std::int32_t place;                ///< within the chunk
    std::uint8_t constraining_platen;  ///< see `ClusterState::constraining_platen`
};

/// Which nodes are linked now.
struct ClusterState {
    std::vector<std::uint8_t> linked;               ///< [link] 1 while the point links its nodes
    std::vector<std::uint8_t> supported;            ///< [place] `State::near_platen` of the node
    std::vector<std::uint8_t> constraining_platen;  ///< [place] of the component it is the first of: 1 + its platen, 0 for none
    std::vector<std::int32_t> component;            ///< [place] first place of its component
    std::vector<double> inverse_mass;  ///< [place] of the component it is the first of; 0 if a platen constrains it, 1/kg
    std::vector<std::uint8_t> whole;   ///< [cluster] 1 while it is one component
    std::vector<ClusterSums> sums;     ///< by chunk

    // Found by `complete_cluster_state`: constrained nodes, and where components may change.
    std::vector<std::vector<ConstrainedNode>> constrained;  ///< by chunk
    std::vector<std::int32_t> chunk_of_point;               ///< [2 c]
    std::vector<std::uint8_t> cracked;                      ///< by chunk: 1 once a point of it has failed
    std::vector<std::vector<std::int32_t>> platen_nodes;    ///< by chunk: places of nodes that may meet a platen
    /// Called by the thread that works on a point when the point fails.
    void note_failure(std::size_t point) {
        if (!chunk_of_point.empty()) {
            std::atomic_ref(cracked[chunk_of_point[point]]).store(1, std::memory_order_relaxed);
        }
    }
};
/// Bytes of its arrays.
std::size_t memory_of(const ClusterState& clusters);
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
