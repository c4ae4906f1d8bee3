// A specimen is an assemblage of grains, with the arrays of the specimen file.
//
// Grains are polygons of constant-strain triangles and share no nodes; facing edges of neighbouring grains are contacts. Any
// specimen that passes `validate` can be run, whatever program made it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "share/file/settings.hpp"

namespace graincrack {

class H5Input;
class H5Output;

/// Kind of a contact at the start of a run (dataset /contacts/kind).
///
/// A crystal can consist of several grains, which are then the parts that stay whole; contacts between them are within the
/// crystal. A boundary that is open at the start is not a crack of the test, a notch or a flaw.
enum class ContactKind : std::uint8_t { grain_boundary = 0, pre_existing_crack = 1, within_crystal = 2, open_boundary = 3 };
/// True if contacts of a kind are broken at the start.
constexpr bool starts_broken(std::uint8_t kind) {
    return kind == static_cast<std::uint8_t>(ContactKind::pre_existing_crack) ||
           kind == static_cast<std::uint8_t>(ContactKind::open_boundary);
}

/// Parts of the boundary with fixed numbers; a specimen may name further parts (dataset /boundary/part).
enum class BoundaryPart : std::uint8_t { bottom = 0, right = 1, top = 2, left = 3, rim = 4 };

// Every contact belongs to the class of the phases of its two grains, or to one of the classes of flaws. For p phases there are
// p (p + 1)/2 classes, in the order 00, 01, 11, 02, 12, 22, …, followed by the classes of flaws.

/// Largest number of phases of a specimen, whose classes fit in uint8.
inline constexpr std::size_t max_phases = 22;
/// Largest number of classes of a specimen, which fit in uint8.
inline constexpr std::size_t max_classes = 256;
/// The class of a contact between grains of two phases, in any order.
constexpr std::size_t contact_class(std::size_t phase, std::size_t other) {
    const std::size_t high = std::max(phase, other);
    return high * (high + 1) / 2 + std::min(phase, other);
}
constexpr std::size_t n_contact_classes(std::size_t n_phases) { return n_phases * (n_phases + 1) / 2; }
/// Statistics of the mesh; attributes of /specimen. Lengths in m, angles in rad.
struct MeshStatistics {
    double mean_edge = 0;       ///< mean over all grain edges, rim included
    double edge_variation = 0;  ///< coefficient of variation of the edges
    double min_edge = 0;
    double max_edge = 0;
    double mean_diameter = 0;  ///< mean of the equal-area diameters of the grains
    double diameter_variation = 0;
    double min_diameter = 0;
    double max_diameter = 0;
    double min_angle = 0;         ///< smallest angle of any element
    double psi6 = 0;              ///< |⟨e^(6iθ)⟩| over the edges: 0 no preferred direction, 1 a lattice
    double area_error = 0;        ///< (area of all grains − area of the shape) / area of the shape
    double elongation = 0;        ///< mean ratio of the long to the short axis of the grains; 0: not measured
    double elongation_angle = 0;  ///< direction of the long axis, counter-clockwise from x
};

/// Arrays of a specimen. Index ranges: n nodes, e elements, g grains, c contacts, b boundary edges. SI units.
struct Specimen {
    std::string shape;         ///< "rectangle", "disc", "ring", "beam", "half-disc" or "polygon"
    double width = 0;          ///< extent along x (disc: diameter)
    double height = 0;         ///< extent along y between the platens (disc: diameter)
    std::string tessellation;  ///< "delaunay", … or a name given by another program
    std::uint64_t seed = 0;
    int elements_per_edge = 1;
    double loading_arc =
        0;  ///< disc: angle (rad) under which the facet at a pole is seen from the centre; 0: vertex or rectangle
    MeshStatistics statistics;
    Settings settings;  ///< settings that made it; empty if unknown

    std::vector<std::array<double, 2>> node_position;        ///< [n] m
    std::vector<std::array<std::int32_t, 3>> element_nodes;  ///< [e] counter-clockwise
    std::vector<std::int32_t> element_grain;                 ///< [e]
    std::vector<std::uint8_t> grain_phase;                   ///< [g] index into phase_names
    std::vector<double> grain_area;                          ///< [g] m²
    std::vector<std::int32_t> grain_crystal;                 ///< [g] crystal of the grain, from 0; empty: each grain is one
    std::vector<std::array<std::int32_t, 4>>
        contact_nodes;  ///< [c] a1 a2 b1 b2: a1→a2 counter-clockwise around a, a1 on b1, a2 on b2
    std::vector<std::int32_t> contact_grain_boundary;         ///< [c] groups the contacts of one grain-to-grain edge
    std::vector<std::uint8_t> contact_kind;                   ///< [c] ContactKind
    std::vector<std::uint8_t> contact_flaw;                   ///< [c] class of flaws, from 1; 0: grain boundary; empty: 0
    std::vector<double> contact_strength_factor;              ///< [c] factor on the strengths of a contact; empty: 1 everywhere
    std::vector<std::array<std::int32_t, 2>> boundary_edges;  ///< [b] solid on the left
    std::vector<std::uint8_t> boundary_part;                  ///< [b] index into part_names
    std::vector<std::string> phase_names{"rock"};
    std::vector<std::string> flaw_names;  ///< classes of flaws, such as "joint"; a material has a table [flaws.NAME] for each
    std::vector<std::string> part_names{"bottom", "right", "top", "left", "rim"};

    [[nodiscard]] std::size_t n_nodes() const { return node_position.size(); }
    [[nodiscard]] std::size_t n_elements() const { return element_nodes.size(); }
    [[nodiscard]] std::size_t n_grains() const { return grain_phase.size(); }
    [[nodiscard]] std::size_t n_contacts() const { return contact_nodes.size(); }
    [[nodiscard]] std::size_t n_boundary_edges() const { return boundary_edges.size(); }
};

/// Fraction of the area of all grains by phase.
std::vector<double> phase_fractions(const Specimen& specimen);

/// Length of a contact, m.
double contact_length(const Specimen& specimen, std::size_t contact);

/// Class of each contact [c].
std::vector<std::uint8_t> contact_classes(const Specimen& specimen);
/// Names of all classes: pairs of phases as "quartz-mica", the phase with the lower index first, then classes of flaws.
std::vector<std::string> contact_class_names(const Specimen& specimen);
/// True if a text can name a class of flaws: a letter, then lower-case letters, digits and _, 40 at most; not "broken" or
/// "intact", which are states.
bool is_flaw_name(std::string_view name);

/// The class of contacts within crystals of a phase, "within_quartz". It is a class of flaws: a material may have a table
/// [flaws.within_quartz]; without it they are as contacts between two crystals of the phase, but stiffer
/// (`contact_within_crystals`).
std::string within_class(std::string_view phase);
/// The phase of such a class; "" for any other.
std::string phase_of_within_class(std::string_view class_name);

/// Grain of each node [n]; −1 for a node of no element.
std::vector<std::int32_t> grain_of_nodes(const Specimen& specimen);

/// Checks that the arrays fit each other and the conventions of the schema: lengths, index ranges, counter-clockwise
/// elements of positive area that do not share sides in the same sense, elements of a grain contiguous and ascending, each node
/// of one grain, contacts conforming (a1 on b1, a2 on b2 within 1e-9 of the specimen's size) with grain(a) < grain(b), their
/// edges and those of the boundary outer sides of grains in the right sense and each there once, every grain with a contact (in
/// a specimen that has contacts), known shapes, kinds and parts; size, areas and mean edge within 1 % of those declared, and
/// the middle within 0.1 % of the size at the origin.
/// The cost is linear in the size.
/// \throws InputError naming `where` and the first violation
void validate(const Specimen& specimen, const std::string& where);

/// Writes /specimen, /nodes, /elements, /grains, /contacts, /boundary and /VTKHDF into an open file.
void write_specimen(H5Output& file, const Specimen& specimen);
/// Reads a specimen that `write_specimen` or another program wrote by the same schema, and validates it.
Specimen read_specimen(const H5Input& file);

}  // namespace graincrack
