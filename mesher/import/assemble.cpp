#include "mesher/import/assemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "mesher/assemblage/separate_bodies.hpp"
#include "mesher/cells/statistics.hpp"
#include "mesher/import/clean_mesh.hpp"
#include "mesher/import/outline.hpp"
#include "share/base/error.hpp"
#include "share/base/union_find.hpp"
#include "share/base/units.hpp"
#include "share/file/specimen.hpp"

namespace graincrack::mesher {

namespace {

constexpr double off_centre = 5e-4;     ///< over an extent: half of what a specimen file allows
constexpr double largest_extent = 1e4;  ///< m
constexpr double smallest_extent = 1e-9;

/// Moves the middle of the extent, or the requested point, of a mesh to the origin.
void place(ImportedMesh& mesh, Outline& outline, const Placement& placement, std::vector<Remark>& notes) {
    Point origin = placement.origin.value_or(outline.middle);
    if (!placement.origin) {
        // Deviations within its roundness are not corrected.
        double longest = 0;
        for (const Side& side : outline.sides) {
            if (side.part < 0) continue;
            longest = std::max(longest, length(mesh.points[index(side.to)] - mesh.points[index(side.from)]));
        }
        const bool is_round = outline.shape != "rectangle" && outline.shape != "beam";
        const auto slack = [&](double size) { return off_centre * size + (is_round ? longest * longest / (4 * size) : 0); };
        if (std::abs(origin.x) <= slack(outline.width) && std::abs(origin.y) <= slack(outline.height)) origin = {};
    }
    if (origin == Point{}) return;
    for (Point& p : mesh.points) p = p - origin;
    outline.middle = outline.middle - origin;
    notes.push_back(fmt::format("moved by ({}, {}), so that {} is the origin", format_length(-origin.x), format_length(-origin.y),
                                placement.origin ? "the point that was given" : "the middle of its extent"));
}

PlaneMesh plane_mesh_of(ImportedMesh& mesh, std::vector<Side> sides) {
    PlaneMesh plane;
    plane.crystal_of_body.resize(mesh.phase_of_grain.size());
    std::iota(plane.crystal_of_body.begin(), plane.crystal_of_body.end(), 0);
    plane.points = std::move(mesh.points);
    plane.triangles = std::move(mesh.triangles);
    plane.body_of_triangle = std::move(mesh.grain_of_triangle);
    plane.sides = std::move(sides);
    plane.complete_bodies();
    return plane;
}

/// Assigns the phases of grains, those with a given order first.
void give_phases(Specimen& specimen, const std::vector<int>& imported_grain, const ImportedMesh& mesh,
                 std::vector<Remark>& notes) {
    const auto name_of = [&](std::size_t grain) {
        return mesh.phase_of_grain[grain].empty() ? "rock" : mesh.phase_of_grain[grain];
    };
    std::vector<std::string> found;
    for (std::size_t grain = 0; grain < mesh.phase_of_grain.size(); ++grain) {
        if (std::find(found.begin(), found.end(), name_of(grain)) == found.end()) found.push_back(name_of(grain));
    }
    std::vector<std::string>& names = specimen.phase_names;
    names.clear();
    for (const auto& list : {mesh.phases, found}) {
        for (const std::string& phase : list) {
            const bool is_there = std::find(found.begin(), found.end(), phase) != found.end();
            if (is_there && std::find(names.begin(), names.end(), phase) == names.end()) names.push_back(phase);
        }
    }
    if (names.size() > max_phases) throw InputError(fmt::format("{} phases; at most {} fit", names.size(), max_phases));
    for (std::size_t g = 0; g < specimen.n_grains(); ++g) {
        const auto phase = std::find(names.begin(), names.end(), name_of(index(imported_grain[g])));
        specimen.grain_phase[g] = static_cast<std::uint8_t>(phase - names.begin());
    }
    const auto unnamed = std::count(mesh.phase_of_grain.begin(), mesh.phase_of_grain.end(), "");
    if (unnamed > 0 && names.size() > 1) {
        notes.emplace_back(fmt::format("{} grains have no phase and are of \"rock\"", unnamed), "no_phase");
    }
}

/// Notes the number of bodies of connected grains if it exceeds one.
void tell_bodies(const Specimen& specimen, std::vector<Remark>& notes) {
    const auto grains = grain_of_nodes(specimen);
    UnionFind bodies(specimen.n_grains());
    std::size_t n_bodies = specimen.n_grains();
    for (const auto& nodes : specimen.contact_nodes) {
        const auto a = bodies.find(index(grains[index(nodes[0])]));
        const auto b = bodies.find(index(grains[index(nodes[2])]));
        if (a == b) continue;
        bodies.join(a, b);
        --n_bodies;
    }
    if (n_bodies > 1) {
        notes.emplace_back(fmt::format("the grains make {} bodies that share no sides", n_bodies), "several_bodies");
    }
}

}  // namespace

std::vector<int> make_grains_of_triangles(ImportedMesh& mesh) {
    std::vector<int> grains(mesh.triangles.size());
    std::iota(grains.begin(), grains.end(), 0);
    grains.swap(mesh.grain_of_triangle);
    std::vector<std::string> phases;
    for (const int grain : grains) phases.push_back(mesh.phase_of_grain[index(grain)]);
    mesh.phase_of_grain = std::move(phases);
    return grains;
}

Specimen assemble(ImportedMesh mesh, const Placement& placement, CrystalChoice crystals, const std::string& name,
                  std::vector<Remark>& notes) {
    if (placement.scale != 1) {
        for (Point& p : mesh.points) p = placement.scale * p;
    }
    clean(mesh, name);
    std::vector<int> crystal_of_element;
    if (crystals == CrystalChoice::breaking) {
        if (mesh.triangles.size() == mesh.phase_of_grain.size()) {
            throw InputError(name +
                             ": --crystals break: each crystal is one element, so that nothing can break within it; smaller "
                             "elements, another --grain, or --crystals elastic is needed");
        }
        crystal_of_element = make_grains_of_triangles(mesh);
    }
    notes.insert(notes.end(), mesh.notes.begin(), mesh.notes.end());
    Outline outline = outline_of(mesh, placement.shape, name, notes);
    const double size = std::max(outline.width, outline.height);
    if (!(size <= largest_extent && size >= smallest_extent)) {
        throw InputError(fmt::format("{}: {} across; a specimen of {} to {} is needed (--scale 1mm for files in mm)", name,
                                     format_length(size), format_length(smallest_extent), format_length(largest_extent)));
    }
    place(mesh, outline, placement, notes);

    std::vector<int> imported_grain;
    Specimen specimen = separate_bodies(plane_mesh_of(mesh, std::move(outline.sides)), &imported_grain);
    specimen.shape = outline.shape;
    specimen.width = outline.width;
    specimen.height = outline.height;
    specimen.loading_arc = outline.loading_arc;
    specimen.tessellation = "imported";
    specimen.part_names = std::move(outline.part_names);
    give_phases(specimen, imported_grain, mesh, notes);
    if (crystals == CrystalChoice::breaking) {
        for (const int element : imported_grain) specimen.grain_crystal.push_back(crystal_of_element[index(element)]);
    }
    specimen.statistics = statistics_of(specimen);
    tell_bodies(specimen, notes);
    validate(specimen, name);
    return specimen;
}

}  // namespace graincrack::mesher
