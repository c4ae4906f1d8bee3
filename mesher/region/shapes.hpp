// The shapes of laboratory specimens, centred on the origin by the middle of their extent; the load is along y. Sizes in m,
// angles in rad, counter-clockwise from x.
#pragma once

#include <string>
#include <vector>

#include "mesher/region/region.hpp"

namespace graincrack::mesher {

/// A rectangle with the parts bottom, right, top and left.
Region rectangle(double width, double height);
/// A disc of the part rim; see `Circle`.
Region disc(double diameter, Pole pole = Pole::facet, int diameters = 1, int loaded_diameter = 0);
/// A disc with flat poles: the parts top and bottom, seen from the centre under the angle `flats`, and rim.
Region disc_with_flats(double diameter, double flats);
/// A disc of the part outer with a central round hole of the part inner. Its poles are facets.
Region ring(double outer_diameter, double inner_diameter);
/// Half a disc with the parts bottom (its flat side) and rim. Its crown is a point of the rim.
Region half_disc(double diameter);
/// A polygon of either direction. \param parts names of the sides, each from its corner to the next; empty names: "side"
Region polygon(std::vector<Point> corners, const std::vector<std::string>& parts);

/// Adds a round hole of the part hole_1, hole_2, … \throws UsageError naming `where` if it is not inside or meets another loop
void add_hole(Region& region, Point centre, double radius, const std::string& where);
/// A straight crack through the middle; a joint if it is as long as the specimen in its direction. \throws UsageError naming
/// `where` if it is longer
PrescribedEdge central_slit(const Region& region, double length, double angle, const std::string& where);
/// A crack upwards from the bottom. \param at its place along x, m \throws UsageError naming `where` if it has no room
PrescribedEdge slit_from_below(const Region& region, double length, const std::string& where, double at = 0);

/// Moves the middle of a region's extent to the origin. \return the translation, m
Point centre_region(Region& region);

/// Angle by which a disc is rotated to its load, rad; 0 for other regions.
double turn_to_load(const Region& region);
/// Rotates points of a disc so that the loaded diameter lies along y; its poles come to y = ±D/2 exactly.
void turn_to_load(const Region& region, std::vector<Point>& points);

}  // namespace graincrack::mesher
