// Applies a program to a specimen: finds the nodes and edges of its boundary conditions and the amplitudes that drive them.
#pragma once

#include <array>
#include <vector>

#include "share/file/specimen.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Number of the amplitude of each action of each boundary condition, in order; `no_amplitude` for an action never set.
using AmplitudeNumbers = std::vector<std::array<std::int32_t, n_actions>>;
AmplitudeNumbers number_amplitudes(const Program& program);

/// Nodes (internal indices) and boundary edges (rows of /boundary) of a region, ascending. A box includes corners that lie
/// outside it by up to 1e-9 of the specimen's size.
struct RegionContent {
    std::vector<std::int32_t> nodes;
    std::vector<std::size_t> edges;
};
/// \param where the region in messages, such as "shear.toml: boundary.upper"
RegionContent content_of_region(const Region& region, const Assemblage& assemblage, const Specimen& specimen,
                                const std::string& where);

/// Makes the platens and prescribed conditions of a program. Platens have the contacts' stiffness per area; bonded platens are
/// smooth and do not hinder the lateral strain. Later boundary conditions override earlier ones at a component of a node.
/// \param platen_friction rad \throws InputError for a region without nodes, or an edge with the same load twice
Boundary make_program_boundary(const Assemblage& assemblage, const Specimen& specimen, const Program& program,
                               const ContactParameters& contact, double platen_friction);

/// Removes the platens: until they are placed again no node meets them.
void remove_platens(State& state);
/// Places absent platens at the present specimen: each face lies at the outermost boundary node that it may meet, a bonded face
/// holds all its nodes where they are. If the specimen has rotated as a whole, the faces are inclined by its mean rotation.
void place_platens(const Assemblage& assemblage, const Boundary& boundary, State& state);

/// Sets the initial velocities of nodes (later entries override earlier ones) and adds their kinetic energy to the external work.
void set_initial_velocities(const Program& program, const Assemblage& assemblage, const Specimen& specimen, State& state);

}  // namespace graincrack
