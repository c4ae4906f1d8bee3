// Makes sets of parallel random joints.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// Joints on parallel lines at equal spacing. On each line joints and bridges of rock alternate; their lengths are uniform within
/// ±30 % of their means. The position of the first line and the starts of joints are random.
struct JointSet {
    double spacing = 0;      ///< distance of the lines, m
    double dip = 0;          ///< direction of the lines, counter-clockwise from x, rad
    double persistence = 1;  ///< jointed fraction of the lines; 1: through the whole specimen
    double length = 0;       ///< mean length of a joint, m
    FlawKind kind;
    std::string name;  ///< for messages: "--joint-set 2"
};

/// Reads "spacing=20mm,dip=45deg,persistence=0.7,length=30mm,class=joint,state=broken". Spacing and dip are required; the default
/// length is the spacing. \throws UsageError naming `name`
JointSet parse_joint_set(std::string_view text, const std::string& name);

/// Returns the joints of a set across the extent of a region; joints without room may be left out.
/// \param number of the set, which selects its random numbers
/// \throws UsageError if spacing, joints or bridges are too short for grains of mean edge `edge`, or there are too many
std::vector<PrescribedEdge> joints_of(const JointSet& set, const Region& region, double edge, std::uint64_t seed,
                                      std::size_t number);

}  // namespace graincrack::mesher
