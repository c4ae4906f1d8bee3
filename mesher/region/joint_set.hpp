// Sets of parallel joints, drawn at random.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// Joints on parallel lines at equal spacing; on each line joints and bridges of rock follow one another, whose lengths are
/// uniform within ±30 % of their means. Where the first line lies and where a joint begins is drawn at random.
struct JointSet {
    double spacing = 0;      ///< of the lines, m
    double dip = 0;          ///< direction of the lines, counter-clockwise from x, rad
    double persistence = 1;  ///< share of the lines that is jointed; 1: through the whole specimen
    double length = 0;       ///< mean length of a joint, m
    FlawKind kind;
    std::string name;  ///< for messages: "--joint-set 2"
};

/// Reads "spacing=20mm,dip=45deg,persistence=0.7,length=30mm,class=joint,state=broken"; spacing and dip are needed, the length is
/// the spacing unless given. \throws UsageError naming `name`
JointSet parse_joint_set(std::string_view text, const std::string& name);

/// The joints of a set across the extent of a region; they may be left out where they have no room.
/// \param number of the set, for random numbers of its own
/// \throws UsageError if spacing, joints or bridges are too short for grains of mean edge `edge`, or there are too many
std::vector<PrescribedEdge> joints_of(const JointSet& set, const Region& region, double edge, std::uint64_t seed,
                                      std::size_t number);

}  // namespace graincrack::mesher
