// Selective mass scaling (share/doc/loading.md): the nodes that contacts link at a vertex of the reference mesh, a vertex
// cluster, move relative to each other with 1 + β times their mass, and together with their own mass (Olovsson, Simonsson &
// Unosson 2005 do so for the nodes of an element). For linked nodes with masses m and total mass m_g:
//
//   M' = M + β (M − m mᵀ/m_g)            a_i = ā + (f_i/m_i − ā)/(1 + β),  ā = Σf/m_g
//
// Contacts are much stiffer than grains, so the relative motion of their nodes limits the step. Equilibrium and momentum are
// unchanged; angular momentum of the relative motion is not conserved. A cluster stays what it is when its contacts have failed:
// node–edge contacts, as stiff as bonds, need it as bonds do.
//
// A cluster with a node on a platen, or within `platen_reach` of one, is constrained by the platen as by an infinite mass: ā is
// the platen's, and the work on the added mass is booked as the platen's. When a cluster meets a platen or leaves it, its nodes
// keep their momentum M' v. That loses kinetic energy and never gains any; the loss is booked.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/model/assemblage.hpp"
#include "solver/model/boundary.hpp"

namespace graincrack {

/// Distance from a platen within which a node is constrained by it, over the node's tributary length. A free node has its own
/// mass and would overlap too far in one step with mass scaling, so it is slowed before it comes into contact. At the speed to
/// which a grain rebounds from 100 MPa, σ/√(ρ E) = 12 m/s, it moves by 1.2e-3 of a 5 mm edge in such a step (5e-7 s).
inline constexpr double platen_reach = 4e-3;

/// Constant data of the scaling. Default: none.
struct MassScaling {
    double factor = 0;  ///< β; 0: no mass scaling
    /// [n] masses of nodes, each twice: of x and of y.
    std::vector<double> mass, inverse_mass;
    std::vector<double> cluster_mass;  ///< [clusters] kg
    [[nodiscard]] bool is_on() const { return factor > 0; }
};

/// \throws InputError if more nodes meet at a vertex than a chunk can hold
MassScaling make_mass_scaling(const Assemblage& assemblage, double factor);

/// Energies summed over the clusters of a chunk of nodes since the start, J.
struct ClusterSums {
    double damping = 0;
    double platen_loss = 0;  ///< kinetic energy lost where clusters met or left a platen
    double platen_work = 0;  ///< done on the added mass that platens constrain
    using IsSum = void;
};

/// A cluster that a platen constrains.
struct ConstrainedCluster {
    std::int32_t cluster;
    std::uint8_t constraining_platen;  ///< see `ClusterState::constraining_platen`
};

/// Which clusters platens constrain now.
struct ClusterState {
    std::vector<std::uint8_t> near_platen;  ///< [n] `State::near_platen` at the last change
    std::vector<ClusterSums> sums;          ///< by chunk of nodes

    // Found by `complete_cluster_state`:
    std::vector<std::uint8_t> constraining_platen;             ///< [clusters] 1 + the platen, 0 for none
    std::vector<double> inverse_mass;                          ///< [clusters] 0 if a platen constrains it, 1/kg
    std::vector<std::vector<ConstrainedCluster>> constrained;  ///< by chunk
    std::vector<std::vector<std::int32_t>> platen_nodes;       ///< by chunk: nodes that may meet a platen
};
/// Velocities of the platens, by `ClusterState::constraining_platen`.
class PlatenVelocities {
public:
    /// As node velocities: half a step before now.
    PlatenVelocities(const StepLoading& loading, double time_step)
        : velocity_{Vector2{}, loading.increment_before[0] / time_step * loading.platen_axis,
                    loading.increment_before[1] / time_step * loading.platen_axis} {}
    [[nodiscard]] const Vector2& operator[](std::uint8_t constraining_platen) const { return velocity_[constraining_platen]; }

private:
    std::array<Vector2, 3> velocity_;
};

}  // namespace graincrack
