// A program on a specimen: to which nodes and edges it prescribes velocities and loads, by which amplitude.
#pragma once

#include <array>
#include <vector>

#include "share/file/specimen.hpp"
#include "solver/model/boundary.hpp"
#include "solver/model/state.hpp"
#include "solver/program/program.hpp"

namespace graincrack {

/// Amplitude of each action of each boundary condition, `no_amplitude` where it is never set; numbered condition by condition.
using AmplitudeNumbers = std::vector<std::array<std::int32_t, n_actions>>;
AmplitudeNumbers number_amplitudes(const Program& program);

/// Nodes and boundary edges of a region, ascending, in internal indices of nodes and rows of /boundary. Corners within 1e-9 of
/// the specimen's size of a box belong to it.
struct RegionContent {
    std::vector<std::int32_t> nodes;
    std::vector<std::size_t> edges;
};
/// \param where what a message names, such as "shear.toml: boundary.upper"
/// \throws InputError if the specimen has no part of a requested name, or nothing there
RegionContent content_of_region(const Region& region, const Assemblage& assemblage, const Specimen& specimen,
                                const std::string& where);

/// Platens and prescribed conditions of a program. Platens have the contacts' stiffness per area; bonded ones are smooth, so that
/// they do not hinder the lateral strain. Where two boundary conditions drive the same component of a node the later one does.
/// \param platen_friction rad \throws InputError
Boundary make_program_boundary(const Assemblage& assemblage, const Specimen& specimen, const Program& program,
                               const ContactParameters& contact, double platen_friction);

/// Takes the platens away: nothing meets them, bonded or not, before they are placed.
void remove_platens(State& state);
/// Places absent platens where the specimen is now: each face of a platen in touch with the outermost node of the boundary that
/// it may meet, a bonded one with all its nodes as they lie. A specimen that has turned as a whole is taken to stand upright: the
/// faces are inclined by its mean rotation.
void place_platens(const Assemblage& assemblage, const Boundary& boundary, State& state);

/// Gives the nodes their initial velocities, later ones of the file winning, and books their kinetic energy as external.
void set_initial_velocities(const Program& program, const Assemblage& assemblage, const Specimen& specimen, State& state);

}  // namespace graincrack
