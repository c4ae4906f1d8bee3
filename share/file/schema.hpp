// Defines every path of the files, with unit and meaning. The programs take all paths from here. share/doc/file-format.md
// describes the layout.
#pragma once

#include <string>
#include <string_view>

namespace graincrack::schema {

/// A dataset: path, unit, meaning.
struct Dataset {
    const char* path;
    std::string_view unit;
    std::string_view description;
};

inline constexpr const char* specimen_group = "/specimen";
inline constexpr const char* run_group = "/run";
inline constexpr const char* phases_group = "/run/phases";    ///< one dataset per property, [phase] in the order of /grains/phase
inline constexpr const char* classes_group = "/run/classes";  ///< one dataset per contact parameter, [class]
inline constexpr const char* history_group = "/history";
inline constexpr const char* cracks_group = "/cracks";
inline constexpr const char* sensitivity_group = "/sensitivity";
inline constexpr const char* frames_group = "/frames";
inline constexpr const char* probes_group = "/probes";
inline constexpr const char* program_group = "/program";
inline constexpr const char* state_group = "/state";
inline constexpr const char* platens_group = "/platens";  ///< only for faces of finite width: rollers and punches
inline constexpr const char* provenance_group = "/provenance";
inline constexpr const char* vtk_group = "/VTKHDF";

// clang-format off
inline constexpr Dataset node_position{"/nodes/position", "m", "reference position x y"};
inline constexpr Dataset element_nodes{"/elements/nodes", "1", "nodes of a constant-strain triangle, counter-clockwise"};
inline constexpr Dataset element_grain{"/elements/grain", "1", "grain of the element"};
inline constexpr Dataset grain_phase{"/grains/phase", "1", "mineral, index into the attribute names"};
inline constexpr Dataset grain_area{"/grains/area", "m2", "area of the grain"};
inline constexpr Dataset grain_crystal{"/grains/crystal", "1", "crystal of the grain; absent: each grain is one"};
inline constexpr Dataset grain_axis{"/grains/axis", "rad", "direction of the axis of the crystal from x, counter-clockwise, in (0, pi); of runs with a temperature whose crystals have axes"};
inline constexpr Dataset contact_nodes{"/contacts/nodes", "1", "a1 a2 b1 b2: a1 to a2 counter-clockwise around grain a, a1 on b1, a2 on b2"};
inline constexpr Dataset contact_grain_boundary{"/contacts/grain_boundary", "1", "groups the contacts of one grain-to-grain edge"};
inline constexpr Dataset contact_class{"/contacts/class", "1", "pair of phases of the two grains, or class of flaws; index into the attribute names; absent: one class"};
inline constexpr Dataset contact_strength_factor{"/contacts/strength_factor", "1", "factor on the strengths of the contact; absent: 1"};
inline constexpr Dataset contact_kind{"/contacts/kind", "1", "kind of the contact at the start, index into the attribute names"};
inline constexpr Dataset boundary_edges{"/boundary/edges", "1", "nodes of a boundary edge, solid on the left"};
inline constexpr Dataset boundary_part{"/boundary/part", "1", "named part of the boundary, index into the attribute names"};

inline constexpr Dataset platens_bottom{"/platens/bottom", "m", "a row a face: left and right end across the direction of the platens, position along it"};
inline constexpr Dataset platens_top{"/platens/top", "m", "a row a face: left and right end across the direction of the platens, position along it"};

inline constexpr Dataset crack_time{"/cracks/time", "s", "time at which the contact point passed its peak"};
inline constexpr Dataset crack_step{"/cracks/step", "1", "step at which it did"};
inline constexpr Dataset crack_contact{"/cracks/contact", "1", "row of /contacts"};
inline constexpr Dataset crack_point{"/cracks/point", "1", "0 at a1, 1 at a2"};
inline constexpr Dataset crack_mode{"/cracks/mode", "1", "by the sign of the opening, index into the attribute names: tensile if the contact was open then, else shear"};
inline constexpr Dataset crack_mode_angle{"/cracks/mode_angle", "rad", "atan2(|shear traction|, normal traction) at the end of the step before, the last one short of the peak"};
inline constexpr Dataset crack_position{"/cracks/position", "m", "position x y then"};
inline constexpr Dataset crack_orientation{"/cracks/orientation", "rad", "direction of the contact from x, counter-clockwise, in [0, pi)"};
inline constexpr Dataset crack_length{"/cracks/length", "m", "half the edge"};
inline constexpr Dataset crack_opening{"/cracks/opening", "m", "opening then"};
inline constexpr Dataset crack_sliding{"/cracks/sliding", "m", "sliding then"};
inline constexpr Dataset crack_energy{"/cracks/energy_released", "J", "fracture energy dissipated by the point until the end of the run"};
inline constexpr Dataset crack_time_damaged_10{"/cracks/time_damaged_10", "s", "time at which less than 90 % of its cohesion was left, NaN until then"};
inline constexpr Dataset crack_opening_damaged_10{"/cracks/opening_damaged_10", "m", "opening when 10 % of its cohesion was lost, NaN until then"};
inline constexpr Dataset crack_sliding_damaged_10{"/cracks/sliding_damaged_10", "m", "sliding when 10 % of its cohesion was lost, NaN until then"};
inline constexpr Dataset crack_time_damaged_50{"/cracks/time_damaged_50", "s", "time at which less than 50 % of its cohesion was left, NaN until then"};
inline constexpr Dataset crack_opening_damaged_50{"/cracks/opening_damaged_50", "m", "opening when 50 % of its cohesion was lost, NaN until then"};
inline constexpr Dataset crack_sliding_damaged_50{"/cracks/sliding_damaged_50", "m", "sliding when 50 % of its cohesion was lost, NaN until then"};
inline constexpr Dataset crack_time_broken{"/cracks/time_broken", "s", "time at which it broke: less than 10 % of its cohesion was left, NaN until then"};
inline constexpr Dataset crack_opening_broken{"/cracks/opening_broken", "m", "opening when it broke, NaN until then"};
inline constexpr Dataset crack_sliding_broken{"/cracks/sliding_broken", "m", "sliding when it broke, NaN until then"};
inline constexpr Dataset crack_time_separated{"/cracks/time_separated", "s", "time at which it lost all tensile strength, NaN until then"};
inline constexpr Dataset crack_opening_separated{"/cracks/opening_separated", "m", "opening when it separated, NaN until then"};
inline constexpr Dataset crack_sliding_separated{"/cracks/sliding_separated", "m", "sliding when it separated, NaN until then"};
// clang-format on

// Datasets in /frames/NNNN; `path` is the last part.
inline constexpr Dataset frame_displacement{"displacement", "m", "displacement x y of the nodes"};
inline constexpr Dataset frame_velocity{"velocity", "m/s", "velocity x y of the nodes"};
inline constexpr Dataset frame_element_stress{"element_stress", "Pa", "Cauchy stress xx yy xy zz, tension positive"};
inline constexpr Dataset frame_opening{"opening", "m", "opening of contact points 0 and 1"};
inline constexpr Dataset frame_sliding{"sliding", "m", "sliding of contact points 0 and 1"};
inline constexpr Dataset frame_traction{"traction", "Pa", "normal and shear traction of contact points 0 and 1"};
inline constexpr Dataset frame_damage{"damage", "1", "damage of contact points 0 and 1"};
inline constexpr Dataset frame_state{"state", "1", "state of contact points 0 and 1, index into the attribute names"};

}  // namespace graincrack::schema
